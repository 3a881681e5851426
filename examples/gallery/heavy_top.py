"""A heavy top without symmetry

The path of the top's long axis on the sphere. Rotations are matrices that stay orthogonal, the
equations have no singular angles, and the energy is kept.
"""
import hvi
import matplotlib.pyplot as plt

top = hvi.Scene("heavy-top").integrate((0, 50), step=0.02, method="gauss:4", every=1)
axes = plt.figure().add_subplot(projection="3d")
axes.plot(top["R[1,3]"], top["R[2,3]"], top["R[3,3]"], linewidth=0.7)
