"""A breather of the sine-Gordon equation

The field on a ring of 400 points swings at one place and radiates nothing. Sums over the points stay
loops in the compiled step, so that a million points take the same code.
"""
import hvi
import matplotlib.pyplot as plt

field = hvi.Scene("sine-gordon").integrate((0, 60), step=0.02, every=20)
plt.pcolormesh(range(400), field.t, field.q.T, cmap="RdBu", shading="nearest")
plt.xlabel("point")
plt.ylabel("t")
plt.colorbar(label="u")
