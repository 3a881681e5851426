"""Symplectic integrators of Leok & Zhang, derived exactly and compiled, for any Hamiltonian.

>>> import hvi
>>> result = hvi.Scene("kepler").integrate((0, 10), step=0.01)
>>> result.success
True

hvi-gen derives the method, writes and compiles the steps; this package finds it by the variable
HVI_GEN, in its own wheel, or on PATH.
"""
# SPDX-License-Identifier: MIT
from __future__ import annotations

from ._ensemble import EnsembleResult
from ._errors import Error, InputError, InternalError, MathError, OutsideError
from ._events import Event
from ._library import StepError
from ._report import report
from ._result import Result
from ._scene import Scene
from ._solve import solve_ivp
from ._stepper import Stepper
from ._tableau import Tableau, check, tableau

__all__ = ["EnsembleResult", "Error", "Event", "InputError", "InternalError", "MathError",
           "OutsideError", "Result", "Scene", "StepError", "Stepper", "Tableau", "check",
           "report", "solve_ivp", "tableau"]
