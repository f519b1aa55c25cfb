"""Regions kept as the rows that fill them: pieces of a page, seen from one place of theirs.

A disc or a slice that is filled again and again is the same rows elsewhere, as long as no edge cuts
them: then each row is one copy.
"""

from typing import NamedTuple

from bgi.raster.lines import Ints
from bgi.raster.offsets import NOTHING

FigureRows = tuple[Ints, Ints, Ints]
"""Rows to fill: y, from the top down, and both ends, seen from the figure's place."""


class Region(NamedTuple):
    """What fills a figure, and how far it reaches."""

    rows: list[tuple[slice, slice, int]]
    """Where each row is on pages of one width, counted from the reach's upper left corner; where it
    is in eight such rows, that a fill pattern repeats; and how many pixels it has."""
    left: int
    top: int
    right: int
    bottom: int


def region(figure: FigureRows, width: int) -> Region:
    """The rows of a figure as they lie on pages of one width."""
    y, left, right = figure
    if not len(y):
        return Region([], *NOTHING)
    extent = int(left.min()), int(y[0]), int(right.max()), int(y[-1])
    place = (y - extent[1]) * width + (left - extent[0])
    numbers = place.tolist(), (place % (8 * width)).tolist(), (right - left + 1).tolist()
    rows = [
        (slice(start, start + length), slice(again, again + length), length)
        for start, again, length in zip(*numbers, strict=True)
    ]
    return Region(rows, *extent)
