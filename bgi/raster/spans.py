"""Many polygons at a time, by the rules of `bgi.raster.polygons`: their edges, and what fills them.

The scan-line filling of many polygons in a few array operations. All crossings of all sides with
all rows are computed at once. A polygon whose path goes down once and up once has two crossings in
every row, which need no sorting; all other crossings are sorted by row and x.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bgi.raster.arrays import repeat
from bgi.raster.lines import Ints, Segments, grouped, toward_zero

CHUNK = 1 << 14
"""Rows of polygons worked on at a time: bounds the memory, whatever the polygons."""
_FAR = 1 << 24
"""No page is so wide: crossings beyond it are moved there."""
_X_BITS = 26
"""Bits for x + _FAR."""


class Spans(NamedTuple):
    """Rows to fill: y, first x, last x, and the polygon each belongs to, in painting order."""

    y: Ints
    left: Ints
    right: Ints
    owner: Ints


_NO_INTS = np.zeros(0, dtype=np.int64)
NO_SPANS = Spans(_NO_INTS, _NO_INTS, _NO_INTS, _NO_INTS)


class Edges(NamedTuple):
    """The lines of m polygons: x1, y1, x2, y2, arrays (k - 1, m)."""

    sides: Segments
    real: NDArray[np.bool_]
    """Which of them are lines: the others lie between two paths and have no length."""
    single: NDArray[np.bool_]
    """Which polygons consist of one path."""


def edges_many(points: NDArray[Any]) -> Edges:
    """`polygons.edges` for m polygons of k points each, shape (m, k, 2)."""
    x, y = np.ascontiguousarray(points.transpose(2, 1, 0))
    sides = x[:-1], y[:-1], x[1:], y[1:]
    back = (x == x[0]) & (y == y[0])
    real, single = np.ones(back[1:].shape, dtype=bool), np.ones(len(points), dtype=bool)
    # Most polygons return to their first point only at the end: they are one path each.
    parted = np.flatnonzero(back[1:-1].any(axis=0) if len(x) > 2 else back[0])
    if len(parted):
        parts = _split(x[:, parted], y[:, parted])
        real[:, parted], single[parted] = parts.real, parts.single
        pairs = list(zip(sides, parts.sides, strict=True))
        if any((side[:, parted] != new).any() for side, new in pairs):
            sides = x[:-1].copy(), y[:-1].copy(), x[1:].copy(), y[1:].copy()
            for side, new in zip(sides, parts.sides, strict=True):
                side[:, parted] = new
    return Edges(sides, real, single)


def _split(x: Ints, y: Ints) -> Edges:
    """What `polygons.paths` does, for the points (k, m) of m polygons at a time."""
    start_x, start_y = x[0], y[0]
    x1, y1, x2, y2 = x[:-1].copy(), y[:-1].copy(), x[1:].copy(), y[1:].copy()
    real = np.zeros(x1.shape, dtype=bool)
    open_path, alone, closed, single = np.ones((4, x.shape[1]), dtype=bool)
    closed[:] = False
    before_x, before_y = x[0], y[0]
    for j in range(1, len(x)):
        back = (x[j] == start_x) & (y[j] == start_y)
        begins = ~open_path
        drawn = open_path & ~(back & alone)
        x1[j - 1], y1[j - 1], real[j - 1] = before_x, before_y, drawn
        single &= ~(closed & drawn)
        closed |= drawn & back
        start_x, start_y = np.where(begins, x[j], start_x), np.where(begins, y[j], start_y)
        moved = begins | drawn
        before_x, before_y = np.where(moved, x[j], before_x), np.where(moved, y[j], before_y)
        open_path = begins | ~(back & drawn)
        alone = begins | (alone & ~drawn)
    return Edges((x1, y1, np.where(real, x2, x1), np.where(real, y2, y1)), real, single)


def fill(polygons: Edges, top: int, bottom: int) -> Iterator[tuple[slice, Spans]]:
    """Fill closed polygons, from row `top` to row `bottom`.

    Their sides are int64, or object for larger coordinates. Yields groups of consecutive polygons:
    which ones, and their spans.
    """
    x1, y1, x2, y2 = polygons.sides
    up = y2 < y1
    upper, lower = np.minimum(y1, y2), np.maximum(y1, y2)
    walls = _Walls(upper, lower - upper, np.where(up, x2, x1), np.where(up, x1 - x2, x2 - x1), up)
    highest, lowest = upper.min(axis=0), lower.max(axis=0)
    # One path that goes down once and up once crosses every row twice.
    simple = polygons.single & (walls.dy.sum(axis=0) == 2 * (lowest - highest))
    if y1.dtype == object:
        simple = np.zeros(len(highest), dtype=bool)
    first = np.clip(highest, top, bottom + 1).astype(np.int64)
    rows = np.clip(lowest, top, bottom + 1).astype(np.int64) - first
    twice, often = np.where(simple, rows, 0), np.where(simple, 0, rows)
    for part in grouped(rows, CHUNK):
        numbers = np.arange(part.start, part.stop)
        found = []
        if twice[part].any():
            found.append(_crossed_twice(walls.of(part), numbers, first[part], twice[part]))
        crooked = numbers[often[part] > 0]
        if len(crooked):
            found.append(_crossed_often(walls.of(crooked), crooked, first[crooked], often[crooked]))
        yield part, _in_order(found)


class _Walls(NamedTuple):
    """Sides from their upper end down: arrays (k, n)."""

    y: Ints
    dy: Ints
    x: Ints
    dx: Ints
    up: NDArray[np.bool_]
    """Whether the polygon's path goes up here."""

    def of(self, which: Ints | slice) -> "_Walls":
        """The sides of some of the polygons."""
        y, dy, x, dx = (array[:, which] for array in self[:4])
        return _Walls(y, dy, x, dx, self.up[:, which])


def _crossed_twice(walls: _Walls, owner: Ints, first: Ints, rows: Ints) -> Spans:
    """The spans of polygons whose path goes down once and up once: from the one to the other."""
    total, begin = int(rows.sum()), np.cumsum(rows) - rows
    row, x = _crossings(walls, first, rows, begin + total * walls.up)
    crossings = np.empty(2 * total)
    crossings[row] = x
    down, up = crossings[:total], crossings[total:]
    y = np.arange(total) + repeat(first - begin, rows)
    left, right = np.floor(np.minimum(down, up)), np.floor(np.maximum(down, up))
    return Spans(y, left.astype(np.int64), right.astype(np.int64), repeat(owner, rows))


def _crossed_often(walls: _Walls, owner: Ints, first: Ints, rows: Ints) -> Spans:
    """The spans of any polygons: the crossings of each row sorted and paired."""
    begin = np.cumsum(rows) - rows
    row, place = _crossings(walls, first, rows, begin)
    x = np.clip(np.floor(place), -_FAR, _FAR).astype(np.int64)
    ordered = np.sort((row << _X_BITS) + (x + _FAR))
    row, x = ordered >> _X_BITS, (ordered & ((1 << _X_BITS) - 1)) - _FAR
    starts = np.flatnonzero(np.diff(row, prepend=-1))
    number = np.arange(len(row)) - repeat(starts, np.diff(starts, append=len(row)))
    left = np.flatnonzero((number[:-1] % 2 == 0) & (row[1:] == row[:-1]))
    row = row[left]
    which = np.searchsorted(begin, row, side="right") - 1
    return Spans(row + (first - begin)[which], x[left], x[left + 1], owner[which])


def _in_order(found: list[Spans]) -> Spans:
    """Spans of different polygons together, in the polygons' order."""
    if len(found) < 2:
        return found[0] if found else NO_SPANS
    together = Spans(*(np.concatenate(arrays) for arrays in zip(*found, strict=True)))
    order = np.argsort(together.owner, kind="stable")
    return Spans(*(array[order] for array in together))


def _crossings(
    walls: _Walls, first: Ints, rows: Ints, number: Ints
) -> tuple[Ints, NDArray[np.float64]]:
    """Where sides cross the rows of their polygons, side after side: the row and x.

    `first` is each polygon's first row on the page, `number` the same row in the result, where the
    rows of all polygons follow one another. The crossing is the floor of x.
    """
    start = np.clip(walls.y, first, first + rows).astype(np.int64, copy=False)
    end = np.clip(walls.y + walls.dy, first, first + rows).astype(np.int64, copy=False)
    count = (end - start).ravel()
    side = repeat(np.arange(len(count)), count)
    row = (start.ravel() - (np.cumsum(count) - count)).take(side)
    row += np.arange(len(side))
    below = row - walls.y.ravel().take(side)
    if below.dtype == object:
        across = toward_zero(below * walls.dx.ravel().take(side), walls.dy.ravel().take(side))
        x = np.clip(across + walls.x.ravel().take(side), -_FAR, _FAR).astype(np.float64)
    else:
        # Truncated toward zero: the floor where a side goes to the right, the ceiling to the left.
        # The quotient is a multiple of 1 / dy. Half of that is added, so that an error of floating
        # point never crosses a whole number (coordinates are below 2**24).
        dy = np.maximum(walls.dy, 1).astype(np.float64)
        rounding = np.where(walls.dx < 0, 1 - 0.5 / dy, 0.5 / dy)
        x = (walls.dx / dy).ravel().take(side)
        x *= below
        x += (walls.x + rounding).ravel().take(side)
    row += np.broadcast_to(number - first, walls.y.shape).ravel().take(side)
    return row, x
