"""Which cell hides which: the painter's order, without sorting where that can be.

The cells of z = f(x, y) stand between vertical planes x = x[i]. A ray of light on its way to the
eye crosses all these planes in one direction, the one in which the eye lies; so drawing the cells
plane by plane toward the eye, what comes later may hide what came before, and never the reverse.
The same holds for y. That is exact, needs no depths, and needs no sorting.

It stays true when the surface is turned, reflected or sheared, with the direction of the eye as
seen from the surface (see `surfaces.space.view`).

Several surfaces over the same grid take turns cell by cell, in each the one farthest from the eye
first: right as long as they do not cross inside a cell. Cells anywhere in space are sorted by the
depth of their middles, which is right to within a cell.

The cells between two planes are a strip. All orders come in blocks of some strips, or some cells.
"""

from collections.abc import Iterator, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Doubles, Ints
from surfaces.shape.cells import four_corners
from surfaces.space.view import View
from surfaces.visible.lattice import BLOCK, Cells, Lattice

Item = TypeVar("Item", bound=np.generic)


def back_to_front(field: NDArray[Item], eye: Doubles) -> NDArray[Item]:
    """A view of a field over the grid, shape (nx, ny, ...), whose last entry is the nearest.

    `eye` is the direction of the eye as seen from the surface. A component of zero leaves a free
    choice, for then the cells on that axis do not hide one another.
    """
    return field[:: 1 if eye[0] >= 0 else -1, :: 1 if eye[1] >= 0 else -1]


def in_any_order(lattices: Sequence[Lattice], view: View) -> Iterator[Cells]:
    """The cells of surfaces, for what needs no order."""
    for lattice in lattices:
        for strips in _parted(range(len(lattice.whole)), lattice):
            yield _block([lattice], strips, np.arange(lattice.whole.shape[1]), view)


def in_strips(lattices: Sequence[Lattice], view: View) -> Iterator[Cells]:
    """The cells of height fields over the same x and y in painting order, the nearest last."""
    first = lattices[0]
    runs = _approach(first.y[0], view.eye[1], view.parallel)
    columns = np.concatenate([np.array(run, dtype=np.int64) for run in runs])
    for run in _approach(first.x[:, 0], view.eye[0], view.parallel):
        for strips in _parted(run, first):
            yield _block(lattices, strips, columns, view)


def by_depth(lattice: Lattice, view: View) -> Iterator[Cells]:
    """The cells of a surface anywhere in space, that with the nearest middle last."""
    ways = [np.ascontiguousarray(way).ravel() for way in (lattice.x, lattice.y, lattice.z)]
    cells, parts = np.flatnonzero(lattice.whole), lattice.parts
    count = len(cells)
    order = _order(lattice, view, cells)
    cells = np.append(cells, np.zeros(parts.shape[1], np.int64))  # to be replaced
    for start in range(0, len(order), BLOCK // 4):
        some = order[start : start + BLOCK // 4]
        corners = lattice.corners(cells.take(some))
        beyond = np.flatnonzero(some >= count)
        corners[:, beyond] = parts[:, some[beyond] - count]
        nodes = np.stack([way.take(corners).ravel() for way in ways])
        numbers = np.arange(corners.size).reshape(corners.shape)
        yield Cells(nodes, lattice.values.take(corners).ravel(), numbers, view)


def _order(lattice: Lattice, view: View, cells: Ints) -> Ints:
    """The places of some cells, and behind them of a lattice's parts of cells, sorted by depth."""
    near = view.nearness_of(lattice.x, lattice.y, lattice.z)
    middle = np.zeros(lattice.whole.shape)
    for corner in four_corners(near):
        middle += corner
    parts = near.ravel().take(lattice.parts).sum(axis=0)
    del near  # which for millions of cells is large
    order: Ints = np.argsort(np.append(middle.ravel().take(cells), parts), kind="stable")
    return order


def _approach(lines: Doubles, eye: float, parallel: bool) -> list[range]:
    """The strips between lines, from both sides toward the one in which the eye is.

    Whichever way a ray leads from an eye near by, it meets them in the opposite order. From an eye
    far away all lead one way.
    """
    count = len(lines) - 1
    if parallel:
        before = count if eye >= 0 else 0
    else:
        before = min(max(int(np.searchsorted(lines, eye)) - 1, 0), count)
    return [range(before), range(count - 1, before - 1, -1)]


def _parted(strips: range, lattice: Lattice) -> Iterator[range]:
    """Strips in blocks."""
    step = max(1, BLOCK // lattice.z.shape[1])
    for start in range(0, len(strips), step):
        yield strips[start : start + step]


def _block(lattices: Sequence[Lattice], strips: range, columns: Ints, view: View) -> Cells:
    """The cells of neighbouring strips of lattices, in the order of strips and columns.

    Of several lattices in the same place, the one on the eye's side is last.
    """
    low, numbers = min(strips), np.array(strips)
    parts = [lattice.rows(slice(low, max(strips) + 2)) for lattice in lattices]
    nodes = np.concatenate([part for part, _ in parts], axis=1)
    values = np.concatenate([part for _, part in parts])
    starts = np.arange(len(lattices)) * parts[0][1].size
    around = lattices[0].around
    places = (numbers - low)[:, None] * (len(columns) + 1) + columns
    corner = places.ravel() + starts[:, None]  # the first of each cell's corners
    whole = np.stack([lattice.whole[np.ix_(numbers, columns)].ravel() for lattice in lattices])
    if len(lattices) > 1:
        height = np.nan_to_num(sum(nodes[2].take(corner + step) for step in around) / 4)
        near = height * np.sign(view.eye[2]) if view.parallel else -np.abs(height - view.eye[2])
        order = np.argsort(near, axis=0)
        whole = np.take_along_axis(whole, order, axis=0)
        corner = np.take_along_axis(corner, order, axis=0)
    there = np.flatnonzero(whole.T)
    cells = Cells(nodes, values, corner.T.ravel().take(there) + around[:, None], view)
    ranks = there // len(lattices)
    for lattice, start in zip(lattices, starts.tolist(), strict=True):
        cells, ranks = _with_rim(cells, ranks, lattice, strips, columns, start)
    return cells


def _with_rim(
    cells: Cells, ranks: Ints, lattice: Lattice, strips: range, columns: Ints, start: int
) -> tuple[Cells, Ints]:
    """Add the parts of cells at the rims of a lattice's holes, each after the cells in its place.

    `ranks`, (m,), are the places of the cells so far; `start` is the lattice's first node there.
    """
    if lattice.rim is None:
        return cells, ranks
    (rim, at_rim), low = lattice.rim, min(strips)
    strip, column = np.divmod(rim.cell, len(columns))
    here = np.flatnonzero((strip >= low) & (strip <= max(strips)))
    corners = rim.corners[here].T
    on_rim = corners >= lattice.z.size
    points, place = np.unique(corners[on_rim] - lattice.z.size, return_inverse=True)
    corners = corners - low * (len(columns) + 1) + start
    corners[on_rim] = len(cells.values) + place
    rank = np.argsort(strips)[strip[here] - low] * len(columns) + np.argsort(columns)[column[here]]
    ranks = np.concatenate((ranks, rank))
    sequence = np.argsort(ranks, kind="stable")
    more = Cells(
        np.concatenate((cells.nodes, rim.points[points].T), axis=1),
        np.concatenate((cells.values, at_rim[points])),
        np.concatenate((cells.corners, corners), axis=1)[:, sequence],
        cells.view,
    )
    return more, ranks[sequence]
