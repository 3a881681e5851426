"""A comet on an ellipse of eccentricity 0.99, fifty steps an orbit

In logarithmic time, Stormer-Verlet stays on the ellipse to rounding: dots are single steps of ten
orbits, which fall on one curve. Only the time along the ellipse has an error.
"""
import hvi
import matplotlib.pyplot as plt

comet = hvi.Scene("eccentric-kepler").integrate((0, 62.8), every=1)
plt.plot(comet["x"], comet["y"], ".", markersize=3)
plt.plot([0], [0], "o", color="C1")
plt.gca().set_aspect("equal")
plt.title(f"energy changes by {abs(comet.energy - comet.energy[0]).max():.0e}", fontsize="medium")
