"""Circles, ellipses and arcs by the kernel's integer rules; no angle is ever sampled for thin ones.

A stepper walks one quadrant of the ellipse in hundredths of a pixel's area and mirrors each point
four ways. Arcs keep those points whose *rank* lies between the ranks of the end points: a number
that grows around the ellipse and needs no arc tangent. End points come from a table of 91 sines.
Thick curves are another matter: one point for every whole degree, joined by thick lines.
"""

import math
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from bgi.raster.lines import Ints

Offset = tuple[int, int]
"""dx, dy from the centre, dy downwards."""

# The tiny addend saves sin 30 degrees from being a hair less than one half.
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
    """One quadrant, from the top (0, ry) to the right tip, y upwards."""
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


@lru_cache(maxsize=128)
def quadrant(rx: int, ry: int) -> list[Offset]:
    """The stepper's points of one quadrant (x right, y up), radii 0 taken as 1; else empty.

    Nothing for negative radii, and nothing where the original's arithmetic overflows.
    """
    if not drawable(rx, ry):
        return []
    return list(_steps(max(rx, 1), max(ry, 1)))


@lru_cache(maxsize=128)
def outline(rx: int, ry: int) -> tuple[Ints, Ints]:
    """All points of a thin ellipse as offsets dx, dy: four a step, in the stepper's order."""
    steps = np.array(quadrant(rx, ry), dtype=np.int64).reshape(-1, 2)
    x, y = steps[:, 0], steps[:, 1]
    dx, dy = np.stack([x, -x, x, -x], axis=1), np.stack([-y, -y, y, y], axis=1)
    return dx.ravel(), dy.ravel()


def drawable(rx: int, ry: int) -> bool:
    """Whether there is anything to draw: not for negative radii, nor for those that overflow."""
    return min(rx, ry) >= 0 and 100 * max(rx, ry) ** 2 < _OVERFLOW


def reduced(start: int, end: int) -> tuple[int, int]:
    """Angles brought into a turn; a whole number of turns from start to end is one."""
    if start != end and (end - start) % 360 == 0:
        return start % 360, start % 360 + 360
    return start % 360, end % 360


def thick_points(start: int, end: int, rx: int, ry: int) -> list[Offset]:
    """The corners of a thick curve: one for every whole degree from start to end."""
    if not -360 <= start <= 720 or not -360 <= end <= 720:
        start, end = reduced(start, end)
    if start >= end:
        end += 360
    return [point_at(angle, rx, ry) for angle in range(start, end + 1)]


def _rank(dx: int, dy: int) -> int:
    """A number that grows counter-clockwise from the right, for points of one ellipse."""
    up = -dy
    if up >= 0:
        return up - dx if dx >= 0 else 2000 - dx - up
    return 4000 + dx - up if dx < 0 else 6000 + dx + up


def arc(start: int, end: int, rx: int, ry: int) -> list[Offset]:
    """The points of a thin arc, in the stepper's order."""
    start, end = reduced(start, end)
    if start == end:
        return []
    rx, ry = max(rx, 1), max(ry, 1)
    first, last = point_at(start, rx, ry), point_at(end, rx, ry)
    sweep = (end - start) % 360 or 360
    if sweep < 2 or (first == last and sweep < 350):
        return [last]
    low, high = _rank(*first), _rank(*last)
    wraps = high <= low
    points = zip(*(offsets.tolist() for offsets in outline(rx, ry)), strict=True)
    ranked = ((point, _rank(*point)) for point in points)
    if wraps:
        return [point for point, rank in ranked if rank >= low or rank <= high]
    return [point for point, rank in ranked if low <= rank <= high]


def quarters(start: int, end: int) -> list[tuple[int, int]]:
    """The pieces of a slice, cut at 90, 180 and 270 degrees."""
    cuts = [start, *(a for a in (90, 180, 270) if start < a < end), end]
    return list(pairwise(cuts))


@lru_cache(maxsize=128)
def places(rx: int, ry: int, width: int) -> tuple[NDArray[np.int64], int, int]:
    """`outline` as offsets into a page of that width, with its reach in x and in y."""
    dx, dy = outline(rx, ry)
    return dy * width + dx, int(dx.max(initial=-1)), int(dy.max(initial=-1))
