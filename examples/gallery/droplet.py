"""Atoms that evaporate

38 atoms with the forces of Lennard and Jones begin in the lowest of their minima, with velocities of a
hot droplet. Lines are their paths; the energy changes by no more than rounding and the step allow.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

atoms = hvi.Scene("lennard-jones-38").stepper("stormer-verlet")
x = atoms.initial()
momenta = np.random.default_rng(1).normal(0, 0.9, atoms.dof)
x[atoms.dof:] = momenta - np.tile(momenta.reshape(-1, 3).mean(axis=0), atoms.dof // 3)
run = atoms.integrate(x, (0, 6), 0.005, every=10)
axes = plt.figure().add_subplot(projection="3d")
for atom in range(atoms.dof // 3):
    axes.plot(*run.q[3 * atom:3 * atom + 3], linewidth=0.7)
