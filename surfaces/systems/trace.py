"""Lines and polygons as pixels, for a graphics system that has nothing but putpixel.

The rules are those of Borland's driver, so that a picture drawn pixel by pixel is the picture that
graphics.h draws. A line goes downwards, n steps along its longer side, and after i of them
(2 m i + n) // (2 n) along the shorter one, whose length is m. A polygon is filled row by row
(scan-line filling, by the even-odd rule), from its topmost to the one above its lowest, between the
crossings of its sides in pairs, both ends included.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from surfaces.arrays import Doubles, Ints, repeat

Pixel = tuple[int, int]

# Breaks ties: nudges an exact half up or down. Along a line of n steps all places are multiples of
# 1/n, so what is not a half is at least 1/(2n) away from one: more than this on any screen.
TIE = 2.0**-16
# Beyond any screen, yet small enough that the products of two coordinates fit into 64 bits.
FAR = 2**24


def rounded(points: Doubles) -> Ints:
    """The pixels nearest to points of the screen. (graphics.h would cut the fraction off.)

    A half, and what a rounding error leaves of one, goes down and to the right: sines differ in
    their last bit from machine to machine, and pictures must not.
    """
    return np.floor(np.clip(points, -FAR, FAR) + (0.5 + TIE)).astype(np.int64)


def line_pixels(starts: Ints, ends: Ints, joined: bool = False) -> tuple[Ints, Ints, Ints]:
    """The pixels of lines: x, y, and the number of the line that each belongs to.

    Args:
        starts: (n, 2): the first pixels, with no number below 0.
        ends: (n, 2): the last ones.
        joined: Whether to leave out each line's last pixel, with which another line begins.
    """
    x1, y1 = starts.T
    dx, dy = (ends - starts).T
    n = np.maximum(np.abs(dx), np.abs(dy))
    count = n + (not joined)
    line = repeat(np.arange(len(n)), count)
    step = np.arange(len(line)) - (np.cumsum(count) - count).take(line)
    n = np.maximum(n, 1)
    # A half is rounded away from the upper end.
    x = (dx / n).take(line) * step
    x += (x1 + (0.5 + np.copysign(TIE, dx * dy))).take(line)
    y = (dy / n).take(line) * step
    y += (y1 + (0.5 + TIE)).take(line)
    return x.astype(np.int64), y.astype(np.int64), line


def clip(starts: Doubles, ends: Doubles, width: int, height: int) -> tuple[Ints, Ints, Ints]:
    """The parts of lines inside the screen, clipped as Liang and Barsky do (1984).

    A line is start + t (end - start), and each edge of the screen says from which t on or up to
    which t it is inside. The pixels at both ends, (n, 2), and the number of each part's line.
    """
    room = np.array((width - 1.0, height - 1.0))
    if _inside(starts, room) and _inside(ends, room):
        return _nearest(starts), _nearest(ends), np.arange(len(starts))
    way = ends - starts
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second = -starts / way, (room - starts) / way
    # A line along an edge never crosses it: it is inside or outside for good.
    level, inside = way == 0, (starts >= 0) & (starts <= room)
    enter = np.where(level, np.where(inside, 0.0, np.inf), np.minimum(first, second))
    leave = np.where(level, 1.0, np.maximum(first, second))
    enter = np.maximum(enter.max(axis=1), 0.0)
    leave = np.minimum(leave.min(axis=1), 1.0)
    kept = np.flatnonzero(enter <= leave)
    way, enter, leave = way[kept], enter[kept, None], leave[kept, None]
    inside_start = np.where(enter > 0, starts[kept] + enter * way, starts[kept])
    inside_end = np.where(leave < 1, starts[kept] + leave * way, ends[kept])
    # Kept inside once more: a product may have ended a rounding error beyond the edge.
    start, end = np.clip(inside_start, 0, room), np.clip(inside_end, 0, room)
    return _nearest(start), _nearest(end), kept


def _nearest(points: Doubles) -> Ints:
    """`rounded` for points of the screen: they are not negative, so truncation is the floor."""
    return (points + (0.5 + TIE)).astype(np.int64)


def _inside(points: Doubles, room: Doubles) -> bool:
    x, y = points[:, 0], points[:, 1]
    if not len(points):
        return True
    across = x.min() >= 0 and x.max() <= room[0]
    return bool(across and y.min() >= 0 and y.max() <= room[1])


def polygon_rows(points: Sequence[Pixel], height: int) -> Iterator[tuple[int, int, int]]:
    """The rows (y, left, right) that fill a polygon, on a screen of that height."""
    sides = polygon_sides(points)
    top = max(min(min(a[1], b[1]) for a, b in sides), 0) if sides else 0
    bottom = min(max(max(a[1], b[1]) for a, b in sides), height) if sides else 0
    for y in range(top, bottom):
        crossings = sorted(
            upper[0] + int((y - upper[1]) * (lower[0] - upper[0]) / (lower[1] - upper[1]))
            for upper, lower in (sorted(side, key=lambda point: point[1]) for side in sides)
            if upper[1] <= y < lower[1]
        )
        for left, right in zip(crossings[::2], crossings[1::2], strict=False):
            yield y, left, right


def polygon_sides(points: Sequence[Pixel]) -> list[tuple[Pixel, Pixel]]:
    """The sides of a closed polygon; back at its first point a figure ends, and another begins."""
    paths: list[list[Pixel]] = [[]]
    for point in [*points, points[0]]:
        path = paths[-1]
        if path and point == path[0]:
            if len(path) > 1:
                path.append(point)
                paths.append([])
        else:
            path.append(point)
    return [side for path in paths for side in pairwise(path)]
