"""Small polygons: kept as offsets by their corners, seen from the first one.

What a program fills again and again is often one figure in many places: a piece on its board, a
star, the car that drives across the screen. A shape is kept when it is met for the second time, so
that one that never returns costs nothing but a look.
"""

from typing import NamedTuple

import numpy as np

from bgi.raster import polygons
from bgi.raster.arrays import repeat
from bgi.raster.kept import Kept
from bgi.raster.lines import Trace
from bgi.raster.offsets import Offsets, offsets, reach
from bgi.raster.polygons import Point

MOST_CORNERS = 16
_WIDEST = 128
"""Pixels: what is wider or higher is filled as fast by its rows."""


class Polygon(NamedTuple):
    """A polygon, seen from its first corner."""

    area: Offsets
    outline: Offsets


TOO_LARGE: tuple[()] = ()
"""What is kept of a large polygon."""


def _shape(corners: tuple[Point, ...], trace: Trace, width: int) -> Polygon | tuple[()]:
    """A closed polygon as it lies on pages of one width, which draw lines by `trace`."""
    across, down = zip(*corners, strict=True)
    if max(across) - min(across) > _WIDEST or max(down) - min(down) > _WIDEST:
        return TOO_LARGE
    outline = polygons.paths([*corners, *corners[:1]])
    rows = polygons.scan(outline, min(down), max(down))
    y, one, other = np.array([list(part) for part in rows], dtype=np.int64)
    left, right = np.minimum(one, other), np.maximum(one, other)
    lengths = right - left + 1
    x = repeat(left - (np.cumsum(lengths) - lengths), lengths) + np.arange(lengths.sum())
    y = repeat(y, lengths)
    sides = polygons.edges(outline) or [(*corners[0], *corners[0])]
    x1, y1, x2, y2 = np.array(sides, dtype=np.int64).T
    edge_x, edge_y, _, _ = trace((x1, y1, x2, y2))
    return Polygon(
        offsets(y * width + x, reach(x, y), width),
        offsets(edge_y * width + edge_x, reach(edge_x, edge_y), width),
    )


SHAPES = Kept(_shape, 1 << 23)
"""By corners, by how a page draws lines, and by its width."""
