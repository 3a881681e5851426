# Runs of hvi-gen: where the time is scaled, events are the scene's, or derivatives are wished for.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import csv
import re
import tempfile
from pathlib import Path
from typing import Any, Mapping, Sequence

import numpy as np

from . import _gen
from ._result import Result


def run(scene: str, text: str, t_span: Sequence[float] | None, t_eval: Any,
        method: Sequence[str], step: float | None, accuracy: float | None,
        parameters: Mapping[str, Any] | None, tangent: bool, every: int | None, progress: bool,
        more: Sequence[str] = ()) -> Result:
    """Calls `hvi-gen run`, and reads its files. Raises what its exit status means; a run that
    stopped early is a Result with success False."""
    words = ["run", *method, *_gen.parameter_options(parameters), *more]
    if t_span is not None:
        if float(t_span[0]) != 0:
            raise ValueError("this run begins at t = 0")
        words += ["--until", _gen.exact_text(t_span[1])]
    if step is not None:
        words += ["--step", _gen.exact_text(step)]
    if accuracy is not None:
        words += ["--accuracy", _gen.exact_text(accuracy)]
    if t_eval is not None:
        words += ["--times", _evenly(t_eval)]
    if every is not None:
        words += ["--every", str(every)]
    if tangent:
        words += ["--tangent"]
    with tempfile.TemporaryDirectory(prefix="hvi-run-") as folder:
        output = Path(folder) / "run"
        _gen.call([*words, "--only", "table,summary", "--format", "npy", "-o", str(output), scene],
                  progress, may_stop=True)
        return _result(output, _events_in(text))


def _evenly(times: Any) -> str:
    times = np.array(times, dtype=float).ravel()
    if times.size < 2 or not np.allclose(np.diff(times), (times[-1] - times[0]) / (times.size - 1),
                                         rtol=1e-9, atol=0):
        raise ValueError("t_eval of this run is evenly spaced: numpy.linspace(first, last, count)")
    return f"{times[0]!r}:{times[-1]!r}:{times.size}"


def _events_in(text: str) -> list[str]:
    """Names of the scene's events, in their order."""
    return re.findall(r"""^\s*\[events\.["']?([^\]"']+)["']?\]""", text, re.MULTILINE)


def _result(output: Path, events: list[str]) -> Result:
    table = np.load(output / "trajectory.npy", allow_pickle=False)
    summary = _summary(output / "summary.txt")
    names = list(table.dtype.names)
    end = names.index("energy") if "energy" in names else len(names)
    variables = names[1:end]
    y = np.array([table[name] for name in variables])
    failed = next((summary[key] for key in ("stopped", "incomplete") if key in summary), None)
    result = Result(
        t=np.array(table["t"]), y=y, names=variables,
        energy=np.array(table["energy"]) if "energy" in names else np.full(len(table), np.nan),
        invariants={name: np.array(table[name]) for name in names[end + 1:]},
        status=-1 if failed else 0, message=failed or "the end was reached",
        steps=int((re.findall(r"\d+", summary.get("steps", "")) or ["0"])[0]),
        nfev=int((re.findall(r"(\d+) in all", summary.get("evaluations", "")) or ["0"])[0]),
        method=summary.get("method", ""), summary=summary)
    if events:
        result.t_events, result.y_events = _events(output / "events.csv", events, len(variables))
    if (output / "tangent.csv").exists():
        result.tangent = np.loadtxt(output / "tangent.csv", delimiter=",", ndmin=2)
    return result


def _summary(path: Path) -> dict[str, str]:
    """Lines of the summary: a word, and what is said of it."""
    lines = (line.split(None, 1) for line in path.read_text(encoding="utf-8").splitlines())
    return {words[0]: words[1] for words in lines if len(words) == 2}


def _events(path: Path, names: list[str], size: int) -> tuple[list[np.ndarray], list[np.ndarray]]:
    found: dict[str, list[list[float]]] = {name: [] for name in names}
    if path.exists():
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                event = row.pop("event")
                row.pop("number")
                found.setdefault(event, []).append([float(value) for value in row.values()])
    tables = [np.array(found[name]).reshape(len(found[name]), 1 + size) for name in names]
    return [table[:, 0] for table in tables], [table[:, 1:] for table in tables]
