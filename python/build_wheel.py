"""Builds the wheel with setuptools: that of the system where pip has none.

pip builds in an environment without the packages of the system, and would fetch setuptools. Where
Debian's is there, no network is needed.
"""
# SPDX-License-Identifier: MIT
import importlib.util
import os
import sys

_of_debian = "/usr/lib/python3/dist-packages"

if importlib.util.find_spec("setuptools") is None and os.path.isdir(f"{_of_debian}/setuptools"):
    sys.path.append(_of_debian)


def _missing():
    return [name for name in ("setuptools", "wheel") if importlib.util.find_spec(name) is None]


def get_requires_for_build_wheel(config_settings=None):
    return _missing()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    from setuptools import build_meta
    return build_meta.build_wheel(wheel_directory, config_settings, metadata_directory)
