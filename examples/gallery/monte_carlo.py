"""Hamiltonian Monte Carlo

Samples of a distribution with the shape of a banana. Each proposal is a short trajectory of
Stormer-Verlet; as the step keeps volumes and is reversible, accepting by the energy error is exact.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

target = hvi.Scene(coordinates=["x", "y"], momenta=["px", "py"],
                   hamiltonian="(px^2 + py^2)/2 + x^2/2 + 4*(y - x^2/2)^2",
                   initial={"x": 0, "y": 0, "px": 0, "py": 0}).stepper("stormer-verlet")
random = np.random.default_rng(0)
x, samples, accepted = np.zeros(4), [], 0
for _ in range(3000):
    x[2:] = random.normal(size=2)
    end = x.copy()
    for _ in range(10):
        target.step(end, 0.15)
    if np.log(random.random()) < target.energy(x) - target.energy(end):
        x, accepted = end, accepted + 1
    samples.append(x[:2].copy())
plt.plot(*np.array(samples).T, ".", markersize=2)
plt.title(f"{accepted / 30:.0f} % of the proposals accepted", fontsize="medium")
