"""Runs the examples of the gallery, and writes a page with a picture for each.

    python3 make.py DIRECTORY [NAME...]
    python3 make.py DIRECTORY --compare PAGES [NAME...]

An example is a file beside this one, of Python or a shell script. It begins with a title and what is
to be seen: in its docstring, or in comments. Python draws one picture with matplotlib.pyplot; a script
writes the pictures that its text shows. Each runs in an empty directory. Pages are Markdown; `index.md`
shows them all, and is written where no NAME chooses some. With --compare the status is 1, too, where a
page differs from the one in PAGES.
"""
import argparse
import ast
import contextlib
import re
import runpy
import shutil
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

here = Path(__file__).resolve().parent
sources = sorted(each for each in here.iterdir()
                 if each.suffix in (".py", ".sh") and each.name != Path(__file__).name)


def parts(source):
    """Returns the title of an example, what is to be seen with its pictures, and its code."""
    lines = source.read_text(encoding="utf-8").splitlines()
    if source.suffix == ".py":
        tree = ast.parse("\n".join(lines))
        end, text = tree.body[0].end_lineno, ast.get_docstring(tree)
    else:
        end = next(k for k, line in enumerate(lines) if not line.startswith("#"))
        text = "\n".join(line[2:] for line in lines[:end] if "SPDX" not in line).strip()
    title, _, seen = text.partition("\n\n")
    if source.suffix == ".py":
        seen += f"\n\n![{title}]({source.stem}.png)"
    return title, seen, "\n".join(lines[end:]).strip()


def pictures(source):
    """Returns the names of the pictures of an example."""
    return re.findall(r"!\[[^]]*\]\(([^)]+)\)", parts(source)[1])


def page(source):
    title, seen, code = parts(source)
    language = "python" if source.suffix == ".py" else "sh"
    return f"# {title}\n\n{seen}\n\n```{language}\n{code}\n```\n"


def index():
    """Returns the page of all examples: pictures in rows of three, each with its title."""
    cells = []
    for source in sources:
        title = parts(source)[0]
        cells.append(f"[![{title}]({pictures(source)[0]})<br>{title}]({source.stem}.md)")
    cells += [""] * (-len(cells) % 3)
    rows = ["| " + " | ".join(cells[k:k + 3]) + " |" for k in range(0, len(cells), 3)]
    names = "\n".join(source.stem for source in sources)
    return ("# Gallery\n\nThese examples are complete: each runs as it stands, with the package `hvi` of "
            "[Python](../python.md)\nor in a shell. Their files are in `examples/gallery`.\n\n"
            "| | | |\n| :---: | :---: | :---: |\n" + "\n".join(rows) +
            f"\n\n```{{toctree}}\n:hidden:\n\n{names}\n```\n")


def draw_in_python(source):
    """Runs an example, and saves what it draws."""
    plt.close("all")
    plt.rcParams.update({"figure.figsize": (6, 4.5), "figure.autolayout": True, "savefig.dpi": 80})
    runpy.run_path(str(source), run_name="__main__")
    if not plt.gcf().axes:
        raise ValueError("the example draws nothing")
    plt.savefig(pictures(source)[0], metadata={"Software": None})


def draw(source, output):
    """Runs an example in an empty directory, and takes its pictures out of it."""
    with tempfile.TemporaryDirectory() as directory, contextlib.chdir(directory):
        if source.suffix == ".py":
            draw_in_python(source)
        else:
            subprocess.run(["sh", "-eu", source], check=True)
        for name in pictures(source):
            shutil.copy(name, output)


def write(path, text, pages):
    """Writes a page; returns whether the one of the same name in `pages` has this text, too."""
    path.write_text(text, encoding="utf-8")
    if pages is None or (pages / path.name).is_file() and (pages / path.name).read_text("utf-8") == text:
        return True
    print(f"{pages / path.name} is not what {path} is: build the target update-gallery", file=sys.stderr)
    return False


def main():
    parser = argparse.ArgumentParser(description="Make the gallery.")
    parser.add_argument("directory", type=Path)
    parser.add_argument("--compare", type=Path, metavar="PAGES")
    parser.add_argument("names", nargs="*", metavar="NAME")
    words = parser.parse_intermixed_args()
    for name in words.names:
        if name not in [source.stem for source in sources]:
            parser.error(f"there is no example {name}")
    output, pages = words.directory.resolve(), words.compare and words.compare.resolve()
    output.mkdir(parents=True, exist_ok=True)
    chosen = [source for source in sources if not words.names or source.stem in words.names]
    good = bool(words.names) or write(output / "index.md", index(), pages)
    for source in chosen:
        print(source.stem, flush=True)
        try:
            draw(source, output)
        except Exception:
            traceback.print_exc()
            good = False
        good = write(output / f"{source.stem}.md", page(source), pages) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
