"""A stability map

6400 stars begin at rest in the potential of Henon and Heiles. Colours show the largest energy error
after 100 time units on a logarithmic scale; white stars have left the galaxy. Rows run on all cores.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

star = hvi.Scene(coordinates=["x", "y"], momenta=["px", "py"],
                 hamiltonian="(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3",
                 initial={"x": 0, "y": 0, "px": 0, "py": 0})
x, y = np.meshgrid(np.linspace(-1, 1, 80), np.linspace(-0.8, 1.2, 80))
ends = star.ensemble({"x": x.ravel(), "y": y.ravel()}, t_span=(0, 100), step=0.2,
                     method="stormer-verlet")
stays = ends.success & (np.hypot(*ends.y[:, :2].T) < 2)
error = np.where(stays, np.log10(np.abs(ends.energy_error) + 1e-17), np.nan)
plt.pcolormesh(x, y, error.reshape(x.shape), shading="nearest")
plt.colorbar(label="log10 of the energy error")
plt.gca().set_aspect("equal")
