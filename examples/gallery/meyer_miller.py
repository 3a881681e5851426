"""Electrons as oscillators

Meyer and Miller's Hamiltonian maps two electronic states to two oscillators whose squared amplitudes
are the populations, coupled to the motion of a nucleus. The total population is kept to rounding.
"""
import hvi
import matplotlib.pyplot as plt

molecule = hvi.Scene(
    coordinates=["R", "x1", "x2"], momenta=["P", "p1", "p2"],
    hamiltonian="P^2/2 + R^2/2 + k*R*(x1^2 + p1^2 - x2^2 - p2^2)/2 + c*(x1*x2 + p1*p2)",
    parameters={"k": "0.4", "c": "0.5"},
    invariants={"population": "(x1^2 + p1^2 + x2^2 + p2^2)/2"},
    initial={"R": 1, "x1": "sqrt(2)", "x2": 0, "P": 0, "p1": 0, "p2": 0})
run = molecule.integrate((0, 60), step=0.05, method="gauss:4")
plt.plot(run.t, (run["x1"]**2 + run["p1"]**2) / 2, label="first state")
plt.plot(run.t, (run["x2"]**2 + run["p2"]**2) / 2, label="second state")
plt.plot(run.t, run["population"], "k:", label="both")
plt.xlabel("t")
plt.legend()
