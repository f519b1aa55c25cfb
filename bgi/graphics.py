"""Class Graphics: every drawing operation of the BGI, a few lines each.

A method here adds the viewport's origin, chooses between the number path and the array path, and
leaves geometry to `raster` and pixels to `Page`. What each call means is told in `bgi.api`.
"""

import os
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.arguments import (
    Number,
    Numbers,
    batches,
    broadcast,
    is_array,
    polygon_points,
    whole,
    whole_array,
)
from bgi.constants import HORIZ_DIR, LEFT_TEXT
from bgi.fonts import bitmap
from bgi.fonts.codepage import encode
from bgi.imagefile import save_png
from bgi.modes import YASP
from bgi.raster import curves, lines, polygons
from bgi.raster.patterns import EMPTY_ROWS, SOLID_MASK
from bgi.raster.polygons import NO_SPANS, Point
from bgi.screen import Screen


class Graphics(Screen):
    """A graphics screen to draw on: the methods are graphics.h's functions."""

    # Numbers or arrays

    def _each(
        self, call: Callable[..., None], color: Numbers | None = None, **arguments: Numbers
    ) -> None:
        """Call with whole numbers: once, or for every element of the arrays among the arguments.

        A `color` becomes the drawing colour of its call only.
        """
        if color is not None:
            arguments["color"] = color
        if not any(is_array(value) for value in arguments.values()):
            calls = [[whole(name, value) for name, value in arguments.items()]]
        else:
            calls = np.stack(broadcast(**arguments), axis=-1).tolist()
        before = self.settings.color
        try:
            for numbers in calls:
                if color is not None:
                    self.settings.color = numbers.pop() & self._mask
                call(*numbers)
        finally:
            self.settings.color = before

    # Pixels

    def putpixel(self, x: Numbers, y: Numbers, color: Numbers) -> None:
        """Set pixels."""
        if type(x) is int and type(y) is int and type(color) is int:
            self.page.put(x + self._dx, y + self._dy, color & self._mask)
        elif is_array(x) or is_array(y) or is_array(color):
            for xs, ys, colors in batches(x=x, y=y, color=color):
                self.page.put_many(xs + self._dx, ys + self._dy, colors & self._mask)
        else:
            self.putpixel(whole("x", x), whole("y", y), whole("color", color))

    def getpixel(self, x: Numbers, y: Numbers) -> int | NDArray[np.uint8]:
        """Read pixels."""
        if type(x) is int and type(y) is int:
            return self.page.get(x + self._dx, y + self._dy)
        if is_array(x) or is_array(y):
            found = [
                self.page.get_many(xs + self._dx, ys + self._dy) for xs, ys in batches(x=x, y=y)
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
                self.page.line(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self.settings.color)
            else:
                self._segment(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self.settings.color)
        elif any(is_array(value) for value in (x1, y1, x2, y2, color)):
            shade = self.settings.color if color is None else color
            ends = broadcast(x1=x1, y1=y1, x2=x2, y2=y2, color=shade)
            corners = np.stack(ends[:4], axis=1) + np.tile(self._origin, 2)
            self._segments(corners, ends[4] & self._mask)
        else:
            self._each(self.line, x1=x1, y1=y1, x2=x2, y2=y2, color=color)

    def _segment(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """One line between absolute points, in line style, width and write mode."""
        for strand in lines.strands(x1, y1, x2, y2) if self._thick else [(x1, y1, x2, y2)]:
            if self._solid:
                self.page.line(*strand, color)
            else:
                self.page.styled_line(strand, color, self._pattern, self._xor)

    def _segments(self, corners: NDArray[Any], colors: NDArray[Any]) -> None:
        """Many lines, absolute rows x1, y1, x2, y2, each in its colour."""
        x1, y1, x2, y2 = corners.T
        segments = (x1, y1, x2, y2)
        if self._thick:
            segments, colors = lines.strands_many(segments), np.repeat(colors, 3)
        self.page.lines(segments, colors, self._pattern, self._xor)

    def lineto(self, x: Number, y: Number) -> None:
        """Draw from the current position to x, y and go there."""
        x, y = whole("x", x), whole("y", y)
        here = self.settings
        # A level line starts its pattern at the new point: the kernel passes it first.
        self.line(x, y, here.x, here.y)
        here.x, here.y = x, y

    def linerel(self, dx: Number, dy: Number) -> None:
        """Draw from the current position by dx, dy and go there."""
        self.lineto(self.settings.x + whole("dx", dx), self.settings.y + whole("dy", dy))

    def rectangle(
        self,
        left: Numbers,
        top: Numbers,
        right: Numbers,
        bottom: Numbers,
        color: Numbers | None = None,
    ) -> None:
        """Draw the outline of a box: four lines."""
        if not (
            type(left) is int
            and type(top) is int
            and type(right) is int
            and type(bottom) is int
            and color is None
        ):
            self._each(self.rectangle, left=left, top=top, right=right, bottom=bottom, color=color)
        elif self._plain:
            x1, x2 = (left, right) if left <= right else (right, left)
            y1, y2 = (top, bottom) if top <= bottom else (bottom, top)
            dx, dy = self._dx, self._dy
            self.page.outline(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self.settings.color)
        else:
            self.line(left, top, right, top)
            self.line(right, top, right, bottom)
            self.line(right, bottom, left, bottom)
            self.line(left, bottom, left, top)

    # Polygons

    def drawpoly(
        self, points: Numbers, flat: Numbers | None = None, color: Numbers | None = None
    ) -> None:
        """Draw open polygons: a line from each point to the next."""
        corners = polygon_points(points, flat)
        if isinstance(corners, list):
            ink = self._one_color("color", color, self.settings.color)
            for side in polygons.edges(self._shifted(corners)):
                self._segment(*side, ink)
        else:
            sides, real = polygons.edges_many(corners + self._origin)
            colors = self._colors("color", color, self.settings.color, len(corners))
            owners = np.nonzero(real)[0]
            self._segments(sides[real], colors[owners])

    def fillpoly(
        self,
        points: Numbers,
        flat: Numbers | None = None,
        fill: Numbers | None = None,
        color: Numbers | None = None,
    ) -> None:
        """Fill polygons, then draw their outlines."""
        corners = polygon_points(points, flat)
        settings = self.settings
        if isinstance(corners, list):
            shade = self._one_color("fill", fill, settings.fill.color)
            ink = self._one_color("color", color, settings.color)
            self._fill_polygon(self._shifted(corners), shade, ink)
            return
        fills = self._colors("fill", fill, settings.fill.color, len(corners))
        colors = self._colors("color", color, settings.color, len(corners))
        if self._xor:  # the next fill must cover a side before the next side meets it
            for one, shade, ink in zip(corners.tolist(), fills, colors, strict=True):
                self._fill_polygon(self._shifted(one), int(shade), int(ink))
        else:
            self._fill_polygons(corners + self._origin, fills, colors)

    def _fill_polygon(self, points: list[Point], fill: int, color: int) -> None:
        sides = polygons.edges([*points, *points[:1]])
        rows = self.settings.fill_rows
        if rows != EMPTY_ROWS:  # EMPTY_FILL leaves a polygon's interior alone
            _, top, _, bottom = self.page.box
            self.page.fill_rows(polygons.scan(sides, top, bottom), fill, rows)
        if color:  # an outline in colour 0 is not drawn
            for side in sides:
                self._segment(*side, color)

    def _fill_polygons(
        self, points: NDArray[Any], fills: NDArray[Any], colors: NDArray[Any]
    ) -> None:
        sides, real = polygons.edges_many(np.concatenate([points, points[:, :1]], axis=1))
        real &= (colors != 0)[:, None]
        rows, box = self.settings.fill_rows, self.page.box
        for part, spans in polygons.spans(sides, box[1], box[3]):
            owners = np.nonzero(real[part])[0] + part.start
            x1, y1, x2, y2 = sides[part][real[part]].T
            segments = (x1, y1, x2, y2)
            if self._thick:
                segments, owners = lines.strands_many(segments), np.repeat(owners, 3)
            filled = NO_SPANS if rows == EMPTY_ROWS else spans
            self.page.paint(filled, fills, rows, segments, owners, colors, self._pattern)

    def _shifted(self, points: list[Point]) -> list[Point]:
        dx, dy = self._origin
        return [(x + dx, y + dy) for x, y in points]

    def _one_color(self, name: str, value: Numbers | None, default: int) -> int:
        return default if value is None else whole(name, value) & self._mask

    def _colors(self, name: str, values: Numbers | None, default: int, count: int) -> NDArray[Any]:
        """A colour for each of `count` shapes."""
        array = whole_array(name, default if values is None else values) & self._mask
        if array.ndim == 0 or array.shape == (count,):
            return np.broadcast_to(array, count)
        raise ValueError(f"{name} must be a number or {count} numbers, not of shape {array.shape}")

    # Boxes

    def bar(
        self,
        left: Numbers,
        top: Numbers,
        right: Numbers,
        bottom: Numbers,
        fill: Numbers | None = None,
    ) -> None:
        """Fill boxes in the fill pattern; no outline."""
        if (
            type(left) is int
            and type(top) is int
            and type(right) is int
            and type(bottom) is int
            and fill is None
        ):
            self._bar(left, top, right, bottom, self.settings.fill.color)
        else:
            shade = self.settings.fill.color if fill is None else fill
            self._each(self._bar, left=left, top=top, right=right, bottom=bottom, fill=shade)

    def _bar(self, left: int, top: int, right: int, bottom: int, fill: int) -> None:
        x1, x2 = (left, right) if left <= right else (right, left)
        y1, y2 = (top, bottom) if top <= bottom else (bottom, top)
        box = (x1 + self._dx, y1 + self._dy, x2 + self._dx, y2 + self._dy)
        self.page.fill(box, fill & self._mask, self.settings.fill_rows)

    # Circles

    def circle(self, x: Numbers, y: Numbers, radius: Numbers, color: Numbers | None = None) -> None:
        """Draw circles, round on a screen of the mode's aspect ratio."""
        if type(x) is int and type(y) is int and type(radius) is int and color is None:
            ry = radius * self.mode.xasp // YASP
            self._ellipse(x + self._dx, y + self._dy, radius, ry)
        else:
            self._each(self.circle, x=x, y=y, radius=radius, color=color)

    def _ellipse(self, x: int, y: int, rx: int, ry: int) -> None:
        """A whole ellipse around absolute x, y; thin ones ignore line style and write mode."""
        color = self.settings.color
        if not self._thick:
            self.page.ellipse(x, y, rx, ry, color)
            return
        corners = [(x + dx, y + dy) for dx, dy in curves.thick_points(0, 360, rx, ry)]
        for side in polygons.edges(corners):
            for strand in lines.strands(*side):
                self.page.styled_line(strand, color, SOLID_MASK, self._xor)

    # Text

    def outtext(self, text: str | bytes) -> None:
        """Write at the current position, which moves on if the text is level and left-justified."""
        here, style = self.settings, self.settings.text
        self.outtextxy(here.x, here.y, text)
        if style.direction == HORIZ_DIR and style.horiz == LEFT_TEXT:
            here.x += self.textwidth(text)

    def outtextxy(self, x: Number, y: Number, text: str | bytes) -> None:
        """Write at x, y."""
        self._write(whole("x", x) + self._dx, whole("y", y) + self._dy, encode(text))

    def _write(self, x: int, y: int, text: bytes) -> None:
        """Bitmap text: a character that the viewport would cut is left out whole."""
        left, top, right, bottom = self.page.box
        cell = bitmap.CELL
        first = max(0, -((x - left) // cell))
        last = min(len(text), (right + 1 - x) // cell)
        whole_line = first == 0 and last == len(text) and top <= y <= bottom + 1 - cell
        if self.settings.view.clip:
            text = text[first:last] if top <= y <= bottom + 1 - cell else b""
        elif not whole_line:  # without clipping, text that would leave the screen is dropped
            return
        if text:
            self.page.stamp(x + first * cell, y, bitmap.mask(text, 1), self.settings.color)

    def textwidth(self, text: str | bytes) -> int:
        """The width of a text in pixels."""
        return bitmap.CELL * len(encode(text))

    def textheight(self, text: str | bytes) -> int:
        """The height of a text in pixels: the same for every text."""
        encode(text)
        return bitmap.CELL

    # Pictures

    def writeimagefile(
        self,
        filename: str | os.PathLike[str],
        left: Number = 0,
        top: Number = 0,
        right: Number | None = None,
        bottom: Number | None = None,
    ) -> None:
        """Save a part of the active page as a PNG."""
        x1, y1 = max(0, whole("left", left)), max(0, whole("top", top))
        x2 = self.getmaxx() if right is None else whole("right", right)
        y2 = self.getmaxy() if bottom is None else whole("bottom", bottom)
        part = self.page.array[y1 : max(y2 + 1, 0), x1 : max(x2 + 1, 0)]
        if not part.size:
            raise ValueError(f"nothing of {left}, {top}, {right}, {bottom} is on the screen")
        save_png(filename, part, self.card.palette)
