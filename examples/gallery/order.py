"""Spectral convergence

On Kepler's ellipse with one step for 1/10 of a time unit, each further node of Gauss's rule gains
two digits or more, until doubles have no more. A method with more stages is often faster than one
with smaller steps.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

kepler = hvi.Scene("kepler")
stages = range(2, 9)
best = kepler.integrate((0, 10), step=0.05, method="gauss:12").y[:, -1]
for step in (0.2, 0.1):
    ends = [kepler.integrate((0, 10), step=step, method=f"gauss:{s}").y[:, -1] for s in stages]
    plt.semilogy(stages, [np.abs(end - best).max() for end in ends], "o-", label=f"h = {step}")
plt.xlabel("stages")
plt.ylabel("error at t = 10")
plt.legend()
