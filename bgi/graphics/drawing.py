"""Pixels, lines and outlines: the number path and the array path of each call."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bgi.constants import SOLID_LINE, THICK_WIDTH, USERBIT_LINE, grError
from bgi.graphics.pen import Pen
from bgi.kernel.arguments import (
    NOT_SO_SIMPLE,
    TO_INT,
    Number,
    Numbers,
    broadcast,
    in_chunks,
    is_array,
    polygon_points,
    whole,
)
from bgi.kernel.state import KERNEL
from bgi.memory.card import MAX_SIDE
from bgi.raster import polygons, spans
from bgi.settings import linesettingstype


class Drawing(Pen):
    """A screen to set pixels and draw lines on."""

    # The line style

    def setlinestyle(self, style: Number, pattern: Number, width: Number) -> None:
        """Set line style, user pattern and width; -11 and no change if either is unknown."""
        number = style if type(style) is int else whole("style", style)
        bits = (pattern if type(pattern) is int else whole("pattern", pattern)) & 0xFFFF
        thickness = width if type(width) is int else whole("width", width)
        widest = MAX_SIDE if self.mode.square else THICK_WIDTH
        if SOLID_LINE <= number <= USERBIT_LINE and 0 <= thickness <= widest:
            line = self.settings.line
            line.linestyle, line.upattern, line.thickness = number, bits, thickness
            self._use_line_settings()
        else:
            KERNEL.result.set(grError)

    def getlinesettings(self) -> linesettingstype:
        """Line style, pattern and thickness as given."""
        line = self.settings.line
        return linesettingstype(line.linestyle, line.upattern, line.thickness)

    def setwritemode(self, mode: Number) -> None:
        """COPY_PUT or XOR_PUT for lines; only bit 0 counts, as in Borland's driver."""
        number = mode if type(mode) is int else whole("mode", mode)
        self.settings.writemode = number & 1
        self._use_line_settings()

    # Pixels

    def putpixel(self, x: Numbers, y: Numbers, color: Numbers) -> None:
        """Set pixels."""
        if type(x) is int and type(y) is int and type(color) is int:
            self.page.put(x + self._dx, y + self._dy, color & self._mask)
            return
        try:
            x, y, color = TO_INT[type(x)](x), TO_INT[type(y)](y), TO_INT[type(color)](color)
        except NOT_SO_SIMPLE:
            pass  # what follows is not in here, so that its errors tell of nothing else
        else:
            self.page.put(x + self._dx, y + self._dy, color & self._mask)
            return
        if is_array(x) or is_array(y) or is_array(color):
            for xs, ys, colors in in_chunks(x=x, y=y, color=color):
                self.page.put_many(xs + self._dx, ys + self._dy, colors & self._mask)
        else:
            self.putpixel(whole("x", x), whole("y", y), whole("color", color))

    def getpixel(self, x: Numbers, y: Numbers) -> int | NDArray[np.uint8]:
        """Read pixels."""
        if type(x) is int and type(y) is int:
            return self.page.get(x + self._dx, y + self._dy)
        if is_array(x) or is_array(y):
            found = [
                self.page.get_many(xs + self._dx, ys + self._dy) for xs, ys in in_chunks(x=x, y=y)
            ]
            shape = np.broadcast_shapes(np.shape(x), np.shape(y))
            return np.concatenate([np.zeros(0, np.uint8), *found]).reshape(shape)
        return self.page.get(whole("x", x) + self._dx, whole("y", y) + self._dy)

    # Lines

    def line(
        self, x1: Numbers, y1: Numbers, x2: Numbers, y2: Numbers, color: Numbers | None = None
    ) -> None:
        """Draw lines in the line style, width and write mode."""
        if (
            type(x1) is int
            and type(y1) is int
            and type(x2) is int
            and type(y2) is int
            and color is None
        ):
            dx, dy = self._dx, self._dy
            if self._plain:
                self.page.line(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self._ink)
            elif self._bold:
                self.page.thick_line(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self._ink)
            else:
                self._segment(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self._ink)
        elif is_array(x1) or is_array(y1) or is_array(x2) or is_array(y2) or is_array(color):
            shade = self.settings.color if color is None else color
            ends = broadcast(x1=x1, y1=y1, x2=x2, y2=y2, color=shade)
            dx, dy = self._dx, self._dy
            x1, y1, x2, y2, colors = ends
            self._segments((x1 + dx, y1 + dy, x2 + dx, y2 + dy), self._index(colors))
        elif color is None:
            self.line(whole("x1", x1), whole("y1", y1), whole("x2", x2), whole("y2", y2))
        else:
            self._each(self.line, x1=x1, y1=y1, x2=x2, y2=y2, color=color)

    def lineto(self, x: Number, y: Number) -> None:
        """Draw from the current position to x, y and go there."""
        x = x if type(x) is int else whole("x", x)
        y = y if type(y) is int else whole("y", y)
        here, dx, dy = self.settings, self._dx, self._dy
        # A level line starts its pattern at the new point: the kernel passes it first.
        self._segment(x + dx, y + dy, here.x + dx, here.y + dy, self._ink)
        here.x, here.y = x, y

    def linerel(self, dx: Number, dy: Number) -> None:
        """Draw from the current position by dx, dy and go there."""
        dx = dx if type(dx) is int else whole("dx", dx)
        dy = dy if type(dy) is int else whole("dy", dy)
        self.lineto(self.settings.x + dx, self.settings.y + dy)

    def rectangle(
        self,
        left: Numbers,
        top: Numbers,
        right: Numbers,
        bottom: Numbers,
        color: Numbers | None = None,
    ) -> None:
        """Draw the outline of a box: four lines."""
        if (
            type(left) is int
            and type(top) is int
            and type(right) is int
            and type(bottom) is int
            and color is None
        ):
            dx, dy = self._dx, self._dy
            self._box(left + dx, top + dy, right + dx, bottom + dy, self._ink)
        else:
            self._each(self.rectangle, left=left, top=top, right=right, bottom=bottom, color=color)

    # Polygons

    def drawpoly(
        self, points: Numbers, flat: Numbers | None = None, color: Numbers | None = None
    ) -> None:
        """Draw open polygons: a line from each point to the next."""
        corners = polygon_points(points, flat)
        if isinstance(corners, list):
            ink = self._one_color("color", color, self.settings.color)
            self._outline(polygons.paths(self._shifted(corners)), self._index(ink))
        else:
            sides, real = spans.edges_many(*self._columns(corners))
            colors = self._colors("color", color, self.settings.color, len(corners))
            owners, which = np.nonzero(real.T)
            x1, y1, x2, y2 = (end[which, owners] for end in sides)
            self._segments((x1, y1, x2, y2), self._index(colors)[owners])
