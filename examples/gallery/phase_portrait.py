"""The phase portrait of a pendulum

Each curve is one run of 400 steps. Curves close, however long the runs: a symplectic step moves
along a curve of a Hamiltonian close by, so that it neither spirals in nor out.
"""
import hvi
import matplotlib.pyplot as plt

pendulum = hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 - cos(q)", initial={"q": 0, "p": 0})
for p in (0.4, 0.8, 1.2, 1.6, 1.9, 2.1, 2.4):
    for sign in (1, -1):
        run = pendulum.integrate((0, 40), step=0.1, method="stormer-verlet",
                                 initial={"p": sign * p})
        plt.plot(run["q"], run["p"], color="C0" if p < 2 else "C1")
plt.xlim(-3.5, 3.5)
plt.xlabel("angle q")
plt.ylabel("momentum p")
