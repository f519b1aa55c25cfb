"""Scan conversion: the pixels that triangles cover, many triangles at a time.

A triangle is cut in two at the row of its middle corner. Either part has an apex, the triangle's
highest or lowest corner, from which two sides lead: each of its rows reaches from one to the other
(Foley, van Dam, Feiner and Hughes, "Computer Graphics: Principles and Practice", 1990, 3.6). What
a row needs is kept in arrays of its own, one number for each triangle: they are quick to take from.
"""

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints, repeat


def reaching(x: Doubles, y: Doubles, width: int, height: int) -> Bools:
    """Which triangles, corners (3, n) each, have a pixel's middle within their box."""
    reach: Bools = np.ones(x.shape[1], dtype=bool)
    for (a, b, c), size in ((x, width), (y, height)):
        low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        reach &= np.ceil(np.maximum(low, 0)) <= np.minimum(high, size - 1)
    return reach


def covered(x: Doubles, y: Doubles, width: int, height: int) -> tuple[Doubles, Doubles, Ints]:
    """The pixels whose middles lie in triangles, corners (3, n) each, sides (but for rounding) too.

    Their x and y, and the number of the triangle that each belongs to.
    """
    (x1, x2, x3), (y1, y2, y3) = _downwards(x, y)
    with np.errstate(divide="ignore", invalid="ignore"):
        long, above, below = (x3 - x1) / (y3 - y1), (x2 - x1) / (y2 - y1), (x3 - x2) / (y3 - y2)
    # The row of the middle corner belongs to the part above it, unless that is a point.
    cut = np.where(y2 > y1, np.floor(y2), np.ceil(y2) - 1)
    first = np.concatenate((np.ceil(np.maximum(y1, 0)), np.maximum(cut + 1, 0)))
    last = np.concatenate((np.minimum(cut, height - 1), np.floor(np.minimum(y3, height - 1))))
    apex_x, apex_y = np.concatenate((x1, x3)), np.concatenate((y1, y3))
    # Seen from below, what is to the left is what grows faster.
    to_left = np.concatenate((np.minimum(long, above), np.maximum(long, below)))
    to_right = np.concatenate((np.maximum(long, above), np.minimum(long, below)))

    row, part = _ranges(first, last)
    down, apex = row - apex_y.take(part), apex_x.take(part)
    left, right = apex + to_left.take(part) * down, apex + to_right.take(part) * down
    column, span = _ranges(np.ceil(np.maximum(left, 0)), np.floor(np.minimum(right, width - 1)))
    triangle = np.tile(np.arange(x.shape[1]), 2)
    return column, row.take(span), triangle.take(part.take(span))


def _downwards(x: Doubles, y: Doubles) -> tuple[list[Doubles], list[Doubles]]:
    """The corners of triangles from the highest to the lowest."""
    across, down = list(x), list(y)
    for i, j in ((0, 1), (1, 2), (0, 1)):
        swapped = down[i] > down[j]
        across[i], across[j] = (
            np.where(swapped, across[j], across[i]),
            np.where(swapped, across[i], across[j]),
        )
        down[i], down[j] = np.minimum(down[i], down[j]), np.maximum(down[i], down[j])
    return across, down


def _ranges(first: Doubles, last: Doubles) -> tuple[Doubles, Ints]:
    """The whole numbers of many ranges, one after the other, and which range each is from."""
    count = np.maximum(last - first + 1, 0).astype(np.int64)
    owner = repeat(np.arange(len(count)), count)
    shift = first - (np.cumsum(count) - count)
    number: Doubles = shift.take(owner)
    number += np.arange(len(owner))
    return number, owner
