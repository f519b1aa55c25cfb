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

from bgi.raster.lines import Ints, Segment, Segments, toward_zero

Point = tuple[int, int]

_CELLS = 1 << 20
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
    x1, y1, x2, y2 = np.moveaxis(corners, 2, 0)
    up = y2 < y1
    x1, x2 = np.where(up, x2, x1), np.where(up, x1, x2)
    y1, y2 = np.where(up, y2, y1), np.where(up, y1, y2)
    first = np.maximum(y1.min(axis=1), top)
    rows = np.maximum(np.minimum(y2.max(axis=1) - 1, bottom) - first + 1, 0)
    batch = max(1, _CELLS // (x1.shape[1] * max(1, int(rows.max(initial=1)))))
    for start in range(0, len(corners), batch):
        part = slice(start, start + batch)
        sides = x1[part].T, y1[part].T, x2[part].T, y2[part].T
        found = _fill(sides, first[part], rows[part])
        yield part, found._replace(owner=found.owner + start)


def _fill(sides: Segments, first: Ints, rows: Ints) -> Spans:
    """One batch: sides are (k, n) arrays, the k-th side of each of n polygons."""
    x1, y1, x2, y2 = sides
    tallest = int(rows.max(initial=0))
    y = first[:, None] + np.arange(tallest)
    wanted = np.arange(tallest) < rows[:, None]
    crossings = np.full((len(x1), *y.shape), _FAR, dtype=x1.dtype)
    for side in range(len(x1)):
        below = y - y1[side][:, None]
        dx, dy = (x2[side] - x1[side])[:, None], (y2[side] - y1[side])[:, None]
        x = x1[side][:, None] + toward_zero(below * dx, dy)
        if x.dtype == object:
            x = np.clip(x, 1 - _FAR, _FAR - 1)
        np.copyto(crossings[side], x, where=wanted & (below >= 0) & (below < dy))
    crossings.sort(axis=0)
    left = crossings[0 : len(x1) // 2 * 2 : 2].transpose(1, 2, 0)
    right = crossings[1::2].transpose(1, 2, 0)
    owner, row, pair = np.nonzero(right < _FAR)
    return Spans(y[owner, row], left[owner, row, pair], right[owner, row, pair], owner)
