"""A graphics system that writes SVG: a drawing made of polygons and lines, sharp at any size.

    picture = Svg(640, 480)
    surface(f, x=(-3, 3), y=(-3, 3), n=60, on=picture)
    picture.save("surface.svg")

Its functions are graphics.h's, one shape each. That is all a graphics system needs.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from surfaces.systems.pen import WHITE

Pixel = tuple[int, int]

# Red, green and blue of graphics.h's sixteen colours, as the EGA mixes them.
SIXTEEN = (
    *("#000000", "#0000aa", "#00aa00", "#00aaaa", "#aa0000", "#aa00aa", "#aa5500", "#aaaaaa"),
    *("#555555", "#5555ff", "#55ff55", "#55ffff", "#ff5555", "#ff55ff", "#ffff55", "#ffffff"),
)

NOT_XML = "[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"
"""Control characters and halves of surrogate pairs, which no XML file may hold (XML 1.0, 2.2).

A text, compiled when a drawing is written: that takes longer than to import all else here."""
ESCAPED = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})
"""By hand: the standard library's escape() imports its web client."""


class Svg:
    """A drawing of width by height units, with 256 colours on a background."""

    vector = True
    """Polygons are better than pixels here."""

    def __init__(self, width: int = 640, height: int = 480, background: str = "#000000") -> None:
        self._size = width, height
        self._palette = [*SIXTEEN, *("#ffffff",) * 240]
        self._palette[0] = _xml(background)
        self._color, self._fill = WHITE, WHITE
        self._shapes: list[str] = []

    def getmaxx(self) -> int:
        """The largest x."""
        return self._size[0] - 1

    def getmaxy(self) -> int:
        """The largest y."""
        return self._size[1] - 1

    def getmaxcolor(self) -> int:
        """The largest colour, 255."""
        return 255

    def getcolor(self) -> int:
        """The drawing colour."""
        return self._color

    def setcolor(self, color: int) -> None:
        """Set the colour of lines, outlines and text."""
        self._color = color

    def setfillstyle(self, pattern: int, color: int) -> None:
        """Set the colour of fills; patterns are all solid."""
        self._fill = color

    def setrgbpalette(self, index: int, red: int, green: int, blue: int) -> None:
        """Mix a colour for all that is drawn from now on: 0..255 each."""
        self._palette[index] = f"#{red:02x}{green:02x}{blue:02x}"

    def putpixel(self, x: int, y: int, color: int) -> None:
        """A square of one unit."""
        ink = self._palette[color]
        self._shapes.append(f'<path d="M{x - 0.5} {y - 0.5}h1v1h-1z" fill="{ink}"/>')

    def line(self, x1: int, y1: int, x2: int, y2: int) -> None:
        """A line of one unit's width."""
        ink = self._palette[self._color]
        self._shapes.append(f'<path d="M{x1} {y1}L{x2} {y2}" stroke="{ink}"/>')

    def fillpoly(self, points: Sequence[Pixel]) -> None:
        """A polygon; with no outline (colour 0) it has one of its own colour, to leave no gap."""
        corners = "L".join(f"{x} {y}" for x, y in points)
        fill = self._palette[self._fill]
        ink = self._palette[self._color] if self._color else fill
        self._shapes.append(f'<path d="M{corners}z" fill="{fill}" stroke="{ink}"/>')

    def outtextxy(self, x: int, y: int, text: str) -> None:
        """Text whose upper left corner is at x, y, 8 units wide a character."""
        ink = self._palette[self._color]
        self._shapes.append(
            f'<text x="{x}" y="{y + 7}" textLength="{8 * len(text)}" fill="{ink}">'
            f"{_xml(text)}</text>"
        )

    def __str__(self) -> str:
        """The drawing as an SVG document."""
        width, height = self._size
        return "\n".join(
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.5 -0.5 {width} {height}"'
                ' fill="none" stroke-width="1" stroke-linejoin="round" stroke-linecap="round"'
                ' font-family="monospace" font-size="11">',
                f'<rect x="-0.5" y="-0.5" width="{width}" height="{height}"'
                f' fill="{self._palette[0]}"/>',
                *self._shapes,
                "</svg>\n",
            )
        )

    def _repr_svg_(self) -> str:
        """The drawing for notebooks."""
        return str(self)

    def save(self, path: str | Path) -> None:
        """Write the drawing to a file."""
        document = str(self).encode()  # before an old file is emptied
        Path(path).write_bytes(document)


def _xml(text: str) -> str:
    """A text as XML holds it, also between quotation marks; what it cannot hold as U+FFFD."""
    return re.sub(NOT_XML, "\ufffd", text).translate(ESCAPED)
