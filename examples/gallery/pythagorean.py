"""The Pythagorean problem of three bodies

Masses 3, 4 and 5 begin at rest in the corners of the triangle with these sides (Burrau, 1913).
After close encounters the lightest body leaves, and the other two stay together. Steps adapt by a
scale of the time, and remain symplectic.
"""
import hvi
import matplotlib.pyplot as plt

bodies = hvi.Scene("pythagorean").integrate(every=4)
half = len(bodies.q) // 2
for k in range(half):
    plt.plot(*bodies.q[[2 * k, 2 * k + 1]], linewidth=0.7, label=bodies.names[2 * k])
plt.gca().set_aspect("equal")
