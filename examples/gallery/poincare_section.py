"""A Poincare section of Henon and Heiles

Dots are the places where orbits of the energy 1/8 pass through x = 0 upwards. Orbits that lie on
curves are regular; the one whose dots fill an area is chaotic.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

star = hvi.Scene(coordinates=["x", "y"], momenta=["px", "py"],
                 hamiltonian="(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3",
                 initial={"x": 0, "y": 0, "px": "1/2", "py": 0})
for y in (-0.3, -0.2, -0.1, 0.08, 0.25, 0.35, 0.45):
    px = np.sqrt(2 * (1 / 8 - y**2 / 2 + y**3 / 3))
    points = star.section("x", (0, 1500), step=0.15, method="gauss:4", initial=[0, y, px, 0])
    plt.plot(points[:, 1], points[:, 3], ".", markersize=2)
plt.xlabel("y")
plt.ylabel("py")
