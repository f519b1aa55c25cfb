"""Pixels, lines and outlines: the number path, the array path, and what both leave to the page."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.graphics.screen import Screen
from bgi.kernel.arguments import (
    Number,
    Numbers,
    batches,
    broadcast,
    is_array,
    polygon_points,
    whole,
    whole_array,
)
from bgi.raster import lines, polygons, spans
from bgi.raster.lines import Segment, Segments
from bgi.raster.polygons import Point

FEW = 256
"""So many lines are drawn one by one as fast as together."""


class Lines(Screen):
    """A screen to set pixels and draw lines on."""

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
            self._segment(x1 + dx, y1 + dy, x2 + dx, y2 + dy, self.settings.color)
        elif any(is_array(value) for value in (x1, y1, x2, y2, color)):
            shade = self.settings.color if color is None else color
            ends = broadcast(x1=x1, y1=y1, x2=x2, y2=y2, color=shade)
            dx, dy = self._dx, self._dy
            x1, y1, x2, y2, colors = ends
            self._segments((x1 + dx, y1 + dy, x2 + dx, y2 + dy), colors & self._mask)
        else:
            self._each(self.line, x1=x1, y1=y1, x2=x2, y2=y2, color=color)

    def _segment(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """One line between absolute points, in line style, width and write mode."""
        if self._plain:
            self.page.line(x1, y1, x2, y2, color)
            return
        for strand in lines.strands(x1, y1, x2, y2) if self._thick else [(x1, y1, x2, y2)]:
            if self._solid:
                self.page.line(*strand, color)
            else:
                self.page.styled_line(strand, color, self._pattern, self._xor)

    def _sides(self, sides: list[Segment], color: int) -> None:
        """The lines of one figure; of a very large one few can be seen, and arrays find them."""
        if len(sides) < FEW:
            for side in sides:
                self._segment(*side, color)
        else:
            x1, y1, x2, y2 = whole_array("sides", sides).T
            self._segments((x1, y1, x2, y2), np.full(len(sides), color))

    def _segments(self, segments: Segments, colors: NDArray[Any]) -> None:
        """Many lines between absolute points, each in its colour."""
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
            self._sides(polygons.edges(polygons.paths(self._shifted(corners))), ink)
        else:
            sides, real, _ = spans.edges_many(corners + self._origin)
            colors = self._colors("color", color, self.settings.color, len(corners))
            owners, which = np.nonzero(real.T)
            x1, y1, x2, y2 = (end[which, owners] for end in sides)
            self._segments((x1, y1, x2, y2), colors[owners])

    def _shifted(self, points: list[Point]) -> list[Point]:
        dx, dy = self._origin
        return [(x + dx, y + dy) for x, y in points] if dx or dy else points

    def _one_color(self, name: str, value: Numbers | None, default: int) -> int:
        return default if value is None else whole(name, value) & self._mask

    def _colors(self, name: str, values: Numbers | None, default: int, count: int) -> NDArray[Any]:
        """A colour for each of `count` shapes."""
        array = whole_array(name, default if values is None else values) & self._mask
        if array.ndim == 0 or array.shape == (count,):
            return np.broadcast_to(array, count)
        raise ValueError(f"{name} must be a number or {count} numbers, not of shape {array.shape}")
