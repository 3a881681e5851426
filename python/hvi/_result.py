# A trajectory as numbers.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any, Callable

import numpy as np


@dataclasses.dataclass
class Result:
    """A trajectory, with the names of `scipy.integrate.solve_ivp` and more.

    `t` has shape (rows,), `y` (variables, rows): a row for each coordinate, then for each
    momentum, in the order of `names`. `q` and `p` are the two halves of `y`; `energy` has shape
    (rows,) and each of `invariants` too. Numbers are in the units of the scene.
    """

    t: np.ndarray
    y: np.ndarray
    names: list[str]
    energy: np.ndarray
    invariants: dict[str, np.ndarray]
    status: int  #: 0: the end was reached; 1: an event ended it; -1: a step failed
    message: str
    t_events: list[np.ndarray] | None = None  #: times of each event
    y_events: list[np.ndarray] | None = None  #: states of each event, (count, variables)
    sol: Callable[[Any], np.ndarray] | None = None  #: y at any time between, with dense_output
    nfev: int = 0  #: how often dH/dq was computed
    steps: int = 0
    method: str = ""
    tangent: np.ndarray | None = None  #: derivative of the end by the start, where it was wished
    summary: dict[str, str] = dataclasses.field(default_factory=dict)  #: of hvi-gen run

    @property
    def success(self) -> bool:
        """Whether the end or a terminal event was reached."""
        return self.status >= 0

    @property
    def q(self) -> np.ndarray:
        return self.y[: len(self.y) // 2]

    @property
    def p(self) -> np.ndarray:
        return self.y[len(self.y) // 2 :]

    def __getitem__(self, name: str) -> np.ndarray:
        """The column of that name: a variable, an invariant, `t` or `energy`."""
        if name in self.names:
            return self.y[self.names.index(name)]
        if name in self.invariants:
            return self.invariants[name]
        if name in ("t", "energy"):
            return getattr(self, name)
        raise KeyError(name)

    def columns(self) -> dict[str, np.ndarray]:
        """All columns by their names, the time first."""
        return {"t": self.t, **dict(zip(self.names, self.y)), "energy": self.energy,
                **self.invariants}

    def plot(self, *names: str, axes: Any = None) -> Any:
        """Draws columns over the time, all coordinates without names; needs matplotlib.

        Returns the axes. Raises KeyError for a name that is no column.
        """
        import matplotlib.pyplot as plt

        axes = plt.figure().add_subplot() if axes is None else axes
        for name in names or self.names[: len(self.names) // 2]:
            axes.plot(self.t, self[name], label=name)
        axes.set_xlabel("t")
        axes.legend()
        return axes

    def to_xarray(self) -> Any:
        """The table as an `xarray.Dataset` over t; needs xarray."""
        import xarray

        columns = self.columns()
        t = columns.pop("t")
        return xarray.Dataset({name: ("t", values) for name, values in columns.items()},
                              coords={"t": t}, attrs={"method": self.method})

    def save(self, path: os.PathLike[str] | str) -> None:
        """Writes the table: `.csv` with a header, or `.npz` with an array for each column.

        The file is there whole or not at all. Raises ValueError for another ending.
        """
        path = Path(path)
        part = path.with_name(f".{path.name}.{os.getpid()}.part")
        columns = self.columns()
        try:
            with open(part, "xb") as file:
                if path.suffix == ".csv":
                    np.savetxt(file, np.column_stack(list(columns.values())), fmt="%.17g",
                               delimiter=",", header=",".join(columns), comments="")
                elif path.suffix == ".npz":
                    np.savez(file, **columns)
                else:
                    raise ValueError(f"{path.name} ends neither in .csv nor in .npz")
            os.replace(part, path)
        finally:
            part.unlink(missing_ok=True)

    def __repr__(self) -> str:
        return (f"<hvi.Result of {self.method}: {len(self.t)} rows of {', '.join(self.names)}; "
                f"{self.message}>")
