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
_QUAD = 5
"""Points of a closed polygon of four corners."""
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


def edges_many(x: Ints, y: Ints) -> Edges:
    """`polygons.edges` for m polygons of k points each, shape (k, m)."""
    sides = x[:-1], y[:-1], x[1:], y[1:]
    back = (x == x[0]) & (y == y[0])
    real = np.ones(back[1:].shape, dtype=bool)
    # Most polygons return to their first point only at the end: they are one path each.
    parted = np.flatnonzero(back[1:-1].any(axis=0) if len(x) > 2 else back[0])
    if len(parted):
        parts = _split(x[:, parted], y[:, parted])
        real[:, parted] = parts.real
        pairs = list(zip(sides, parts.sides, strict=True))
        if any((side[:, parted] != new).any() for side, new in pairs):
            sides = x[:-1].copy(), y[:-1].copy(), x[1:].copy(), y[1:].copy()
            for side, new in zip(sides, parts.sides, strict=True):
                side[:, parted] = new
    return Edges(sides, real)


def _split(x: Ints, y: Ints) -> Edges:
    """What `polygons.paths` does, for the points (k, m) of m polygons at a time."""
    start_x, start_y = x[0], y[0]
    x1, y1, x2, y2 = x[:-1].copy(), y[:-1].copy(), x[1:].copy(), y[1:].copy()
    real = np.zeros(x1.shape, dtype=bool)
    open_path, alone = np.ones((2, x.shape[1]), dtype=bool)
    before_x, before_y = x[0], y[0]
    for j in range(1, len(x)):
        back = (x[j] == start_x) & (y[j] == start_y)
        begins = ~open_path
        drawn = open_path & ~(back & alone)
        x1[j - 1], y1[j - 1], real[j - 1] = before_x, before_y, drawn
        start_x, start_y = np.where(begins, x[j], start_x), np.where(begins, y[j], start_y)
        moved = begins | drawn
        before_x, before_y = np.where(moved, x[j], before_x), np.where(moved, y[j], before_y)
        open_path = begins | ~(back & drawn)
        alone = begins | (alone & ~drawn)
    return Edges((x1, y1, np.where(real, x2, x1), np.where(real, y2, y1)), real)


def fill(x: Ints, y: Ints, top: int, bottom: int) -> Iterator[tuple[slice, Spans]]:
    """Fill m closed polygons, from row `top` to row `bottom`; their points (k + 1, m) are int64.

    For larger coordinates they are objects. Yields groups of consecutive polygons: which ones, and
    their spans.
    """
    x, y, simple = _simple(x, y)
    first = np.clip(y.min(axis=0), top, bottom + 1).astype(np.int64)
    rows = np.clip(y.max(axis=0), top, bottom + 1).astype(np.int64) - first
    twice, often = np.where(simple, rows, 0), np.where(simple, 0, rows)
    for part in grouped(rows, CHUNK):
        numbers = np.arange(part.start, part.stop)
        found = []
        if twice[part].any():
            sides = x[:-1, part], y[:-1, part], x[1:, part], y[1:, part]
            found.append(_crossed_twice(sides, numbers, first[part], twice[part]))
        crooked = numbers[often[part] > 0]
        if len(crooked):
            sides = edges_many(x[:, crooked], y[:, crooked]).sides
            found.append(_crossed_often(sides, crooked, first[crooked], often[crooked]))
        yield part, _in_order(found)


def fill_one(sides: Segments, top: int, bottom: int) -> Spans:
    """The rows that fill one closed polygon of many sides, (k, 1)."""
    _, y1, _, y2 = sides
    ends = min(y1.min(), y2.min()), max(y1.max(), y2.max())
    first, last = np.clip(ends, top, bottom + 1).astype(np.int64)
    number = np.zeros(1, np.int64)
    return _crossed_often(sides, number, number + first, number + (last - first))


def _simple(x: Ints, y: Ints) -> tuple[Ints, Ints, NDArray[np.bool_]]:
    """Polygons, and which of them are one path that goes down once and up once.

    Those of coordinates that are objects are taken as if they were not.
    """
    if x.dtype == object or y.dtype == object:
        return x, y, np.zeros(x.shape[1], dtype=bool)
    heights = y.max(axis=0) - y.min(axis=0)
    simple: NDArray[np.bool_] = abs(y[1:] - y[:-1]).sum(axis=0) == 2 * heights
    # Where a point next to the first one is the first one, too, there are no two paths.
    parted = ((x[2:-2] == x[0]) & (y[2:-2] == y[0])).any(axis=0)
    if len(x) == _QUAD and parted.any():
        # The second path is one side: in rows of its own it is not paired. So it is left out.
        alone = parted & simple & ((x[1] != x[0]) | (y[1] != y[0]))
        last_x, last_y = np.where(alone, (x[0], y[0]), (x[3], y[3]))
        return np.stack((*x[:3], last_x, x[4])), np.stack((*y[:3], last_y, y[4])), simple
    return x, y, simple & ~parted


def _crossed_twice(sides: Segments, owner: Ints, first: Ints, rows: Ints) -> Spans:
    """The spans of polygons whose path goes down once and up once: from the one to the other."""
    total, begin = int(rows.sum()), np.cumsum(rows) - rows
    row, x = _crossings(sides, first, rows, begin + total * (sides[3] < sides[1]))
    crossings = np.empty(2 * total)
    crossings[row] = x
    down, up = crossings[:total], crossings[total:]
    y = np.arange(total) + repeat(first - begin, rows)
    left, right = np.floor(np.minimum(down, up)), np.floor(np.maximum(down, up))
    return Spans(y, left.astype(np.int64), right.astype(np.int64), repeat(owner, rows))


def _crossed_often(sides: Segments, owner: Ints, first: Ints, rows: Ints) -> Spans:
    """The spans of any polygons: the crossings of each row sorted and paired."""
    begin = np.cumsum(rows) - rows
    row, place = _crossings(sides, first, rows, begin)
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
    sides: Segments, first: Ints, rows: Ints, number: Ints
) -> tuple[Ints, NDArray[np.float64]]:
    """Where sides cross the rows of their polygons, side after side: the row and x.

    `first` is each polygon's first row on the page, `number` the same row in the result, where the
    rows of all polygons follow one another. The crossing is the floor of x.
    """
    x1, y1, x2, y2 = sides
    dx, dy = x2 - x1, y2 - y1
    start = np.clip(np.minimum(y1, y2), first, first + rows)
    count = np.clip(np.maximum(y1, y2), first, first + rows) - start
    counts = count.ravel().astype(np.int64, copy=False)
    begin = (np.cumsum(counts) - counts).reshape(count.shape)

    def of_each(values: NDArray[Any]) -> NDArray[Any]:
        return repeat(values.ravel(), counts)

    step = np.arange(counts.sum())
    row = of_each(start - begin + (number - first)).astype(np.int64, copy=False) + step
    if dy.dtype == object:
        up = dy < 0
        below = of_each(start - begin - np.where(up, y2, y1)) + step
        across = toward_zero(below * of_each(dx), of_each(dy))
        far = np.clip(across + of_each(np.where(up, x2, x1)), -_FAR, _FAR)
        return row, far.astype(np.float64)
    # Truncated toward zero: the floor where a side goes to the right, the ceiling to the left. The
    # quotient is a multiple of 1 / dy. Half of that is added, so that an error of floating point
    # never crosses a whole number (coordinates are below 2**24).
    height = dy + (dy == 0)
    slope, rounding = dx / height, 0.5 / height
    rounding = np.where(slope < 0, 1 - abs(rounding), abs(rounding))
    x = of_each(slope) * step
    x += of_each((start - y1 - begin) * slope + (x1 + rounding))
    return row, x
