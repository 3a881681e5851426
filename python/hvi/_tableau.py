# Tableaux and certificates of methods.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
from typing import Any, Mapping

from . import _gen


@dataclasses.dataclass(frozen=True)
class Tableau:
    """A method's coefficients as sympy numbers, exact where they have a closed form.

    Names are the paper's: `A` is A^phi, `A_tilde` A~, `M[i][j]` psi_i(c_j), `A_psi[i][j]` the
    integral of psi_j from 0 to c_i. `A` and `A_tilde`, `M` and `A_psi` are sympy matrices.
    """

    name: str
    stages: int
    basis: list[str]
    c: list[Any]
    b: list[Any]
    A: Any
    A_tilde: Any
    json: Mapping[str, Any]  #: all that hvi-gen says of it, as its JSON has it

    def matrix(self, name: str) -> Any:
        """Another matrix of the JSON: `M`, `M_inverse`, `A_psi`. Raises KeyError."""
        import sympy

        from ._sympy import number

        return sympy.Matrix(number(self.json[name]))


def _method_options(method: str | Mapping[str, Any] | None) -> list[str]:
    """Words of the command line: of a name, or of `basis`, `nodes` and `weights`."""
    if method is None:
        return []
    if isinstance(method, str):
        name, _, composition = method.partition("+")
        return ["--method", name] + (["--compose", composition] if composition else [])
    options = []
    for name, value in method.items():
        if name not in ("basis", "nodes", "weights"):
            raise TypeError(f"a method has basis, nodes and weights, and no {name!r}")
        text = value if isinstance(value, str) else ", ".join(_gen.exact_text(x) for x in value)
        options += [f"--{name}", text]
    return options


def tableau(method: str | Mapping[str, Any], **parameters: Any) -> Tableau:
    """Derives the tableau of a method exactly; keywords are values of its parameters. Needs sympy.

    `method` is a name as `gauss:3`, or a dictionary with `basis`, `nodes` and perhaps `weights`.
    Raises InputError and MathError.

    >>> import hvi
    >>> hvi.tableau("gauss:2").A
    Matrix([
    [            1/4, 1/4 - sqrt(3)/6],
    [1/4 + sqrt(3)/6,             1/4]])
    """
    import sympy

    from ._sympy import number

    json = _gen.call_json(["tableau", *_method_options(method),
                           *_gen.parameter_options(parameters)])
    return Tableau(json["name"], json["stages"], json["basis"], number(json["c"]),
                   number(json["b"]), sympy.Matrix(number(json["A"])),
                   sympy.Matrix(number(json["A_tilde"])), json)


def check(method: str | Mapping[str, Any], **parameters: Any) -> dict[str, Any]:
    """The certificate of a method: order, symplecticity, symmetry, stability, as a dictionary.

    >>> import hvi
    >>> hvi.check("gauss:3")["order"]
    6
    """
    return _gen.call_json(["check", *_method_options(method),
                           *_gen.parameter_options(parameters)])
