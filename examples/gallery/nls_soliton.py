"""Two solitons of the nonlinear Schrodinger equation

The real and imaginary parts of the wave are coordinates and momenta. Two solitons run into each other
on a ring and leave with their shapes; the norm, a quadratic invariant, is kept to rounding.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

n, a = 200, 0.2
scene = '''
name = "schrodinger"
coordinates = ["q[1..N]"]
momenta = ["p[1..N]"]
hamiltonian = """sum(i=1..N, ((q[mod(i,N)+1] - q[i])^2 + (p[mod(i,N)+1] - p[i])^2)/(4*a^2)
                 - (q[i]^2 + p[i]^2)^2/8)"""
[parameters]
N = 200
a = "1/5"
[invariants]
norm = "sum(i=1..N, q[i]^2 + p[i]^2)"
[initial]
"q[i]" = 0
"p[i]" = 0
'''
with open("schrodinger.toml", "w", encoding="utf-8") as file:
    file.write(scene)
stepper = hvi.Scene("schrodinger.toml").stepper("gauss:2")
x = a * (np.arange(n) - n / 2)
wave = sum(np.exp(1j * v * x) / np.cosh(x - x0) for x0, v in ((-6, 1), (6, -1)))
run = stepper.integrate(np.sqrt(2) * np.r_[wave.real, wave.imag], (0, 12), 0.01, every=10)
plt.pcolormesh(x, run.t, np.hypot(run.q, run.p).T / np.sqrt(2), shading="nearest")
plt.xlabel("x")
plt.ylabel("t")
plt.title(f"the norm changes by {np.ptp(run['norm']):.0e}", fontsize="medium")
