# What the tests of the package share.
# SPDX-License-Identifier: MIT
import math
import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, os.environ["HVI_PYTHON_PACKAGE"])

import numpy as np  # noqa: E402

import hvi  # noqa: E402


def oscillator(**more):
    """q'' = -q from (1, 0)."""
    return hvi.Scene(coordinates=["q"], momenta=["p"], hamiltonian="p^2/2 + q^2/2",
                     initial={"q": 1, "p": 0}, **more)


def verlet_of_oscillator(h, n):
    """(q, p) after n steps of Stormer-Verlet on the oscillator from (1, 0), in closed form.

    A step has the trace 2 cos(theta) = 2 - h^2; its ellipse has q^2 (1 - h^2/4) + p^2 constant.
    """
    theta = math.acos(1 - h * h / 2)
    return math.cos(n * theta), -math.sqrt(1 - h * h / 4) * math.sin(n * theta)


class TestCase(unittest.TestCase):
    def assert_near(self, left, right, most):
        np.testing.assert_allclose(left, right, rtol=0, atol=most)

    def folder(self):
        """A folder for this test."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return Path(folder.name)
