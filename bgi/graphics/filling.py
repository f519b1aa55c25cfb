"""Filled boxes and polygons, and flood filling."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.constants import EMPTY_FILL, USER_FILL, grError
from bgi.graphics.pen import Pen
from bgi.kernel.arguments import Number, Numbers, length, polygon_points, whole
from bgi.kernel.state import KERNEL
from bgi.raster import lines, polygons, spans
from bgi.raster.lines import Ints, Segments
from bgi.raster.patterns import EMPTY_ROWS
from bgi.raster.polygons import Point, Rows
from bgi.raster.shapes import MOST_CORNERS, SHAPES
from bgi.raster.spans import NO_SPANS
from bgi.settings import fillsettingstype

POLYGONS = 4096
"""Polygons worked on at a time: the arrays of their sides fit into the processor's cache."""


class Filling(Pen):
    """A screen to fill shapes on."""

    # The fill pattern

    def setfillstyle(self, pattern: Number, color: Number) -> None:
        """Set fill pattern and colour; -11 and no change for an unknown pattern."""
        number, index = whole("pattern", pattern), whole("color", color)
        if EMPTY_FILL <= number < USER_FILL:
            fill = self.settings.fill
            fill.pattern, fill.color = number, index
            self._use_fill_settings()
        else:
            KERNEL.result.set(grError)

    def setfillpattern(self, pattern: bytes | Sequence[Number], color: Number) -> None:
        """Fill with eight rows of eight bits; -11 and no change for an unknown colour."""
        rows = _eight_rows(pattern)
        index = whole("color", color)
        if 0 <= index <= self._mask:
            self.settings.fill = fillsettingstype(USER_FILL, index)
            self.settings.user_rows = rows
            self._use_fill_settings()
        else:
            KERNEL.result.set(grError)

    def getfillpattern(self) -> bytes:
        """The eight rows of the user's pattern, whatever pattern is in use."""
        return self.settings.user_rows

    def getfillsettings(self) -> fillsettingstype:
        """Fill pattern and colour as given."""
        fill = self.settings.fill
        return fillsettingstype(fill.pattern, fill.color)

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
        if fill is None and type(left) is type(top) is type(right) is type(bottom) is int:
            dx, dy = self._dx, self._dy
            ink, rows = self._fill_ink, self._fill_rows
            self.page.fill(left + dx, top + dy, right + dx, bottom + dy, ink, rows)
        else:
            shade = self.settings.fill.color if fill is None else fill
            call = self._bar_in_color
            self._each(call, left=left, top=top, right=right, bottom=bottom, fill=shade)

    def _bar_in_color(self, left: int, top: int, right: int, bottom: int, fill: int) -> None:
        dx, dy = self._dx, self._dy
        ink, rows = self._fill_index(fill), self._fill_rows
        self.page.fill(left + dx, top + dy, right + dx, bottom + dy, ink, rows)

    def bar3d(
        self,
        left: Numbers,
        top: Numbers,
        right: Numbers,
        bottom: Numbers,
        depth: Numbers,
        topflag: Numbers,
    ) -> None:
        """Fill a box, and outline it with its side and top in depth."""
        if (
            type(left) is type(top) is type(right) is type(bottom) is int
            and type(depth) is type(topflag) is int
        ):
            self._bar3d(left, top, right, bottom, depth, topflag)
            return
        self._each(
            self._bar3d,
            left=left,
            top=top,
            right=right,
            bottom=bottom,
            depth=depth,
            topflag=topflag,
        )

    def _bar3d(
        self, left: int, top: int, right: int, bottom: int, depth: int, topflag: int
    ) -> None:
        self._bar3d_front(left, top, right, bottom)
        # The corners are sorted as unsigned numbers: one below 0 counts as the far one.
        if (right < 0, right) < (left < 0, left):
            left, right = right, left
        if (bottom < 0, bottom) < (top < 0, top):
            top, bottom = bottom, top
        x1, y1, x2, y2 = left + self._dx, top + self._dy, right + self._dx, bottom + self._dy
        color = self._ink
        self._box(x1, y1, x2, y2, color)
        if depth == 0:
            return
        # Three quarters of the depth, an unsigned number too: a negative one rises far away.
        x3, raised = x2 + depth, (depth * 3 + (0x10000 if depth < 0 else 0)) >> 2
        self._segment(x2, y2, x3, y2 - raised, color)
        self._segment(x3, y2 - raised, x3, y1 - raised, color)
        if topflag:
            self._segment(x3, y1 - raised, x1 + depth, y1 - raised, color)
            self._segment(x1 + depth, y1 - raised, x1, y1, color)
            self._segment(x2, y1, x3, y1 - raised, color)

    def _bar3d_front(self, left: int, top: int, right: int, bottom: int) -> None:
        """Fill within the outline, if the viewport shows three pixels each way of the whole."""
        x1, x2 = (left, right) if left <= right else (right, left)
        y1, y2 = (top, bottom) if top <= bottom else (bottom, top)
        x1, y1, x2, y2 = x1 + self._dx, y1 + self._dy, x2 + self._dx, y2 + self._dy
        box = self.page.box
        if min(x2, box[2]) - max(x1, box[0]) >= 2 and min(y2, box[3]) - max(y1, box[1]) >= 2:
            ink, rows = self._fill_ink, self._fill_rows
            self.page.fill(x1 + 1, y1 + 1, x2 - 1, y2 - 1, ink, rows)

    # Polygons

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
        # In XOR mode the next fill must cover a side before the next side meets it.
        if self._xor or self._wide:
            for one, shade, ink in zip(corners.tolist(), fills, colors, strict=True):
                self._fill_polygon(self._shifted(one), int(shade), int(ink))
        else:
            for start in range(0, len(corners), POLYGONS):
                part = slice(start, start + POLYGONS)
                self._fill_polygons(self._columns(corners[part]), fills[part], colors[part])

    def _fill_polygon(self, points: list[Point], fill: int, color: int) -> None:
        fill, ink = self._fill_index(fill), self._index(color)
        if self._fill_again(points, fill, ink if color else None):
            return
        outline = polygons.paths([*points, *points[:1]])
        if self._fill_rows != EMPTY_ROWS:  # which leaves a polygon's interior alone
            self._fill_area(outline, fill)
        if color:  # an outline in colour 0 is not drawn, though one in 16 is: as index 0
            self._outline(outline or [points[:1] * 2], ink)  # a polygon of one point is that point

    def _fill_again(self, points: list[Point], fill: int, ink: int | None) -> bool:
        """Fill a small polygon that was met before; False if it is not one, or an edge cuts it."""
        rows, page = self._fill_rows, self.page
        if not (self._plain and rows != EMPTY_ROWS and 0 < len(points) <= MOST_CORNERS):
            return False
        (x, y), (left, top, right, bottom) = points[0], page.box
        if not (left <= x <= right and top <= y <= bottom):
            return False
        corners = tuple([(corner_x - x, corner_y - y) for corner_x, corner_y in points])
        shape = SHAPES.again(corners, page.trace, page.width)
        if not shape or not page.fill_offsets(x, y, shape.area, fill, rows):
            return False
        return ink is None or page.put_offsets(x, y, shape.outline, ink, False)

    def _fill_polygons(
        self, points: NDArray[Any], fills: NDArray[Any], colors: NDArray[Any]
    ) -> None:
        x, y = np.concatenate([points, points[:, :1]], axis=1)
        fills, inks = self._fill_index(fills), self._index(colors)
        rows, box = self._fill_rows, self.page.box
        sides, owners = self._outlines(x, y, np.flatnonzero(colors))
        for part, found in spans.fill(x, y, box[1], box[3]):
            first, last = owners.searchsorted((part.start, part.stop))
            x1, y1, x2, y2 = (end[first:last] for end in sides)
            filled = NO_SPANS if rows == EMPTY_ROWS else found
            own = owners[first:last]
            self.page.paint(filled, fills, rows, (x1, y1, x2, y2), own, inks, self._dashes)

    def _outlines(self, x: NDArray[Any], y: NDArray[Any], drawn: Ints) -> tuple[Segments, Ints]:
        """The lines of those polygons that are outlined, and whose line each of them is."""
        (x1, y1, x2, y2), real = spans.edges_many(x[:, drawn], y[:, drawn])
        real[0] |= ~real.any(axis=0)  # a polygon of one point is that point
        which, side = np.nonzero(real.T)
        sides = x1[side, which], y1[side, which], x2[side, which], y2[side, which]
        owners = drawn[which]
        return (lines.strands_many(sides), np.repeat(owners, 3)) if self._thick else (sides, owners)

    # Flood filling

    def floodfill(self, x: Numbers, y: Numbers, border: Numbers) -> None:
        """Fill the area around a point up to a border colour."""
        if type(x) is int and type(y) is int and type(border) is int:
            self._floodfill(x, y, border)
        else:
            self._each(self._floodfill, x=x, y=y, border=border)

    def _floodfill(self, x: int, y: int, border: int) -> None:
        self.page.fill_rows(self._area(x, y, border), self._fill_ink, self._fill_rows)

    def _area(self, x: int, y: int, border: int) -> Rows:
        """The area that a flood from there would fill."""
        x, y, border = x + self._dx, y + self._dy, border & self._mask
        return self.page.area(x, y, border, self._fill_ink, self._fill_rows)

    def _overflows(self, x: int, y: int, border: int) -> bool:
        """Whether a flood from there would reach all four sides of the viewport."""
        rows, starts, ends = self._area(x, y, border)
        return bool(rows) and (min(starts), min(rows), max(ends), max(rows)) == self.page.box


def _eight_rows(pattern: bytes | Sequence[Number]) -> bytes:
    count = length("pattern", pattern)
    if count != 8:
        raise ValueError(f"pattern must be 8 bytes, not {count}")
    return bytes(whole(f"pattern[{i}]", row) & 0xFF for i, row in enumerate(pattern))
