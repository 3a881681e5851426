# Many trajectories of a scene.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
import os
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Mapping, Sequence

import numpy as np

from ._library import Library
from ._stepper import Integration, Stepper


@dataclasses.dataclass
class EnsembleResult:
    """Where trajectories end, a row for each, in the order of their starts."""

    t: np.ndarray  #: time at the end, shape (trajectories,)
    y: np.ndarray  #: state at the end, (trajectories, variables)
    names: list[str]  #: of the variables
    energy_error: np.ndarray  #: change of the energy from the start to the end
    status: np.ndarray  #: 0, or -1 where a step failed
    message: list[str]
    parameters: dict[str, np.ndarray]  #: that differ

    @property
    def success(self) -> np.ndarray:
        return self.status == 0

    def to_frame(self) -> Any:
        """All of it as a `pandas.DataFrame`; needs pandas."""
        import pandas

        return pandas.DataFrame({**self.parameters, "t": self.t,
                                 **dict(zip(self.names, self.y.T)),
                                 "energy_error": self.energy_error, "status": self.status})


def ensemble_of(library: Library, initial: Any, parameters: Any, t_span: Sequence[float] | None,
                step: float | None, threads: int | None) -> EnsembleResult:
    """Integrates rows on threads: steps hold no lock of the interpreter."""
    usual = Stepper(library)
    varied = _columns(parameters)
    starts, count = _starts(usual, initial, varied)

    def one(row: int) -> tuple[float, np.ndarray, float, int, str]:
        stepper = Stepper(library, {name: values[row] for name, values in varied.items()})
        start = stepper.initial()
        for index, values in starts:
            start[index] = values[row]
        size = len(stepper.variables)
        try:
            integration = Integration(stepper, start, t_span, step)
        except ValueError as error:
            return np.nan, np.full(size, np.nan), np.nan, -1, str(error)
        return integration.to_end()

    Integration(usual, None, t_span, step)  # refuses once what is wrong in all
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        rows = list(pool.map(one, range(count)))
    t, y, errors, status, messages = zip(*rows) if rows else ((), (), (), (), ())
    return EnsembleResult(np.array(t), np.array(y).reshape(count, len(usual.variables)),
                          list(usual.variables), np.array(errors), np.array(status, dtype=int),
                          list(messages), varied)


def _columns(table: Any) -> dict[str, np.ndarray]:
    """Columns of a data frame or dictionary, as arrays of doubles of one length."""
    if table is None:
        return {}
    names = table.columns if hasattr(table, "columns") else table.keys()
    columns = {str(name): np.asarray(table[name], dtype=float) for name in names}
    if any(column.ndim != 1 for column in columns.values()):
        raise ValueError("a column has one number for each trajectory")
    return columns


def _starts(stepper: Stepper, initial: Any, varied: Mapping[str, np.ndarray]):
    """Indices of variables with their values, and the number of trajectories."""
    if initial is None:
        named: dict[int, np.ndarray] = {}
    elif hasattr(initial, "keys"):
        unknown = [name for name in initial.keys() if name not in stepper.variables]
        if unknown:
            raise ValueError(f"there is no variable {unknown[0]!r}, but "
                             + ", ".join(stepper.variables))
        named = {stepper.variables.index(name): column
                 for name, column in _columns(initial).items()}
    else:
        table = np.asarray(initial, dtype=float)
        if table.ndim != 2 or table.shape[1] != len(stepper.variables):
            raise ValueError(f"initial has a column for each of {', '.join(stepper.variables)}")
        named = dict(enumerate(table.T))
    counts = {len(column) for column in (*named.values(), *varied.values())}
    if len(counts) != 1:
        raise ValueError("columns have one length" if counts else
                         "an ensemble has initial values or parameters for each trajectory")
    return list(named.items()), counts.pop()
