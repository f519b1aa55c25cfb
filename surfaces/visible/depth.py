"""The z-buffer: a depth for every pixel (Catmull's thesis, 1974).

It draws cells anywhere in space, in any order, even through one another. The paper keeps z beside
x' and y', "only to get the inverse". On one pixel, though, larger z means nearer to the eye: the
triple is all that a z-buffer needs. For turned surfaces we take what always holds, the distance
along the line of sight. A cell is two triangles; on each its depth and its value run evenly, and
each pixel keeps the nearest it was offered.
"""

from collections.abc import Iterable

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import Pen
from surfaces.visible.lattice import Cells
from surfaces.visible.scan import covered, reaching

COLOR = 255
"""The last of the 64 bits of a depth hold its colour: one maximum finds the nearest and that."""
HALVES = ((0, 0), (1, 2), (2, 3))
"""The corners of a cell's two triangles."""


class DepthBuffer:
    """The nearest colour for every pixel of the screen."""

    def __init__(
        self,
        pen: Pen,
        palette: Palette,
        view: View,
        cells: Iterable[Cells],
        drawn: Iterable[Cells] = (),
    ) -> None:
        """Offer cells to the pixels that they cover; those `drawn` are on the screen already."""
        self._pen, self._palette, self._view = pen, palette, view
        self._nearest = np.full(pen.width * pen.height, -np.inf)
        self._low, self._high = np.inf, -np.inf
        for part in drawn:
            self._add(part)
        self._drawn = self._nearest.copy()
        for part in cells:
            self._add(part)

    def _add(self, cells: Cells) -> None:
        """Offer cells."""
        near = cells.near.take(cells.corners)
        if near.size:
            self._low, self._high = min(self._low, near.min()), max(self._high, near.max())
        for under in (False, True):
            corners = cells.corners.take(np.flatnonzero(cells.under == under), axis=1)
            self._triangles(cells, corners[HALVES, :].reshape(3, -1), under)

    def _triangles(self, cells: Cells, corners: Ints, under: bool) -> None:
        """Offer triangles, (3, n), of which the under side is seen, or the upper one."""
        width, height = self._pen.width, self._pen.height
        x, y = (way.take(corners) for way in cells.screen)
        area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])
        seen = np.flatnonzero(reaching(x, y, width, height) & (area != 0))
        corners, area = corners.take(seen, axis=1), area.take(seen)
        x, y = x.take(seen, axis=1), y.take(seen, axis=1)
        column, row, owner = covered(x, y, width, height)

        def across(nodes: Doubles) -> Doubles:
            """What runs evenly from corner to corner, at the pixels."""
            a, b, c = nodes.take(corners)
            b, c = b - a, c - a
            right = (b * (y[2] - y[0]) - c * (y[1] - y[0])) / area
            down = (c * (x[1] - x[0]) - b * (x[2] - x[0])) / area
            start = a - right * x[0] - down * y[0]
            found: Doubles = start.take(owner) + right.take(owner) * column
            found += down.take(owner) * row
            return found

        depth = across(cells.near)
        if self._view.parallel:
            value = across(cells.values)
        else:  # on the screen value/w and 1/w run evenly (Blinn, 1992)
            value = across(cells.values * cells.near) / depth
        pixel_x, pixel_y = column.astype(np.int64), row.astype(np.int64)
        key = depth.view(np.int64) & ~COLOR | self._palette.shade(value, pixel_x, pixel_y, under)
        np.maximum.at(self._nearest, pixel_y * width + pixel_x, key.view(np.float64))

    @property
    def _range(self) -> float:
        """From the farthest cell to the nearest; in a perspective from what is infinitely far."""
        low = self._low if self._view.parallel else 0.0
        return self._high - low if self._high > low else 1.0

    def shows(self, points: Doubles) -> Bools:
        """Which points (m, 3) are on the screen and not behind a cell.

        On a steep cell the depth changes much within a pixel. So a point counts as behind it only
        if it is so by a hundredth of the way from the farthest cell to the nearest.
        """
        near = self._view.nearness(points)
        shown = ~self.hides(points, near + self._range / 100)
        return shown if self._view.parallel else shown & (near > 0)  # and not behind the eye

    def hides(self, points: Doubles, nearest: Doubles) -> Bools:
        """Whether a cell nearer than `nearest`, (m,) of `View.nearness`, is seen at points (m, 3).

        What is off the screen is hidden.
        """
        x, y = np.floor(apply(points, self._view.screen)[:, :2] + 0.5).astype(np.int64).T
        inside = (x >= 0) & (x < self._pen.width) & (y >= 0) & (y < self._pen.height)
        hidden: Bools = ~inside
        there = self._nearest[y[inside] * self._pen.width + x[inside]]
        hidden[inside] = there > nearest[inside]
        return hidden

    def draw(self) -> None:
        """Set each pixel to the nearest colour, unless what is drawn already is nearer."""
        place = np.flatnonzero(self._nearest > self._drawn)
        y, x = np.divmod(place, self._pen.width)
        self._pen.pixels(x, y, self._nearest.view(np.int64)[place] & COLOR)
