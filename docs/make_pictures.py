"""Draw the pictures of the pages in this folder, each by the code that stands above it.

    python docs/make_pictures.py

A picture belongs to the block of code just before it. The block runs on a screen of its own, after
`from bgi import *` and `initgraph(VGA, VGAHI)`, and what it leaves there is saved: the upper left
part, as far as something is drawn. So a page cannot show what its code does not draw.
"""

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import bgi
from bgi.graphics import current

DOCS = Path(__file__).parent
PICTURES = DOCS / "pictures"
LEAST_WIDTH, MARGIN = 400, 12

_BLOCK = re.compile(
    r"```python\n(?P<code>.*?)```\n"  # a block of code
    r"(?:\n!\[[^]]*\]\(pictures/(?P<picture>[\w-]+\.png)\))?",  # and perhaps its picture
    re.DOTALL,
)


def pages() -> list[Path]:
    """The pages whose code runs on an open screen."""
    return [
        page
        for page in sorted(DOCS.glob("*.md"))
        if "`from bgi import *` and `initgraph(VGA, VGAHI)`" in page.read_text("utf-8")
    ]


def blocks(page: Path) -> Iterator[tuple[str, str | None]]:
    """The blocks of code of a page, each with the name of its picture if it has one."""
    for found in _BLOCK.finditer(page.read_text("utf-8")):
        yield found["code"], found["picture"]


def run(code: str) -> None:
    """Run a block on a fresh screen, which stays open."""
    bgi.closegraph()
    names = {name: getattr(bgi, name) for name in bgi.__all__}
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    exec(code, names)


def save(file: Path) -> None:
    """Save the page that is shown, as far as something is drawn."""
    bgi.setactivepage(bgi.getvisualpage())
    down, across = np.nonzero(current.screen.page.array)
    right = max(LEAST_WIDTH - 1, int(across.max()) + MARGIN)
    bgi.writeimagefile(file, 0, 0, right, int(down.max()) + MARGIN)


def main(folder: Path = PICTURES) -> list[str]:
    """Draw all pictures; returns their names."""
    os.environ.update(BGI_MONITOR="none", BGI_KEYS="Space " * 9)
    drawn = []
    for page in pages():
        for code, picture in blocks(page):
            if picture is not None:
                run(code)
                save(folder / picture)
                drawn.append(picture)
    bgi.closegraph()
    return drawn


if __name__ == "__main__":
    print(f"{len(main(*map(Path, sys.argv[1:])))} pictures")
