# Reports: error against run time, and how methods behave at the edges.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
from pathlib import Path
from typing import Sequence

from . import _gen


def report(*scenes: str, methods: Sequence[str] | str | None = None,
           output: os.PathLike[str] | str = "report", only: Sequence[str] = (),
           progress: bool = False) -> Path:
    """Writes the report of hvi-gen on scenes to a folder, and returns the path of report.html.

    It takes minutes. Raises InputError and OutsideError.
    """
    words = ["report", "-o", os.fspath(output)]
    if methods is not None:
        words += ["--methods", methods if isinstance(methods, str) else ", ".join(methods)]
    if only:
        words += ["--only", ",".join(only)]
    _gen.call([*words, *scenes], progress)
    return Path(output) / "report.html"
