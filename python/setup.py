"""Adds to pyproject.toml the version, which is that of the checkout, and what a wheel is tagged with."""
# SPDX-License-Identifier: MIT
import re
from pathlib import Path

from setuptools import setup
from wheel.bdist_wheel import bdist_wheel

here = Path(__file__).resolve().parent


class Wheel(bdist_wheel):
    """A wheel for every Python 3; with hvi-gen inside it is for this platform alone."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = not (here / "hvi/bin/hvi-gen").exists()

    def get_tag(self):
        return "py3", "none", "any" if self.root_is_pure else super().get_tag()[2]


def version():
    text = (here.parent / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(hvi\s+VERSION\s+([0-9.]+)", text)[1]


setup(version=version(), cmdclass={"bdist_wheel": Wheel})
