"""Calls with arrays, which the others draw in a loop; the time is that of one element."""

from typing import Any

import numpy as np

from bench import calls
from bench.arguments import boxes, lines, middles, points, polygons
from bench.calls import ArrayCall
from bench.groups.fills import QUAD
from bench.groups.lines import TRIANGLE
from bench.timing import Arguments, Row


def columns(many: Arguments) -> tuple[Any, ...]:
    """An array for each argument."""
    return tuple(np.array(many).T)


def corners(many: Arguments) -> tuple[Any, ...]:
    """One array of polygons, without the corner that closes them."""
    return (np.array([points[:-1] for (points,) in many]),)


TABLE = [
    ArrayCall("array of 10,000 putpixel", "putpixel", columns, points((5,), count=10_000)),
    ArrayCall("array of 10,000 getpixel", "getpixel", columns, points(count=10_000)),
    ArrayCall("array of 2,000 lines of 8 pixels", "line", columns, boxes(9, 6, 2000)),
    ArrayCall("array of 500 random lines", "line", columns, lines(500)),
    ArrayCall("array of 2,000 quads of 5x5", "fillpoly", corners, polygons(QUAD, 2000)),
    ArrayCall("array of 400 triangles of 50", "fillpoly", corners, polygons(TRIANGLE, 400)),
    ArrayCall("array of 400 circles", "circle", columns, middles(50, 50, count=400)),
    ArrayCall("array of 400 bars 50x50", "bar", columns, boxes(50, 50, 400)),
    ArrayCall("array of 400 rectangles 100x100", "rectangle", columns, boxes(100, 100, 400)),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("arrays", TABLE)
