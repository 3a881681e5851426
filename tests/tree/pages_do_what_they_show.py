#!/usr/bin/env python3
# Runs the commands that a page of the manual shows, one after the other in an empty directory, and
# compares what they print with what the page says.
# SPDX-License-Identifier: GPL-2.0-or-later
"""
pages_do_what_they_show.py PAGE --root CHECKOUT --hvi-gen PROGRAM --directory EMPTY [--update]

Blocks between fences, in the order of the page:

  any, with a name   the first line is a comment that is a file's name, `# swing.toml` or `// main.cpp`:
                     the block is written to it; `# added to swing.toml` adds to its end
  sh                 commands, which have to end with status 0
  console            lines after `$ ` are commands, what follows is all that they print, with standard
                     error; a line `...` stands for any lines. Their status is 0, unless a line of
                     this begins with `error: `
  all else           is read by people alone

A block behind a line `<!-- not run: REASON -->` is not looked at. Programs find hvi-gen, the package of
Python, and the headers in ~/.local/include, as if hvi were installed; `examples` is the one of the checkout.

What is printed has the same words as the page. Times may be any: a number before ns, us, ms or s.
Other numbers depend on the processor in their last digits. They agree to a hundredth, those with an
exponent, as errors have, within a factor of ten.

--update writes what was printed into the blocks of the page that have no line `...`.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

NAMED = re.compile(r"(?:#|//|/\*) (added to )?([\w.-]+\.\w+)(?: \*/)?")
NOT_RUN = re.compile(r"<!-- not run: .+ -->")
NUMBER = re.compile(r"([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)")
TIME = re.compile(r"\d+(\.\d+)?(e[-+]\d+)? (ns|us|ms|s)\b")

PROGRESS = re.compile(r"hvi-gen: [\w ']+ \(\d+ s\)")


class Fault(Exception):
    pass


class Block:
    def __init__(self, language, line):
        self.language, self.line, self.lines = language, line, []


def blocks_of(text):
    """The blocks that are looked at, each with the number of its first line in the page."""
    result, block, before, is_run = [], None, "", True
    for number, line in enumerate(text.split("\n")):
        if block is None and line.startswith("```"):
            block = Block(line[3:].strip(), number + 1)
            is_run = not NOT_RUN.fullmatch(before)
        elif block is not None and line == "```":
            if is_run:
                result.append(block)
            block = None
        elif block is not None:
            block.lines.append(line)
        before = line
    return result


def indented(text):
    """The lines where blocks begin that have no fences."""
    result, is_fenced, before = [], False, ""
    for number, line in enumerate(text.split("\n"), 1):
        is_fenced ^= line.lstrip().startswith("```")
        if not is_fenced and not before and line.startswith("    "):
            result.append(number)
        before = line
    return result


def alike(shown, printed):
    """Whether two numbers are the same but for what the processor makes of them."""
    a, b = float(shown), float(printed)
    if "e" in shown + printed:
        return max(abs(a), abs(b)) <= 10 * min(abs(a), abs(b)) or max(abs(a), abs(b)) < 1e-12
    return abs(a - b) <= 1e-2 * abs(a)


def same_line(shown, printed):
    parts = [NUMBER.split(" ".join(TIME.sub("TIME", line).split())) for line in (shown, printed)]
    if len(parts[0]) != len(parts[1]):
        return False
    return all(a == b or (i % 2 == 1 and alike(a, b)) for i, (a, b) in enumerate(zip(*parts)))


def matches(shown, printed):
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and same_line(shown[0], printed[0]) and matches(shown[1:], printed[1:])


def stripped(lines):
    """Without blanks at the ends of lines, and blank lines at the end."""
    return "\n".join(line.rstrip() for line in lines).rstrip("\n").split("\n")


def sessions(block):
    """Of a block `console` the lines of each command, and those below it."""
    result = []
    for line in block.lines:
        if line.startswith("$ "):
            result.append(([line], []))
        elif not result:
            raise Fault("begins with no line `$ COMMAND`")
        elif not result[-1][1] and result[-1][0][-1].endswith("\\"):
            result[-1][0].append(line)
        else:
            result[-1][1].append(line)
    return result


class Page:
    def __init__(self, arguments):
        self.path = arguments.page
        self.text = self.path.read_text()
        self.directory = arguments.directory / "here"
        self.environment = environment(arguments)
        self.changes = []

    def command(self, words):
        done = subprocess.run(["bash", "-euc", words], cwd=self.directory,
                              env=self.environment, stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        printed = done.stdout.rstrip("\n").split("\n") if done.stdout else []
        return done.returncode, [line for line in printed if not PROGRESS.fullmatch(line)]

    def write(self, block):
        """Whether the block is a file, which is there then."""
        named = NAMED.fullmatch(block.lines[0]) if block.lines else None
        if not named or block.language in ("sh", "console"):
            return False
        lines = block.lines[1:] if named[1] else block.lines
        with open(self.directory / named[2], "a" if named[1] else "w") as file:
            file.write("".join(line + "\n" for line in lines))
        return True

    def run(self, block):
        status, printed = self.command("\n".join(block.lines))
        if status != 0:
            raise Fault("ends with status %d:\n%s" % (status, "\n".join(printed)))

    def compare(self, block):
        faults, seen = [], []
        for words, shown in sessions(block):
            status, printed = self.command("\n".join(words)[2:])
            seen += words + (shown if "..." in shown else printed)
            if (status != 0) != any(line.startswith("error: ") for line in printed):
                faults.append("ends with status %d:\n%s" % (status, "\n".join(printed)))
            elif not matches(stripped(shown), stripped(printed)):
                faults.append("has the lines\n\n%s\n\nbut `%s` prints\n\n%s"
                              % ("\n".join(shown), "\n".join(words)[2:], "\n".join(printed)))
        if faults:
            self.changes.append((block, seen))
            raise Fault("\n".join(faults))

    def look(self):
        faults = ["%s:%d: a block by indentation, where fences are wanted" % (self.path, line)
                  for line in indented(self.text)]
        for block in blocks_of(self.text):
            try:
                if self.write(block):
                    continue
                if block.language == "sh":
                    self.run(block)
                if block.language == "console":
                    self.compare(block)
            except Fault as fault:
                faults.append("%s:%d: the block %s" % (self.path, block.line + 1, fault))
        return faults


def environment(arguments):
    """What commands find: a home in which hvi is installed, and an empty directory to be in."""
    place = arguments.directory
    shutil.rmtree(place, ignore_errors=True)
    include, programs = place / "home/.local/include/hvi", place / "home/.local/bin"
    for directory in (include, programs, place / "here"):
        directory.mkdir(parents=True)
    for file in (arguments.root / "src/hvi").iterdir():
        (include / file.name).symlink_to(file)
    (include / "generated").symlink_to(arguments.root / "generated/hvi/generated")
    (programs / "hvi-gen").symlink_to(arguments.hvi_gen)
    (programs / "python3").symlink_to(sys.executable)
    (place / "here/examples").symlink_to(arguments.root / "examples")
    path = [str(programs), "/usr/lib/ccache", os.environ["PATH"]]
    return {**os.environ, "HOME": str(place / "home"), "PATH": ":".join(path), "LC_ALL": "C.UTF-8",
            "COLUMNS": "100", "PYTHONPATH": str(arguments.root / "python"),
            "PYTHONDONTWRITEBYTECODE": "1", "XDG_CACHE_HOME": str(place / "home/.cache")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page", type=pathlib.Path)
    for option in ("--root", "--hvi-gen", "--directory"):
        parser.add_argument(option, type=lambda word: pathlib.Path(word).resolve(), required=True)
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    page = Page(arguments)
    faults = page.look()
    if arguments.update:
        lines = page.text.split("\n")
        for block, seen in reversed(page.changes):
            lines[block.line:block.line + len(block.lines)] = seen
        page.path.write_text("\n".join(lines))
    for fault in faults:
        print(fault + "\n")
    are_mended = arguments.update and len(faults) == len(page.changes)
    return 0 if are_mended or not faults else 1


if __name__ == "__main__":
    sys.exit(main())
