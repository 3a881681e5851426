# Expressions of sympy as hvi-gen reads them, and exact numbers of hvi-gen for sympy.
# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Callable, Sequence

import sympy
from sympy.printing.str import StrPrinter


class _Printer(StrPrinter):
    """Writes what hvi-gen reads: `^` for powers, and its names of functions."""

    _names = {"Abs": "abs", "Max": "max", "Min": "min"}

    def _print_Function(self, expr):
        name = self._names.get(expr.func.__name__, expr.func.__name__)
        return f"{name}({', '.join(self._print(each) for each in expr.args)})"

    _print_Abs = _print_Max = _print_Min = _print_Function

    def _print_Exp1(self, expr):
        return "e"

    def _print_Infinity(self, expr):
        raise ValueError("infinity has no place in an expression of a scene")

    _print_NegativeInfinity = _print_ComplexInfinity = _print_NaN = _print_Infinity
    _print_ImaginaryUnit = _print_Infinity


def text_of(expression: Any) -> str:
    """An expression of sympy as text. Raises ValueError where a scene has no place for it."""
    text = _Printer({"full_prec": False}).doprint(sympy.sympify(expression))
    return text.replace("**", "^")


def traced(function: Callable[..., Any], names: Sequence[str]) -> str:
    """The text of f(t, y): it is called once, with symbols of sympy.

    Raises TypeError where the function does not take symbols, as those of numpy do not.
    """
    symbols = [sympy.Symbol(name, real=True) for name in names]
    try:
        return text_of(function(sympy.Symbol("t", real=True), symbols))
    except (TypeError, AttributeError) as error:
        raise TypeError("the function is called with symbols of sympy, and fails: use sympy.sin in "
                        f"place of numpy.sin, or give an expression ({error})") from error


def number(entry: Any) -> Any:
    """An entry of hvi-gen's JSON: exact where it has a closed form, else 50 digits."""
    if isinstance(entry, list):
        return [number(each) for each in entry]
    if entry is None:
        return None
    if entry.get("exact") is not None:
        return sympy.sympify(entry["exact"].replace("^", "**"), locals={"e": sympy.E})
    return sympy.Float(entry["decimal"], 50)
