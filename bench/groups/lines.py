"""Pixels and lines."""

from bench import calls
from bench.arguments import (
    boxes,
    floats,
    in_turn,
    lines,
    numpy_ints,
    points,
    polygons,
    within,
)
from bench.calls import Call
from bench.timing import Row

DASHED = (("setlinestyle", 3, 0, 1),)
THICK = (("setlinestyle", 0, 0, 3),)
XOR = (("setwritemode", 1),)
TRIANGLE = [(0, 0), (50, 10), (20, 50)]
OCTAGON = [(58, 0), (84, 26), (84, 58), (58, 84), (26, 84), (0, 58), (0, 26), (26, 0)]
short, level, upright = boxes(11, 6), boxes(640, 1), boxes(1, 480)

TABLE = [
    Call("putpixel", "putpixel", points((5,))),
    Call("putpixel, floats", "putpixel", floats(points((5,)))),
    Call("putpixel, numpy's integers", "putpixel", numpy_ints(points((5,)))),
    Call("putpixel, off the screen", "putpixel", in_turn((-1, 5, 5), (700, 500, 5))),
    Call("getpixel", "getpixel", points()),
    Call("line, 10 pixels", "line", short),
    Call("line, random ends", "line", lines(), cold=True),
    Call("line, random ends, floats", "line", floats(lines(), 4), cold=True),
    Call("line, level, 640 pixels", "line", level),
    Call("line, upright, 480 pixels", "line", upright),
    Call("line, 10 pixels, dashed", "line", short, DASHED),
    Call("line, random ends, dashed", "line", lines(), DASHED, cold=True),
    Call("line, 10 pixels, thick", "line", short, THICK),
    Call("line, random ends, thick", "line", lines(), THICK, cold=True),
    Call("line, 10 pixels, XOR", "line", short, XOR),
    Call("line, random ends, XOR", "line", lines(), XOR, cold=True),
    Call("line, level, dashed", "line", level, DASHED),
    Call("line, level, XOR", "line", level, XOR),
    Call("lineto, random ends", "lineto", points(), cold=True),
    Call("linerel, 10 pixels", "linerel", in_turn((10, 5), (-10, -5))),
    Call("rectangle 100x100", "rectangle", boxes(100, 100)),
    Call("rectangle 100x100, dashed", "rectangle", boxes(100, 100), DASHED),
    Call("rectangle 100x100, thick", "rectangle", boxes(100, 100), THICK),
    Call("rectangle 100x100, XOR", "rectangle", boxes(100, 100), XOR),
    Call("drawpoly, triangle of 50", "drawpoly", polygons(TRIANGLE)),
    Call("drawpoly, 8 corners", "drawpoly", polygons(OCTAGON)),
    Call("moveto", "moveto", within(1, 1)),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("lines", TABLE)
