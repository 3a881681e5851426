"""Four point vortices

Vortices have no momenta: the two coordinates of each are conjugate to each other, and the Hamiltonian
is a sum of logarithms. No Lagrangian leads to these equations.
"""
import hvi
import matplotlib.pyplot as plt

vortices = hvi.Scene("point-vortices").integrate((0, 40), step=0.05, method="gauss:4")
for q, p in zip(vortices.q, vortices.p):
    plt.plot(q, p, linewidth=0.8)
    plt.plot(q[-1:], p[-1:], "ko", markersize=4)
plt.gca().set_aspect("equal")
