"""Circles, ellipses, arcs, and slices of them."""

from bench import calls
from bench.arguments import anywhere, floats, middles
from bench.calls import Call
from bench.groups.lines import THICK
from bench.timing import Row

HATCHED = (("setfillstyle", 7, 4),)

TABLE = [
    Call("circle, radius 50", "circle", middles(50, 50)),
    Call("circle, radius 5", "circle", middles(5, 5)),
    Call("circle, any radius, clipped", "circle", anywhere(1), cold=True),
    Call("circle, radius 50, floats", "circle", floats(middles(50, 50))),
    Call("circle, radius 50, thick", "circle", middles(50, 50, count=20), THICK),
    Call("circle, any radius, thick", "circle", anywhere(1, count=20), THICK, cold=True),
    Call("ellipse 60x35", "ellipse", middles(60, 0, 360, 60, 35)),
    Call("ellipse, any radii", "ellipse", anywhere(2, 0, 360, count=50), cold=True),
    Call("arc of 180 degrees, radius 50", "arc", middles(50, 0, 180, 50)),
    Call("arc, any radius", "arc", anywhere(1, 30, 200, count=50), cold=True),
    Call("pieslice, radius 45", "pieslice", middles(45, 30, 120, 45, count=50)),
    Call("pieslice, any radius", "pieslice", anywhere(1, 30, 120, count=50), cold=True),
    Call("pieslice, radius 45, hatched", "pieslice", middles(45, 30, 120, 45, count=50), HATCHED),
    Call("sector 60x35", "sector", middles(60, 30, 120, 60, 35, count=50)),
    Call("sector, any radii", "sector", anywhere(2, 30, 120, count=50), cold=True),
    Call("fillellipse 40x25", "fillellipse", middles(40, 40, 25, count=50)),
    Call("fillellipse, any radii", "fillellipse", anywhere(2, count=50), cold=True),
    Call("fillellipse 40x25, hatched", "fillellipse", middles(40, 40, 25, count=50), HATCHED),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("curves", TABLE)
