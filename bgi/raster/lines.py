"""Lines: which pixels, clipped how, in which order.

The pixels are those of Bresenham's line ("Algorithm for computer control of a digital plotter", IBM
Systems Journal 4, 1965); an exact tie steps early. The driver draws every line downwards, a level
one from its first point, both ends included: n steps along the longer axis, and after i of them
`(2 * m * i + n) // (2 * n)` steps along the shorter one, where m is its length.

The kernel clips before that, as Cohen and Sutherland do (Newman and Sproull, "Principles of
Interactive Computer Graphics", 1973): an end that is outside moves to one violated edge after
another, first left or right, then top or bottom. Its other coordinate is truncated toward zero, and
the driver draws a new line between the clipped ends: its pixels may differ from the whole line's.

A thick line is three thin ones, each clipped on its own: the line itself, the same shifted by -1,
the same shifted by +1; in y if it is more level than upright, else in x.
"""

from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.raster.arrays import repeat

Ints = NDArray[np.int64]
Box = tuple[int, int, int, int]
"""left, top, right, bottom, all inside."""
Segment = tuple[int, int, int, int]
"""x1, y1, x2, y2."""
Segments = tuple[Ints, Ints, Ints, Ints]
"""x1, y1, x2, y2 of many lines."""
Course = tuple[int, int, int, int, int]
"""The place of a line's first pixel; its steps along the longer axis, and its length along the
shorter one; what a step along either adds to the place."""
Trace = Callable[[Segments], tuple[Ints, Ints, Ints, Ints]]
"""How a driver draws lines, as `trace_many` does."""

CHUNK = 8192
"""Pixels traced at a time: such arrays fit into the processor's cache."""
_MOVES = 8
"""More moves than any line needs to come inside: each end crosses at most two edges."""
_FEW = 40
"""Below this many lines that an edge cuts, one after another is faster than all at once."""
_FRACTION_BITS = 32
"""Bits after the binary point of a step along the shorter axis."""
_SHIFT = np.array(_FRACTION_BITS)
_BELOW_ONE = (1 << _FRACTION_BITS) - 1
_ROUNDING = (1 << _FRACTION_BITS - 1) + (1 << _FRACTION_BITS - 14)
"""A half, and a little more than the truncated step loses: less than 1 / 2n, for n below 4096."""

_SHIFTS = np.array([0, -1, 1])
"""Of the strands of a thick line."""


def toward_zero(numerator: Any, denominator: Any) -> Any:
    """The quotient as C computes it, for ints and arrays; any number where the denominator is 0.

    The numbers of an int64 array must be below 2**52: then floating point is exact, and faster.
    """
    denominator = denominator + (denominator == 0)
    if isinstance(numerator, np.ndarray) and numerator.dtype != object:
        return (numerator / denominator).astype(np.int64)
    quotient = abs(numerator) // abs(denominator)
    return quotient * (1 - 2 * ((numerator < 0) != (denominator < 0)))


def clip(x1: int, y1: int, x2: int, y2: int, box: Box) -> Segment | None:
    """The part of a line inside `box` as the kernel computes it, or None."""
    left, top, right, bottom = box
    dx, dy = x2 - x1, y2 - y1
    for _ in range(_MOVES):
        if (
            (x1 < left and x2 < left)
            or (x1 > right and x2 > right)
            or (y1 < top and y2 < top)
            or (y1 > bottom and y2 > bottom)
        ):
            return None
        if not (left <= x1 <= right and top <= y1 <= bottom):
            x1, y1 = _move(x1, y1, dx, dy, box)
        elif not (left <= x2 <= right and top <= y2 <= bottom):
            x2, y2 = _move(x2, y2, dx, dy, box)
        else:
            return x1, y1, x2, y2
    return None


def _move(x: int, y: int, dx: int, dy: int, box: Box) -> tuple[int, int]:
    """One step of `clip`: an outside end goes to the left or right edge, else to top or bottom."""
    left, top, right, bottom = box
    if not left <= x <= right:
        edge = left if x < left else right
        return edge, y + toward_zero((edge - x) * dy, dx)
    edge = top if y < top else bottom
    return x + toward_zero((edge - y) * dx, dy), edge


def clip_many(segments: Segments, box: Box) -> tuple[Segments, NDArray[np.intp]]:
    """`clip` for arrays: the lines that remain, and which of the given ones they are."""
    out = beyond(segments, box)
    kept = np.flatnonzero(~out)
    if len(kept) < len(out):
        x1, y1, x2, y2 = (end[kept] for end in segments)
    else:
        x1, y1, x2, y2 = segments
    cut = np.flatnonzero(_outside(x1, y1, box) | _outside(x2, y2, box))
    if not len(cut):
        return (x1, y1, x2, y2), kept
    cut_many = _cut_each if len(cut) < _FEW else _cut_together
    pieces, left = cut_many((x1[cut], y1[cut], x2[cut], y2[cut]), box)
    stay = np.ones(len(kept), np.bool_)
    stay[cut] = False
    cut = cut[left]
    stay[cut] = True
    whole = x1.copy(), y1.copy(), x2.copy(), y2.copy()
    for end, piece in zip(whole, pieces, strict=True):
        end[cut] = piece
    x1, y1, x2, y2 = (end[stay] for end in whole)
    return (x1, y1, x2, y2), kept[stay]


def _cut_each(segments: Segments, box: Box) -> tuple[Segments, NDArray[np.intp]]:
    """`clip_many` of a few lines."""
    each = zip(*(end.tolist() for end in segments), strict=True)
    found = [clip(x1, y1, x2, y2, box) for x1, y1, x2, y2 in each]
    left = [number for number, piece in enumerate(found) if piece]
    pieces = np.array([found[number] for number in left], np.int64).reshape(-1, 4)
    return (pieces[:, 0], pieces[:, 1], pieces[:, 2], pieces[:, 3]), np.array(left, np.intp)


def _cut_together(segments: Segments, box: Box) -> tuple[Segments, NDArray[np.intp]]:
    """`clip_many` of lines that have an end outside."""
    x1, y1, x2, y2 = segments
    dx, dy = x2 - x1, y2 - y1
    kept = np.arange(len(x1))
    for _ in range(_MOVES):
        out = beyond((x1, y1, x2, y2), box)
        if out.any():
            stay = ~out
            x1, y1, x2, y2, dx, dy, kept = (a[stay] for a in (x1, y1, x2, y2, dx, dy, kept))
        out1, out2 = _outside(x1, y1, box), _outside(x2, y2, box)
        if not (out1.any() or out2.any()):
            return (x1, y1, x2, y2), kept
        # Like `clip`, one move a round, the first end's before the second's.
        x1, y1 = _moved(x1, y1, dx, dy, out1, box)
        x2, y2 = _moved(x2, y2, dx, dy, out2 & ~out1, box)
    inside = ~(_outside(x1, y1, box) | _outside(x2, y2, box))
    return (x1[inside], y1[inside], x2[inside], y2[inside]), kept[inside]


def beyond(segments: Segments, box: Box) -> NDArray[np.bool_]:
    """Which lines have both ends beyond the same edge."""
    left, top, right, bottom = box
    x1, y1, x2, y2 = segments
    out: NDArray[np.bool_] = (np.maximum(x1, x2) < left) | (np.minimum(x1, x2) > right)
    out |= (np.maximum(y1, y2) < top) | (np.minimum(y1, y2) > bottom)
    return out


def _outside(x: Ints, y: Ints, box: Box) -> NDArray[np.bool_]:
    left, top, right, bottom = box
    beyond: NDArray[np.bool_] = (x < left) | (x > right) | (y < top) | (y > bottom)
    return beyond


def _moved(
    x: Ints, y: Ints, dx: Ints, dy: Ints, wanted: NDArray[np.bool_], box: Box
) -> tuple[Ints, Ints]:
    """`_move` for arrays: those ends move that are wanted."""
    left, top, right, bottom = box
    ahead = np.where(wanted, np.clip(x, left, right) - x, 0)
    down = np.where(wanted & (ahead == 0), np.clip(y, top, bottom) - y, 0)
    return x + ahead + toward_zero(down * dx, dy), y + down + toward_zero(ahead * dy, dx)


def course(x1: int, y1: int, x2: int, y2: int, width: int) -> Course:
    """How a thin line goes over a page of that width."""
    if y2 < y1:
        x1, y1, x2, y2 = x2, y2, x1, y1
    first, aside, n, m = y1 * width + x1, 1, x2 - x1, y2 - y1
    if n < 0:
        aside, n = -1, -n
    return (first, n, m, aside, width) if n >= m else (first, m, n, width, aside)


def course_rightward(x1: int, y1: int, x2: int, y2: int, width: int) -> Course:
    """`course` for a driver that draws its lines to the right, and not down."""
    if x2 <= x1:
        x1, y1, x2, y2 = x2, y2, x1, y1
    first, below, n, m = y1 * width + x1, width, x2 - x1, y2 - y1
    if m < 0:
        below, m = -width, -m
    return (first, m, n, below, 1) if m >= n else (first, n, m, 1, below)


def places(course: Course) -> Ints:
    """Where the steps of a line are that is neither level nor upright.

    In fixed point: a step along the shorter axis is a fraction.
    """
    first, n, m, along, across = course
    step = (m << _FRACTION_BITS) // n
    if across == 1 or across == -1:  # what the fraction adds is a place, as the rest is
        step = (along << _FRACTION_BITS) + across * step
        start = (first << _FRACTION_BITS) + (_ROUNDING if across == 1 else _BELOW_ONE - _ROUNDING)
        place: Ints = np.arange(start, start + (n + 1) * step, step, dtype=np.int64)
        place >>= _SHIFT
        return place
    place = np.arange(_ROUNDING, _ROUNDING + (n + 1) * step, step, dtype=np.int64)
    place >>= _SHIFT
    place *= _number(across)
    place += np.arange(first, first + (n + 1) * along, along, dtype=np.int64)
    return place


@lru_cache(maxsize=64)
def _number(number: int) -> NDArray[np.int64]:
    """An array of no dimensions: numpy takes it sooner than an int."""
    return np.array(number)


def steps_of(segments: Segments) -> Ints:
    """How many steps lines have."""
    x1, y1, x2, y2 = segments
    steps: Ints = np.maximum(abs(x2 - x1), abs(y2 - y1)).astype(np.int64, copy=False)
    return steps


def trace_many(segments: Segments) -> tuple[Ints, Ints, Ints, Ints]:
    """The pixels of many thin lines, one line after another.

    Returns x, y, the number of steps from the line's start, and the line's number.
    """
    x1, y1, x2, y2 = segments
    up = y2 < y1
    dx, dy = x2 - x1, abs(y2 - y1)
    x1, y1, dx = np.where(up, x2, x1), np.minimum(y1, y2), np.where(up, -dx, dx)
    n = np.maximum(abs(dx), dy)
    count = n + 1
    line = repeat(np.arange(len(n)), count)
    step = np.arange(len(line), dtype=np.int64)
    step -= (np.cumsum(count) - count).take(line)
    # The exact positions are multiples of 1 / n. A half is rounded the way the line goes: adding
    # 1 / 4n more, or less, keeps an error of floating point on the right side.
    scale = 1 / np.maximum(n, 1)
    x = (dx * scale).take(line)
    x *= step
    x += (x1 + (0.5 + np.copysign(0.25 * scale, dx))).take(line)
    y = (dy * scale).take(line)
    y *= step
    y += (y1 + (0.5 + 0.25 * scale)).take(line)
    return np.floor(x, out=x).astype(np.int64), np.floor(y, out=y).astype(np.int64), step, line


def trace_rightward(segments: Segments) -> tuple[Ints, Ints, Ints, Ints]:
    """`trace_many` for a driver that draws its lines to the right, and not down."""
    x1, y1, x2, y2 = segments
    y, x, step, line = trace_many((y2, x2, y1, x1))
    return x, y, step, line


def grouped(sizes: Ints, most: int) -> Iterator[slice]:
    """Cut a row of things into groups of at most that size together, or of one large thing."""
    ends = np.cumsum(sizes)
    start, total = 0, 0
    while start < len(ends):
        end = max(start + 1, int(np.searchsorted(ends, total + most, side="right")))
        yield slice(start, end)
        start, total = end, int(ends[end - 1])


def strands(x1: int, y1: int, x2: int, y2: int) -> list[Segment]:
    """The three thin lines that make a thick one."""
    if abs(x2 - x1) >= abs(y2 - y1):
        return [(x1, y1 + d, x2, y2 + d) for d in (0, -1, 1)]
    return [(x1 + d, y1, x2 + d, y2) for d in (0, -1, 1)]


def strands_many(segments: Segments) -> Segments:
    """`strands` for arrays: the three of the first line, then those of the second, and so on."""
    x1, y1, x2, y2 = segments
    level = abs(x2 - x1) >= abs(y2 - y1)
    in_x, in_y = np.multiply.outer(~level, _SHIFTS), np.multiply.outer(level, _SHIFTS)
    x1, y1 = (x1[:, np.newaxis] + in_x).ravel(), (y1[:, np.newaxis] + in_y).ravel()
    return x1, y1, (x2[:, np.newaxis] + in_x).ravel(), (y2[:, np.newaxis] + in_y).ravel()


def trace_strands(trace: Trace, segments: Segments) -> tuple[Ints, Ints, Ints]:
    """The pixels of many thick lines that nothing clips, x and y and the step: each is traced once.

    Its other strands are the same pixels beside it.
    """
    x1, y1, x2, y2 = segments
    x, y, step, line = trace(segments)
    level = (abs(x2 - x1) >= abs(y2 - y1))[line]
    return *beside(x, y, level), np.tile(step, 3)


def beside(x: Ints, y: Ints, level: NDArray[np.bool_]) -> tuple[Ints, Ints]:
    """Pixels, and those on both sides of them: above and below where their line is level."""
    upright = ~level
    return (
        np.concatenate((x, x - upright, x + upright)),
        np.concatenate((y, y - level, y + level)),
    )
