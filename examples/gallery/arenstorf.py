"""Arenstorf's orbit

A satellite in the plane of Earth and Moon, in the frame that turns with them: it comes back to where
it began after 17.065 units of time. Steps are short near Earth and Moon, by a scale of the time.
"""
import hvi
import matplotlib.pyplot as plt

earth = "sqrt((x + mu)^2 + y^2)"
moon = "sqrt((x - 1 + mu)^2 + y^2)"
satellite = hvi.Scene(
    coordinates=["x", "y"], momenta=["px", "py"],
    hamiltonian=f"(px^2 + py^2)/2 + y*px - x*py - (1 - mu)/{earth} - mu/{moon}",
    parameters={"mu": "0.012277471"}, scale=f"{earth}^(3/2)*{moon}^(3/2)",
    initial={"x": "0.994", "y": 0, "px": 0, "py": "0.994 - 2.00158510637908252240537862224"})
orbit = satellite.integrate((0, 17.0652165601579625588917206249), step=0.01, method="gauss:8")
plt.plot(orbit["x"], orbit["y"])
plt.plot([-0.0123], [0], "o", [0.9877], [0], "o")
plt.gca().set_aspect("equal")
