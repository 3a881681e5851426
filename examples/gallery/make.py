"""Runs the examples of the gallery, and writes a page with a picture for each.

    python3 make.py DIRECTORY [NAME...]
    python3 make.py DIRECTORY --compare PAGES [NAME...]

An example is a file beside this one: its docstring is a title and what is to be seen, its code draws
with matplotlib.pyplot. Pages are Markdown; `index.md` shows them all, and is written where no NAME
chooses some. With --compare the status is 1, too, where a page differs from the one in PAGES.
"""
import argparse
import ast
import os
import runpy
import sys
import traceback
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

here = Path(__file__).resolve().parent
sources = sorted(each for each in here.glob("*.py") if each.name != Path(__file__).name)


def parts(source):
    """Returns the title of an example, what is to be seen, and its code."""
    text = source.read_text(encoding="utf-8")
    tree = ast.parse(text)
    title, _, seen = ast.get_docstring(tree).partition("\n\n")
    return title, seen, "\n".join(text.splitlines()[tree.body[0].end_lineno:]).strip()


def page(source):
    title, seen, code = parts(source)
    return f"# {title}\n\n{seen}\n\n![{title}]({source.stem}.png)\n\n```python\n{code}\n```\n"


def index():
    """Returns the page of all examples: pictures in rows of three, each with its title."""
    cells = []
    for source in sources:
        title = parts(source)[0]
        cells.append(f"[![{title}]({source.stem}.png)<br>{title}]({source.stem}.md)")
    cells += [""] * (-len(cells) % 3)
    rows = ["| " + " | ".join(cells[k:k + 3]) + " |" for k in range(0, len(cells), 3)]
    names = "\n".join(source.stem for source in sources)
    return ("# Gallery\n\nThese examples are complete: each runs as it stands, with the package `hvi` of "
            "[Python](../python.md).\nTheir files are in `examples/gallery`.\n\n"
            "| | | |\n| :---: | :---: | :---: |\n" + "\n".join(rows) +
            f"\n\n```{{toctree}}\n:hidden:\n\n{names}\n```\n")


def draw(source, output):
    """Runs an example in the directory, and saves what it draws under its name."""
    plt.close("all")
    plt.rcParams.update({"figure.figsize": (6, 4.5), "figure.autolayout": True, "savefig.dpi": 80})
    runpy.run_path(str(source), run_name="__main__")
    if not plt.gcf().axes:
        raise ValueError("the example draws nothing")
    plt.savefig(output / f"{source.stem}.png", metadata={"Software": None})


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
    os.chdir(output)
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
