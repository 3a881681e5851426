"""Optimal control: swinging a pendulum up

By Pontryagin's principle the least effort that brings a hanging pendulum upright in five time units
follows a Hamiltonian in the angle, its rate and their multipliers. Newton's method finds the multipliers
to begin with.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

# x' = y, y' = u - sin(x), least integral of u^2/2: u = ly.
optimal = hvi.Scene(coordinates=["x", "y"], momenta=["lx", "ly"],
                    hamiltonian="lx*y - ly*sin(x) + ly^2/2",
                    initial={"x": 0, "y": 0, "lx": 0, "ly": 0}).stepper("gauss:4")


def miss(multipliers):
    end = optimal.integrate([0, 0, *multipliers], (0, 5), 0.05, every=100).y[:, -1]
    return end[:2] - [np.pi, 0]


guess = np.array([0.1, 0.5])
for _ in range(40):
    slope = np.transpose([(miss(guess + d) - miss(guess - d)) / 2e-6 for d in np.eye(2) * 1e-6])
    step = np.linalg.solve(slope, miss(guess))
    guess = guess - step * min(1, 0.2 / np.linalg.norm(step))
run = optimal.integrate([0, 0, *guess], (0, 5), 0.05, every=1)
plt.plot(run.t, run["x"], label="angle")
plt.plot(run.t, run["ly"], label="torque")
plt.axhline(np.pi, color="0.7", linewidth=0.8)
plt.xlabel("t")
plt.legend()
