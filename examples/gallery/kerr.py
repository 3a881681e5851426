"""A geodesic around a spinning black hole

The orbit of a test body in Kerr's metric, in coordinates of Boyer and Lindquist: the ellipse turns,
and its plane too. The Hamiltonian is not separable; its value, minus half the squared mass, is kept.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

delta, sigma = "(r^2 - 2*r + a^2)", "(r^2 + a^2*cos(th)^2)"
body = hvi.Scene(
    coordinates=["r", "th", "phi"], momenta=["pr", "pth", "L"],
    hamiltonian=f"({delta}*pr^2 + pth^2 + (L/sin(th) - a*E*sin(th))^2"
                f" - ((r^2 + a^2)*E - a*L)^2/{delta})/(2*{sigma})",
    parameters={"a": "9/10", "E": "95/100"},
    initial={"r": 10, "th": "pi/2", "phi": 0, "pr": 0, "pth": 0, "L": "5/2"})
stepper = body.stepper("gauss:4")
x = stepper.initial()
x[4] = np.sqrt(-200 * (stepper.energy(x) + 0.5))  # on the mass shell, where H = -1/2
orbit = stepper.integrate(x, (0, 3000), 0.5)
r, th, phi = orbit.q
axes = plt.figure().add_subplot(projection="3d")
axes.plot(r * np.sin(th) * np.cos(phi), r * np.sin(th) * np.sin(phi), r * np.cos(th), linewidth=0.7)
