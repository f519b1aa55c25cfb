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
"""Places that are marked rather than sorted, which takes longer."""


def each_once(place: Ints, xor: bool) -> Ints:
    """Every place that is drawn, once; by XOR none that is drawn an even number of times."""
    if xor:
        places, times = np.unique(place, return_counts=True)
        odd: Ints = places[times % 2 == 1]
        return odd
    least = place.min(initial=_FAR)
    if place.max(initial=least) - least >= _MARKS:
        return np.unique(place)
    marks = np.zeros(place.max(initial=least) - least + 1, np.bool_)
    marks[place - least] = True
    found: Ints = np.flatnonzero(marks) + least
    return found
