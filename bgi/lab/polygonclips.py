"""Polygons cut at the edges of a window, compared by what they cover, and the usual slips."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from typing import Any

from bgi.constants import DARKGRAY, SOLID_FILL, WHITE, YELLOW
from bgi.graphics import Graphics
from bgi.lab.answered import Answer, AnswerExercise, Arguments, Slip, numbers
from bgi.lab.lineclips import BOX, EDGES, UPRIGHT, clip_line

Point = tuple[float, float]


def clip_polygon(
    points: Sequence[Point], left: float, top: float, right: float, bottom: float
) -> list[Point]:
    """The part of a polygon inside: Sutherland and Hodgman's, edge after edge.

    I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17,
    1974.
    """
    found = list(points)
    for edge in _edges(left, top, right, bottom):
        found = _half(found, *edge)
    return found


def _edges(left: float, top: float, right: float, bottom: float) -> list[tuple[int, float, int]]:
    """For each edge: 0 for x or 1 for y, where it is, and in which direction the inside lies."""
    return [(0, left, 1), (0, right, -1), (1, top, 1), (1, bottom, -1)]


def _half(points: Sequence[Point], axis: int, edge: float, sign: int) -> list[Point]:
    """What lies on the right side of one edge."""
    found: list[Point] = []
    for (a, b), is_in, was_in in _steps(points, axis, edge, sign):
        if is_in != was_in:
            found.append(_crossing(a, b, axis, edge))
        if is_in:
            found.append(b)
    return found


def _steps(points: Sequence[Point], axis: int, edge: float, sign: int) -> Any:
    for a, b in zip([*points[-1:], *points[:-1]], points, strict=True):
        yield (a, b), sign * (b[axis] - edge) >= 0, sign * (a[axis] - edge) >= 0


def _crossing(a: Point, b: Point, axis: int, edge: float) -> Point:
    part = (edge - a[axis]) / (b[axis] - a[axis])
    return a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])


def _polygons() -> Iterator[Arguments]:
    shapes: list[list[Point]] = [
        [(150, 100), (250, 100), (200, 180)],  # inside
        [(50, 100), (200, 120), (150, 180)],
        [(200, 30), (250, 150), (150, 150)],
        [(350, 100), (250, 180), (200, 110)],
        [(200, 260), (150, 120), (250, 130)],
        [(30, 20), (370, 30), (380, 250), (20, 260)],  # all around
        [(200, 20), (370, 140), (200, 260), (30, 140)],
        [(310, 90), (390, 90), (350, 190)],  # outside
        [(60, 90), (340, 90), (340, 190), (200, 110), (60, 190)],  # not convex
        [(100, 80), (300, 80), (300, 200), (100, 200)],
    ]
    chance = random.Random(4)
    for size in (3, 4, 5, 6, 8) * 12:
        shapes.append([(chance.randrange(400), chance.randrange(280)) for _ in range(size)])
    for shape in shapes:
        yield shape, *BOX


def _points(value: Any) -> Answer:
    """Points, as numbers in a row; None counts as no points."""
    what = "a list of points, [(x, y), ...]"
    if value is None:
        return ()
    try:
        rows = list(value)
    except TypeError:
        raise ValueError(what) from None
    return tuple(number for row in rows for number in numbers(row, 2, what))


ACROSS, DOWN = 23, 17
"""So many places in the window are asked whether they are inside."""
ROOM = 1e-6


def _same_area(one: Answer, other: Answer, arguments: Arguments) -> bool:
    """Whether two polygons cover the same places; what lies on the window's rim covers nothing."""
    a, b = (_pairs(answer or ()) for answer in (one, other))
    left, top, right, bottom = arguments[1:]
    within = {
        all(
            left - ROOM <= x <= right + ROOM and top - ROOM <= y <= bottom + ROOM for x, y in points
        )
        for points in (a, b)
    }
    if len(within) == 2 or abs(abs(_area(a)) - abs(_area(b))) > 1e-3:
        return False
    for column in range(ACROSS):
        for row in range(DOWN):
            x = left + (column + 0.4337) * (right - left) / ACROSS
            y = top + (row + 0.5713) * (bottom - top) / DOWN
            if _covers(a, x, y) != _covers(b, x, y):
                return False
    return True


def _are_inside(
    points: Sequence[Point], left: float, top: float, right: float, bottom: float
) -> bool:
    return all(left <= x <= right and top <= y <= bottom for x, y in points)


def _pairs(flat: Sequence[float]) -> list[Point]:
    return list(zip(flat[::2], flat[1::2], strict=True))


def _area(points: list[Point]) -> float:
    sides = zip(points, [*points[1:], *points[:1]], strict=True)
    return sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in sides) / 2


def _covers(points: list[Point], x: float, y: float) -> bool:
    """Whether a place is inside, by the even-odd rule."""
    inside = False
    for (x1, y1), (x2, y2) in zip(points, [*points[1:], *points[:1]], strict=True):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            inside = not inside
    return inside


def _halves(*edges: int) -> Any:
    """`clip_polygon` by some of the four edges: 0 left, 1 right, 2 top, 3 bottom."""

    def formula(
        points: Sequence[Point], left: float, top: float, right: float, bottom: float
    ) -> Any:
        all_edges = ((0, left, 1), (0, right, -1), (1, top, 1), (1, bottom, -1))
        found = list(points)
        for edge in edges:
            found = _half(found, *all_edges[edge])
        return found

    return formula


def _kept(points: Sequence[Point], left: float, top: float, right: float, bottom: float) -> Any:
    return [(x, y) for x, y in points if left <= x <= right and top <= y <= bottom]


def _pushed(points: Sequence[Point], left: float, top: float, right: float, bottom: float) -> Any:
    return [(min(max(x, left), right), min(max(y, top), bottom)) for x, y in points]


def _sides_alone(points: Sequence[Point], *box: float) -> Any:
    sides = zip([*points[-1:], *points[:-1]], points, strict=True)
    cut = [clip_line(*map(int, a), *map(int, b), *map(int, box)) for a, b in sides]
    return [end for line in cut if line for end in (line[:2], line[2:])]


def _bad_halves(keep: str) -> Any:
    """Each edge with a mistake: which of the points it keeps."""

    def formula(
        points: Sequence[Point], left: float, top: float, right: float, bottom: float
    ) -> Any:
        found = list(points)
        for axis, edge, sign in ((0, left, 1), (0, right, -1), (1, top, 1), (1, bottom, -1)):
            new: list[Point] = []
            steps = list(_steps(found, axis, edge, sign))
            for (a, b), is_in, was_in in steps[1:] if keep == "open" else steps:
                entering = is_in and not was_in
                if is_in != was_in and not (keep == "no entry" and entering):
                    new.append(_crossing(a, b, axis, edge))
                leaving = was_in and not is_in
                if leaving and keep == "no exit":
                    new.pop()
                if (is_in and not (keep == "no corner" and entering)) or (
                    leaving and keep == "outside"
                ):
                    new.append(b)
                if entering and keep == "late":
                    new[-2:] = new[:-3:-1]
            found = new
        return found

    return formula


SLIPS = [
    Slip(lambda points, *box: points, "nothing is cut off"),
    Slip(_kept, "where a side crosses an edge there is a new point: cut there"),
    Slip(
        lambda points, *box: (
            clip_polygon(points, *box) if _kept(points, *box) == list(points) else []
        ),
        "a polygon that is only partly inside is not nothing: its part inside is wanted",
    ),
    Slip(_pushed, "points outside are pushed to the edges: cut the sides where they cross instead"),
    Slip(_halves(0, 1, 2), "the bottom edge does not cut"),
    Slip(_halves(0, 1, 3), "the top edge does not cut"),
    Slip(_halves(0, 2, 3), "the right edge does not cut"),
    Slip(_halves(1, 2, 3), "the left edge does not cut"),
    Slip(_halves(0, 1), "the top and bottom edges do not cut: y, too, has two"),
    *(
        Slip(
            _halves(edge),
            f"only the {name} edge cuts: what one edge has left is cut by the next one",
        )
        for edge, name in enumerate(("left", "right", "top", "bottom"))
    ),
    Slip(
        _sides_alone,
        "the sides are cut one by one, so that corners of the window are missing: cut the whole"
        " polygon by one edge after the other",
    ),
    Slip(
        _bad_halves("open"),
        "the side from the last point back to the first is missing",
    ),
    Slip(
        _bad_halves("no entry"),
        "where the polygon comes in, two points belong to it: the crossing, and the point itself",
    ),
    Slip(
        _bad_halves("no corner"),
        "where the polygon comes in, two points belong to it: the crossing, and the point itself",
    ),
    Slip(
        _bad_halves("no exit"),
        "where the polygon goes out there is a new point, too: the crossing",
    ),
    Slip(
        _bad_halves("outside"),
        "where the polygon goes out only the crossing belongs to it: the point is outside",
    ),
    Slip(
        _bad_halves("late"),
        "where the polygon comes in the crossing is first, then the point",
    ),
    Slip(
        lambda points, *box: [],
        "it is always empty: is there a return? Is inside taken for outside? y grows downwards, and"
        " top is less than bottom",
    ),
]


def _draw_polygon(screen: Graphics, arguments: Arguments, answer: Answer) -> None:
    points, left, top, right, bottom = arguments
    screen.rectangle(left, top, right, bottom, DARKGRAY)
    screen.drawpoly([*points, points[0]], None, DARKGRAY)
    if answer:
        found = [(int(x), int(y)) for x, y in _pairs(answer)]
        screen.setcolor(WHITE)
        screen.setfillstyle(SOLID_FILL, YELLOW)
        screen.fillpoly([*found, found[0]])


EXERCISE = AnswerExercise(
    "clip_polygon",
    ("points", *EDGES),
    _polygons,
    clip_polygon,
    _points,
    SLIPS,
    UPRIGHT | {"IndexError": "an edge may leave no point at all: then there is nothing to cut"},
    _same_area,
    _draw_polygon,
    parts=(),
    otherwise="a crossing lies at a + part * (b - a), part being (edge - a) / (b - a) across that"
    " edge. Cut by one edge after the other, each time what the one before has left",
)
