"""check.clip_line and clip_polygon: right algorithms pass, each usual mistake gets its hint."""

import pytest

from bgi.lab import check
from tests.lab.mistakes import Mistakes


def code(x, y, left, top, right, bottom):
    return (x < left) + 2 * (x > right) + 4 * (y < top) + 8 * (y > bottom)


def cohen_sutherland(x1, y1, x2, y2, left, top, right, bottom):
    box = left, top, right, bottom
    while True:
        one, other = code(x1, y1, *box), code(x2, y2, *box)
        if one & other:
            return None
        if not one | other:
            return x1, y1, x2, y2
        if one:
            x1, y1 = moved(x1, y1, x2, y2, one, *box)
        else:
            x2, y2 = moved(x1, y1, x2, y2, other, *box)


def moved(x1, y1, x2, y2, out, left, top, right, bottom):
    if out & 3:
        x = left if out & 1 else right
        return x, y1 + (y2 - y1) * (x - x1) / (x2 - x1)
    y = top if out & 4 else bottom
    return x1 + (x2 - x1) * (y - y1) / (y2 - y1), y


def liang_barsky(x1, y1, x2, y2, left, top, right, bottom):
    first, last, dx, dy = 0.0, 1.0, x2 - x1, y2 - y1
    for p, q in ((-dx, x1 - left), (dx, right - x1), (-dy, y1 - top), (dy, bottom - y1)):
        if p == 0:
            if q < 0:
                return None
        elif p < 0:
            first = max(first, q / p)
        else:
            last = min(last, q / p)
    if first > last:
        return None
    return x1 + first * dx, y1 + first * dy, x1 + last * dx, y1 + last * dy


@pytest.mark.parametrize("function", [cohen_sutherland, liang_barsky])
def test_any_algorithm_is_right(function):
    verdict = check.clip_line(function)
    assert verdict, str(verdict)


def inside(p, axis, edge, sign):
    return sign * (p[axis] - edge) >= 0


def crossing(a, b, axis, edge):
    part = (edge - a[axis]) / (b[axis] - a[axis])
    return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]


def sutherland_hodgman(points, left, top, right, bottom, edges="bltr"):
    cuts = {"l": (0, left, 1), "t": (1, top, 1), "r": (0, right, -1), "b": (1, bottom, -1)}
    for name in edges:
        axis, edge, sign = cuts[name]
        result = []
        for i, b in enumerate(points):
            a = points[i - 1]
            if inside(a, axis, edge, sign) != inside(b, axis, edge, sign):
                result.append(crossing(a, b, axis, edge))
            if inside(b, axis, edge, sign):
                result.append(b)
        points = result
    return points


@pytest.mark.parametrize("edges", ["bltr", "lrtb", "trbl"])
def test_the_edges_may_cut_in_any_order(edges):
    verdict = check.clip_polygon(lambda points, *box: sutherland_hodgman(points, *box, edges=edges))
    assert verdict, str(verdict)


def test_nothing_may_be_none_and_the_points_may_begin_anywhere():
    def clip(points, *box):
        found = sutherland_hodgman(points, *box)
        return [*found[1:], *found[:1]][::-1] or None

    assert check.clip_polygon(clip)


lines, polygons = Mistakes(), Mistakes()
FAR = 10**6


@lines("the ends are exchanged")
def exchanged(x1, y1, x2, y2, *box):
    return liang_barsky(x2, y2, x1, y1, *box)


@lines("nothing is cut off")
def as_it_is(x1, y1, x2, y2, *box):
    return x1, y1, x2, y2


@lines("nothing is cut off from the other lines")
def only_refuses(x1, y1, x2, y2, *box):
    return liang_barsky(x1, y1, x2, y2, *box) and (x1, y1, x2, y2)


@lines("a line that is only partly inside is not nothing")
def all_or_nothing(x1, y1, x2, y2, *box):
    return None if code(x1, y1, *box) or code(x2, y2, *box) else (x1, y1, x2, y2)


@lines("the second end is not moved")
def first_end(x1, y1, x2, y2, *box):
    found = liang_barsky(x1, y1, x2, y2, *box)
    return found and (*found[:2], x2, y2)


@lines("the first end is not moved")
def second_end(x1, y1, x2, y2, *box):
    found = liang_barsky(x1, y1, x2, y2, *box)
    return found and (x1, y1, *found[2:])


@lines("another slope")
def pushed(x1, y1, x2, y2, left, top, right, bottom):
    if liang_barsky(x1, y1, x2, y2, left, top, right, bottom) is None:
        return None
    x1, x2 = (min(max(x, left), right) for x in (x1, x2))
    y1, y2 = (min(max(y, top), bottom) for y in (y1, y2))
    return x1, y1, x2, y2


@lines("the left edge does not cut")
def without_left(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, -FAR, top, right, bottom)


@lines("the top edge does not cut")
def without_top(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, left, -FAR, right, bottom)


@lines("the right edge does not cut")
def without_right(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, left, top, FAR, bottom)


@lines("the bottom edge does not cut")
def without_bottom(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, left, top, right, FAR)


@lines("y grows downwards")
def y_upwards(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, left, bottom, right, top)


@lines("the edges belong to the window")
def edges_outside(x1, y1, x2, y2, left, top, right, bottom):
    return liang_barsky(x1, y1, x2, y2, left + 1, top + 1, right - 1, bottom - 1)


@lines("rounded")
def rounded(x1, y1, x2, y2, *box):
    found = liang_barsky(x1, y1, x2, y2, *box)
    return found and tuple(map(round, found))


@lines("with one of the edges it never meets")
def divides_by_zero(x1, y1, x2, y2, left, top, right, bottom):
    m = (y2 - y1) / (x2 - x1)
    return cohen_sutherland(x1, y1, x2, y2 + 0 * m, left, top, right, bottom)


@lines("find out anew where that end is")
def never_moves(x1, y1, x2, y2, *box):
    while code(x1, y1, *box) | code(x2, y2, *box):
        if code(x1, y1, *box) & code(x2, y2, *box):
            return None
    return x1, y1, x2, y2


@lines("None, or four numbers")
def as_two_points(x1, y1, x2, y2, *box):
    return (x1, y1), (x2, y2)


@polygons("nothing is cut off")
def polygon_as_it_is(points, *box):
    return points


@polygons("only partly inside is not nothing")
def polygon_or_nothing(points, *box):
    return points if not any(code(x, y, *box) for x, y in points) else []


@polygons("there is a new point")
def keeps_points(points, *box):
    return [(x, y) for x, y in points if not code(x, y, *box)]


@polygons("pushed to the edges")
def pushes_points(points, left, top, right, bottom):
    return [(min(max(x, left), right), min(max(y, top), bottom)) for x, y in points]


@polygons("the bottom edge does not cut")
def polygon_without_bottom(points, *box):
    return sutherland_hodgman(points, *box, edges="ltr")


@polygons("the top edge does not cut")
def polygon_without_top(points, *box):
    return sutherland_hodgman(points, *box, edges="lrb")


@polygons("the right edge does not cut")
def polygon_without_right(points, *box):
    return sutherland_hodgman(points, *box, edges="ltb")


@polygons("the left edge does not cut")
def polygon_without_left(points, *box):
    return sutherland_hodgman(points, *box, edges="rtb")


@polygons("top and bottom edges do not cut")
def only_x(points, *box):
    return sutherland_hodgman(points, *box, edges="lr")


@polygons("only the left edge cuts")
def one_edge(points, *box):
    return sutherland_hodgman(points, *box, edges="l")


def halves(points, box, take):
    """Sutherland and Hodgman's, taking what `take` says of a side that crosses."""
    left, top, right, bottom = box
    for cut in ((0, left, 1), (0, right, -1), (1, top, 1), (1, bottom, -1)):
        result = []
        for i, b in enumerate(points):
            a = points[i - 1]
            result += take(a, b, inside(a, *cut), inside(b, *cut), cut, i)
        points = result
    return points


def crossed(a, b, cut, wanted):
    return [crossing(a, b, *cut[:2])] if wanted else []


@polygons("the side from the last point back to the first")
def not_closed(points, *box):
    def take(a, b, was_in, is_in, cut, i):
        if i == 0:
            return []
        return crossed(a, b, cut, was_in != is_in) + [b] * is_in

    return halves(points, box, take)


@polygons("where the polygon comes in")
def no_crossing_inwards(points, *box):
    def take(a, b, was_in, is_in, cut, i):
        return crossed(a, b, cut, was_in and not is_in) + [b] * is_in

    return halves(points, box, take)


@polygons("where the polygon comes in")
def no_point_inwards(points, *box):
    def take(a, b, was_in, is_in, cut, i):
        return crossed(a, b, cut, was_in != is_in) + [b] * (is_in and was_in)

    return halves(points, box, take)


@polygons("it is always empty")
def polygon_upside_down(points, left, top, right, bottom):
    return sutherland_hodgman(points, left, bottom, right, top)


@polygons("a list of points")
def a_flat_list(points, *box):
    return [v for point in points for v in point]


@polygons("nothing to cut")
def first_of_nothing(points, *box):
    found = points
    for name in "ltrb":
        found = sutherland_hodgman([found[0], *found[1:]], *box, edges=name)
    return found


ALL = [("clip_line", lines), ("clip_polygon", polygons)]
TABLE = [(exercise, *row) for exercise, mistakes in ALL for row in mistakes.table]


@pytest.mark.parametrize(
    ("exercise", "function", "hint"), TABLE, ids=[f"{row[0]}-{row[1].__name__}" for row in TABLE]
)
def test_each_mistake_gets_its_hint(exercise, function, hint):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)


def test_the_picture_shows_where_it_was_cut():
    assert check.clip_line(as_it_is).picture
    assert check.clip_polygon(polygon_as_it_is).picture
