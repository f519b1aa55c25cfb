"""What fills an ellipse, and slices of one: the rows of an area, and the arc at its edge.

A slice is filled quadrant by quadrant: each piece is the polygon of its arc and the centre, by the
rules of `bgi.raster.polygons`. Mostly its arc only goes on, one pixel each time: then every row is
crossed twice, and all of them are found at once.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bgi.raster import lines, polygons
from bgi.raster.ellipses import Curve, arc, point_at, quadrant
from bgi.raster.kept import Kept
from bgi.raster.lines import Ints
from bgi.raster.offsets import offsets, reach
from bgi.raster.regions import FigureRows, Region, region

_FAR = 1 << 16
"""Beyond every radius."""


def _disc(rx: int, ry: int) -> FigureRows:
    x, y = quadrant(rx, ry)
    last = np.ones(len(y), np.bool_)
    np.not_equal(y[:-1], y[1:], out=last[:-1])
    widest = x[last]  # of each y, the last one that has it
    right = np.concatenate((widest, widest[-2::-1]))
    return np.arange(len(right), dtype=np.int64) - len(right) // 2, -right, right


DISCS = Kept(_disc, 1 << 21)
"""The rows that fill an ellipse, by both radii."""


class Piece(NamedTuple):
    """A piece of a slice, within a quadrant."""

    rows: FigureRows
    edge: Curve
    """Its arc."""
    smooth: bool
    """Whether lines along the arc are just its points: each leads from a pixel to one beside."""


def _piece(first: int, last: int, rx: int, ry: int, width: int) -> Piece:
    stretch = _stretch(first, last, rx, ry)
    dx, dy = stretch or arc(first, last, rx, ry)
    if not (stretch or _smooth(dx, dy)):
        curve = Curve(dx, dy, offsets(dy * width + dx, reach(dx, dy), width))
        return Piece(_scanned_rows(dx, dy), curve, False)
    xs, ys = sorted((int(dx[0]), int(dx[-1]))), sorted((int(dy[0]), int(dy[-1])))
    extent = xs[0], ys[0], xs[1], ys[1]
    curve = Curve(dx, dy, offsets(dy * width + dx, extent, width))
    return Piece(_smooth_rows(dx, dy), curve, True)


def _stretch(first: int, last: int, rx: int, ry: int) -> tuple[Ints, Ints] | None:
    """`arc` within a quadrant, as a stretch of the stepper's points: it is found sooner so.

    None where the stepper does not end at the longest x, as with some flat ellipses, or where the
    arc is one point: then arcs are not so simple.
    """
    start, end = point_at(first, rx, ry), point_at(last, rx, ry)
    x, y = quadrant(rx, ry)
    if last - first < 2 or start == end or min(rx, ry) < 1 or x[-1] != rx:
        return None
    # Within a quadrant this is the rank, or falls as that grows.
    position = x - y
    low, high = sorted(abs(dx) - abs(dy) for dx, dy in (start, end))
    here, there = int(position.searchsorted(low)), int(position.searchsorted(high, "right"))
    if there - here < 2:
        return None
    at_top, at_side = here == 0, there == len(x)
    x, y = x[here:there], y[here:there]
    if at_top or at_side:  # a point on an axis is its own mirror image, and comes twice
        twice = np.ones(len(x), np.int64)
        twice[0], twice[-1] = 1 + at_top, 1 + at_side
        x, y = x.repeat(twice), y.repeat(twice)
    return x if first < 90 or first >= 270 else -x, -y if first < 180 else y


def _smooth(dx: Ints, dy: Ints) -> bool:
    """Whether points only go on, one pixel each time, within a quadrant."""
    if len(dx) < 2 or dy[0] * dy[-1] < 0 or (dx[0] == dx[-1] and dy[0] == dy[-1]):
        return False
    across, down = dx[1:] - dx[:-1], dy[1:] - dy[:-1]
    return _one_way(across) and _one_way(down)


def _one_way(steps: Ints) -> bool:
    """Whether steps lead one way only, or nowhere, by 1 at most."""
    least, most = int(steps.min()), int(steps.max())
    return least >= -1 and most <= 1 and least * most >= 0


def _scanned_rows(dx: Ints, dy: Ints) -> FigureRows:
    """The rows that fill the polygon of an arc and its centre."""
    points = list(zip(dx.tolist(), dy.tolist(), strict=True))
    area = polygons.paths([*points, (0, 0), *points[:1]])
    y, one, other = np.array(polygons.scan(area, -_FAR, _FAR), dtype=np.int64)
    return y, np.minimum(one, other), np.maximum(one, other)


def _smooth_rows(dx: Ints, dy: Ints) -> FigureRows:
    """The same of an arc within a quadrant: every row is crossed twice.

    Once by the longer radius, and once by the shorter radius or the arc, which crosses a row at the
    point from where it goes down.
    """
    if dy[0] > dy[-1]:
        dx, dy = dx[::-1], dy[::-1]
    top, bottom = int(dy[0]), int(dy[-1])
    y = np.arange(min(top, 0), max(bottom, 0), dtype=np.int64)
    edge = dx[:-1][dy[1:] > dy[:-1]]
    if top < 0:
        one = _radius_crossings(int(dx[0]), top, y)
        other = np.append(edge, _radius_crossings(int(dx[-1]), bottom, y[bottom - top :]))
    else:
        one = _radius_crossings(int(dx[-1]), bottom, y)
        other = np.append(_radius_crossings(int(dx[0]), top, y[:top]), edge)
    return y, np.minimum(one, other), np.maximum(one, other)


def _radius_crossings(x: int, y: int, rows: Ints) -> Ints:
    """Where the line from the centre to x, y crosses rows, counted from its upper end."""
    crossings: Ints = lines.toward_zero((rows - min(y, 0)) * (x if y > 0 else -x), abs(y))
    return crossings + (x if y < 0 else 0)


PIECES = Kept(_piece, 1 << 22)
"""By start and end, both radii, and the width of a page."""


def _region(first: int, last: int, rx: int, ry: int, width: int) -> Region:
    whole = (first, last) == (0, 360)
    return region(DISCS[rx, ry] if whole else PIECES[first, last, rx, ry, width].rows, width)


REGIONS = Kept(_region, 1 << 22)
"""What fills a piece, or from 0 to 360 an ellipse: by the same."""


def slice_angles(start: int, end: int) -> tuple[int, int]:
    """The angles of a slice, the lesser one first, 0..360.

    A negative angle is taken as an unsigned number of 16 bits: -90 is 65446, which means 286. An
    end of 360 stays, any other whole turn is 0.
    """
    unsigned = [angle if angle >= 0 else angle + 0x10000 for angle in (start, end)]
    first, last = unsigned[0] % 360, unsigned[1] if unsigned[1] == 360 else unsigned[1] % 360
    return min(first, last), max(first, last)


def quarters(start: int, end: int) -> list[tuple[int, int]]:
    """The pieces of a slice, cut at 90, 180 and 270 degrees."""
    cuts = [start, *(a for a in (90, 180, 270) if start < a < end), end]
    return list(pairwise(cuts))
