# Calls of hvi-gen.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any, Sequence

from ._errors import OutsideError, raised


def program() -> str:
    """The path of hvi-gen: that of HVI_GEN, else that of the wheel, else the first on PATH.

    Raises OutsideError where there is none.
    """
    named = os.environ.get("HVI_GEN")
    inside = Path(__file__).parent / "bin" / "hvi-gen"
    found = named or (str(inside) if inside.exists() else shutil.which("hvi-gen"))
    if not found:
        raise OutsideError("hvi-gen is not on PATH, and HVI_GEN does not name it\n"
                           "help: `./dev demo` in a checkout of hvi builds it and says where it is")
    return found


def call(arguments: Sequence[str], progress: bool = False, may_stop: bool = False) -> str:
    """Calls hvi-gen, and returns what it writes to standard output.

    `progress` lets its messages through to the terminal. `may_stop`: the status 1 with results, of
    a run that stopped early, is no error. Raises what an exit status means.
    """
    try:
        done = subprocess.run([program(), *arguments], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=None if progress else subprocess.PIPE,
                              text=True, encoding="utf-8", errors="replace", check=False)
    except OSError as error:
        raise OutsideError(f"hvi-gen cannot be called: {error}") from error
    if done.returncode == 130:
        raise KeyboardInterrupt
    if done.returncode != 0 and not (may_stop and done.returncode == 1 and done.stdout):
        raise raised(done.returncode, done.stderr or "")
    return done.stdout


def call_json(arguments: Sequence[str]) -> Any:
    """Calls hvi-gen, and reads the JSON that it writes."""
    return json.loads(call([*arguments, "--format", "json"]))


def parameter_options(parameters: Any) -> list[str]:
    """`--param NAME=VALUE` for each; a float stands for the decimal that Python prints."""
    options = []
    for name, value in (parameters or {}).items():
        options += ["--param", f"{name}={exact_text(value)}"]
    return options


def exact_text(value: Any) -> str:
    """A number, an expression or a sympy expression as hvi-gen reads it."""
    if isinstance(value, str):
        return value
    if hasattr(value, "free_symbols"):
        from ._sympy import text_of
        return text_of(value)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{value!r} is neither a number nor an expression")
    return str(value) if hasattr(value, "denominator") else repr(float(value))
