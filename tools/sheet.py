"""Write the one-page sheet of all calls, to be printed: docs/sheet.html.

    python -m tools.sheet

What is on it follows from the package: its names by topic as `bgi.__all__` has them, the first
sentence of each docstring, and the tables of colours, patterns and modes. A browser prints it on
one side of A4.
"""

import base64
import re
import tempfile
from collections.abc import Callable, Iterator
from html import escape
from itertools import groupby
from pathlib import Path

import bgi
from bgi.kernel import modes
from bgi.memory.rgb import SIXTEEN
from tools import a_to_z

FILE = a_to_z.DOCS / "sheet.html"

LEFT_OUT = {"Structures, classes and exceptions"}
"""Topics whose names no program calls."""

SWATCH = 24, 10
"""Pixels of a sample of a fill pattern or a line."""

HEAD = """\
<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>graphics.h on a page</title>
<style>
@page { size: A4 landscape; margin: 7mm; }
body { font: 5.8pt/1.24 "Liberation Sans", Arial, Helvetica, sans-serif; margin: 0; color: #000; }
h1 { font-size: 10pt; margin: 0 0 1mm; }
main { columns: 5; column-gap: 3mm; }
h2 { font-size: 6.6pt; margin: 1.2mm 0 .3mm; border-bottom: .2mm solid #000; break-after: avoid; }
p { margin: 0; padding-left: 2mm; text-indent: -2mm; break-inside: avoid; }
code { font: 600 5.5pt "Liberation Mono", "Courier New", monospace; }
img, i { display: inline-block; height: 1.9mm; vertical-align: middle; image-rendering: pixelated; }
i { width: 4mm; border: .1mm solid #888; }
.two { columns: 2; column-gap: 2mm; }
@media screen { body { margin: 1rem; font-size: 12px; } code { font-size: 12px; }
  h2 { font-size: 15px; } main { columns: 22rem; } img, i { height: 10px; } i { width: 24px; } }
</style>
<h1>graphics.h on a page: <code>from bgi import *</code></h1>
<main>
"""


def topics() -> Iterator[tuple[str, list[str]]]:
    """The names of the package by topic, as its list of names has them."""
    source = Path(bgi.__file__).read_text("utf-8").partition("__all__ = [")[2].partition("\n]")[0]
    for part in source.split("    # ")[1:]:
        heading, _, names = part.partition("\n")
        yield heading.partition(" (")[0], re.findall(r'"(\w+)"', names)


def calls() -> Iterator[str]:
    """What can be called: each with its arguments and what it does."""
    described = a_to_z.described()
    for heading, names in topics():
        known = [described[name] for name in names if name in described]
        if known and heading not in LEFT_OUT:
            yield f"<h2>{escape(heading)}</h2>"
            yield from (row(one.written, escape(one.what)) for one in known)


def row(code: str, words: str) -> str:
    """A line of the sheet."""
    return f"<p><code>{escape(code)}</code> {words}"


def numbered(names: list[str], look: Callable[[str, int], str] = lambda name, number: "") -> str:
    """Constants in two columns: each with its number and what it looks like."""
    rows = (row(f"{getattr(bgi, n)} {n}", look(n, getattr(bgi, n))) for n in names)
    return f"<div class='two'>{''.join(rows)}</div>"


def constants() -> Iterator[str]:
    """The tables of constants, under the calls that take them."""
    groups = dict(topics())
    yield "<h2>setcolor, setbkcolor, setfillstyle</h2>"
    yield numbered(groups["Colours: indices into the palette"][:16], lambda _, color: ink(color))
    yield "<h2>setfillstyle(pattern, color)</h2>"
    yield numbered(groups["Fill patterns"], lambda _, fill: sample(fill=fill))
    yield "<h2>setlinestyle(linestyle, upattern, thickness)</h2>"
    yield numbered(groups["Line styles and widths"], lambda name, style: stroke(name, style))
    yield "<h2>putimage; the first two: setwritemode</h2>"
    yield numbered(["COPY_PUT", "XOR_PUT", "OR_PUT", "AND_PUT", "NOT_PUT"])
    yield "<h2>settextstyle(font, direction, charsize), settextjustify</h2>"
    yield numbered(groups["Text: fonts, directions, justification"])
    yield "<h2>initgraph(driver, mode): size, colours</h2>"
    drivers = {getattr(bgi, name): name for name in groups["Graphics drivers"]}
    ordered = sorted(modes.MODES, key=lambda mode: (mode.driver, mode.number))
    rows = []
    for (driver, *size), alike in groupby(
        ordered, lambda m: (m.driver, m.width, m.height, m.colors)
    ):
        numbers = [mode.number for mode in alike]
        last = f"..{numbers[-1]}" if len(numbers) > 1 else ""
        rows.append(row(f"{drivers[driver]}, {numbers[0]}{last}", "{} x {}, {}".format(*size)))
    yield f"<div class='two'>{''.join(rows)}</div>"


def ink(color: int) -> str:
    """A sample of a colour."""
    red, green, blue = SIXTEEN[color]
    return f"<i style='background: rgb({red}, {green}, {blue})'></i>"


def stroke(name: str, style: int) -> str:
    """A sample of a style of lines; of a width, its unit."""
    return sample(line=style) if name.endswith("_LINE") else "pixels"


def sample(fill: int | None = None, line: int = bgi.SOLID_LINE) -> str:
    """A picture of a pattern or of a style of lines, blue on white."""
    screen = bgi.Graphics(modes.window(*SWATCH))
    screen.setbkcolor(bgi.WHITE)
    screen.cleardevice()
    if fill is None:
        screen.setlinestyle(line, 0x6666, bgi.NORM_WIDTH)
        screen.setcolor(bgi.BLUE)
        screen.line(0, SWATCH[1] // 2, SWATCH[0] - 1, SWATCH[1] // 2)
    else:
        screen.setfillstyle(fill, bgi.BLUE)
        screen.bar(0, 0, SWATCH[0] - 1, SWATCH[1] - 1)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(
            folder, "sample.bmp"
        )  # the same bytes everywhere, which compressed ones are not
        screen.writeimagefile(str(file))
        picture = base64.b64encode(file.read_bytes()).decode()
    return f'<img src="data:image/bmp;base64,{picture}" alt="">'


def text() -> str:
    """The sheet."""
    return HEAD + "\n".join([*calls(), *constants(), "</main>", "</html>", ""])


if __name__ == "__main__":
    FILE.write_text(text(), "utf-8", newline="\n")
