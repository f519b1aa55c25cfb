"""From a pixel back to the surface, and whether a point of it is seen.

The paper's inverse (15) needs z beside x' and y', and a pixel has none. But the surface has: in the
pixel's column (see `visible.sweep`) the nearest strip that covers the pixel says which z belongs to
it. Then (x', y', z) -> (x, y, z) is one product with a matrix. Where there are no columns,
triangles are asked for their points at the pixel, by barycentric coordinates: those of the tiles,
eight by eight cells, whose boxes on the screen hold the pixel.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from surfaces.arrays import Bools, Doubles
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.visible.lattice import Lattice
from surfaces.visible.sweep import CHUNK, Sweep

# A pixel on the surface's outline may have its centre just outside: then look around, so far.
AROUND = sorted(product((0.0, 0.5, -0.5), repeat=2), key=lambda way: abs(way[0]) + abs(way[1]))
# Cells along each side of a tile.
TILE = 8
# How far outside a point may lie, as a part of the triangle: between two there must be no gap.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Triangles:
    """Triangles of a surface, in space and on the screen."""

    space: Doubles
    """(m, 3, 3)"""
    screen: Doubles
    """(m, 3, 2)"""
    w: Doubles
    """(m, 3): what a perspective divides the corners by; else 1."""

    @classmethod
    def of(cls, space: Doubles, view: View) -> "Triangles":
        """Triangles in space, (m, 3, 3), as they are seen."""
        w = np.ones(space.shape[:2]) if view.parallel else 1 / view.nearness(space)
        return cls(space, apply(space, view.screen)[..., :2], w)

    @classmethod
    def joined(cls, parts: Sequence["Triangles"]) -> "Triangles":
        """All of some triangles."""
        arrays = zip(*((part.space, part.screen, part.w) for part in parts), strict=True)
        space, screen, w = map(np.concatenate, arrays)
        return cls(space, screen, w)

    @cached_property
    def _around(self) -> tuple[Doubles, Doubles]:
        return self.screen.min(axis=1), self.screen.max(axis=1)

    def near(self, px: float, py: float) -> "Triangles":
        """Those that may reach a pixel or its edges."""
        low, high = self._around
        here = np.array((px, py))
        near = np.flatnonzero(((low < here + 1) & (high > here - 1)).all(axis=1))
        return Triangles(self.space[near], self.screen[near], self.w[near])

    def points_at(self, px: float, py: float) -> Doubles:
        """Their points at a place of the screen, (n, 3)."""
        a, b, c = self.screen.swapaxes(0, 1)
        (bx, by), (cx, cy), (x, y) = (b - a).T, (c - a).T, ((px, py) - a).T
        area = bx * cy - by * cx
        area[area == 0] = np.nan  # a triangle seen on its edge, or none at all
        u, v = (x * cy - y * cx) / area, (bx * y - by * x) / area
        hit = np.flatnonzero((u >= -ROUNDING) & (v >= -ROUNDING) & (u + v <= 1 + ROUNDING))
        # Barycentric coordinates on the screen are those in space, times w, up to their sum.
        at_b, at_c = u[hit] / self.w[hit, 1], v[hit] / self.w[hit, 2]
        whole = (1 - u[hit] - v[hit]) / self.w[hit, 0] + at_b + at_c
        u[hit], v[hit] = at_b / whole, at_c / whole
        start, to_b, to_c = self.space[hit].swapaxes(0, 1)
        found: Doubles = start + u[hit, None] * (to_b - start) + v[hit, None] * (to_c - start)
        return found


class Tiles:
    """Where a lattice's cells are on the screen: boxes around eight by eight of them."""

    def __init__(self, lattice: Lattice, view: View) -> None:
        """Look once at every node."""
        self._lattice, self._view = lattice, view
        rows = [self._boxes(first) for first in range(0, len(lattice.whole), TILE)]
        self._in_row = rows[0].shape[-1]
        self._low, self._high = np.concatenate(rows, axis=-1)
        rims = np.zeros((0, 3, 3))
        if lattice.rim is not None:
            nodes = np.stack((lattice.x, lattice.y, lattice.z), axis=-1).reshape(-1, 3)
            rims = lattice.rim[0].triangles(nodes)
        self._rims = Triangles.of(rims, view)

    def _boxes(self, first: int) -> Doubles:
        """The lowest and the highest x and y of a row of tiles, (2, 2, tiles)."""
        rows, count = slice(first, first + TILE + 1), self._lattice.whole.shape[1]
        ways = (way[rows] for way in (self._lattice.x, self._lattice.y, self._lattice.z))
        places = np.stack(self._view.places(*ways))
        starts = np.arange(0, count, TILE)
        ends = np.minimum(starts + TILE, count)
        found = []
        for extreme in (np.fmin, np.fmax):  # they pass over NaN
            at_columns = extreme.reduce(places, axis=1)
            within = extreme.reduceat(at_columns, starts, axis=1)
            found.append(extreme(within, at_columns[:, ends]))
        return np.stack(found)

    def near(self, px: float, py: float) -> Triangles:
        """The triangles that may reach a pixel or its edges: two for every cell, and at rims."""
        here = np.array(((px,), (py,)))
        tiles = np.flatnonzero(((self._low < here + 1) & (self._high > here - 1)).all(axis=0))
        row, column = np.divmod(tiles, self._in_row)
        i, j = np.divmod(np.arange(TILE * TILE), TILE)
        i, j = ((TILE * row[:, None] + i).ravel(), (TILE * column[:, None] + j).ravel())
        lattice = self._lattice
        height, width = lattice.whole.shape
        inside = np.flatnonzero((i < height) & (j < width))
        i, j = i[inside], j[inside]
        cells = (i * width + j)[lattice.whole[i, j]]
        at = np.divmod(lattice.corners(cells).T, width + 1)
        space = np.stack((lattice.x[at], lattice.y[at], lattice.z[at]), axis=-1)
        halves = Triangles.of(np.concatenate((space[:, :3], space[:, [0, 2, 3]])), self._view)
        return Triangles.joined((halves.near(px, py), self._rims.near(px, py)))


def nearest(points: Sequence[Doubles] | Doubles, view: View) -> Doubles | None:
    """Of points (x, y, z) on one pixel the one nearest to the eye; None if there are none."""
    return max(points, key=lambda point: float(view.nearness(point)), default=None)


def pick(
    sweeps: Sequence[Sweep],
    holes: Sequence[Bools],
    rims: Triangles,
    view: View,
    px: float,
    py: float,
) -> Doubles | None:
    """The nearest point (x, y, z) of height fields at a pixel, or within half a pixel; or None.

    Args:
        sweeps: The columns of each of them.
        holes: Which of its cells, (nx, ny), are not there, or not whole.
        rims: What there is of cells that are not whole.
        view: How they are seen.
        px: The pixel's x...
        py: ... and y.
    """
    rims = rims.near(px, py)
    for dx, dy in AROUND:
        x, y = px + dx, py + dy
        hits = [
            point
            for sweep, hole in zip(sweeps, holes, strict=True)
            if (point := _first(sweep.points_at(x, y), sweep, hole)) is not None
        ]
        if len(rims.space):
            hits.extend(rims.points_at(x, y))
        hit = nearest(hits, view)
        if hit is not None:
            return apply((x, y, apply(hit, view.screen)[2]), view.back)
    return None


def pick_triangle(triangles: Triangles, view: View, px: float, py: float) -> Doubles | None:
    """The nearest point (x, y, z) of triangles at a pixel, or within half a pixel; or None."""
    for dx, dy in AROUND:
        hit = nearest(triangles.points_at(px + dx, py + dy), view)
        if hit is not None:
            return hit
    return None


def _first(points: Doubles, sweep: Sweep, hole: Bools) -> Doubles | None:
    """The first of some points, the nearest first, that does not lie in a hole."""
    for point in points:
        i = np.clip(np.searchsorted(sweep.grid.x, point[0]) - 1, 0, hole.shape[0] - 1)
        j = np.clip(np.searchsorted(sweep.grid.y, point[1]) - 1, 0, hole.shape[1] - 1)
        if not hole[i, j]:
            return np.asarray(point)
    return None


def seen(sweeps: Sequence[Sweep], points: Doubles) -> Bools:
    """Which points (m, 3) of the surfaces no strip hides; a strip of its own cell never does.

    The horizon knows what hides a point when the surface has no holes and is alone. Otherwise this
    asks, for each point, every strip in its column: that costs one look at every line for every
    point. For lines on a surface, whose points are few, it is quick enough.
    """
    found = np.ones(len(points), dtype=bool)
    for sweep in sweeps:
        if not sweep.edge_on:
            step = max(1, CHUNK // sweep.shape[0])
            for start in range(0, len(points), step):
                part = slice(start, start + step)
                found[part] &= ~sweep.hidden(points[part])
    return found
