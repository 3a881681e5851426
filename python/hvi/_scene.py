# Scenes: a Hamiltonian or Lagrangian with its start.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import atexit
import functools
import os
import re
import shutil
import tempfile
import types
from pathlib import Path
from typing import Any, Mapping, Sequence

import numpy as np

from . import _gen
from ._ensemble import EnsembleResult, ensemble_of
from ._library import Library
from ._result import Result
from ._run import run
from ._stepper import Stepper
from ._tableau import _method_options, check

_refusal_of_rtol = (
    "rtol and atol would adapt the step to an error, and so lose what a symplectic method keeps; "
    "accuracy=1e-8 looks for a method and a fixed step with that error at the end")


_usual_method = "gauss:4"


class SceneStepper(Stepper):
    """A stepper of a scene. A pickle of it is the scene, the method and the parameters: what steps
    keep, such as remainders of sums, is forgotten as by `reset()`."""

    def __init__(self, scene: "Scene", method: Any, parameters: Mapping[str, Any]):
        self._recipe = (scene, method, dict(parameters))
        super().__init__(scene._library(method), parameters)

    def copy(self) -> "SceneStepper":
        other = super().copy()
        other._recipe = self._recipe
        return other

    def __reduce__(self):
        return SceneStepper, self._recipe


class Scene:
    """A mechanical system that hvi-gen makes steppers of.

    `Scene("kepler")` is one of `hvi-gen list scenes`, `Scene("mine.toml")` a file, and

    >>> import hvi
    >>> pendulum = hvi.Scene(coordinates=["q"], momenta=["p"], hamiltonian="p^2/2 - cos(q)",
    ...                      initial={"q": 1, "p": 0})
    >>> result = pendulum.integrate((0, 10), step=0.1, method="gauss:3")
    >>> bool(abs(result.energy - result.energy[0]).max() < 1e-8)
    True

    one of its own. Momenta without names are `p`, of several coordinates `p_x` or `px`, or `p1` of
    `q1`, as the Hamiltonian has them. Expressions are text or sympy's. Parameters are numbers and expressions; a
    float stands for the decimal that Python prints, so that 0.1 is 1/10. Text with an error raises
    InputError, with a caret below the place, when it is read: at the first use.
    """

    def __init__(self, source: os.PathLike[str] | str | None = None, *,
                 coordinates: Sequence[str] | None = None, momenta: Sequence[str] | None = None,
                 velocities: Sequence[str] | None = None, hamiltonian: Any = None,
                 lagrangian: Any = None,
                 parameters: Mapping[str, Any] | None = None,
                 initial: Mapping[str, Any] | None = None,
                 invariants: Mapping[str, Any] | None = None, method: Any = None,
                 step: Any = None, until: Any = None, name: str = "scene"):
        has_parts = any(part is not None for part in (
            coordinates, momenta, velocities, hamiltonian, lagrangian, parameters, initial,
            invariants))
        if (source is None) == (not has_parts):
            raise TypeError("a scene has a name or a file, or coordinates and a hamiltonian or "
                            "lagrangian")
        self.method = method
        self._file: str | None = None
        self._text: str | None = None
        if source is not None:
            self._file = os.fspath(source)
            self.name = Path(self._file).stem
            if step is not None or until is not None:
                raise TypeError("step and until stand in the scene; integrate() takes others")
            return
        if coordinates is None or (hamiltonian is None) == (lagrangian is None):
            raise TypeError("a scene has coordinates, and one of hamiltonian and lagrangian")
        if (momenta if lagrangian is not None else velocities) is not None:
            raise TypeError("a hamiltonian has momenta, and a lagrangian velocities")
        self.name = name
        of_hamiltonian = hamiltonian is not None
        self._text = _scene_text(
            {"name": name, "coordinates": list(coordinates),
             **({"momenta": list(momenta or _conjugates("p", coordinates, hamiltonian)),
                 "hamiltonian": hamiltonian} if of_hamiltonian else
                {"velocities": list(velocities or _conjugates("v", coordinates, lagrangian)),
                 "lagrangian": lagrangian})},
            {"parameters": parameters, "invariants": invariants, "initial": initial,
             "run": {key: value for key, value in (("step", step), ("until", until))
                     if value is not None}})

    def __repr__(self) -> str:
        return f"<hvi.Scene {self.name}>"

    def __str__(self) -> str:
        """The scene's text, in TOML."""
        return self.text

    @property
    def text(self) -> str:
        """The scene in TOML. Raises InputError where it has no such name or file."""
        return self._text if self._text is not None else _gen.call(["show", str(self._file)])

    def __getstate__(self) -> dict[str, Any]:
        return {"method": self.method, "name": self.name, "_file": self._file, "_text": self._text}

    # ---- steps ----

    def stepper(self, method: Any = None, **parameters: Any) -> SceneStepper:
        """A compiled stepper: its `step(x, h)` and `integrate()` call C.

        `method` is a name (`"gauss:4"`, with a composition `"stormer-verlet+kahan-li:8"`) or a
        dictionary with `basis`, `nodes` and perhaps `weights`; without it that of the scene, and
        where that has none `gauss:4`.
        Keywords are parameters of the scene. Compiling takes seconds once, and is kept. Raises
        InputError, MathError, and OutsideError without a compiler.
        """
        return SceneStepper(self, self._method(method), parameters)

    def _method(self, method: Any) -> Any:
        """The method that is wished for; None where the scene names its own."""
        if method is not None or self.method is not None:
            return method if method is not None else self.method
        names_one = re.search(r"""^\s*["']?method["']?\s*=""", self.text, re.MULTILINE)
        return None if names_one else _usual_method

    def integrate(self, t_span: Sequence[float] | None = None, t_eval: Any = None, *,
                  method: Any = None, step: float | None = None, accuracy: float | None = None,
                  events: Any = None, parameters: Mapping[str, Any] | None = None,
                  initial: Any = None, tangent: bool = False, dense_output: bool = False,
                  every: int | None = None, progress: bool = False, rtol: Any = None,
                  atol: Any = None) -> Result:
        """Integrates the scene over t_span, and returns a Result with scipy's names and more.

        Rows, `events` and `dense_output` are as `Stepper.integrate` has them. `initial` is a state
        in the order of the variables, or a dictionary that changes some of the scene's. With
        `accuracy` a method and a step are looked for that have this relative error at the end, in
        up to a minute. `tangent` adds the derivative of the end by the start, a matrix with a row
        for each variable. Scaled time, scenes with events of their own, `tangent` and `accuracy`
        are runs of hvi-gen: they begin at t = 0 where the scene does, and `t_eval` is evenly
        spaced.
        """
        if rtol is not None or atol is not None:
            raise TypeError(_refusal_of_rtol)
        if accuracy is not None and (method is not None or step is not None):
            raise TypeError("accuracy chooses the method and the step")
        method = self._method(method) if accuracy is None else None
        if tangent or accuracy is not None or self._is_of_runs():
            for name, value in (("events", events), ("initial", initial),
                                ("dense_output", dense_output or None)):
                if value is not None:
                    raise ValueError(f"{name} does not go with tangent, accuracy, or a scene that "
                                     "has a scale of the time or events of its own")
            with self.file() as path:
                return run(path, self.text, t_span, t_eval, _method_options(method), step,
                           accuracy, parameters, tangent, every, progress)
        stepper = self.stepper(method, **(parameters or {}))
        return stepper.integrate(_state(stepper, initial), t_span, step, t_eval=t_eval,
                                 every=every, events=events, dense_output=dense_output,
                                 progress=progress)

    def _is_of_runs(self) -> bool:
        """Whether the scene has a scale of the time, or events."""
        return re.search(r"^\s*\[(time|events)\b", self.text, re.MULTILINE) is not None

    def section(self, zero: Any, t_span: Sequence[float] | None = None, *,
                direction: str = "up", **options: Any) -> np.ndarray:
        """The Poincare section where `zero` vanishes: states, an array (points, variables).

        Keywords are those of `integrate`.
        """
        from ._events import Event

        result = self.integrate(t_span, t_eval=[], events=Event(zero, direction), **options)
        assert result.y_events is not None
        return result.y_events[0]

    def ensemble(self, initial: Any = None, parameters: Any = None,
                 t_span: Sequence[float] | None = None, *, method: Any = None,
                 step: float | None = None, threads: int | None = None) -> EnsembleResult:
        """Integrates many trajectories, and returns where they end.

        `initial` is an array (trajectories, variables), or a data frame or dictionary with columns
        of variables; `parameters` a data frame or dictionary with columns of parameters. What is
        left out is the scene's. A row depends on its own numbers alone, so that its bits are the
        same with any number of threads; a row that fails says so, and ends no other.
        """
        return ensemble_of(self._library(self._method(method)), initial, parameters, t_span, step, threads)

    # ---- what the scene is like ----

    def lyapunov(self, t_span: Sequence[float] | None = None, *, method: Any = None,
                 step: float | None = None, spectrum: bool = False,
                 parameters: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """The largest Lyapunov exponent and MEGNO, or all exponents: `lyapunov` and `megno`.

        `lyapunov` is a number, or with `spectrum` an array from the largest on.
        """
        kind = "spectrum" if spectrum else "largest"
        with self.file() as path:
            result = run(path, self.text, t_span, None, _method_options(self._method(method)),
                         step, None, parameters, False, None, False, [f"--lyapunov={kind}"])
        values = {name: [float(word) for word in re.split(r"[,\s]+", text) if word]
                  for name, text in result.summary.items() if name in ("lyapunov", "megno")}
        exponents = np.array(values.pop("lyapunov"))
        return {"lyapunov": exponents if spectrum else float(exponents[0]),
                **{name: value[0] for name, value in values.items()}}

    def symmetries(self) -> dict[str, Any]:
        """Affine symmetries and their momentum maps, as a dictionary: all there are, proved."""
        with self.file() as path:
            return _gen.call_json(["symmetries", path])

    def check(self, method: Any = None) -> dict[str, Any]:
        """The certificate of a method, as `hvi.check`; of the scene's without a name."""
        method = self._method(method)
        return check(method if method is not None else self.stepper().description.method)

    # ---- what hvi-gen reads ----

    def file(self) -> "_SceneFile":
        """A context: the word or the path under which hvi-gen finds the scene."""
        return _SceneFile(self._file, self._text, self.name)

    def _library(self, method: Any) -> Library:
        key = (self._file, self.text, repr(method))
        if key not in _libraries:
            with self.file() as path:
                _libraries[key] = _compiled(path, method)
        return _libraries[key]


_libraries: dict[Any, Library] = {}


class _SceneFile:
    def __init__(self, file: str | None, text: str | None, name: str):
        self._file, self._scene, self._name = file, text, name
        self._directory: tempfile.TemporaryDirectory[str] | None = None

    def __enter__(self) -> str:
        if self._scene is None:
            assert self._file is not None
            return self._file
        self._directory = tempfile.TemporaryDirectory(prefix="hvi-")
        path = Path(self._directory.name) / f"{self._name}.toml"
        path.write_text(self._scene, encoding="utf-8")
        return str(path)

    def __exit__(self, *_: Any) -> None:
        if self._directory is not None:
            self._directory.cleanup()


@functools.lru_cache(maxsize=None)
def _folder_of_modules() -> str:
    """A folder for packages, gone at the end of the process. NOTE: hvi-gen keeps what it compiles."""
    folder = tempfile.mkdtemp(prefix="hvi-modules-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def _compiled(scene: str, method: Any) -> Library:
    name = f"scene_{len(_libraries)}"
    folder = _folder_of_modules()
    _gen.call(["module", *_method_options(method), "--language", "python", "--name", name, "-o",
               folder, scene])
    return _package(Path(folder) / name)._library


def _package(folder: Path) -> Any:
    """The package that hvi-gen has written, run as a module of this one: it finds `_library` here."""
    path = folder / "__init__.py"
    module = types.ModuleType(f"{__package__}.{folder.name}")
    module.__file__, module.__package__ = str(path), __package__
    exec(compile(path.read_text(encoding="utf-8"), path, "exec"), module.__dict__)
    return module


def _conjugates(letter: str, coordinates: Sequence[str], function: Any) -> list[str]:
    """Names of momenta or velocities where nobody gives them: those that the function has.

    Of q they are p, p_q, pq, and of q1 also p1.
    """
    words = set(re.findall(r"\w+", _gen.exact_text(function)))
    several = [[f"{letter}_{q}" for q in coordinates], [f"{letter}{q}" for q in coordinates],
               [letter + re.sub(r"^\D+", "", q) for q in coordinates]]
    choices = [[letter]] + several if len(coordinates) == 1 else several
    fitting = [names for names in choices if words & set(names) and len(set(names)) == len(names)]
    return (fitting or choices)[0]


def _state(stepper: Stepper, initial: Any) -> Any:
    if not isinstance(initial, Mapping):
        return initial
    state = stepper.initial()
    for name, value in initial.items():
        if name not in stepper.variables:
            raise ValueError(f"there is no variable {name!r}, but {', '.join(stepper.variables)}")
        state[stepper.variables.index(name)] = float(value)
    return state


def _toml(value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(each) for each in value) + "]"
    text = _gen.exact_text(value)
    return '"' + "".join(_escaped(letter) for letter in text) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return "\\" + letter
    return f"\\u{ord(letter):04x}" if ord(letter) < 0x20 or ord(letter) == 0x7f else letter


def _scene_text(top: Mapping[str, Any], tables: Mapping[str, Mapping[str, Any] | None]) -> str:
    lines = [f"{key} = {_toml(value)}" for key, value in top.items()]
    for table, entries in tables.items():
        if entries:
            lines += ["", f"[{table}]"]
            lines += [f"{_toml(key)} = {_toml(value)}" for key, value in entries.items()]
    return "\n".join(lines) + "\n"
