"""Class Pen: what the drawing topics share, between a call and the page.

How a call is repeated for arrays, how a line is drawn in the style that is set, how an area is
filled in the pattern that is set. All points here are absolute: the viewport's origin is in them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import chain, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.graphics.screen import State
from bgi.kernel.arguments import Numbers, in_chunks, is_array, whole, whole_array
from bgi.raster import brush, lines, polygons, spans
from bgi.raster.lines import Segment, Segments
from bgi.raster.polygons import Path, Point
from bgi.raster.shortlines import LONGEST, SHORT_LINES
from bgi.raster.styledboxes import STYLED_BOXES

FEW = 256
"""Below this many lines a loop is as fast as the array path."""


class Pen(State):
    """A screen to draw on."""

    # Numbers or arrays

    def _each(
        self, call: Callable[..., None], color: Numbers | None = None, **arguments: Numbers
    ) -> None:
        """Call with whole numbers: once, or for every element of the arrays among the arguments.

        A `color` becomes the drawing colour of its call only.
        """
        if color is None:
            for numbers in _calls(arguments):
                call(*numbers)
            return
        before = self.settings.color
        try:
            for *numbers, shade in _calls({**arguments, "color": color}):
                self._use_color(shade & self._given_mask)
                call(*numbers)
        finally:
            self._use_color(before)

    # Lines

    def _segment(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """One line between absolute points, in line style, width and write mode."""
        page = self.page
        if self._plain:
            page.line(x1, y1, x2, y2, color)
        elif self._bold:
            page.thick_line(x1, y1, x2, y2, color)
        elif self._wide:
            for strand in self._strands(x1, y1, x2, y2):
                if self._xor:
                    page.styled_line(*strand, color, self._dashes, True)
                else:
                    page.line(*strand, color)
        else:
            self._styled(x1, y1, x2, y2, color)

    def _styled(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """One line in a line pattern or by XOR, thin or thick."""
        dx, dy, page = x2 - x1, y2 - y1, self.page
        style, xor = self._dashes, self._xor
        if -LONGEST <= dx <= LONGEST and -LONGEST <= dy <= LONGEST:
            figure = SHORT_LINES[dx, dy, style.bits, self._thick, xor, page.trace, page.width]
            if page.put_offsets(x1, y1, figure, color, xor):
                return
        if self._thick:
            for strand in lines.strands(x1, y1, x2, y2):
                page.styled_line(*strand, color, style, xor)
        else:
            page.styled_line(x1, y1, x2, y2, color, style, xor)

    def _strands(self, x1: int, y1: int, x2: int, y2: int) -> list[Segment]:
        """The thin lines that make one in the line width."""
        if self._wide:
            return brush.rows(x1, y1, x2, y2, self.settings.line.thickness, self.page.box)
        return lines.strands(x1, y1, x2, y2) if self._thick else [(x1, y1, x2, y2)]

    def _box(self, left: int, top: int, right: int, bottom: int, color: int) -> None:
        """The outline of a box between absolute corners, in any order: four lines."""
        if self._plain:
            self.page.outline(left, top, right, bottom, color)
            return
        if not self._thick:
            self._styled_box(left, top, right, bottom, color)
            return
        self._segment(left, top, right, top, color)
        self._segment(right, top, right, bottom, color)
        self._segment(right, bottom, left, bottom, color)
        self._segment(left, bottom, left, top, color)

    def _styled_box(self, left: int, top: int, right: int, bottom: int, color: int) -> None:
        """The outline of a box in a line pattern or by XOR, thin."""
        style, xor, page = self._dashes, self._xor, self.page
        dx, dy = right - left, bottom - top
        if abs(dx) < page.width and abs(dy) < page.height:
            figure = STYLED_BOXES.again(dx, dy, style.bits, xor, page.trace, page.width)
            if figure is not None and page.put_offsets(left, top, figure, color, xor):
                return
        page.styled_outline(left, top, right, bottom, color, style, xor)

    def _outline(self, outline: list[Path], color: int) -> None:
        """The lines of one polygon, by its paths."""
        if sum(map(len, outline)) < FEW:  # else arrays are faster: they drop at once what is far
            draw = self.page.line if self._plain else self._segment
            for path in outline:
                for (x1, y1), (x2, y2) in pairwise(path):
                    draw(x1, y1, x2, y2, color)
        else:
            x1, y1, x2, y2 = whole_array("sides", polygons.edges(outline)).T
            self._segments((x1, y1, x2, y2), np.full(len(x1), color))

    def _segments(self, segments: Segments, colors: NDArray[Any]) -> None:
        """Many lines between absolute points, each in its colour."""
        if self._wide:
            for x1, y1, x2, y2, color in np.stack((*segments, colors), axis=-1).tolist():
                self._segment(x1, y1, x2, y2, color)
            return
        if self._thick:
            segments, colors = lines.strands_many(segments), np.repeat(colors, 3)
        self.page.line_many(segments, colors, self._dashes, self._xor)

    # Areas

    def _fill_area(self, outline: list[Path], fill: int) -> None:
        """Fill what the paths of a polygon enclose."""
        rows = self._fill_rows
        _, top, _, bottom = self.page.box
        if sum(map(len, outline)) < FEW:
            self.page.fill_rows(polygons.scan(outline, top, bottom), fill, rows)
            return
        x1, y1, x2, y2 = whole_array("sides", polygons.edges(outline)).T[:, :, None]
        found = spans.fill_one((x1, y1, x2, y2), top, bottom)
        self.page.fill_spans(found, np.array([fill]), rows)

    # Arguments of polygons

    def _shifted(self, points: list[Point]) -> list[Point]:
        """Points relative to the viewport as absolute ones."""
        dx, dy = self._origin
        return [(x + dx, y + dy) for x, y in points] if dx or dy else points

    def _columns(self, points: NDArray[Any]) -> NDArray[Any]:
        """Points (n, k, 2) relative to the viewport as absolute ones, (2, k, n): x and y."""
        columns = np.ascontiguousarray(points.transpose(2, 1, 0))
        columns += np.array(self._origin).reshape(2, 1, 1)
        return columns

    def _one_color(self, name: str, value: Numbers | None, default: int) -> int:
        return default if value is None else whole(name, value) & self._given_mask

    def _colors(self, name: str, values: Numbers | None, default: int, count: int) -> NDArray[Any]:
        """A colour, as given, for each of `count` shapes."""
        given = whole_array(name, default if values is None else values) & self._given_mask
        array = np.asarray(given, dtype=np.int64)  # masked, every colour fits
        if array.ndim == 0 or array.shape == (count,):
            return np.broadcast_to(array, count)
        raise ValueError(f"{name} must be a number or {count} numbers, not of shape {array.shape}")


def _calls(arguments: dict[str, Numbers]) -> Iterable[Sequence[int]]:
    """The whole numbers of every call that arguments ask for: of one, or one for each element."""
    if any(map(is_array, arguments.values())):
        parts = in_chunks(**arguments)
        return chain.from_iterable(
            zip(*map(np.ndarray.tolist, part), strict=True) for part in parts
        )
    return ([whole(name, value) for name, value in arguments.items()],)
