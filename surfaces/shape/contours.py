"""Contour lines by marching squares, all cells at once.

In a cell, the surface is either above or below the level at each corner. Where two neighbouring
corners differ, the contour crosses the side between them, at the place that interpolates linearly;
the crossings of a cell are joined in pairs. A saddle has four: the mean of its corners says which
go together. (It is the plane's case of marching cubes: Lorensen and Cline, 1987.)
"""

from typing import NamedTuple

import numpy as np

from surfaces.arrays import Doubles, Ints
from surfaces.shape.cells import all_corners
from surfaces.shape.grid import Grid


class Contours(NamedTuple):
    """Straight pieces of contour lines, one in a cell, two in a saddle."""

    starts: Doubles
    """(m, 3): points of the surface."""
    ends: Doubles
    """(m, 3)"""
    cell: Ints
    """(m, 2): the cell i, j that each lies in."""
    corners: Doubles
    """(m, 4, 3): the corners of that cell, or of the part of it that there is."""


# The corners 0..3 of a cell go round; side k leads from corner k to the next.
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))
# Corners above the level, as bits -> pairs of sides to join; saddles (5, 10) with a low middle.
JOINS: dict[int, tuple[tuple[int, int], ...]] = {
    1: ((3, 0),),
    2: ((0, 1),),
    3: ((3, 1),),
    4: ((1, 2),),
    5: ((3, 0), (1, 2)),
    6: ((0, 2),),
    7: ((3, 2),),
    8: ((2, 3),),
    9: ((2, 0),),
    10: ((0, 1), (2, 3)),
    11: ((2, 1),),
    12: ((1, 3),),
    13: ((1, 0),),
    14: ((0, 3),),
}
OTHER_SADDLE = {5: 10, 10: 5}


def contours(grid: Grid, level: float) -> Contours:
    """The lines on the surface where z = level; holes have none."""
    cells, corners = _crossed(grid, level)
    corner_z = corners[..., 2]
    kind = (corner_z >= level) @ (1, 2, 4, 8)
    after = np.roll(corners, -1, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (level - corner_z) / (after[..., 2] - corner_z)
        crossing = (corners + part[..., None] * (after - corners))[..., :2]
    high_middle = corner_z.mean(axis=1) >= level
    for saddle, other in OTHER_SADDLE.items():
        kind = np.where((kind == saddle) & high_middle, -other, kind)
    starts, ends, owners = [], [], []
    for number, pairs in JOINS.items():
        chosen = np.flatnonzero(np.abs(kind) == number)
        for a, b in pairs:
            starts.append(crossing[chosen, a])
            ends.append(crossing[chosen, b])
            owners.append(chosen)
    owner = np.concatenate(owners)
    return Contours(
        _at(np.concatenate(starts), level),
        _at(np.concatenate(ends), level),
        cells[owner],
        corners[owner],
    )


def _crossed(grid: Grid, level: float) -> tuple[Ints, Doubles]:
    """The cells that a level crosses, (m, 2), and their corners in space, (m, 4, 3).

    Parts of cells at the rim of a hole may have one corner twice: no contour passes between these.
    """
    x, y, z = grid.x, grid.y, grid.z
    above = z >= level
    i, j = np.nonzero(grid.whole & ~(all_corners(above) | all_corners(~above)))
    cells = np.stack((i, j), axis=1)
    corners = np.stack(
        [np.stack((x[i + a], y[j + b], z[i + a, j + b]), axis=1) for a, b in CORNERS], axis=1
    )
    if grid.rim is None:
        return cells, corners
    nodes = np.concatenate((grid.points.reshape(-1, 3), grid.rim.points))
    parts = np.stack(np.divmod(grid.rim.cell, len(y) - 1), axis=1)
    return np.concatenate((cells, parts)), np.concatenate((corners, nodes[grid.rim.corners]))


def _at(points: Doubles, level: float) -> Doubles:
    return np.column_stack((points, np.full(len(points), level)))
