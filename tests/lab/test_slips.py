"""Functions that answer: more slips of learners, a line for each, with a part of their hints."""

from itertools import pairwise
from math import comb, cos, degrees, pi, radians, sin

import numpy as np
import pytest

import bgi
from bgi.lab import check
from tests.lab.test_clipping import (
    cohen_sutherland,
    halves,
    inside,
    liang_barsky,
    sutherland_hodgman,
)
from tests.lab.test_matrices import rotation, scaling, translation, window_to_viewport
from tests.lab.test_projections import paper, projection
from tests.lab.test_splines import bernstein, casteljau, mixed

FAR = 10**6


def by_codes(x1, y1, x2, y2, left, top, right, bottom, bits=(1, 2, 4, 8), turns=9, cut=float):
    """Cohen and Sutherland's, whose codes and steps can be mistaken: left, right, below, above."""

    def code(x, y):
        beyond = x < left, x > right, y > bottom, y < top
        return sum(bit for bit, is_beyond in zip(bits, beyond, strict=True) if is_beyond)

    for _ in range(turns):
        one, other = code(x1, y1), code(x2, y2)
        if one & other:
            return None
        if not one | other:
            break
        out = one or other
        if out & 12:
            y = top if out & 8 else bottom
            x = x1 + cut((x2 - x1) * (y - y1) / (y2 - y1))
        else:
            x = left if out & 1 else right
            y = y1 + cut((y2 - y1) * (x - x1) / (x2 - x1))
        x1, y1, x2, y2 = (x, y, x2, y2) if one else (x1, y1, x, y)
    return x1, y1, x2, y2


def by_parts(x1, y1, x2, y2, left, top, right, bottom, ends=(0, 1), takes=(max, min), asks=True):
    """Liang and Barsky's, in which something can be left out."""
    (first, last), dx, dy = ends, x2 - x1, y2 - y1
    for p, q in ((-dx, x1 - left), (dx, right - x1), (-dy, y1 - top), (dy, bottom - y1)):
        if p < 0:
            first = takes[0](first, q / p)
        elif p > 0:
            last = takes[1](last, q / p)
        elif q < 0 and asks != "not aside":
            return None
    if first > last and asks:
        return None
    return x1 + first * dx, y1 + first * dy, x1 + last * dx, y1 + last * dy


def outside(x, y, left, top, right, bottom):
    return not (left <= x <= right and top <= y <= bottom)


def prints(function):
    return lambda *given: print(function(*given))


def draws(*given):
    bgi.putpixel(1, 2, 3)


CLIP_LINE = {
    "left and right are exchanged": lambda *a: by_codes(*a, bits=(2, 1, 4, 8)),
    "top and bottom are exchanged": lambda *a: by_codes(*a, bits=(1, 2, 8, 4)),
    "the top edge does not cut": lambda *a: by_codes(*a, bits=(1, 2, 4, 0)),
    "// cuts off": lambda *a: by_codes(*a, cut=np.floor),
    "go on until both ends are inside": lambda *a: by_codes(*a, turns=1),
    "code1 & code2, not code1 and code2": lambda x1, y1, x2, y2, *box: (
        None
        if outside(x1, y1, *box) and outside(x2, y2, *box)
        else liang_barsky(x1, y1, x2, y2, *box)
    ),
    "is there a return? And y grows": lambda x1, y1, x2, y2, left, top, right, bottom: (
        cohen_sutherland(x1, y1, x2, y2, left, bottom, right, top)
    ),
    "where p is 0": lambda *a: by_parts(*a, asks="not aside"),
    "larger than the second one": lambda *a: by_parts(*a, asks=""),
    "max and min are exchanged": lambda *a: by_parts(*a, takes=(min, max)),
    "t begins with 0 and ends with 1": lambda *a: by_parts(*a, ends=(-FAR, FAR)),
    "the answer is None, no line": lambda *a: liang_barsky(*a) or (0, 0, 0, 0),
    "edges, not sizes": lambda x1, y1, x2, y2, left, top, right, bottom: liang_barsky(
        x1, y1, x2, y2, left, top, left + right, top + bottom
    ),
    "only y1 and y2 are wrong": lambda x1, y1, x2, y2, *box: (
        (found := liang_barsky(x1, y1, x2, y2, *box)) and (found[0], y1, found[2], y2)
    ),
    "it prints the answer": prints(liang_barsky),
    "draws nothing": draws,
}


def one_edge_each(points, *box):
    return [point for name in "ltrb" for point in sutherland_hodgman(points, *box, edges=name)]


def with_slip(points, box, wanted):
    """`wanted` says what of crossing and point belongs to the result: going out, coming in."""

    def take(a, b, was_in, is_in, cut, i):
        if was_in == is_in:
            return [b] * is_in
        axis, edge, _ = cut
        part = (edge - a[axis]) / (b[axis] - a[axis])
        cross = (a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]))
        return [{"x": cross, "b": b}[letter] for letter in wanted[is_in]]

    return halves(points, box, take)


def sides_alone(points, *box):
    found = [liang_barsky(*a, *b, *box) for a, b in pairwise([points[-1], *points])]
    return [end for one in found if one for end in (one[:2], one[2:])]


CLIP_POLYGON = {
    "the crossing is first": lambda points, *box: with_slip(points, box, ("x", "bx")),
    "the point is outside": lambda points, *box: with_slip(points, box, ("xb", "xb")),
    "goes out there is a new point": lambda points, *box: with_slip(points, box, ("", "xb")),
    "only the bottom edge cuts": lambda points, *box: sutherland_hodgman(points, *box, edges="b"),
    "the sides are cut one by one": sides_alone,
    "always the same": lambda points, left, top, right, bottom: [
        *((left, top), (right, top)),
        *((right, bottom), (left, bottom)),
    ],
    "each time what the one before has left": one_edge_each,
    "Is inside taken for outside?": lambda points, *box: [
        point for point in points if not inside(point, 0, -FAR, 1)
    ],
    "is there a return?": lambda points, *box: points.reverse(),
    "draws nothing": draws,
}

TRANSLATION = {
    "only row 2, column 3 is wrong": lambda tx, ty: translation(tx, -ty),
    "last column only": lambda tx, ty: [[1, 0, tx], [0, 1, ty], [tx, ty, 1]],
    "on the diagonal only": lambda tx, ty: [[1, 1, tx], [1, 1, ty], [0, 0, 1]],
    "that is scaling": lambda tx, ty: scaling(1 + tx, 1 + ty),
    "always the same": lambda tx, ty: translation(5, 3),
    "it prints the answer": prints(translation),
    "is there a return?": lambda tx, ty: None,
}


def one_row_three_times(sx, sy):
    matrix = [[0] * 3] * 3
    matrix[0][0], matrix[1][1], matrix[2][2] = sx, sy, 1
    return matrix


SCALING = {
    "one row, three times the same": one_row_three_times,
    "row 1, column 2 and row 2, column 1": lambda sx, sy: [[sx, 1, 0], [1, sy, 0], [0, 0, 1]],
    "only row 3, column 3 is wrong": lambda sx, sy: [[sx, 0, 0], [0, sy, 0], [0, 0, sx * sy]],
    "only row 2, column 2 is wrong": lambda sx, sy: scaling(sx, -sy),
    "sx is not used": lambda sx, sy: scaling(sy, sy),
    "no percentages": lambda sx, sy: scaling(sx / 100, sy / 100),
}


def turned(angle):
    return rotation(degrees(angle))


ROTATION = {
    "degrees from radians": lambda angle: turned(angle * 180 / pi),
    "is something rounded on the way": lambda angle: turned(angle * 3.1416 / 180),
    "or a constant": lambda angle: turned(angle * 22 / 7 / 180),
    "it is nearly right": lambda angle: [[round(v, 2) for v in row] for row in rotation(angle)],
    "half as far": lambda angle: turned(angle * pi / 360),
    "// cuts the angle off": lambda angle: turned(angle * pi // 180),
    "row 1, column 3 and row 2, column 3": lambda angle: [
        [*row[:2], last] for row, last in zip(rotation(angle), (1, 1, 1), strict=True)
    ],
    "the rows are cos, -sin, 0": lambda angle: rotation(angle)[::-1],
}


def rows(x, y):
    return np.array(translation(x, y)).T


ABOUT = {
    "the product of matrices is @": lambda angle, x, y: (
        np.array(translation(x, y)) * rotation(angle) * translation(-x, -y)
    ),
    "both moves go the same way": lambda angle, x, y: (
        np.array(translation(x, y)) @ rotation(angle) @ translation(x, y)
    ),
    "Lists are not": lambda angle, x, y: translation(x, y) * rotation(angle),
    "points that are rows": lambda angle, x, y: rows(-x, -y) @ rotation(angle) @ rows(x, y),
    "three matrices are multiplied": lambda angle, x, y: (
        np.array(translation(x, y)) + rotation(angle)
    ),
}


def fitted(window, viewport, change=lambda sx, sy: (sx, sy), sign=1, more=0):
    sx = (viewport[2] + more - viewport[0]) / (window[2] - window[0])
    sy = (viewport[3] + more - viewport[1]) / (window[3] - window[1])
    sx, sy = change(sx, sy)
    left, top = viewport[0] - sign * sx * window[0], viewport[1] - sign * sy * window[1]
    return [[sx, 0, left], [0, sy, top], [0, 0, 1]]


WINDOW = {
    "numbers of their own": lambda w, v: fitted(w, v, lambda sx, sy: (min(sx, sy),) * 2),
    "it is stretched by numbers": lambda w, v: fitted(w, v, lambda sx, sy: (sx, sx)),
    "the two scales are exchanged": lambda w, v: fitted(w, v, lambda sx, sy: (sy, sx)),
    "// cuts the scale off": lambda w, v: fitted(w, v, lambda sx, sy: (sx // 1, sy // 1)),
    "the wrong way": lambda w, v: fitted(w, v, sign=-1),
    "without 1 more": lambda w, v: fitted(w, v, more=1),
    "in this order": lambda w, v: (
        window_to_viewport((w[0], w[2], w[1], w[3]), (v[0], v[2], v[1], v[3]))
        if w[1] != w[0] and w[3] != w[2]
        else scaling(1, 1)
    ),
    "always the same": lambda w, v: [[2, 0, 200], [0, 4, 100], [0, 0, 1]],
}


def weighed(points, t, factor):
    n = len(points) - 1
    return mixed(points, [factor(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])


def first_of_the_rounds(points, t):
    points = list(points)
    for round_ in range(1, len(points)):
        for i in range(len(points) - 1, round_ - 1, -1):
            points[i] = mixed(points[i - 1 : i + 1], (1 - t, t))
    return points[0]


def through_all(points, t):
    """Lagrange's polynomial."""
    n, weights = len(points) - 1, []
    for i in range(n + 1):
        others = [(n * t - j) / (i - j) for j in range(n + 1) if j != i]
        weights.append(np.prod(others))
    return mixed(points, weights)


def without_a_guard(points, t):
    return without_a_guard([mixed(pair, (1 - t, t)) for pair in pairwise(points)], t)


CURVE = {
    "t is not used": lambda points, t: casteljau(points, 0.5),
    "int() leaves 0 and 1": lambda points, t: casteljau(points, int(t)),
    "which one is returned": first_of_the_rounds,
    "one round only": lambda points, t: mixed(points[:2], (1 - t, t)),
    "the last weight is missing": lambda points, t: weighed(
        points, t, lambda n, i: comb(n, i) * (i < n)
    ),
    "too large by one": lambda points, t: bernstein([*points, (0, 0)], t),
    "goes through all its points": through_all,
    "only y is wrong": lambda points, t: (casteljau(points, t)[0], 0),
    "stops at one point": without_a_guard,
    "each round mixes neighbours": lambda points, t: mixed(points, [t] * len(points)),
    "must be two numbers, (x, y)": lambda points, t: [casteljau(points, t)],
    "it prints the answer": prints(casteljau),
    "draws nothing": draws,
}
CASTELJAU = CURVE | {
    "the binomial numbers are missing": lambda points, t: weighed(points, t, lambda n, i: 1),
    "only the first three points": lambda points, t: casteljau(points[:3], t),
    "only the first four points": lambda points, t: casteljau(points[:4], t),
}


def spline(points, t, *weights):
    return mixed(points, [weight / 6 for weight in weights])


BSPLINE = {
    "1 4 1 stands for 1 3 3 1": lambda points, t: mixed(
        points, [comb(3, i) * t**i * (1 - t) ** (3 - i) / 6 for i in range(4)]
    ),
    "quadratic": lambda points, t: mixed(
        points, ((1 - t) ** 2 / 2, (-2 * t * t + 2 * t + 1) / 2, t * t / 2)
    ),
    "1 together, for every t": lambda points, t: spline(
        points, t, (1 - t) ** 3, 3 * t**3 + 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3
    ),
    "At t = 0 they are 1, 4, 1, 0": lambda points, t: spline(
        points, t, (1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t, t**3
    ),
}

PROJECTION = {
    "and the distance is missing": lambda x, y, z, d: (x / z, y / z) if z else (0, 0),
    "nothing is added": lambda x, y, z, d: tuple(np.add(projection(x, y, z, d), (320, 240))),
    "0, 0 is in the middle": lambda x, y, z, d: tuple(np.add(projection(x, -y, z, d), (320, 240))),
    "not by its square": lambda x, y, z, d: projection(x, y, z, d) / np.array(d + z),
    "only near the screen": lambda x, y, z, d: (x * (1 - z / d), y * (1 - z / d)),
    "the distance is given": lambda x, y, z, d: projection(x, y, z, 100),
    "no abs()": lambda x, y, z, d: projection(x, y, abs(z), d),
    "the eye lies at z = -distance": lambda x, y, z, d: (
        (x * d / (z - d), y * d / (z - d)) if z != d else (0, 0)
    ),
    "in brackets": lambda x, y, z, d: (x * d / d + z, y * d / d + z),
    "by similar triangles": lambda x, y, z, d: (x + z * cos(pi / 4), y - z * sin(pi / 4) / 2),
}

PAPER = {
    "45 degrees are only an example": lambda x, y, z, t, x0, y0: paper(x, y, z, pi / 4, x0, y0),
    "320 and 240 are only an example": lambda x, y, z, t, x0, y0: paper(x, y, z, t, 320, 240),
    "the paper shortens nothing": lambda x, y, z, t, x0, y0: paper(x / 2, y, z, t, x0, y0),
    "to the lower left": lambda x, y, z, t, x0, y0: paper(-x, y, z, t, x0, y0),
    "y goes to the right: x0 + y": lambda x, y, z, t, x0, y0: paper(x, -y, z, t, x0, y0),
    "only y is wrong": lambda x, y, z, t, x0, y0: (
        paper(x, y, z, t, x0, y0)[0],
        y0 - z + x * sin(t),
    ),
    "only x is wrong": lambda x, y, z, t, x0, y0: (
        x0 + y - x * cos(t),
        paper(x, y, z, t, x0, y0)[1],
    ),
    "y' = y0 - z + x * cos(theta)": lambda x, y, z, t, x0, y0: (
        x0 - x + y * sin(radians(30)),
        y0 - z + y * cos(t),
    ),
}

TOPICS = {
    "clip_line": CLIP_LINE,
    "clip_polygon": CLIP_POLYGON,
    "translation": TRANSLATION,
    "scaling": SCALING,
    "rotation": ROTATION,
    "about": ABOUT,
    "window_to_viewport": WINDOW,
    "bezier": CURVE,
    "casteljau": CASTELJAU,
    "bspline": BSPLINE,
    "projection": PROJECTION,
    "paper": PAPER,
}
TABLE = [(topic, *row) for topic, slips in TOPICS.items() for row in slips.items()]


@pytest.mark.parametrize(
    ("exercise", "hint", "function"), TABLE, ids=[f"{row[0]}-{row[1]}" for row in TABLE]
)
def test_each_mistake_gets_its_hint(exercise, hint, function):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
