"""Lines: which pixels, clipped how, in which order.

The driver draws every line downwards (a level one from its first point), with both ends: n steps
along the longer axis, and after i of them `(2 * m * i + n) // (2 * n)` along the shorter one (m its
length), so that an exact tie steps early. The kernel clips before: it moves an outside end to one
violated edge after another, left or right, then top or bottom, the other coordinate truncated
toward zero, and the driver then draws a fresh line between the clipped ends.

A thick line is three thin ones, clipped each on its own: the line itself, then shifted by -1, then
by +1; in y if the line is rather level, else in x.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Box = tuple[int, int, int, int]
"""left, top, right, bottom, all inside."""
Segment = tuple[int, int, int, int]
"""x1, y1, x2, y2."""
Segments = tuple[Ints, Ints, Ints, Ints]
"""x1, y1, x2, y2 of many lines."""

PIXELS = 8192
"""Pixels traced at a time."""
_MOVES = 8
"""More moves than any line needs to come inside: each end crosses at most two edges."""


def toward_zero(numerator: Any, denominator: Any) -> Any:
    """The quotient as C computes it, for ints and arrays; anything where the denominator is 0.

    An int64 array must hold less than 2**52: then floating point is exact, and much faster.
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
        if max(x1, x2) < left or min(x1, x2) > right or max(y1, y2) < top or min(y1, y2) > bottom:
            return None
        if not (left <= x1 <= right and top <= y1 <= bottom):
            x1, y1 = _move(x1, y1, dx, dy, box)
        elif not (left <= x2 <= right and top <= y2 <= bottom):
            x2, y2 = _move(x2, y2, dx, dy, box)
        else:
            return x1, y1, x2, y2
    return None


def _move(x: int, y: int, dx: int, dy: int, box: Box) -> tuple[int, int]:
    left, top, right, bottom = box
    if not left <= x <= right:
        edge = left if x < left else right
        return edge, y + toward_zero((edge - x) * dy, dx)
    edge = top if y < top else bottom
    return x + toward_zero((edge - y) * dx, dy), edge


def clip_many(segments: Segments, box: Box) -> tuple[Segments, NDArray[np.intp]]:
    """`clip` for arrays: the lines that remain, and which of the given ones they are."""
    left, top, right, bottom = box
    x1, y1, x2, y2 = segments
    dx, dy = x2 - x1, y2 - y1
    kept = np.arange(len(x1))
    for _ in range(_MOVES):
        outside = (np.maximum(x1, x2) < left) | (np.minimum(x1, x2) > right)
        outside |= (np.maximum(y1, y2) < top) | (np.minimum(y1, y2) > bottom)
        if outside.any():
            stay = ~outside
            x1, y1, x2, y2, dx, dy, kept = (a[stay] for a in (x1, y1, x2, y2, dx, dy, kept))
        out1, out2 = _outside(x1, y1, box), _outside(x2, y2, box)
        if not (out1.any() or out2.any()):
            return (x1, y1, x2, y2), kept
        # Like `clip`, one move a round, the first end's before the second's.
        x1, y1 = _moved(x1, y1, dx, dy, out1, box)
        x2, y2 = _moved(x2, y2, dx, dy, out2 & ~out1, box)
    inside = ~(_outside(x1, y1, box) | _outside(x2, y2, box))
    return (x1[inside], y1[inside], x2[inside], y2[inside]), kept[inside]


def _outside(x: Ints, y: Ints, box: Box) -> NDArray[np.bool_]:
    left, top, right, bottom = box
    beyond: NDArray[np.bool_] = (x < left) | (x > right) | (y < top) | (y > bottom)
    return beyond


def _moved(
    x: Ints, y: Ints, dx: Ints, dy: Ints, wanted: NDArray[np.bool_], box: Box
) -> tuple[Ints, Ints]:
    left, top, right, bottom = box
    ahead = np.where(wanted, np.clip(x, left, right) - x, 0)
    down = np.where(wanted & (ahead == 0), np.clip(y, top, bottom) - y, 0)
    return x + ahead + toward_zero(down * dx, dy), y + down + toward_zero(ahead * dy, dx)


def places(segment: Segment, width: int) -> Ints:
    """The pixels of one thin line, as places on a page of that width, in drawing order."""
    x1, y1, x2, y2 = segment
    if y2 < y1:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy = x2 - x1, y2 - y1
    right = 1 if dx >= 0 else -1
    n, m, along, across = abs(dx), dy, right, width
    if dy > n:
        n, m, along, across = dy, n, width, right
    # The rule's fractions are multiples of 1 / 2n: half of that more outweighs what a step with 32
    # bits of fraction lacks. (A level or upright line needs steps too, to be as long as it is.)
    length = n or 1
    start, step = (1 << 31) + (1 << 30) // length, (m << 32) // length or 1
    place = np.arange(start, start + (n + 1) * step, step)
    place >>= 32
    place *= across
    place += np.arange(y1 * width + x1, y1 * width + x1 + (n + 1) * along, along)
    return place


def trace_many(segments: Segments) -> tuple[Ints, Ints, Ints, Ints]:
    """The pixels of many thin lines one after another: x, y, step from the line's start, line."""
    x1, y1, x2, y2 = segments
    up = y2 < y1
    x1, x2 = np.where(up, x2, x1), np.where(up, x1, x2)
    y1, y2 = np.where(up, y2, y1), np.where(up, y1, y2)
    dx, dy = x2 - x1, y2 - y1
    steep = dy > abs(dx)
    n = np.where(steep, dy, abs(dx))
    m = np.where(steep, abs(dx), dy)
    line = np.repeat(np.arange(len(n)), n + 1)
    ends = np.cumsum(n + 1)
    step = np.arange(len(line)) - np.repeat(ends - (n + 1), n + 1)
    across = toward_zero(step * (2 * m)[line] + n[line], (2 * n)[line])
    in_x = np.where(steep[line], across, step)
    in_y = step + across - in_x
    return x1[line] + in_x * np.sign(dx)[line], y1[line] + in_y, step, line


def batches(sizes: Ints, most: int) -> Iterator[slice]:
    """Cut consecutive things into groups of about that size together, at least one a group."""
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
    x1, y1, x2, y2 = (np.repeat(a, 3) for a in segments)
    shift = np.tile([0, -1, 1], len(segments[0]))
    level = abs(x2 - x1) >= abs(y2 - y1)
    in_x, in_y = np.where(level, 0, shift), np.where(level, shift, 0)
    return x1 + in_x, y1 + in_y, x2 + in_x, y2 + in_y
