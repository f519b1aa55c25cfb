"""Circles, ellipses and arcs by the kernel's integer rules: which pixels, in which order.

A stepper walks along one quadrant and mirrors each point four ways. Of two neighbouring pixels it
takes the one with the smaller error, as Bresenham's circle does ("A linear algorithm for
incremental digital display of circular arcs", Communications of the ACM 20, 1977). The midpoint
algorithm, which asks on which side of the curve the middle between the two lies, is its better
known relative. The error is the ellipse's equation, scaled to whole numbers.

An arc keeps those points whose *rank* lies between the ranks of its two ends: a number that grows
around the ellipse and needs no arc tangent. The ends come from a table of 91 sines. A thick curve
is different: one point for every whole degree, joined by thick lines.
"""

import math
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bgi.raster import lines, polygons
from bgi.raster.lines import Ints

Offset = tuple[int, int]
"""dx, dy from the centre, dy downwards."""

# Without the small addend sin 30 degrees would come out just below one half.
_SINES = [math.floor(32768 * math.sin(math.radians(a)) + 1e-9) for a in range(91)]
_OVERFLOW = 1 << 32
"""The stepper's square no longer fits 32 bits: the original draws nothing (radii above 6553)."""


def sine(angle: int) -> int:
    """65536 times the sine of a whole number of degrees, as the kernel's table has it."""
    angle %= 360
    if angle >= 180:
        return -sine(angle - 180)
    return 2 * _SINES[min(angle, 180 - angle)]


def point_at(angle: int, rx: int, ry: int) -> Offset:
    """The offset of an arc's point: floors, so that it falls outward on the left and below."""
    return sine(angle + 90) * rx >> 16, -(sine(angle) * ry >> 16)


def _steps(rx: int, ry: int) -> Iterator[Offset]:
    """One quadrant, from the top (0, ry) to the right end, y upwards.

    `error` is p * x**2 + q * y**2 - square at the point x, y. One step to the right adds h to it,
    one step down takes v away.
    """
    square = 100 * max(rx, ry) ** 2
    p, q = square // rx // rx, square // ry // ry
    x, y = 0, ry
    error, dv, dh = q * ry * ry - square, 2 * q * ry, 0
    while True:  # the flat part: every x once
        yield x, y
        h, v = dh + p, dv - q
        if 2 * error + 2 * h >= v:
            y, error, dv = y - 1, error - v, v - q
        x, error, dh = x + 1, error + h, h + p
        if dh >= dv:
            break
    while y >= 0:  # the steep part: every y once
        yield x, y
        h, v = dh + p, dv - q
        if h // 2 + error <= v:
            x, error, dh = x + 1, error + h, h + p
        y, error, dv = y - 1, error - v, v - q


REMEMBERED = 1024
"""The largest radius of a curve whose points are kept."""


def quadrant(rx: int, ry: int) -> list[Offset]:
    """The stepper's points of one quadrant (x right, y up), radii 0 taken as 1; else empty.

    Nothing for negative radii, and nothing where the original's arithmetic overflows.
    """
    if not drawable(rx, ry):
        return []
    find = _known_steps if max(rx, ry) <= REMEMBERED else _all_steps
    return find(max(rx, 1), max(ry, 1))


def _all_steps(rx: int, ry: int) -> list[Offset]:
    return list(_steps(rx, ry))


_known_steps = lru_cache(maxsize=128)(_all_steps)


def drawable(rx: int, ry: int) -> bool:
    """Whether there is anything to draw: not for negative radii, nor for those that overflow."""
    return min(rx, ry) >= 0 and 100 * max(rx, ry) ** 2 < _OVERFLOW


MOST_CORNERS = 679
"""More corners of a thick curve did not fit the original's buffer: it drew nothing then."""


def thick_points(start: int, end: int, rx: int, ry: int) -> list[Offset]:
    """The corners of a thick curve: one for every whole degree from start to end.

    The original compares angles as unsigned numbers of 16 bits, so that an arc which begins below
    0 goes beyond a whole turn. Where it would draw nothing for want of memory, the arc is brought
    into a turn.
    """
    later = 360 if start & 0xFFFF >= end & 0xFFFF else 0
    sweep = (end + later - start) & 0xFFFF
    if sweep >= MOST_CORNERS:
        sweep = min(end - start, 360) % 360 or 360
    return [point_at(angle, rx, ry) for angle in range(start, start + sweep + 1)]


_QUADRANT = 1 << 20
"""Between the ranks of two quadrants. The original's 2000 mixes them up for radii above 1000."""


def _rank(dx: int, dy: int) -> int:
    """A number that grows counter-clockwise from the right, for points of one ellipse."""
    up = -dy
    if up >= 0:
        return up - dx if dx >= 0 else _QUADRANT - dx - up
    return 2 * _QUADRANT + dx - up if dx < 0 else 3 * _QUADRANT + dx + up


class Outline(NamedTuple):
    """The points of a thin curve: offsets from its centre, in the stepper's order."""

    dx: Ints
    dy: Ints
    place: Ints
    """The same as offsets into a page."""
    left: int
    top: int
    right: int
    bottom: int
    """How far it reaches, all offsets from the centre; nothing for an empty one."""


def outline(start: int, end: int, rx: int, ry: int, width: int) -> Outline:
    """A thin curve from angle to angle, for a page of that width."""
    find = _known_outline if rx <= REMEMBERED and ry <= REMEMBERED else _outline
    return find(start, end, rx, ry, width)


def _outline(start: int, end: int, rx: int, ry: int, width: int) -> Outline:
    points = np.array(arc(start, end, rx, ry), dtype=np.int64).reshape(-1, 2)
    return _reaching(points, width)


_known_outline = lru_cache(maxsize=256)(_outline)


@lru_cache(maxsize=64)
def thick_outline(start: int, end: int, rx: int, ry: int, width: int) -> Outline:
    """A thick curve that nothing clips, for a page of that width; each pixel once."""
    sides = polygons.edges(polygons.paths(thick_points(start, end, rx, ry)))
    ends = np.array(sides, dtype=np.int64).reshape(-1, 4)
    x1, y1, x2, y2 = ends.T
    x, y, _, _ = lines.trace_many(lines.strands_many((x1, y1, x2, y2)))
    both = np.unique(y * 2 * _QUADRANT + x + _QUADRANT)  # as one number: quicker than by pairs
    y, x = np.divmod(both, 2 * _QUADRANT)
    return _reaching(np.stack((x - _QUADRANT, y), axis=1), width)


def _reaching(points: Ints, width: int) -> Outline:
    """Points, one a row, as an outline."""
    dx, dy = points.T
    reach = (*points.min(axis=0), *points.max(axis=0)) if len(points) else (0, 0, 0, 0)
    return Outline(dx, dy, dy * width + dx, *map(int, reach))


def arc(start: int, end: int, rx: int, ry: int) -> list[Offset]:
    """The points of a thin arc, or of a whole ellipse: four for each step, in that order."""
    if start == end:
        return []
    points = [point for x, y in quadrant(rx, ry) for point in ((x, -y), (-x, -y), (x, y), (-x, y))]
    first, last = point_at(start, rx, ry), point_at(end, rx, ry)
    sweep = end - start if start < end else 360  # whatever it is
    if points and (sweep < 2 or (first == last and sweep < 350)):
        return [last]
    low, high = _rank(*first), _rank(*last)
    if high <= low:
        return [point for point in points if not high < _rank(*point) < low]
    return [point for point in points if low <= _rank(*point) <= high]


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
