"""A family of halo orbits

Periodic orbits about the point between Earth and Moon where their pulls balance. Newton's method looks
for the start (z, py) from which the satellite crosses the plane y = 0 at a right angle; by symmetry the
other half is the mirror image.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

earth, moon = "sqrt((x + mu)^2 + y^2 + z^2)", "sqrt((x - 1 + mu)^2 + y^2 + z^2)"
frame = hvi.Scene(
    coordinates=["x", "y", "z"], momenta=["px", "py", "pz"],
    hamiltonian=f"(px^2 + py^2 + pz^2)/2 + y*px - x*py - (1 - mu)/{earth} - mu/{moon}",
    parameters={"mu": "0.01215058"},
    initial={"x": "0.8233", "y": 0, "z": 0, "px": 0, "py": "0.95", "pz": 0}).stepper("gauss:6")
crossing = hvi.Event("y", "down", stop=1)


def miss(x, guess):
    """px + y and pz, which is zero too, at the next crossing of y = 0."""
    run = frame.integrate([x, 0, guess[0], 0, guess[1], 0], (0, 5), 0.02, events=crossing)
    return run.y[[3, 5], -1]


axes = plt.figure().add_subplot(projection="3d")
guess = np.array([0.022, 0.8233 + 0.134])
for x in np.linspace(0.8233, 0.8265, 9):
    for _ in range(8):
        slope = [(miss(x, guess + d) - miss(x, guess - d)) / 2e-6 for d in np.eye(2) * 1e-6]
        guess = guess - np.linalg.solve(np.transpose(slope), miss(x, guess))
    half = frame.integrate([x, 0, guess[0], 0, guess[1], 0], (0, 5), 0.02, events=crossing, every=1)
    for side in (1, -1):
        axes.plot(half["x"], side * half["y"], half["z"], color="C0", linewidth=0.8)
