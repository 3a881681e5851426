"""A banana in a tokamak

The motion of a charged particle in the field of a tokamak, gyrations included, seen in the plane of
radius and height (fields of Qin et al., Phys. Plasmas 20, 084503, 2013). The orbit closes to a banana
over 50 000 gyrations' steps, without drifting out of the device.
"""
import hvi
import matplotlib.pyplot as plt

# Vector potential: A_R = z/R, A_z = 0, R A_phi = ((R - 1)^2 + z^2)/4; p_phi is conserved.
particle = hvi.Scene(
    coordinates=["R", "z"], momenta=["pR", "pz"],
    hamiltonian="((pR - z/R)^2 + pz^2 + (pphi - ((R - 1)^2 + z^2)/4)^2/R^2)/2",
    parameters={"pphi": "1.05*4.816e-4 + 0.05^2/4"},
    initial={"R": "1.05", "z": 0, "pR": 0, "pz": "-2.059e-3"})
orbit = particle.integrate((0, 60000), step=0.6, method="gauss:2", every=10)
plt.plot(orbit["R"], orbit["z"], linewidth=0.5)
plt.xlabel("R")
plt.ylabel("z")
plt.gca().set_aspect("equal")
