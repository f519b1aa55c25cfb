"""From a pixel back to the surface: the paper's inverse, put to use.

The inverse (15) needs z beside x' and y', and a pixel has none. But the surface has: in the pixel's
column (see `surfaces.sweep`) the nearest strip that covers the pixel says which z belongs to it.
Then (x', y', z) -> (x, y, z) is one product with a matrix.
"""

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from surfaces.hidden import View
from surfaces.sweep import Sweep
from surfaces.transforms import FloatArray, apply

# A pixel on the surface's outline may have its centre just outside: then look around, so far.
AROUND = sorted(product((0.0, 0.5, -0.5), repeat=2), key=lambda way: abs(way[0]) + abs(way[1]))


def pick(
    sweeps: Sequence[Sweep], holes: Sequence[NDArray[np.bool_]], view: View, px: float, py: float
) -> FloatArray | None:
    """The nearest point (x, y, z) of height fields at a pixel, or within half a pixel; or None.

    ``holes`` says for each of them which of its cells are not there.
    """
    for dx, dy in AROUND:
        x, y = px + dx, py + dy
        hits = [
            point
            for sweep, hole in zip(sweeps, holes, strict=True)
            if (point := _first(sweep.hits(x, y), sweep, hole)) is not None
        ]
        if hits:
            nearest = max(hits, key=lambda point: float(point @ view.eye))
            stored = apply(nearest, view.screen)[2]
            return apply((x, y, stored), view.back)
    return None


def _first(points: FloatArray, sweep: Sweep, hole: NDArray[np.bool_]) -> FloatArray | None:
    """The first of some points, the nearest first, that does not lie in a hole."""
    for point in points:
        i = np.clip(np.searchsorted(sweep.grid.x, point[0]) - 1, 0, hole.shape[0] - 1)
        j = np.clip(np.searchsorted(sweep.grid.y, point[1]) - 1, 0, hole.shape[1] - 1)
        if not hole[i, j]:
            return np.asarray(point)
    return None
