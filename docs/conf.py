# How Sphinx makes the manual of these pages; ./dev docs calls it.
# SPDX-License-Identifier: GPL-2.0-or-later
import pathlib
import re
import subprocess

root = pathlib.Path(__file__).resolve().parent.parent

project = "hvi"
author = copyright = "the authors of hvi"
release = re.search(r"project\(hvi VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())[1]

# NOTE: pages are Markdown as a forge shows it; directives of Sphinx stand in index.md and
# reference.md alone.
extensions = ["myst_parser", "breathe"]
myst_heading_anchors = 3
highlight_language = "none"

html_theme = "furo"
html_title = f"hvi {release}"
html_copy_source = False

# Pages that one looks something up in, beside the man page that hvi-gen writes of itself.
man_pages = [
    (page, f"hvi-{page}", what, author, 7)
    for page, what in {
        "tutorial": "ten minutes with a pendulum",
        "choosing": "how to choose a method and a step",
        "limits": "what hvi does, what it does not, and what to use in place",
        "scene-files": "the files that describe systems",
        "errors": "messages of hvi-gen and statuses of steps",
    }.items()
]

breathe_default_project = "hvi"

# What Doxygen makes of the headers that users include. NOTE: a heading in a docstring would be a
# section of the page.
doxyfile = """
PROJECT_NAME = hvi
INPUT = {headers}
OUTPUT_DIRECTORY = {output}
INPUT_FILTER = "sed -e 's|^/// # Use|///\\n/// **Use.**|'"
EXCLUDE_SYMBOLS = hvi::detail hvi::detail::*
ENABLE_PREPROCESSING = YES
SEARCH_INCLUDES = NO
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_AS_ERROR = YES
"""


def read_headers(app):
    output = pathlib.Path(app.doctreedir).parent / "doxygen"
    output.mkdir(parents=True, exist_ok=True)
    headers = sorted((root / "src/hvi").glob("*.hpp"))
    for name in ("run", "trajectories/event"):  # hvi::Run, hvi::Event
        headers.append(root / f"src/hvi/detail/{name}.hpp")
    headers = " ".join(f'"{path}"' for path in headers)
    subprocess.run(["doxygen", "-"], input=doxyfile.format(headers=headers, output=output),
                   text=True, check=True)
    app.config.breathe_projects = {"hvi": str(output / "xml")}


def setup(app):
    # NOTE: before breathe looks for its projects.
    app.connect("builder-inited", read_headers, priority=100)
