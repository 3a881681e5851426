"""Symplectic integrators of Leok & Zhang, derived exactly and compiled, for any Hamiltonian.

>>> import hvi
>>> result = hvi.Scene("kepler").integrate((0, 10), step=0.01, method="gauss:4")
>>> result.success
True

hvi-gen derives the method, writes and compiles the steps; this package finds it by the variable
HVI_GEN, in its own wheel, or on PATH.
"""
# SPDX-License-Identifier: MIT
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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

_modules = {
    "_ensemble": ("EnsembleResult",),
    "_errors": ("Error", "InputError", "InternalError", "MathError", "OutsideError"),
    "_events": ("Event",),
    "_library": ("StepError",),
    "_report": ("report",),
    "_result": ("Result",),
    "_scene": ("Scene",),
    "_solve": ("solve_ivp",),
    "_stepper": ("Stepper",),
    "_tableau": ("Tableau", "check", "tableau"),
}


def __getattr__(name: str) -> Any:
    """Imports what is used, so that `import hvi` does not wait for numpy."""
    for module, names in _modules.items():
        if name in names:
            value = getattr(importlib.import_module(f".{module}", __name__), name)
            globals()[name] = value
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
