"""A family of halo orbits

Periodic orbits about the point between Earth and Moon where their pulls balance. For each height z
Newton's method looks for the start (x, py) from which the satellite crosses the plane y = 0 at a right
angle; by symmetry the other half is the mirror image.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

earth, moon = "sqrt((x + mu)^2 + y^2 + z^2)", "sqrt((x - 1 + mu)^2 + y^2 + z^2)"
frame = hvi.Scene(
    coordinates=["x", "y", "z"], momenta=["px", "py", "pz"],
    hamiltonian=f"(px^2 + py^2 + pz^2)/2 + y*px - x*py - (1 - mu)/{earth} - mu/{moon}",
    parameters={"mu": "0.01215058"},
    initial={"x": "0.8234", "y": 0, "z": 0, "px": 0, "py": "0.95", "pz": 0}).stepper("gauss:6")
crossing = hvi.Event("y", "down", stop=1)


def half(start, z):
    """The orbit from a start in the plane y = 0 to the next crossing."""
    x, py = start
    return frame.integrate([x, 0, z, 0, py, 0], (0, 5), 0.02, events=crossing, every=1)


def miss(start, z):
    """px + y and pz, which vanish at a right angle."""
    return half(start, z).y[[3, 5], -1]


axes = plt.figure().add_subplot(projection="3d")
last = start = np.array([0.82338, 0.82338 + 0.13418])
for z in np.arange(0.0223, 0.13, 0.005):
    last, start = start, 2 * start - last
    for _ in range(6):
        slope = [(miss(start + d, z) - miss(start - d, z)) / 2e-6 for d in np.eye(2) * 1e-6]
        start = start - np.linalg.solve(np.transpose(slope), miss(start, z))
    assert np.abs(miss(start, z)).max() < 1e-12
    orbit = half(start, z)
    for side in (1, -1):
        axes.plot(orbit["x"], side * orbit["y"], orbit["z"], color="C0", linewidth=0.8)
axes.set(xlabel="x", ylabel="y", zlabel="z")
