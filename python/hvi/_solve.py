# A twin of scipy's solve_ivp for Hamiltonians.
# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from . import _gen
from ._result import Result
from ._scene import Scene


def solve_ivp(H: Any, t_span: Sequence[float], y0: Any, method: Any = "gauss:4", t_eval: Any = None,
              *, step: float | None = None, accuracy: float | None = None,
              coordinates: Sequence[str] | None = None, momenta: Sequence[str] | None = None,
              parameters: Mapping[str, Any] | None = None, **options: Any) -> Result:
    """Integrates Hamilton's equations as `scipy.integrate.solve_ivp` does a right-hand side.

    `H` is an expression in `q`, `p` and `t` (in `q1, q2, ..., p1, ...` for more degrees of freedom,
    or in the names of `coordinates` and `momenta`), as text or sympy's, or a function H(t, y) that
    takes sympy symbols. `y0` has q, then p. `step` or `accuracy` is needed: there is no rtol.
    `options` are those of `Scene.integrate`.

    >>> import hvi
    >>> result = hvi.solve_ivp("(p^2 + q^2)/2", (0, 3.141592653589793), [1, 0], step=0.1)
    >>> result.success, bool(abs(result.y[0, -1] + 1) < 1e-9)
    (True, True)
    """
    y0 = np.array(y0, dtype=float).ravel()
    if y0.size == 0 or y0.size % 2:
        raise ValueError("y0 has q, then p: an even number of values")
    count = y0.size // 2
    numbers = [""] if count == 1 else [str(k + 1) for k in range(count)]
    q = list(coordinates) if coordinates is not None else ["q" + k for k in numbers]
    p = list(momenta) if momenta is not None else ["p" + k for k in numbers]
    if len(q) != count or len(p) != count:
        raise ValueError(f"y0 has {count} coordinates and as many momenta, names are "
                         + ", ".join([*q, *p]))
    if callable(H) and not hasattr(H, "free_symbols"):
        from ._sympy import traced
        H = traced(H, [*q, *p])
    initial = {name: float(value) for name, value in zip([*q, *p], y0)}
    scene = Scene(coordinates=q, momenta=p, hamiltonian=H, parameters=parameters, initial=initial)
    if step is None and accuracy is None and not {"rtol", "atol"} & set(options):
        raise TypeError("step is missing; or accuracy=1e-8, which looks for a method and a step")
    return scene.integrate(t_span, t_eval, method=None if accuracy is not None else method,
                           step=step, accuracy=accuracy, **options)
