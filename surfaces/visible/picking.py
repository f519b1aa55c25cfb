"""From a pixel back to the surface: the paper's inverse, put to use.

The inverse (15) needs z beside x' and y', and a pixel has none. But the surface has: in the pixel's
column (see `visible.sweep`) the nearest strip that covers the pixel says which z belongs to it.
Then (x', y', z) -> (x, y, z) is one product with a matrix.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from surfaces.arrays import Bools, Doubles
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.visible.sweep import Sweep

# A pixel on the surface's outline may have its centre just outside: then look around, so far.
AROUND = sorted(product((0.0, 0.5, -0.5), repeat=2), key=lambda way: abs(way[0]) + abs(way[1]))


@dataclass(frozen=True)
class Triangles:
    """Triangles of a surface, in space (m, 3, 3) and on the screen (m, 3, 2)."""

    space: Doubles
    screen: Doubles

    @cached_property
    def _around(self) -> tuple[Doubles, Doubles]:
        return self.screen.min(axis=1), self.screen.max(axis=1)

    def near(self, px: float, py: float) -> "Triangles":
        """Those that may reach a pixel or its edges."""
        low, high = self._around
        here = np.array((px, py))
        near = np.flatnonzero(((low < here + 1) & (high > here - 1)).all(axis=1))
        return Triangles(self.space[near], self.screen[near])

    def hits(self, px: float, py: float) -> Doubles:
        """Their points at a place of the screen, (n, 3)."""
        a, b, c = self.screen.swapaxes(0, 1)
        (bx, by), (cx, cy), (x, y) = (b - a).T, (c - a).T, ((px, py) - a).T
        area = bx * cy - by * cx
        area[area == 0] = np.nan  # a triangle seen on its edge, or none at all
        u, v = (x * cy - y * cx) / area, (bx * y - by * x) / area
        hit = np.flatnonzero((u >= 0) & (v >= 0) & (u + v <= 1))
        start, to_b, to_c = self.space[hit].swapaxes(0, 1)
        found: Doubles = start + u[hit, None] * (to_b - start) + v[hit, None] * (to_c - start)
        return found


def pick(
    sweeps: Sequence[Sweep],
    holes: Sequence[Bools],
    rims: Triangles,
    view: View,
    px: float,
    py: float,
) -> Doubles | None:
    """The nearest point (x, y, z) of height fields at a pixel, or within half a pixel; or None.

    ``holes`` says for each of them which of its cells are not there, or not whole; what there is of
    these is in ``rims``.
    """
    rims = rims.near(px, py)
    for dx, dy in AROUND:
        x, y = px + dx, py + dy
        hits = [
            point
            for sweep, hole in zip(sweeps, holes, strict=True)
            if (point := _first(sweep.hits(x, y), sweep, hole)) is not None
        ]
        if len(rims.space):
            hits.extend(rims.hits(x, y))
        if hits:
            nearest = max(hits, key=lambda point: float(point @ view.eye))
            stored = apply(nearest, view.screen)[2]
            return apply((x, y, stored), view.back)
    return None


def _first(points: Doubles, sweep: Sweep, hole: Bools) -> Doubles | None:
    """The first of some points, the nearest first, that does not lie in a hole."""
    for point in points:
        i = np.clip(np.searchsorted(sweep.grid.x, point[0]) - 1, 0, hole.shape[0] - 1)
        j = np.clip(np.searchsorted(sweep.grid.y, point[1]) - 1, 0, hole.shape[1] - 1)
        if not hole[i, j]:
            return np.asarray(point)
    return None
