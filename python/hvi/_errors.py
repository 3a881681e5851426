# Errors of hvi-gen as exceptions of Python.
# SPDX-License-Identifier: MIT
from __future__ import annotations


class Error(Exception):
    """hvi-gen has refused something. The text says what, where (with a caret), and what helps."""


class InputError(Error, ValueError):
    """The input cannot be read: syntax, an unknown name, a missing file, a bad option."""


class MathError(Error, ArithmeticError):
    """The input is understood, but mathematics forbids it."""


class OutsideError(Error, OSError):
    """Something outside failed: no hvi-gen, no compiler, a file that cannot be written."""

    def __str__(self) -> str:
        return str(self.args[0])


class InternalError(Error):
    """A bug of hvi-gen, which asks for a report."""


_kinds = {1: MathError, 2: InputError, 3: OutsideError}


def raised(status: int, text: str) -> Error:
    """The exception of an exit status and of what stands on standard error."""
    lines = text.strip().splitlines()
    first = next((k for k, line in enumerate(lines) if line.startswith("error:")), 0)
    message = "\n".join(lines[first:]) or f"hvi-gen has ended with the status {status}"
    return _kinds.get(status, InternalError)(message.removeprefix("error: "))
