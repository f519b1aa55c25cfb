"""Flood filling: the 4-connected area around a point, as runs of pixels.

This is span filling (A. R. Smith, "Tint Fill", SIGGRAPH 1979): whole runs of a row are filled, and
from each of them the rows above and below are searched. The driver goes on wherever it sees a pixel
that is not border and does not look filled already: what looks filled stops it. (It does not look
at the first and the last column of the viewport: `Areas.area` sees to that.) The original keeps its
seeds on a short stack and loses what does not fit; here nothing is lost, whatever the shape.

A few runs are searched one after another. Many, those of a maze, are all found at once, and joined
by arrays: each run that touches another takes the smaller of their labels, until none changes
(Y. Shiloach and U. Vishkin, "An O(log n) parallel connectivity algorithm", Journal of Algorithms 3,
1982).

Both ways take the pixels as `inside`, which may be filled, and `ways`, through which a run may be
entered: a byte for each pixel, 1 for yes and 0 for no. The last column of their rows, the first row
and the last one are 0, so that no run goes from one row into the next.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.raster.arrays import repeat
from bgi.raster.lines import Ints

Runs = tuple[list[int], list[int]]
"""Where each of them starts, and where it ends (excluded)."""

_YES, _NO = b"\1", b"\0"
FEW = 1500
"""Runs: more of them are found sooner by arrays."""


def flood(inside: bytearray, ways: bytearray, width: int, place: int) -> Runs:
    """The runs to fill from a place. The ways are used up."""
    find_way, find_start, find_end = ways.find, inside.rfind, inside.find
    first, last = find_start(_NO, 0, place) + 1, find_end(_NO, place)
    starts, ends = [first], [last]
    used, nothing = memoryview(ways), bytes(width)
    used[first:last] = nothing[: last - first]
    for start, end in zip(starts, ends, strict=True):  # which grow
        for step in (-width, width):
            way, stop = start + step, end + step
            while way < stop and (way := find_way(_YES, way, stop)) >= 0:
                first, last = find_start(_NO, 0, way) + 1, find_end(_NO, way)
                used[first:last] = nothing[: last - first]
                starts.append(first)
                ends.append(last)
                way = last
        if len(starts) > FEW:
            return flood_many(inside, ways, width, starts)
    return starts, ends


def flood_many(inside: bytearray, ways: bytearray, width: int, places: list[int]) -> Runs:
    """The runs to fill from several places, any number of them."""
    marks = np.frombuffer(inside, np.bool_)
    changes = np.flatnonzero(marks[1:] != marks[:-1]) + 1
    starts, ends = changes[::2], changes[1::2]
    upper, lower = _touching(starts, ends, width)
    # Of two runs that touch, each is entered from the other where a way lies in what they share.
    ways_before = np.zeros(len(ways) + 1, np.int32)
    np.cumsum(np.frombuffer(ways, np.uint8), dtype=np.int32, out=ways_before[1:])
    first = np.maximum(starts[upper] + width, starts[lower])
    last = np.minimum(ends[upper] + width, ends[lower])
    down = ways_before[last] > ways_before[first]
    up = ways_before[last - width] > ways_before[first - width]
    both, one = down & up, down ^ up
    label = _joined(upper[both], lower[both], len(starts))
    there, back = label[upper[one]], label[lower[one]]
    source, target = np.where(down[one], (there, back), (back, there))
    reached = np.zeros(len(starts), np.bool_)
    reached[label[np.searchsorted(starts, places, side="right") - 1]] = True
    while (new := target[reached[source] & ~reached[target]]).size:
        reached[new] = True
    found = reached[label]
    return starts[found].tolist(), ends[found].tolist()


def _touching(starts: Ints, ends: Ints, width: int) -> tuple[Ints, Ints]:
    """The pairs of runs that touch, by number: one, and one below it."""
    first = np.searchsorted(ends, starts + width, side="right")
    count = np.searchsorted(starts, ends + width, side="left") - first
    upper = repeat(np.arange(len(starts)), count)
    lower = np.arange(len(upper)) + repeat(first - (np.cumsum(count) - count), count)
    return upper, lower


def _joined(one: NDArray[Any], other: NDArray[Any], count: int) -> NDArray[np.intp]:
    """A label for each of `count` runs, the same for all that the pairs join."""
    label = np.arange(count)
    while True:
        pair = label[one], label[other]
        apart = pair[0] != pair[1]
        if not apart.any():
            return label
        one, other = one[apart], other[apart]
        smaller, larger = np.minimum(*pair)[apart], np.maximum(*pair)[apart]
        np.minimum.at(label, larger, smaller)
        while (label != (root := label[label])).any():
            label = root
