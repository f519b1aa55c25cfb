"""The z-buffer: a depth for every pixel (Catmull's thesis, 1974).

It draws cells anywhere in space, in any order, even through one another. The paper keeps z beside
x' and y', "only to get the inverse". On one pixel, though, larger z means nearer to the eye: the
triple is all that a z-buffer needs. For turned surfaces we take what always holds, the distance
along the line of sight. A cell is two triangles; each is filled row by row, its depth and its value
running evenly, and each pixel keeps the nearest it was offered.
"""

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.space.transforms import apply
from surfaces.systems.colors import Palette
from surfaces.systems.pen import Pen
from surfaces.visible.order import Cells

CHUNK = 2048
"""Cells at a time: the arrays that are made of them stay in the cache."""
NEARNESS = 2.0**44
"""Steps of depth from the farthest to the nearest. Eight bits of colour go below them: then one
maximum finds the nearest and its colour."""


class DepthBuffer:
    """The nearest colour for every pixel of the screen."""

    def __init__(
        self, pen: Pen, palette: Palette, cells: Cells, drawn: Cells | None = None
    ) -> None:
        """Offer cells to the pixels that they cover; those `drawn` are on the screen already."""
        self._pen, self._palette, self._view = pen, palette, cells.view
        self._nearest = np.full(pen.width * pen.height, -1, dtype=np.int64)
        parts = [cells] if drawn is None else [drawn, cells]
        depths = [self._view.nearness(part.nodes)[part.corners] for part in parts]
        near = np.concatenate(depths)
        # A perspective divides by depths: there, zero is what is infinitely far away.
        low, high = (float(near.min()), float(near.max())) if near.size else (0.0, 1.0)
        self._farthest = low if self._view.parallel else 0.0
        self._range = high - self._farthest or 1.0
        for part, depth in zip(parts, depths, strict=True):
            self._drawn = self._nearest.copy()
            screen = part.screen
            self._add(screen, self._depth(depth), part.values[part.corners], part.under(screen))

    def _depth(self, near: Doubles) -> Doubles:
        """How near points are, from 0 to 1."""
        return (near - self._farthest) / self._range

    def _add(self, screen: Doubles, depth: Doubles, value: Doubles, under: Bools) -> None:
        """Offer cells.

        Args:
            screen: (m, 4, 2): their corners on the screen.
            depth: (m, 4): how near the corners are, 0 to 1.
            value: (m, 4): what the colour shows there, 0 to 1.
            under: (m,): whether the under side is seen.
        """
        if not self._view.parallel:
            value = value * depth
        for start in range(0, len(screen), CHUNK):
            part = slice(start, start + CHUNK)
            corners = np.concatenate(
                (screen[part], depth[part, :, None], value[part, :, None]), axis=2
            )
            for triangle in ((0, 1, 2), (0, 2, 3)):
                self._triangles(corners[:, triangle], under[part])

    def _triangles(self, corners: Doubles, under: Bools) -> None:
        """Offer triangles: corners (m, 3, 4), each of them x, y, depth and value."""
        a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        area = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
        seen = np.flatnonzero(area)  # one seen on its edge covers no pixel
        corners, a, ab, ac, area = corners[seen], a[seen], ab[seen], ac[seen], area[seen, None]
        # How depth and value change from pixel to pixel, to the right and down.
        right = ((ab[:, 2:] * ac[:, 1:2] - ac[:, 2:] * ab[:, 1:2]) / area).T
        down = ((ac[:, 2:] * ab[:, :1] - ab[:, 2:] * ac[:, :1]) / area).T
        at_origin = a[:, 2:].T - right * a[:, 0] - down * a[:, 1]

        row, owner, left, far = self._rows(corners)
        first = np.ceil(np.maximum(left, 0)).astype(np.int64)
        last = np.floor(np.minimum(far, self._pen.width - 1)).astype(np.int64)
        x, span = _ranges(first, last)
        owner, y = owner.take(span), row.take(span)
        depth, value = (
            start.take(owner) + to_right.take(owner) * x + below.take(owner) * y
            for start, to_right, below in zip(at_origin, right, down, strict=True)
        )
        if not self._view.parallel:  # on the screen value/w and 1/w run evenly (Blinn, 1992)
            value = value / depth
        shade = self._palette.shade(value, x, y, under[seen].take(owner))
        key = (np.clip(depth, 0, 1) * NEARNESS).astype(np.int64) << 8 | shade
        np.maximum.at(self._nearest, y * self._pen.width + x, key)

    def _rows(self, corners: Doubles) -> tuple[Ints, Ints, Doubles, Doubles]:
        """The rows of pixels that triangles, (m, 3, 4), cover: four arrays, (n,).

        The row of the screen, the number of the triangle, and where it begins and ends in the row.
        """
        x, y = corners[:, :, 0].T, corners[:, :, 1].T
        top = np.ceil(np.maximum(y.min(axis=0), 0)).astype(np.int64)
        bottom = np.floor(np.minimum(y.max(axis=0), self._pen.height - 1)).astype(np.int64)
        row, owner = _ranges(top, bottom)
        left, far = np.full(len(row), np.inf), np.full(len(row), -np.inf)
        for k in range(3):  # each side that the row meets bounds it
            y1, y2 = y[k].take(owner), y[k - 1].take(owner)
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = ((x[k - 1] - x[k]) / (y[k - 1] - y[k])).take(owner)
                crossing = x[k].take(owner) + (row - y1) * slope
            meets = (row - y1) * (row - y2) <= 0
            left = np.where(meets, np.fmin(left, crossing), left)
            far = np.where(meets, np.fmax(far, crossing), far)
        return row, owner, left, far

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
        hidden[inside] = (there >> 8) / NEARNESS > self._depth(nearest[inside])
        return hidden

    def draw(self) -> None:
        """Set each pixel to the nearest colour, unless what is drawn already is nearer."""
        place = np.flatnonzero(self._nearest > self._drawn)
        y, x = np.divmod(place, self._pen.width)
        self._pen.pixels(x, y, self._nearest[place] & 255)


def _ranges(first: Ints, last: Ints) -> tuple[Ints, Ints]:
    """The whole numbers of many ranges, one after the other, and which range each is from."""
    count = np.maximum(last - first + 1, 0)
    owner = np.repeat(np.arange(len(count)), count)
    begin = np.cumsum(count) - count
    return np.arange(len(owner)) - (begin - first)[owner], owner
