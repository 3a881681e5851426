# A compiled stepper behind its C interface, by ctypes.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import ctypes
import dataclasses
import os
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_int64, c_size_t, c_uint, c_void_p
from typing import Any, Mapping

import numpy as np

# An array's address goes to C as it is: POINTER(c_double) would make an object for each call.
_numbers = c_void_p

_PARAMETER, _COORDINATE, _MOMENTUM, _INVARIANT = range(4)


class StepError(ArithmeticError):
    """A step that could not be taken: no convergence, a collision, overflow.

    The state is where the last good step ended.
    """


@dataclasses.dataclass(frozen=True)
class Description:
    """Facts of a compiled stepper that its library does not tell."""

    name: str  #: what its functions begin with
    scene: str
    text: str  #: what the scene is, in a sentence
    method: str
    command: str  #: that writes the stepper again
    numbers: Mapping[str, float]  #: parameters that are numbers, with their defaults
    lists: tuple[str, ...]  #: parameters that are lists; they come after the numbers
    directory: str  #: where files of the scene are; empty where it has none
    has_time: bool  #: whether a state ends with the time
    step: float | None  #: the scene's own
    until: float | None  #: the scene's end


class Library:
    """The functions of a compiled stepper."""

    def __init__(self, path: os.PathLike[str] | str, description: Description):
        self.description = description
        self._library = ctypes.CDLL(os.fspath(path))
        size, number, handle = c_size_t, c_double, c_void_p
        self._declare("abi_version", [])
        if self.abi_version() != 1:
            raise ImportError(f"{path} has version {self.abi_version()} of the C interface, not 1")
        self._declare("create_with", [c_char_p, c_uint, _numbers, size, POINTER(handle), c_char_p,
                                      size])
        self._declare("destroy", [handle])
        self._declare("copy", [handle, POINTER(handle)])
        self._declare("reset", [handle])
        self._declare("counts", [handle] + 3 * [POINTER(c_int64)])
        self._declare("dof", [handle], c_size_t)
        self._declare("size", [handle], c_size_t)
        self._declare("count", [c_int], c_size_t)
        self._declare("name", [c_int, size], c_char_p)
        self._declare("size_of_name", [handle, c_int, size], c_size_t)
        self._declare("initial", [handle, _numbers])
        self._declare("step", [handle, _numbers, number])
        self._declare("integrate", [handle, _numbers, number, number, size, size, c_char_p,
                                    _numbers, size, POINTER(size)])
        self._declare("energy", [handle, _numbers, _numbers])
        self._declare("invariants", [handle, _numbers, _numbers])
        self._declare("status_text", [c_int], c_char_p)

    def _declare(self, name: str, arguments: list[Any], result: Any = c_int) -> None:
        function = getattr(self._library, f"{self.description.name}_{name}")
        function.argtypes = arguments
        function.restype = result
        setattr(self, name, function)

    def check(self, status: int) -> None:
        """Raises what a status says. Those above 100 are of arguments."""
        if status != 0:
            raise (ValueError if status > 100 else StepError)(self.text_of(status))

    def text_of(self, status: int) -> str:
        return self.status_text(status).decode()

    def names(self, kind: int, handle: int) -> list[str]:
        """Names of numbers. A name with several values has `q[0]`, `q[1]`, ... in their order."""
        result = []
        for k in range(self.count(kind)):
            name, size = self.name(kind, k).decode(), self.size_of_name(handle, kind, k)
            result += [name] if size == 1 else [f"{name}[{i}]" for i in range(size)]
        return result

    def coordinates(self, handle: int) -> list[str]:
        return self.names(_COORDINATE, handle)

    def momenta(self, handle: int) -> list[str]:
        return self.names(_MOMENTUM, handle)

    def invariant_names(self) -> list[str]:
        return [self.name(_INVARIANT, k).decode() for k in range(self.count(_INVARIANT))]

    def create(self, parameters: Mapping[str, Any]) -> int:
        """Makes a stepper and returns its handle.

        Raises TypeError for a name that the scene does not have, ValueError for a value that a
        parameter cannot have.
        """
        values = self._values(parameters)
        handle, message = c_void_p(), ctypes.create_string_buffer(512)
        directory = self.description.directory.encode() or None
        status = self.create_with(directory, 1, values.ctypes.data if values.size else None,
                                  values.size, byref(handle), message, len(message))
        if status != 0:
            raise ValueError(message.value.decode())
        assert handle.value is not None
        return handle.value

    def _values(self, parameters: Mapping[str, Any]) -> np.ndarray:
        description = self.description
        known = (*description.numbers, *description.lists)
        parameters = _written_out(parameters, description.numbers)
        for name in parameters:
            if name not in known:
                raise TypeError(f"{description.scene} has no parameter {name!r}; it has "
                                + (", ".join(known) or "none"))
        if not parameters:
            return np.empty(0)
        numbers = [parameters.get(name, value) for name, value in description.numbers.items()]
        given = [name for name in description.lists if name in parameters]
        if given and len(given) < len(description.lists):
            raise TypeError("lists are given all or none: " + ", ".join(description.lists))
        lists = [np.asarray(parameters[name], dtype=float).ravel() for name in given]
        return np.concatenate([np.asarray(numbers, dtype=float), *lists])


def _written_out(parameters: Mapping[str, Any], numbers: Mapping[str, float]) -> dict[str, Any]:
    """Values of a list `k` as `k[1]`, `k[2]`, ... where these are parameters of the stepper."""
    result: dict[str, Any] = {}
    for name, value in parameters.items():
        items = [each for each in numbers if each.startswith(f"{name}[")]
        if not items or name in numbers:
            result[name] = value
            continue
        values = np.asarray(value, dtype=float).ravel()
        if len(values) != len(items):
            raise ValueError(f"{name} has {len(items)} values, and not {len(values)}")
        result.update(zip(items, values.tolist()))
    return result
