# Expressions of a scene's variables as functions of Python.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import ast
import math
from typing import Callable, Sequence

_functions = {name: getattr(math, name) for name in (
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh",
    "tanh")}
_functions["abs"] = abs
_operators = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow, ast.USub, ast.UAdd)


def compiled(text: str, variables: Sequence[str],
             parameters: dict[str, float]) -> Callable[[float, Sequence[float]], float]:
    """Makes f(t, y) of an expression in the variables, the parameters, t and pi.

    Only arithmetic and elementary functions are taken, so that no text can do anything else.
    Raises ValueError where the text is no such expression.
    """
    try:
        tree = ast.parse(text.replace("^", "**").strip(), mode="eval")
    except SyntaxError as error:
        raise ValueError(f"this is no expression: {text!r}") from error
    known = {"pi": math.pi, **parameters}
    tree = ast.fix_missing_locations(_Translator(text, list(variables), known).visit(tree))
    code = compile(tree, f"<{text}>", "eval")
    names = {**_functions, **known, "__builtins__": {}}

    def value(t: float, y: Sequence[float]) -> float:
        return eval(code, names, {"t": t, "y_": y})

    return value


class _Translator(ast.NodeTransformer):
    """Refuses what is no arithmetic, and puts `y_[k]` in place of the k-th variable."""

    def __init__(self, text: str, variables: list[str], known: dict[str, float]):
        self.text, self.variables, self.known = text, variables, known

    def refuse(self, node: ast.AST) -> ValueError:
        return ValueError(f"{ast.unparse(node)!r} has no meaning in the event {self.text!r}; there "
                          f"are {', '.join([*self.variables, 't', *self.known])}")

    def generic_visit(self, node: ast.AST) -> ast.AST:
        arithmetic = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.Load, *_operators)
        if not isinstance(node, arithmetic):
            raise self.refuse(node)
        return super().generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        if type(node.value) not in (int, float):
            raise self.refuse(node)
        return ast.Constant(float(node.value))

    def visit_Call(self, node: ast.Call) -> ast.AST:
        known = isinstance(node.func, ast.Name) and node.func.id in _functions
        if not known or node.keywords:
            raise self.refuse(node)
        return ast.Call(node.func, [self.visit(each) for each in node.args], [])

    def visit_Name(self, node: ast.Name) -> ast.AST:
        return self.variable(node, node.id)

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        return self.variable(node, ast.unparse(node))

    def variable(self, node: ast.expr, name: str) -> ast.AST:
        if name in self.variables:
            index = ast.Constant(self.variables.index(name))
            return ast.Subscript(ast.Name("y_", ast.Load()), index, ast.Load())
        if name == "t" or name in self.known:
            return node
        raise self.refuse(node)
