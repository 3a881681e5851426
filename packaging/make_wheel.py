"""Makes the wheel of the package `hvi` with hvi-gen inside.

usage: make_wheel.py CHECKOUT HVI-GEN DIRECTORY [LICENCE]

Works in a copy, so that the checkout stays as it is; needs no network where setuptools and wheel are.
The name of the wheel says on which systems hvi-gen runs: manylinux_2_N, for every Linux of this
machine's kind with glibc 2.N, where it needs nothing but glibc; else this one alone. LICENCE is a
file with those of the libraries that are in hvi-gen.
"""
# SPDX-License-Identifier: GPL-2.0-or-later
import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

of_glibc = {"libc", "libm", "libpthread", "libdl", "librt", "ld-linux-x86-64", "ld-linux-aarch64"}


def told_by_readelf(option, program):
    return subprocess.run(["readelf", option, "--wide", program], check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, "LC_ALL": "C"}).stdout


def system_of(program):
    """The last part of the name of a wheel that has this program."""
    machine = platform.machine()
    needed = re.findall(r"\(NEEDED\).*\[([^]]+?)\.so", told_by_readelf("--dynamic", program))
    versions = re.findall(r"\bGLIBC_(\d+)\.(\d+)", told_by_readelf("--version-info", program))
    if not versions or not set(needed) <= of_glibc:
        return f"linux_{machine}"
    major, minor = max((int(major), int(minor)) for major, minor in versions)
    return f"manylinux_{major}_{minor}_{machine}"


def stage(checkout, program, licences, copy):
    """A copy of what the wheel is made of, with modes that do not depend on the user's umask."""
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(checkout / "python", copy / "python",
                    ignore=shutil.ignore_patterns("__pycache__", "build", "dist", "*.egg-info", "bin"))
    shutil.copy(checkout / "CMakeLists.txt", copy)
    inside = copy / "python/hvi/bin/hvi-gen"
    inside.parent.mkdir()
    subprocess.run(["strip", "-o", inside, program], check=True)
    # setuptools takes LICENSE* along. The package alone is MIT, the program is not.
    for licence in licences:
        name = "LICENSE" if licence.stem == "LICENSE" else f"LICENSE.{licence.name}"
        shutil.copy(licence, copy / "python" / name)
    settings = copy / "python/pyproject.toml"
    text = settings.read_text(encoding="utf-8")
    settings.write_text(text.replace('{text = "MIT"}', '{text = "MIT AND GPL-2.0-or-later"}'),
                        encoding="utf-8")
    for path in copy.rglob("*"):
        path.chmod(0o755 if path.is_dir() or path == inside else 0o644)


def main():
    checkout, program, out, *linked = (Path(argument).resolve() for argument in sys.argv[1:])
    copy = out / "copy"
    licences = [checkout / "LICENSE", *sorted((checkout / "LICENSES").iterdir()), *linked]
    stage(checkout, program, licences, copy)
    for old in out.glob("*.whl"):
        old.unlink()
    os.chdir(copy / "python")
    sys.path.insert(0, os.getcwd())
    import build_wheel
    missing = build_wheel.get_requires_for_build_wheel()
    if missing:
        sys.exit(f"error: this Python has no {' and no '.join(missing)}\n"
                 "help: `apt-get install python3-setuptools python3-wheel` installs them")
    options = {"--global-option": ["--quiet"],
               "--build-option": [f"--plat-name={system_of(program)}"]}
    print(out / build_wheel.build_wheel(str(out), options))
    shutil.rmtree(copy)


if __name__ == "__main__":
    main()
