"""Write the lessons of the course as notebooks, for Jupyter and its like.

    python -m tools.notebooks [folder]

Each page becomes a notebook, such as 02-lines.ipynb: its text, and its code in cells that show what
they draw. The file squares.py is laid beside them.
"""

import json
import re
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tools import pictures

FIRST = """\
import os

os.environ["BGI_MONITOR"] = "none"  # no window: each cell shows its picture

from bgi import *
from bgi import current
"""
EACH = "initgraph(VGA, VGAHI)\n{}\ncurrent.screen"
"""A cell begins with an empty screen, and ends with its picture."""

_CODE = re.compile(r"^```python\n(.*?)^```\n", re.DOTALL | re.MULTILINE)
_PICTURE = re.compile(r"^!\[[^]]*\]\([^)]*\)\n\n?", re.MULTILINE)
_LINK = re.compile(r"\[([^]]*)\]\((?!https:)[^)]*\)")
"""To what is not beside the notebook."""

Cell = dict[str, Any]


def notebook(page: Path) -> dict[str, Any]:
    """A lesson in the notebooks' format, nbformat 4."""
    text = page.read_text("utf-8").rpartition("\n\n")[0]  # without the line that leads on
    cells = [_code_cell(FIRST)]
    for number, part in enumerate(_CODE.split(text)):
        cells += [_code_cell(EACH.format(part.rstrip("\n")))] if number % 2 else _prose(part)
    metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    named = [{"id": f"cell-{number}", **cell} for number, cell in enumerate(cells)]
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": metadata, "cells": named}


def _code_cell(code: str) -> Cell:
    source = code.rstrip("\n").splitlines(keepends=True)
    nothing: dict[str, Any] = {"metadata": {}, "execution_count": None, "outputs": []}
    return {"cell_type": "code", "source": source, **nothing}


def _prose(text: str) -> Iterator[Cell]:
    """The text between two pieces of code, if there is any but a picture."""
    words = _LINK.sub(r"\1", _PICTURE.sub("", text)).strip("\n")
    if words:
        source = words.splitlines(keepends=True)
        yield {"cell_type": "markdown", "source": source, "metadata": {}}


def main(folder: Path = Path("notebooks")) -> None:
    """Write all of them."""
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(pictures.COURSE / "squares.py", folder)
    for page in sorted((pictures.DOCS / "course").glob("[0-9][0-9]-*.md")):
        file = folder / f"{page.stem}.ipynb"
        written = json.dumps(notebook(page), indent=1, ensure_ascii=False)
        file.write_text(written + "\n", encoding="utf-8", newline="\n")
        print(file)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
