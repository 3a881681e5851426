"""Runs the examples of the gallery, and writes a page with a picture for each.

    python3 make.py DIRECTORY [NAME...]

An example is a file beside this one: its docstring is a title and what is to be seen, its code draws
with matplotlib.pyplot. Pages are Markdown; `index.md` shows them all. The status is 1 where an example
fails, and the other pages are written all the same.
"""
import ast
import os
import runpy
import sys
import time
import traceback
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

here = Path(__file__).resolve().parent


def draw(source, output):
    """Runs an example in the directory, and saves what it draws under its name."""
    plt.close("all")
    plt.rcParams.update({"figure.figsize": (6, 4.5), "figure.autolayout": True, "savefig.dpi": 110})
    runpy.run_path(str(source), run_name="__main__")
    plt.savefig(output / f"{source.stem}.png", metadata={"Software": None})


def page(source, output):
    """Writes the page of an example; returns its line of the index."""
    text = source.read_text(encoding="utf-8")
    tree = ast.parse(text)
    title, _, seen = ast.get_docstring(tree).partition("\n\n")
    code = "\n".join(text.splitlines()[tree.body[0].end_lineno:]).strip()
    (output / f"{source.stem}.md").write_text(
        f"# {title}\n\n{seen}\n\n![{title}]({source.stem}.png)\n\n```python\n{code}\n```\n",
        encoding="utf-8")
    return f"| [{title}]({source.stem}.md) | ![]({source.stem}.png) |\n"


def main(directory, *names):
    output = Path(directory).resolve()
    output.mkdir(parents=True, exist_ok=True)
    os.chdir(output)
    sources = sorted(each for each in here.glob("*.py") if each.name != Path(__file__).name)
    lines, failed = [], []
    for source in sources:
        if names and source.stem not in names:
            continue
        began = time.perf_counter()
        try:
            draw(source, output)
        except Exception:
            failed.append(source.stem)
            traceback.print_exc()
        lines.append(page(source, output))
        print(f"{source.stem}: {time.perf_counter() - began:.1f} s", flush=True)
    head = "# Gallery\n\nEach example is complete: it runs as it stands.\n\n| | |\n| --- | --- |\n"
    (output / "index.md").write_text(head + "".join(lines), encoding="utf-8")
    if failed:
        print("failed: " + ", ".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
