"""How chaotic is a double pendulum?

Both pendulums begin at rest, at the angles of the map. Two neighbours 1e-8 apart are followed for 10
seconds: the colour is the rate at which they separate. Large angles are chaotic, small ones are not.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

pendulum = hvi.Scene("double-pendulum")
first, second = np.meshgrid(np.linspace(-3, 3, 60), np.linspace(-3, 3, 60))
ends = [pendulum.ensemble({"theta1": first.ravel() + shift, "theta2": second.ravel()},
                          t_span=(0, 10), step=0.02, method="gauss:3").y for shift in (0, 1e-8)]
distance = np.linalg.norm(ends[1] - ends[0], axis=1)
rate = np.log(distance / 1e-8 + 1e-300) / 10
plt.pcolormesh(first, second, rate.reshape(first.shape), shading="nearest", vmin=0)
plt.colorbar(label="rate of separation, 1/s")
plt.xlabel("first angle")
plt.ylabel("second angle")
