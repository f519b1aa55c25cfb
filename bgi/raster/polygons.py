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

from bgi.raster.lines import Ints, Segment, toward_zero

Point = tuple[int, int]
Rows = tuple[list[int], list[int], list[int]]
"""y and both ends of rows to fill, the ends in any order."""

_CELLS = 1 << 15
"""How many crossings are computed at a time: bounds the memory, whatever the polygons."""
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
    """Split a polygon where a path returns to its first point."""
    found: list[list[Point]] = []
    path: list[Point] = []
    for point in points:
        if not path or point != path[0]:
            path.append(point)
        elif len(path) > 1:
            path.append(point)
            found.append(path)
            path = []
    if path:
        found.append(path)
    return found


def edges(points: Sequence[Point]) -> list[Segment]:
    """The lines of a polygon, path by path: what drawpoly() draws."""
    return [(*start, *end) for path in paths(points) for start, end in pairwise(path)]


def scan(sides: Sequence[Segment], top: int, bottom: int) -> Rows:
    """The rows that fill one polygon given by its sides, as far as top..bottom show them."""
    top = max(top, min((min(y1, y2) for _, y1, _, y2 in sides), default=0))
    bottom = min(bottom, max((max(y1, y2) for _, y1, _, y2 in sides), default=0) - 1)
    height = max(0, bottom + 1 - top)
    down, up = [0] * height, [0] * height
    found: list[tuple[int, list[int]]] = []
    rows_down = rows_up = 0
    for x1, y1, x2, y2 in sides:
        chain = down if y1 < y2 else up
        if y2 < y1:
            x1, y1, x2, y2 = x2, y2, x1, y1
        first, last = max(y1, top), min(y2, bottom + 1)
        if first >= last:
            continue
        dx, dy = x2 - x1, y2 - y1
        if dx < 0:
            crossings = [x1 - t * -dx // dy for t in range(first - y1, last - y1)]
        else:
            crossings = [x1 + t * dx // dy for t in range(first - y1, last - y1)]
        chain[first - top : last - top] = crossings
        found.append((first - top, crossings))
        if chain is down:
            rows_down += last - first
        else:
            rows_up += last - first
    if rows_down == rows_up == height:  # every row is crossed once down, once up
        return list(range(top, bottom + 1)), down, up
    return _paired(found, top, height)


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


def edges_many(points: NDArray[Any]) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """`edges` for m polygons of k points each, shape (m, k, 2).

    Returns (m, k - 1, 4) lines, and which of them are real: the others lie between two paths.
    """
    start, before = points[:, 0], points[:, 0]
    open_path = np.ones(len(points), dtype=bool)
    single = np.ones(len(points), dtype=bool)
    found = np.concatenate([points[:, :-1], points[:, 1:]], axis=2)
    real = np.zeros(found.shape[:2], dtype=bool)
    for j in range(1, points.shape[1]):
        point = points[:, j]
        back = (point == start).all(axis=1)
        begins = ~open_path
        drawn = open_path & ~(back & single)
        found[:, j - 1, :2] = before
        real[:, j - 1] = drawn
        start = np.where(begins[:, None], point, start)
        before = np.where((begins | drawn)[:, None], point, before)
        open_path = begins | ~(back & drawn)
        single = begins | (single & ~drawn)
    found[~real, 2:] = found[~real, :2]
    return found, real


def spans(corners: NDArray[Any], top: int, bottom: int) -> Iterator[tuple[slice, Spans]]:
    """Fill polygons given by their sides, as far as rows top..bottom show them.

    `corners` has shape (n, k, 4): n polygons of k sides x1, y1, x2, y2; int64, or object for
    coordinates beyond its range. Yields batches of consecutive polygons: which ones, their spans.
    """
    y1, y2 = corners[:, :, 1], corners[:, :, 3]
    highest = y1.min(axis=1)
    lowest = y1.max(axis=1)  # of closed polygons; an open one's last end is some first one too
    lowest = np.maximum(lowest, y2.max(axis=1))
    highest = np.minimum(highest, y2.min(axis=1))
    # A polygon that goes down once and up once crosses every row twice.
    simple = abs(y2 - y1).sum(axis=1) == 2 * (lowest - highest)
    first = np.maximum(highest, top)
    rows = np.maximum(np.minimum(lowest - 1, bottom) - first + 1, 0)
    batch = max(1, _CELLS // (corners.shape[1] * max(1, int(rows.max(initial=1)))))
    for start in range(0, len(corners), batch):
        part = slice(start, start + batch)
        fill = _fill_simple if simple[part].all() else _fill
        found = fill(_crossings(corners[part], first[part], rows[part]), first[part])
        yield part, found._replace(owner=found.owner + start)


def _crossings(
    corners: NDArray[Any], first: Ints, rows: Ints
) -> Iterator[tuple[NDArray[Any], NDArray[np.bool_]]]:
    """For each side: x on every row of every polygon, (n, rows), and where it does cross."""
    row = np.arange(int(rows.max(initial=0)))
    y = first[:, None] + row
    wanted = row < rows[:, None]
    for side in range(corners.shape[1]):
        x1, y1, x2, y2 = corners[:, side].T
        up = y2 < y1
        above, x = np.where(up, y2, y1)[:, None], np.where(up, x2, x1)[:, None]
        dy, dx = abs(y2 - y1)[:, None], np.where(up, x1 - x2, x2 - x1)[:, None]
        below = y - above
        crossing = x + toward_zero(below * dx, dy)
        if crossing.dtype == object:
            crossing = np.clip(crossing, 1 - _FAR, _FAR - 1)
        yield crossing, wanted & (below >= 0) & (below < dy)


def _fill_simple(crossings: Iterator[tuple[NDArray[Any], NDArray[np.bool_]]], first: Ints) -> Spans:
    """Polygons that cross each of their rows twice: from the lesser to the greater crossing."""
    x, crossed = next(crossings)
    left, right = np.where(crossed, x, _FAR), np.where(crossed, x, -_FAR)
    for x, crossed in crossings:
        np.copyto(left, np.minimum(left, x), where=crossed)
        np.copyto(right, np.maximum(right, x), where=crossed)
    owner, row = np.nonzero(left < _FAR)
    return Spans(first[owner] + row, left[owner, row], right[owner, row], owner)


def _fill(crossings: Iterator[tuple[NDArray[Any], NDArray[np.bool_]]], first: Ints) -> Spans:
    """Any polygons: the crossings of each row sorted and paired."""
    ordered = np.sort(np.stack([np.where(crossed, x, _FAR) for x, crossed in crossings]), axis=0)
    left = ordered[0 : len(ordered) // 2 * 2 : 2].transpose(1, 2, 0)
    right = ordered[1::2].transpose(1, 2, 0)
    owner, row, pair = np.nonzero(right < _FAR)
    return Spans(first[owner] + row, left[owner, row, pair], right[owner, row, pair], owner)
