"""The experiments of the paper

Errors of Chebyshev's method with four nodes and of Gauss's with four on the harmonic oscillator, as
Leok and Zhang have them in Section 6.2. Both keep within a bound; Gauss's has order 8.
"""
import hvi
import matplotlib.pyplot as plt
import numpy as np

oscillator = hvi.Scene("harmonic-oscillator")
axes = plt.figure(figsize=(7, 5)).subplots(2, 1, sharex=True)
for row, method in zip(axes, ("chebyshev:4", "gauss:4")):
    run = oscillator.integrate((0, 100), step=0.1, method=method, every=1)
    exact = np.cos(run.t) * run.q[0, 0] + np.sin(run.t) * run.p[0, 0]
    row.semilogy(run.t[1:], np.abs(run.q[0] - exact)[1:] + 1e-18, linewidth=0.6)
    row.set_ylabel(f"error of q, {method}")
axes[1].set_xlabel("t")
