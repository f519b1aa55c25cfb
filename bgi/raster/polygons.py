"""Polygons: their paths, their edges, and the rows that fill them.

A path that comes back to its first point ends there, and the next point starts another one: that is
how Borland's kernel puts several outlines into one polygon. An edge counts on the rows from its
upper end to just above its lower one; on such a row it crosses at `x + (row - y) * dx / dy`,
truncated toward zero, measured from the upper end. The crossings of a row, sorted, are filled in
pairs, both ends included (even-odd rule).
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bgi.raster.lines import Ints, Segment, Segments, batches, toward_zero

Point = tuple[int, int]
Rows = tuple[Sequence[int], Sequence[int], Sequence[int]]
"""y and both ends of rows to fill, the ends in any order."""

_ROWS = 1 << 14
"""Rows worked on at a time: bounds the memory, whatever the polygons."""
_FAR = 1 << 62
"""No crossing lies so far out: it is clamped to less."""


class Spans(NamedTuple):
    """Rows to fill: y, first x, last x, and the polygon each belongs to, in painting order."""

    y: Ints
    left: Ints
    right: Ints
    owner: Ints


_NO_INTS = np.zeros(0, dtype=np.int64)
NO_SPANS = Spans(_NO_INTS, _NO_INTS, _NO_INTS, _NO_INTS)


def paths(points: Sequence[Point]) -> list[list[Point]]:
    """Split a polygon where a path returns to its first point; a lone last point is no path."""
    found: list[list[Point]] = []
    path: list[Point] = []
    for point in points:
        if not path or point != path[0]:
            path.append(point)
        elif len(path) > 1:
            path.append(point)
            found.append(path)
            path = []
    if len(path) > 1:
        found.append(path)
    return found


def edges(points: Sequence[Point]) -> list[Segment]:
    """The lines of a polygon, path by path: what drawpoly() draws."""
    return [(*start, *end) for path in paths(points) for start, end in pairwise(path)]


def scan(points: Sequence[Point], top: int, bottom: int) -> Rows:
    """The rows that fill one polygon, as far as top..bottom show them."""
    outline = paths([*points, *points[:1]])
    heights = [y for _, y in points]
    top, bottom = max(top, min(heights, default=0)), min(bottom, max(heights, default=0) - 1)
    height = max(0, bottom + 1 - top)
    down, up = [0] * height, [0] * height
    found: list[tuple[int, list[int]]] = []
    rows_down = rows_up = 0
    for path in outline:
        for (x1, y1), (x2, y2) in pairwise(path):
            falling = y1 < y2
            if not falling:
                x1, y1, x2, y2 = x2, y2, x1, y1
            first = y1 if y1 > top else top
            last = y2 if y2 <= bottom else bottom + 1
            if first >= last:
                continue
            crossings = _walk(x1, x2 - x1, y2 - y1, first - y1, last - first)
            found.append((first - top, crossings))
            if falling:
                down[first - top : last - top] = crossings
                rows_down += last - first
            else:
                up[first - top : last - top] = crossings
                rows_up += last - first
    if len(outline) == 1 and rows_down == rows_up == height:
        return range(top, bottom + 1), down, up  # every row is crossed once down, once up
    return _paired(found, top, height)


def _walk(x: int, dx: int, dy: int, below: int, rows: int) -> list[int]:
    """Where a side from x on crosses `rows` rows, the first of them `below` rows down."""
    if dx == 0:
        return [x] * rows
    # The quotient toward zero is the floor of a fall to the right, the ceiling of one to the left.
    start = x * dy + below * dx + (dy - 1 if dx < 0 else 0)
    return [numerator // dy for numerator in range(start, start + rows * dx, dx)]


def _paired(found: list[tuple[int, list[int]]], top: int, height: int) -> Rows:
    """Sort the crossings of each row and pair them: the even-odd rule."""
    crossings: list[list[int]] = [[] for _ in range(height)]
    for first, side in found:
        for row, x in enumerate(side, first):
            crossings[row].append(x)
    pairs = [
        (y, left, right)
        for y, row in enumerate(crossings, top)
        for left, right in zip(sorted(row)[::2], sorted(row)[1::2], strict=False)
    ]
    return [y for y, _, _ in pairs], [x for _, x, _ in pairs], [x for _, _, x in pairs]


def edges_many(points: NDArray[Any]) -> tuple[Segments, NDArray[np.bool_]]:
    """`edges` for m polygons of k points each, shape (m, k, 2).

    Returns their lines x1, y1, x2, y2, arrays (k - 1, m), and which of them are real: the others
    lie between two paths, and have no length.
    """
    x, y = np.ascontiguousarray(points.transpose(2, 1, 0))
    back = (x == x[0]) & (y == y[0])
    sides = x[:-1], y[:-1], x[1:], y[1:]
    if len(x) > 2 and not back[1:-1].any():  # nobody is back before the end: one path each
        return sides, np.ones(back[1:].shape, dtype=bool)
    return _split(x, y)


def _split(x: Ints, y: Ints) -> tuple[Segments, NDArray[np.bool_]]:
    """What `paths` does, for the points (k, m) of m polygons at a time."""
    start_x, start_y = x[0], y[0]
    x1, y1, x2, y2 = x[:-1].copy(), y[:-1].copy(), x[1:].copy(), y[1:].copy()
    real = np.zeros(x1.shape, dtype=bool)
    open_path = np.ones(x.shape[1], dtype=bool)
    single = np.ones(x.shape[1], dtype=bool)
    before_x, before_y = x[0], y[0]
    for j in range(1, len(x)):
        back = (x[j] == start_x) & (y[j] == start_y)
        begins = ~open_path
        drawn = open_path & ~(back & single)
        x1[j - 1], y1[j - 1], real[j - 1] = before_x, before_y, drawn
        start_x, start_y = np.where(begins, x[j], start_x), np.where(begins, y[j], start_y)
        moved = begins | drawn
        before_x, before_y = np.where(moved, x[j], before_x), np.where(moved, y[j], before_y)
        open_path = begins | ~(back & drawn)
        single = begins | (single & ~drawn)
    return (x1, y1, np.where(real, x2, x1), np.where(real, y2, y1)), real


def spans(
    sides: Segments, real: NDArray[np.bool_], top: int, bottom: int
) -> Iterator[tuple[slice, Spans]]:
    """Fill closed polygons given by their sides, as far as rows top..bottom show them.

    `sides` are x1, y1, x2, y2 of shape (k, n), k sides of n polygons; int64, or object for
    coordinates beyond its range; `real` as `edges_many` gives it. Yields batches of consecutive
    polygons: which ones, their spans.
    """
    x1, y1, x2, y2 = sides
    up = y2 < y1
    upper, lower = np.where(up, y2, y1), np.where(up, y1, y2)
    down_from, dx = np.where(up, x2, x1), np.where(up, x1 - x2, x2 - x1)
    highest, lowest = upper.min(axis=0), lower.max(axis=0)
    # One path that goes down once and up once crosses every row twice.
    simple = real.all(axis=0) & ((lower - upper).sum(axis=0) == 2 * (lowest - highest))
    first = np.maximum(highest, top)
    rows = np.maximum(np.minimum(lowest - 1, bottom) - first + 1, 0).astype(np.int64)
    steps = np.stack([upper, lower - upper, down_from, dx], axis=-1)
    for part in batches(rows, _ROWS):
        owner = np.repeat(np.arange(part.start, part.stop), rows[part])
        ends = np.cumsum(rows[part])
        y = np.arange(len(owner)) + (first[part] - (ends - rows[part]))[owner - part.start]
        crossings = [_crossings(y, *step[owner].T) for step in steps]
        if simple[part].all():
            yield part, _outer(y, crossings, owner)
        else:
            yield part, _paired_spans(y, crossings, owner)


def _crossings(y: Ints, upper: Ints, dy: Ints, x: Ints, dx: Ints) -> Ints:
    """Where one side crosses each row; _FAR where it does not."""
    below = y - upper
    x = x + toward_zero(below * dx, dy)
    if x.dtype == object:
        x = np.clip(x, 1 - _FAR, _FAR - 1)
    x[(below < 0) | (below >= dy)] = _FAR
    return x


def _outer(y: Ints, crossings: list[Ints], owner: Ints) -> Spans:
    """Rows crossed twice: from the lesser to the greater crossing."""
    left = np.minimum.reduce(crossings)
    right = np.maximum.reduce([np.where(x == _FAR, -_FAR, x) for x in crossings])
    return Spans(y, left, right, owner)


def _paired_spans(y: Ints, crossings: list[Ints], owner: Ints) -> Spans:
    """Any rows: their crossings sorted and paired."""
    ordered = np.sort(np.stack(crossings, axis=1), axis=1)
    left, right = ordered[:, 0 : len(crossings) // 2 * 2 : 2], ordered[:, 1::2]
    row, pair = np.nonzero(right < _FAR)
    return Spans(y[row], left[row, pair], right[row, pair], owner[row])
