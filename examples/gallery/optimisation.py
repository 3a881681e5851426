"""Accelerated optimisation

Nesterov's accelerated gradients are a discretised Hamiltonian flow whose friction is a function of the
time (Wibisono, Wilson and Jordan, PNAS 113, 2016). A symplectic step of that flow goes down faster
than gradient descent with the same number of gradients.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

# f = (x^2 + 100 y^2)/2; the flow of p = 2 reaches f ~ 1/t^2.
flow = hvi.Scene(coordinates=["x", "y"], momenta=["px", "py"],
                 hamiltonian="(px^2 + py^2)/(2*(t + 1)^3) + (t + 1)^3*(x^2 + 100*y^2)/2",
                 initial={"x": 1, "y": 1, "px": 0, "py": 0})
run = flow.integrate((0, 15), step=0.1, method="stormer-verlet", every=1)
count = np.arange(len(run.t))
plt.semilogy(count, (run["x"]**2 + 100 * run["y"]**2) / 2, label="symplectic flow")
plt.semilogy(count, 0.5 * (1 - 0.01)**(2 * count) + 50 * 0.0**count, label="gradient descent")
plt.xlabel("gradients")
plt.ylabel("f")
plt.legend()
