"""Where a surface ends inside a cell: the rim of a hole.

sqrt(1 - x*x - y*y) has values inside a circle, and no grid has that circle among its lines. Between
a node with a value and a neighbour without, bisection finds where the values end; a cell that has
both kinds is part of the surface as far as the line between two such ends. Where a function has
values right up to the neighbour and again behind it, as 1/x about 0, or grows without end, as
log(r) there, there is no rim: the hole is a missing point, or a pole.

Data say nothing between their nodes: there, a cell that lacks one corner is half of a cell, the
triangle of the other three.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape.cells import all_corners, with_three_corners

Value = Callable[[Doubles, Doubles], Doubles]
"""Heights at points; NaN where there is none."""

HALVINGS = 12
"""Steps of the bisection: they find the rim to 1/4096 of a cell."""
SETTLING, SMALL = 0.8, 1e-3
"""A height has settled if over the last 1/64 of the way it changes by at most SETTLING times its
change over the 7/64 before, plus SMALL of the surface's height."""


@dataclass(frozen=True)
class Rim:
    """Parts of cells at the rims of holes. Nodes and cells are numbered row by row."""

    points: Doubles
    """(r, 3): where lines of the grid end."""
    beside: Ints
    """(r,): the number of the node from which each such line comes."""
    corners: Ints
    """(m, 4): quadrangles, or triangles with one corner twice. A number is that of a node or, from
    the number of nodes on, of a point."""
    cell: Ints
    """(m,): the number of the cell that each is part of."""

    def around(self, origin: Doubles) -> "Rim":
        """The same with its coordinates counted from a point, (3,)."""
        return replace(self, points=self.points - origin)

    def triangles(self, nodes: Doubles) -> Doubles:
        """The parts as triangles in space, (2 m, 3, 3); `nodes` are the grid's, (n, 3)."""
        a, b, c, d = np.concatenate((nodes, self.points))[self.corners].swapaxes(0, 1)
        return np.concatenate((np.stack((a, b, c), axis=1), np.stack((a, c, d), axis=1)))


def _pieces(case: int) -> list[tuple[int, int, int, int]]:
    """The parts of a cell that are there, if its bits say which of the four corners are.

    Places 0 to 3 are the corners in their order, 4 to 7 the ends on the sides that follow them.
    """
    there = [bool(case >> corner & 1) for corner in range(4)]
    if case in (0b0101, 0b1010):  # two corners opposite each other, each on its own
        return [(4 + (k + 3) % 4, k, 4 + k, 4 + k) for k in range(4) if there[k]]
    ring: list[int] = []
    for k in range(4):
        ring += [k] * there[k] + [4 + k] * (there[k] != there[(k + 1) % 4])
    a, b, c, *more = ring
    if len(more) == 2:
        return [(a, b, c, more[0]), (a, more[0], more[1], more[1])]
    return [(a, b, c, more[0] if more else c)]


PIECES = [_pieces(case) if 0 < case < 15 else [] for case in range(16)]


def find(value: Value, x: Doubles, y: Doubles, z: Doubles) -> Rim:
    """The rims of holes, NaN, in a function's heights z[i, j] at x[i], y[j]."""
    there, width = np.isfinite(z), z.shape[1]
    cells, corners = _mixed(there)
    inside = there.ravel()[corners]
    # The sides between a node and a hole, once each, by their first node and their way.
    ends = inside != np.roll(inside, -1, axis=1)
    a, b, _, d = corners.T
    sides = np.stack((2 * a, 2 * b + 1, 2 * d, 2 * a + 1), axis=1)
    once, which = np.unique(sides[ends], return_inverse=True)
    first, along_y = np.divmod(once, 2)
    second = first + np.where(along_y, 1, width)
    node, hole = np.where(there.ravel()[first], (first, second), (second, first))
    points, known = _ends(value, x, y, z, node, hole)

    # A cell's corners, and the numbers of the ends on its sides, or -1.
    places = np.concatenate((corners, np.full(corners.shape, -1)), axis=1)
    places[:, 4:][ends] = np.where(known, z.size + np.cumsum(known) - 1, -1)[which]
    case = inside @ (1, 2, 4, 8)
    owners, parts = [np.zeros(0, np.int64)], [np.zeros((0, 4), np.int64)]
    for pieces, found in zip(PIECES, (np.flatnonzero(case == n) for n in range(16)), strict=True):
        found = found[(places[found][:, sorted({*sum(pieces, ())})] >= 0).all(axis=1)]
        for piece in pieces:
            owners.append(cells[found])
            parts.append(places[found][:, piece])
    return Rim(points[known], node[known], np.concatenate(parts), np.concatenate(owners))


def of_data(z: Doubles) -> Rim:
    """The rims of holes, NaN, in heights that are known at the nodes only."""
    there = np.isfinite(z)
    cells, corners = _mixed(there)
    three, corners = with_three_corners(corners, there.ravel()[corners])
    return Rim(np.zeros((0, 3)), np.zeros(0, np.int64), corners, cells[three])


def _mixed(there: Bools) -> tuple[Ints, Ints]:
    """The cells of which some corners are there and some are not, (m,), and the corners, (m, 4)."""
    cells = np.flatnonzero(~(all_corners(there) | all_corners(~there)))
    width = there.shape[1]
    first = cells + cells // (width - 1)
    return cells, first[:, None] + np.array((0, width, width + 1, 1))


def _ends(
    value: Value, x: Doubles, y: Doubles, z: Doubles, node: Ints, hole: Ints
) -> tuple[Doubles, Bools]:
    """Where the surface ends between nodes and holes, (n, 3), and whether it does so there."""
    start, stop = (np.stack((x[i // len(y)], y[i % len(y)]), axis=-1) for i in (node, hole))
    way = stop - start
    good, bad = np.zeros(len(node)), np.ones(len(node))
    height = z.ravel()[node]
    for _ in range(HALVINGS):
        middle = (good + bad) / 2
        found = value(*(start + middle[:, None] * way).T)
        finite = np.isfinite(found)
        good, bad = np.where(finite, middle, good), np.where(finite, bad, middle)
        height = np.where(finite, found, height)
    # Toward a rim heights settle, toward a pole they grow.
    before, late = (value(*(start + (part * good)[:, None] * way).T) for part in (7 / 8, 63 / 64))
    slack = SMALL * (np.nanmax(z) - np.nanmin(z))
    settled = np.abs(height - late) <= SETTLING * np.abs(late - before) + slack
    # Behind a missing point, or a line of them, there is more of the surface.
    behind = np.column_stack(np.divmod(hole, len(y))) * 2 - np.column_stack(np.divmod(node, len(y)))
    inside = ((behind >= 0) & (behind < z.shape)).all(axis=1)
    goes_on = np.zeros(len(node), dtype=bool)
    goes_on[inside] = np.isfinite(z[tuple(behind[inside].T)])
    known = ((bad < 1) | ~goes_on) & settled
    return np.column_stack((start + good[:, None] * way, height)), known
