"""Filled boxes and polygons, and flood filling."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.constants import EMPTY_FILL, USER_FILL, grError
from bgi.graphics.pen import Pen
from bgi.kernel.arguments import CHUNK, Number, Numbers, polygon_points, whole
from bgi.kernel.state import KERNEL
from bgi.raster import lines, polygons, spans
from bgi.raster.patterns import EMPTY_ROWS, FILL_PATTERNS
from bgi.raster.polygons import Point
from bgi.raster.spans import NO_SPANS
from bgi.settings import fillsettingstype


class Filling(Pen):
    """A screen to fill shapes on."""

    # The fill pattern

    def setfillstyle(self, pattern: Number, color: Number) -> None:
        """Set fill pattern and colour; -11 and no change if either is unknown.

        USER_FILL selects the pattern last given to setfillpattern().
        """
        number, index = whole("pattern", pattern), whole("color", color)
        if not (EMPTY_FILL <= number <= USER_FILL and 0 <= index <= self._mask):
            KERNEL.result.set(grError)
            return
        self.settings.fill = fillsettingstype(number, index)
        user = number == USER_FILL
        self.settings.fill_rows = self.settings.user_rows if user else FILL_PATTERNS[number]

    def setfillpattern(self, pattern: bytes | Sequence[Number], color: Number) -> None:
        """Fill with eight rows of eight bits; -11 and no change for an unknown colour."""
        rows = _eight_rows(pattern)
        index = whole("color", color)
        if not 0 <= index <= self._mask:
            KERNEL.result.set(grError)
            return
        self.settings.fill = fillsettingstype(USER_FILL, index)
        self.settings.fill_rows = self.settings.user_rows = rows

    def getfillpattern(self) -> bytes:
        """The eight rows of the user's pattern, whatever pattern is in use."""
        return self.settings.user_rows

    def getfillsettings(self) -> fillsettingstype:
        """Fill pattern and colour."""
        return replace(self.settings.fill)

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
        x1, x2 = sorted((left + self._dx, right + self._dx))
        y1, y2 = sorted((top + self._dy, bottom + self._dy))
        fill, color = self.settings.fill.color, self.settings.color
        if x2 - x1 > 1 and y2 - y1 > 1:
            self.page.fill((x1 + 1, y1 + 1, x2 - 1, y2 - 1), fill, self.settings.fill_rows)
        self._box(x1, y1, x2, y2, color)
        if depth == 0:
            return
        x3, raised = x2 + depth, (depth * 3) >> 2
        self._segment(x2, y2, x3, y2 - raised, color)
        self._segment(x3, y2 - raised, x3, y1 - raised, color)
        if topflag:
            self._segment(x3, y1 - raised, x1 + depth, y1 - raised, color)
            self._segment(x1 + depth, y1 - raised, x1, y1, color)
            self._segment(x2, y1, x3, y1 - raised, color)

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
        if self._xor:  # the next fill must cover a side before the next side meets it
            for one, shade, ink in zip(corners.tolist(), fills, colors, strict=True):
                self._fill_polygon(self._shifted(one), int(shade), int(ink))
        else:
            for start in range(0, len(corners), CHUNK):
                part = slice(start, start + CHUNK)
                self._fill_polygons(corners[part] + self._origin, fills[part], colors[part])

    def _fill_polygon(self, points: list[Point], fill: int, color: int) -> None:
        outline = self._fill_area(points, fill)
        if color:  # an outline in colour 0 is not drawn
            self._sides(polygons.edges(outline), color)

    def _fill_polygons(
        self, points: NDArray[Any], fills: NDArray[Any], colors: NDArray[Any]
    ) -> None:
        edges = spans.edges_many(np.concatenate([points, points[:, :1]], axis=1))
        drawn = edges.real & (colors != 0)
        rows, box = self.settings.fill_rows, self.page.box
        for part, found in spans.fill(edges, box[1], box[3]):
            owners, side = np.nonzero(drawn[:, part].T)
            owners += part.start
            x1, y1, x2, y2 = (end[side, owners] for end in edges.sides)
            segments = (x1, y1, x2, y2)
            if self._thick:
                segments, owners = lines.strands_many(segments), np.repeat(owners, 3)
            filled = NO_SPANS if rows == EMPTY_ROWS else found
            self.page.paint(filled, fills, rows, segments, owners, colors, self._pattern)

    # Flood filling

    def floodfill(self, x: Numbers, y: Numbers, border: Numbers) -> None:
        """Fill the area around a point up to a border colour."""
        self._each(self._floodfill, x=x, y=y, border=border)

    def _floodfill(self, x: int, y: int, border: int) -> None:
        settings = self.settings
        self.page.flood(
            x + self._dx,
            y + self._dy,
            border & self._mask,
            settings.fill.color,
            settings.fill_rows,
        )


def _eight_rows(pattern: bytes | Sequence[Number]) -> bytes:
    rows = [whole(f"pattern[{i}]", row) & 0xFF for i, row in enumerate(pattern)]
    if len(rows) != 8:
        raise ValueError(f"pattern must be 8 bytes, not {len(rows)}")
    return bytes(rows)
