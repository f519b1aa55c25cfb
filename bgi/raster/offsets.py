"""Figures kept as offsets: their pixels as places on a page, seen from one place of theirs.

A figure that is drawn again and again is the same pixels elsewhere, as long as no edge cuts its
lines: then to draw it is one assignment, for all of its pixels at once.
"""

from typing import NamedTuple

import numpy as np

from bgi.raster.lines import Ints

Reach = tuple[int, int, int, int]
"""Left, top, right and bottom, all inside."""

_FAR = 1 << 62
NOTHING: Reach = _FAR, _FAR, -_FAR, -_FAR
"""The reach of no pixels, which lie inside of everything."""


class Offsets(NamedTuple):
    """A figure's pixels, and how far they reach."""

    place: Ints
    """y * width + x of each, on pages of one width, counted from the reach's upper left corner."""
    left: int
    top: int
    right: int
    bottom: int


def offsets(place: Ints, reach: Reach, width: int) -> Offsets:
    """A figure whose places are counted from the place that it is seen from."""
    return Offsets(place - (reach[1] * width + reach[0]) if len(place) else place, *reach)


def reach(x: Ints, y: Ints) -> Reach:
    """How far pixels reach."""
    return (int(x.min()), int(y.min()), int(x.max()), int(y.max())) if len(x) else NOTHING


_MARKS = 1 << 19
"""Places that are marked, or counted, rather than sorted, which takes longer."""


def figure(x: Ints, y: Ints, extent: Reach, width: int, xor: bool) -> Offsets:
    """A figure of pixels that may come more than once: to be copied, or to be drawn by XOR."""
    left, top, right, bottom = extent
    across = right - left + 1
    if not len(x):
        return Offsets(x, *extent)
    place = y * across
    place += x
    place -= top * across + left
    found = _drawn(place, across * (bottom - top + 1), xor)
    found += found // across * (width - across)
    return Offsets(found, *extent)


def odd(place: Ints) -> Ints:
    """What is seen of places by XOR: those that are drawn an odd number of times."""
    places, times = np.unique(place, return_counts=True)
    found: Ints = places[times % 2 == 1]
    return found


def _drawn(place: Ints, size: int, xor: bool) -> Ints:
    """Every place below a size once; by XOR the odd ones."""
    if size >= _MARKS:
        return odd(place) if xor else np.unique(place)
    if xor:
        return np.flatnonzero(np.bincount(place) & 1)
    marks = np.zeros(size, np.bool_)
    marks[place] = True
    return np.flatnonzero(marks)
