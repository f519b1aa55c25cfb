"""Bars, polygons, floods, and the whole screen."""

from math import cos, pi, sin
from typing import Any

from bench import calls
from bench.arguments import always, any_polygons, boxes, polygons
from bench.calls import Call, Program
from bench.groups.curves import HATCHED
from bench.groups.lines import OCTAGON, TRIANGLE
from bench.timing import Row

STAR = [
    (round(45 + 45 * cos(2 * pi * 2 * k / 5)), round(45 + 45 * sin(2 * pi * 2 * k / 5)))
    for k in range(5)
]
QUAD = [(0, 0), (4, 1), (5, 5), (1, 4)]


def flooding(size: int, pattern: int) -> Program:
    """A square flooded four times, each time over the last."""
    name = f"floodfill {size}x{size}" + (", hatched" if pattern > 1 else "")

    def frame(g: Any) -> None:
        g.rectangle(99, 99, 100 + size, 100 + size)

    def draw(g: Any) -> None:
        for color in (1, 2, 3, 4):
            g.setfillstyle(pattern, color)
            g.floodfill(100 + size // 2, 100 + size // 2, 15)

    return Program(name, draw, frame, times=4)


TABLE: list[Call | Program] = [
    Call("bar 8x8", "bar", boxes(8, 8)),
    Call("bar 50x50", "bar", boxes(50, 50)),
    Call("bar 8x8, hatched", "bar", boxes(8, 8), HATCHED),
    Call("bar 50x50, hatched", "bar", boxes(50, 50), HATCHED),
    Call("bar, the whole screen", "bar", boxes(640, 480, 5)),
    Call("bar, the whole screen, hatched", "bar", boxes(640, 480, 5), HATCHED),
    Call("fillpoly, triangle of 50", "fillpoly", polygons(TRIANGLE, 50)),
    Call("fillpoly, 8 corners", "fillpoly", polygons(OCTAGON, 50)),
    Call("fillpoly, star", "fillpoly", polygons(STAR, 50)),
    Call("fillpoly, quad of 5x5", "fillpoly", polygons(QUAD)),
    Call("fillpoly, any triangle", "fillpoly", any_polygons(3, 64), cold=True),
    Call("fillpoly, any 5 corners", "fillpoly", any_polygons(5, 64), cold=True),
    Call("fillpoly, triangle of 50, hatched", "fillpoly", polygons(TRIANGLE, 50), HATCHED),
    flooding(20, 1),
    flooding(200, 1),
    flooding(200, 7),
    Call("cleardevice", "cleardevice", always(count=5)),
    Call("clearviewport 200x200", "clearviewport", always(count=20),
         (("setviewport", 100, 100, 299, 299, 1),)),
]  # fmt: skip


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("fills", TABLE)
