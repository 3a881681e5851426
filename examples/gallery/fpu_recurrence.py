"""The recurrence of Fermi, Pasta, Ulam and Tsingou

A chain of 31 masses with slightly nonlinear springs begins in its lowest mode. The energy goes to
other modes, and after 9400 units of time nearly all of it is back.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

n = 31
chain = hvi.Scene("fpu-chain").stepper("stormer-verlet", N=n)
run = chain.integrate(t_span=(0, 10000), step=0.1)
k = np.arange(1, n + 1)
modes = np.sqrt(2 / (n + 1)) * np.sin(np.pi * np.outer(k, k) / (n + 1))
frequencies = 2 * np.sin(np.pi * k / (2 * (n + 1)))
energies = ((modes @ run.p)**2 + (frequencies[:, None] * (modes @ run.q))**2) / 2
for mode in range(5):
    plt.plot(run.t, energies[mode], label=f"mode {mode + 1}")
plt.xlabel("t")
plt.ylabel("energy")
plt.legend()
