"""All that the plotter needs of a graphics system: a size, some colours, and putpixel.

The paper's promise is that its method works "with any graphics system where we have some primitive
2-D graphics function". A system is any object with the functions of `System`, named and meant as in
graphics.h: the BGI itself is one, `svg` and `characters` are two more. If it also has
line (with setcolor), fillpoly (with setfillstyle), outtextxy or setrgbpalette, the pen uses them;
otherwise it makes lines and polygons out of pixels, the same pixels, and does without writing. If
it has getviewsettings, the picture is made for the viewport.

What draws knows `bgi` through this file only: its functions, as a system, and its colours. (The
command and the explorer open the screen with it.)
"""

from __future__ import annotations

from typing import Any, Protocol, cast

import numpy as np

import bgi
from bgi import (
    BLACK,
    BLUE,
    BROWN,
    CYAN,
    DARKGRAY,
    GREEN,
    LIGHTBLUE,
    LIGHTCYAN,
    LIGHTGRAY,
    LIGHTGREEN,
    LIGHTMAGENTA,
    LIGHTRED,
    MAGENTA,
    RED,
    WHITE,
    YELLOW,
)
from surfaces.arrays import Doubles, Ints
from surfaces.systems import trace

__all__ = [
    "BLACK",
    "BLUE",
    "BROWN",
    "CYAN",
    "DARKGRAY",
    "GREEN",
    "LIGHTBLUE",
    "LIGHTCYAN",
    "LIGHTGRAY",
    "LIGHTGREEN",
    "LIGHTMAGENTA",
    "LIGHTRED",
    "MAGENTA",
    "RED",
    "WHITE",
    "YELLOW",
    "Pen",
    "System",
]


ENTRIES = 256
"""As many colours as a palette has on the 8514..."""
BYTES_OF_A_MIXTURE = 4
"""... and as many bytes as a pixel has in a window, where colours are mixed without a palette."""


class System(Protocol):
    """The least that a graphics system must have."""

    def getmaxx(self) -> int:
        """The largest x on the screen; the smallest is 0."""

    def getmaxy(self) -> int:
        """The largest y on the screen; y grows downwards."""

    def getmaxcolor(self) -> int:
        """The largest colour: 1, 3, 15 or 255."""

    def putpixel(self, x: Any, y: Any, color: Any) -> None:
        """Set one pixel; a system with `arrays = True` takes arrays of them, as the BGI does."""


class Pen:
    """Arrays in; pixels, lines, polygons and text on a graphics system out.

    `system` None is the current screen of the BGI. A system may say four more things about itself:
    `arrays` (its calls take arrays), `vector` (polygons are better than pixels, as in a drawing
    that can be scaled), `aspect` (the width of a pixel divided by its height), and `character` (how
    many pixels wide and high a character is, if not 8).

    A window of the BGI has no palette of 256, but takes any colour: there the pen keeps a palette
    itself, and a surface looks as it does on the 8514.
    """

    def __init__(self, system: System | None = None) -> None:
        self.system = cast(Any, bgi if system is None else system)
        self.arrays = bool(getattr(self.system, "arrays", self.system is bgi))
        self.vector = bool(getattr(self.system, "vector", False))
        self.width: int = self.system.getmaxx() + 1
        self.height: int = self.system.getmaxy() + 1
        self._whole = self.width, self.height
        if self._has("getviewsettings"):  # then it draws into a part of the screen
            view = self.system.getviewsettings()
            self.width = view.right - view.left + 1
            self.height = view.bottom - view.top + 1
        self.colors: int = self.system.getmaxcolor() + 1
        self._mixed: Ints | None = None
        """What to draw each palette entry with, where the pen keeps a palette of its own."""
        if self.system is bgi and bgi.getimage(0, 0, 0, 0).array.itemsize == BYTES_OF_A_MIXTURE:
            self.colors = ENTRIES
            self._mixed = np.arange(ENTRIES)
        self.character = int(getattr(self.system, "character", 8))

    @property
    def aspect(self) -> float:
        """The width of a pixel divided by its height: 1 on a VGA, less on older cards."""
        if self.system is not bgi:
            return float(getattr(self.system, "aspect", 1.0))
        across, down = bgi.getaspectratio()
        if across == down:  # as in every window
            return 1.0
        # Whatever its mode, a PC's screen is four units wide and three high.
        width, height = self._whole
        return float(4 * height / (3 * width))

    @property
    def color(self) -> int:
        """The current drawing colour; WHITE, where a system has no such thing."""
        return int(self.system.getcolor()) if self._has("getcolor") else self.ink(WHITE)

    def shown_as(self, kind: str) -> Any:
        """What the system shows of itself in a notebook, as "png" or "svg"; None if it does not."""
        screen = bgi.current.screen if self.system is bgi else self.system
        show = getattr(screen, f"_repr_{kind}_", None)
        return show() if show else None

    def ink(self, color: int) -> int:
        """One of graphics.h's sixteen colours, or the largest that the system has."""
        return min(color, self.colors - 1)

    def _has(self, *names: str) -> bool:
        return all(hasattr(self.system, name) for name in names)

    def palette(self, entries: Ints, rgb: Ints) -> None:
        """Give palette entries, (n,), their colours, (n, 3) of 0..255, where that can be done."""
        if self._mixed is not None:
            self._mixed[entries] = [bgi.COLOR(r, g, b) for r, g, b in rgb.tolist()]
        elif self.arrays and self._has("setrgbpalette"):
            self.system.setrgbpalette(entries, *rgb.T)
        elif self._has("setrgbpalette"):
            for entry, (r, g, b) in zip(entries.tolist(), rgb.tolist(), strict=True):
                self.system.setrgbpalette(entry, r, g, b)

    def _shown(self, colors: Any) -> Any:
        """What draws palette entries: they themselves, or what is mixed for them."""
        if self._mixed is None:
            return colors
        mixed = self._mixed.take(colors, mode="clip")
        shown = np.where(np.less(colors, ENTRIES), mixed, colors)  # a mixture stays what it is
        return shown if isinstance(colors, np.ndarray) else int(shown)

    def pixels(self, x: Ints, y: Ints, colors: Ints | int) -> None:
        """Set pixels, in order; what lies off the screen is left out."""
        if self.arrays:
            self.system.putpixel(x, y, self._shown(colors))
            return
        inside = (x >= 0) & (x < self.width) & (y >= 0) & (y < self.height)
        shades = np.broadcast_to(colors, x.shape)
        for pixel in zip(
            x[inside].tolist(), y[inside].tolist(), shades[inside].tolist(), strict=True
        ):
            self.system.putpixel(*pixel)

    def lines(self, starts: Doubles, ends: Doubles, color: int) -> None:
        """Lines between points (n, 2) of the screen, cut off at its edges."""
        a, b, _ = trace.clip(starts, ends, self.width, self.height)
        if not self._has("line"):
            x, y, _ = trace.line_pixels(a, b)
            self.pixels(x, y, color)
        elif self.arrays:
            self.system.line(a[:, 0], a[:, 1], b[:, 0], b[:, 1], color=self._shown(color))
        else:
            self.system.setcolor(color)
            for ends_of_line in np.concatenate((a, b), axis=1).tolist():
                self.system.line(*ends_of_line)

    def polygons(self, points: Ints, fills: Ints | int, outline: int) -> None:
        """Solid polygons, pixels (n, k, 2), one after another; outline 0 is not drawn."""
        if self.arrays and self._has("fillpoly"):
            self.system.fillpoly(points, fill=self._shown(fills), color=self._shown(outline))
            return
        draw = self._fillpoly if self._has("fillpoly", "setfillstyle") else self._fill_pixels
        for polygon, fill in zip(
            points.tolist(), np.broadcast_to(fills, len(points)).tolist(), strict=True
        ):
            draw([(x, y) for x, y in polygon], fill, outline)

    def _fillpoly(self, polygon: list[tuple[int, int]], fill: int, outline: int) -> None:
        self.system.setfillstyle(bgi.SOLID_FILL, fill)
        self.system.setcolor(outline)
        self.system.fillpoly(polygon)

    def _fill_pixels(self, polygon: list[tuple[int, int]], fill: int, outline: int) -> None:
        for y, left, right in trace.polygon_rows(polygon, self.height):
            x = np.arange(max(left, 0), min(right, self.width - 1) + 1)
            self.pixels(x, np.full_like(x, y), fill)
        sides = np.array(trace.polygon_sides(polygon), dtype=np.float64).reshape(-1, 2, 2)
        if outline:
            first, last, _ = trace.clip(sides[:, 0], sides[:, 1], self.width, self.height)
            self.pixels(*trace.line_pixels(first, last)[:2], outline)

    def text(self, x: float, y: float, text: str, color: int) -> None:
        """Write, the upper left corner at x, y, where the system can write."""
        if self._has("outtextxy", "setcolor"):
            before = self.color
            self.system.setcolor(self._shown(color))
            self.system.outtextxy(round(x), round(y), text)
            self.system.setcolor(before)
