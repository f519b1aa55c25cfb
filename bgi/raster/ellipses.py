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
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bgi.raster import lines
from bgi.raster.kept import Kept
from bgi.raster.lines import Ints, Segments, Trace
from bgi.raster.offsets import Offsets, figure, offsets, reach

Offset = tuple[int, int]
"""dx, dy from the centre, dy downwards."""

# Without the small addend sin 30 degrees would come out just below one half.
_TABLE = [math.floor(32768 * math.sin(math.radians(a)) + 1e-9) for a in range(91)]
_OVERFLOW = 1 << 32
"""The stepper's square no longer fits 32 bits: the original draws nothing (radii above 6553)."""


def sine(angle: int) -> int:
    """65536 times the sine of a whole number of degrees, as the kernel's table has it."""
    angle %= 360
    if angle >= 180:
        return -sine(angle - 180)
    return 2 * _TABLE[min(angle, 180 - angle)]


_SINES = np.array([sine(angle) for angle in range(360)], dtype=np.int64)
_COSINES = np.roll(_SINES, -90)


def point_at(angle: int, rx: int, ry: int) -> Offset:
    """The offset of an arc's point: floors, so that it falls outward on the left and below."""
    return sine(angle + 90) * rx >> 16, -(sine(angle) * ry >> 16)


_COUNT = np.arange(6554, dtype=np.int64)
_SQUARES = (_COUNT * _COUNT).astype(np.float64)
"""Of radii that do not overflow."""


_FEW = 150
"""Up to here a loop takes less time than arrays do."""


@lru_cache(maxsize=4)  # a filled ellipse asks for its rows and for its outline
def quadrant(rx: int, ry: int) -> Ints:
    """The stepper's points of one quadrant, from the top (0, ry) to the right end.

    Two rows, x and y upwards. Radii 0 are taken as 1. Nothing for negative radii, and where the
    original's arithmetic overflows.
    """
    if not drawable(rx, ry):
        return np.zeros((2, 0), dtype=np.int64)
    rx, ry = max(rx, 1), max(ry, 1)
    square = 100 * max(rx, ry) ** 2
    find = _walked if rx + ry < _FEW else _computed
    return find(ry, square, square // rx // rx, square // ry // ry)


def _walked(ry: int, square: int, p: int, q: int) -> Ints:
    """Step by step. The error at x, y is p * x**2 + q * y**2 - square."""
    error, y = q * ry * ry - square, ry
    right, down = p, 2 * q * ry - q  # what the error grows by with a step, and falls by
    ys: list[int] = []
    while right < down + p + q:  # the flat part: every x once
        ys.append(y)
        error += right
        right += 2 * p
        if error + error >= down:
            y -= 1
            error -= down
            down -= 2 * q
    x, half = len(ys), right // 2
    xs: list[int] = []
    for falls in range(down, -2 * q, -2 * q):  # the steep part: every y once
        xs.append(x)
        error -= falls
        if half + error <= 0:
            x += 1
            error += right
            right += 2 * p
            half += p
    flat = len(ys)
    steps = np.empty((2, flat + len(xs)), np.int64)
    steps[0, :flat], steps[1, :flat] = _COUNT[:flat], ys
    steps[0, flat:], steps[1, flat:] = xs, _COUNT[y::-1]
    return steps


def _computed(ry: int, square: int, p: int, q: int) -> Ints:
    """The same points at once.

    In the flat part the stepper goes down where the errors of both candidates together are not
    below 0: below the y where a square root says that they are 0, but by one row at most. In the
    steep part it goes to the right in the same way. No two candidates are so near to that place
    that floating point could take one for the other: an eighth, added to whole numbers, makes sure
    of that where they are exactly there.
    """
    flat = int(math.sqrt(square * q / (p * (p + q)))) + 3  # a little farther than p * x = q * y
    x, height = _COUNT[:flat], _SQUARES[:flat] * (-p / q)
    height += (square - 0.125) / q - 0.25
    y = np.minimum(_rounded_root(height), ry)
    y = np.maximum.accumulate(y + x) - x
    turn = int((p * x >= q * y)[1:].argmax()) + 1
    low = int(y[turn])
    down, width = _COUNT[: low + 1], _SQUARES[low::-1] * (-q / p)
    width += (square - p // 2 + 0.125) / p + 0.25
    across = np.maximum(_rounded_root(width), turn)
    across[0] = turn
    across = np.minimum.accumulate(across - down) + down
    return np.array((np.append(x[:turn], across), np.append(y[:turn], _COUNT[low::-1])))


def _rounded_root(squares: NDArray[np.float64]) -> Ints:
    """The whole number next to each square root; of less than 0 it is 0."""
    np.maximum(squares, 0, out=squares)
    np.sqrt(squares, out=squares)
    squares += 0.5
    return squares.astype(np.int64)


def drawable(rx: int, ry: int) -> bool:
    """Whether there is anything to draw: not for negative radii, nor for those that overflow."""
    return min(rx, ry) >= 0 and 100 * max(rx, ry) ** 2 < _OVERFLOW


MOST_CORNERS = 679
"""More corners of a thick curve did not fit the original's buffer: it drew nothing then."""


def thick_points(start: int, end: int, rx: int, ry: int) -> tuple[Ints, Ints]:
    """The corners of a thick curve, x and y: one for every whole degree from start to end.

    The original compares angles as unsigned numbers of 16 bits, so that an arc which begins below
    0 goes beyond a whole turn. Where it would draw nothing for want of memory, the arc is brought
    into a turn.
    """
    later = 360 if start & 0xFFFF >= end & 0xFFFF else 0
    sweep = (end + later - start) & 0xFFFF
    if sweep >= MOST_CORNERS:
        sweep = min(end - start, 360) % 360 or 360
    angles = (_COUNT[: sweep + 1] + start % 360) % 360  # `point_at` for all of them
    return _COSINES[angles] * rx >> 16, -(_SINES[angles] * ry >> 16)


_QUADRANT = 1 << 20
"""Between the ranks of two quadrants. The original's 2000 mixes them up for radii above 1000."""


def _rank(dx: int, dy: int) -> int:
    """A number that grows counter-clockwise from the right, for points of one ellipse."""
    up = -dy
    if up >= 0:
        return up - dx if dx >= 0 else _QUADRANT - dx - up
    return 2 * _QUADRANT + dx - up if dx < 0 else 3 * _QUADRANT + dx + up


class Ring(NamedTuple):
    """The points of a whole thin ellipse, offsets from its centre, and the rank of each."""

    dx: Ints
    dy: Ints
    rank: Ints


def _ring(rx: int, ry: int) -> Ring:
    steps = quadrant(rx, ry)
    x, y = steps
    rank = np.multiply.outer(y - x, _RANK_GROWS) + _RANK_BEGINS
    # Points on the axes are mirrored onto themselves, and belong to one quadrant.
    rank[0, 1::2] = rank[0, ::2]
    rank[-1, 2:] = rank[-1, :2]
    dx, dy = _mirrored(steps)
    return Ring(dx, dy, rank.ravel())


def _mirrored(steps: Ints) -> tuple[Ints, Ints]:
    """dx and dy of a whole ellipse: four points for each step, in that order."""
    dx, dy = (steps[:, :, np.newaxis] * _MIRRORS).reshape(2, -1)
    return dx, dy


_MIRRORS = np.array([[[1, -1, 1, -1]], [[-1, -1, 1, 1]]], dtype=np.int64)
_RANK_GROWS = np.array([1, -1, -1, 1], dtype=np.int64)
_RANK_BEGINS = np.array([0, 1, 3, 2], dtype=np.int64) * _QUADRANT
RINGS = Kept(_ring, 1 << 21)
"""By both radii."""


def arc(start: int, end: int, rx: int, ry: int) -> tuple[Ints, Ints]:
    """dx and dy of a thin arc's points, in the stepper's order."""
    if (start, end) == (0, 360):
        return _mirrored(quadrant(rx, ry))
    if start == end or not drawable(rx, ry):
        return _COUNT[:0], _COUNT[:0]
    dx, dy, rank = RINGS[rx, ry]
    first, last = point_at(start, rx, ry), point_at(end, rx, ry)
    sweep = end - start if start < end else 360  # whatever it is
    if sweep < 2 or (first == last and sweep < 350):
        return np.full(1, last[0]), np.full(1, last[1])
    low, high = _rank(*first), _rank(*last)
    after, before = rank >= low, rank <= high
    inside = after | before if high <= low else after & before
    return dx[inside], dy[inside]


class Curve(NamedTuple):
    """A thin curve: its points as offsets from its centre, and the same as a figure."""

    dx: Ints
    dy: Ints
    pixels: Offsets


def _curve(start: int, end: int, rx: int, ry: int, width: int) -> Curve:
    dx, dy = arc(start, end, rx, ry)
    if (start, end) == (0, 360) and len(dx):  # known sooner
        left, top = int(dx[-1]), int(dy[0])
        extent = left, top, -left, -top
    else:
        extent = reach(dx, dy)
    return Curve(dx, dy, offsets(dy * width + dx, extent, width))


CURVES = Kept(_curve, 1 << 23)
"""By start and end, both radii, and the width of a page."""


def _thick_curve(
    start: int, end: int, rx: int, ry: int, xor: bool, trace: Trace, width: int
) -> Offsets:
    x1, y1, x2, y2 = sides = thick_sides(start, end, rx, ry)
    level = abs(x2 - x1) >= abs(y2 - y1)
    if is_fine(rx, ry) and not xor:  # pixels may come more than once
        x, y = np.concatenate((x1, x2)), np.concatenate((y1, y2))
        level = np.concatenate((level, level))
    else:
        x, y, _, line = trace(sides)
        level = level[line]
    x, y = lines.beside(x, y, level)
    return figure(x, y, reach(x, y), width, xor)


THICK_CURVES = Kept(_thick_curve, 1 << 23)
"""The same of thick curves; also by the write mode, and by how a page draws lines."""
_FINE = 57
"""One degree of a circle of that radius is less than one pixel."""


def is_fine(rx: int, ry: int) -> bool:
    """Whether all sides of a thick curve lead to a pixel beside, or nowhere.

    Then they have no pixels but their ends, and what a box clips away changes none of the others.
    """
    return max(rx, ry) <= _FINE


def thick_sides(start: int, end: int, rx: int, ry: int) -> Segments:
    """The lines of a thick curve, before they are made thick."""
    x, y = thick_points(start, end, rx, ry)
    found = [np.zeros((4, 0), np.int64)]
    first = 0
    while first < len(x):  # `polygons.paths`: once, mostly
        home = (x[first:] == x[first]) & (y[first:] == y[first])
        leaves = first + int(home.argmin())
        if leaves == first:  # which it does not
            break
        back = np.flatnonzero(home[leaves - first :])
        last = leaves + int(back[0]) if len(back) else len(x) - 1
        ends = slice(leaves, last + 1)
        starts = slice(leaves - 1, last)
        found.append(np.array((x[starts], y[starts], x[ends], y[ends])))
        first = last + 1
    x1, y1, x2, y2 = np.concatenate(found, axis=1)
    return x1, y1, x2, y2
