"""The matrices of the plane: the right ones pass, and each usual mistake gets its hint."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from bgi.lab import check
from tests.lab.mistakes import Mistakes


def translation(tx, ty):
    return [[1, 0, tx], [0, 1, ty], [0, 0, 1]]


def scaling(sx, sy):
    return [[sx, 0, 0], [0, sy, 0], [0, 0, 1]]


def rotation(degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def about(degrees, x, y):
    return np.array(translation(x, y)) @ rotation(degrees) @ translation(-x, -y)


def window_to_viewport(window, viewport):
    sx = (viewport[2] - viewport[0]) / (window[2] - window[0])
    sy = (viewport[3] - viewport[1]) / (window[3] - window[1])
    return [[sx, 0, viewport[0] - sx * window[0]], [0, sy, viewport[1] - sy * window[1]], [0, 0, 1]]


RIGHT = [translation, scaling, rotation, about, window_to_viewport]


@pytest.mark.parametrize("function", RIGHT)
def test_the_right_one_passes(function):
    verdict = getattr(check, function.__name__)(function)
    assert verdict, str(verdict)


def test_tuples_and_arrays_will_do():
    assert check.rotation(lambda degrees: tuple(map(tuple, rotation(degrees))))
    assert check.rotation(lambda degrees: np.array(rotation(degrees)))


moves, sizes, turns, about_a_point, windows = (Mistakes() for _ in range(5))


def transposed(matrix):
    return [list(column) for column in zip(*matrix, strict=True)]


@moves("transposed")
def as_a_row(tx, ty):
    return transposed(translation(tx, ty))


@moves("tx and ty are exchanged")
def exchanged(tx, ty):
    return translation(ty, tx)


@moves("the other way")
def backwards(tx, ty):
    return translation(-tx, -ty)


@moves("ty is not used")
def without_ty(tx, ty):
    return translation(tx, tx)


@moves("that is scaling")
def stretched(tx, ty):
    return [[tx, 0, 0], [0, ty, 0], [0, 0, 1]]


@moves("ones belong on the diagonal")
def without_ones(tx, ty):
    return [[0, 0, tx], [0, 0, ty], [0, 0, 1]]


@moves("the last row is 0 0 1")
def without_the_last_one(tx, ty):
    return [[1, 0, tx], [0, 1, ty], [0, 0, 0]]


@moves("three rows of three numbers")
def two_rows(tx, ty):
    return [[1, 0, tx], [0, 1, ty]]


@moves("three rows of three numbers")
def forgets_to_return(tx, ty):
    translation(tx, ty)


@moves("three rows of three numbers")
def in_one_row(tx, ty):
    return [1, 0, tx, 0, 1, ty, 0, 0, 1]


@moves("is the name written as where it was set")
def misspelt(tx, ty):
    return [[1, 0, tx], [0, 1, yt], [0, 0, 1]]  # type: ignore[name-defined]  # noqa: F821


@moves("three rows of three numbers")
def of_texts(tx, ty):
    return [["1", "0", str(tx)], ["0", "1", str(ty)], ["0", "0", "1"]]


@sizes("sx and sy are exchanged")
def sizes_exchanged(sx, sy):
    return scaling(sy, sx)


@sizes("it shrinks")
def shrinks(sx, sy):
    return scaling(1 / sx, 1 / sy)


@sizes("sy is not used")
def without_sy(sx, sy):
    return scaling(sx, sx)


@sizes("that is translation")
def moved(sx, sy):
    return translation(sx, sy)


@sizes("1 leaves everything as it is")
def one_more(sx, sy):
    return scaling(1 + sx, 1 + sy)


@sizes("second row")
def in_the_first_row(sx, sy):
    return [[sx, sy, 0], [0, 0, 0], [0, 0, 1]]


@sizes("other diagonal")
def on_the_other_diagonal(sx, sy):
    return [[0, sx, 0], [sy, 0, 0], [0, 0, 1]]


@sizes("the last row is 0 0 1")
def corner_too(sx, sy):
    return [[sx, 0, 0], [0, sy, 0], [0, 0, sx]]


@sizes("without that 1")
def no_corner(sx, sy):
    return [[sx, 0, 0], [0, sy, 0], [0, 0, 0]]


@sizes("rounded")
def cut_off(sx, sy):
    return scaling(int(sx), int(sy))


@turns("math.radians")
def in_radians(degrees):
    return [[cos(degrees), -sin(degrees), 0], [sin(degrees), cos(degrees), 0], [0, 0, 1]]


@turns("the other way, or is transposed")
def the_other_way(degrees):
    return rotation(-degrees)


@turns("the other way, or is transposed")
def rotation_transposed(degrees):
    return transposed(rotation(degrees))


@turns("cos and sin are exchanged")
def sines_first(degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[s, -c, 0], [c, s, 0], [0, 0, 1]]


@turns("has a minus")
def no_minus(degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, s, 0], [s, c, 0], [0, 0, 1]]


@turns("only one of the two sines")
def two_minuses(degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, -s, 0], [-s, c, 0], [0, 0, 1]]


@turns("twice as far")
def twice_as_far(degrees):
    return rotation(2 * degrees)


@turns("use math.pi")
def rough_pi(degrees):
    angle = degrees * 3.14 / 180
    return [[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]]


@turns("a whole turn is 2 pi")
def a_part_of_a_turn(degrees):
    return rotation(degrees / 360 * 180 / pi)


@turns("the last row is 0 0 1")
def without_a_corner(degrees):
    return [*rotation(degrees)[:2], [0, 0, 0]]


@turns("three rows of three numbers")
def two_by_two(degrees):
    return [row[:2] for row in rotation(degrees)[:2]]


@turns("rounded")
def rounded(degrees):
    return [[round(v) for v in row] for row in rotation(degrees)]


@about_a_point("the point is not used")
def about_nothing(degrees, x, y):
    return rotation(degrees)


@about_a_point("wrong order")
def in_the_wrong_order(degrees, x, y):
    return np.array(translation(-x, -y)) @ rotation(degrees) @ translation(x, y)


@about_a_point("not moved back")
def not_back(degrees, x, y):
    return np.array(rotation(degrees)) @ translation(-x, -y)


@about_a_point("must be moved to 0, 0")
def not_there(degrees, x, y):
    return np.array(translation(x, y)) @ rotation(degrees)


@about_a_point("by -x and -y")
def moved_before(degrees, x, y):
    return np.array(rotation(degrees)) @ translation(x, y)


@about_a_point("x and y are exchanged")
def about_another_point(degrees, x, y):
    return about(degrees, y, x)


@about_a_point("math.radians")
def about_in_radians(degrees, x, y):
    return about(degrees * 180 / pi, x, y)


@about_a_point("the other way")
def about_the_other_way(degrees, x, y):
    return about(-degrees, x, y)


@about_a_point("transposed")
def about_transposed(degrees, x, y):
    return transposed(about(degrees, x, y).tolist())


@about_a_point("the last row is 0 0 1")
def about_without_a_corner(degrees, x, y):
    return [*about(degrees, x, y).tolist()[:2], [0, 0, 0]]


@about_a_point("turned the wrong way")
def multiplied_by_rows(degrees, x, y):
    return np.array(translation(-x, -y)) @ rotation(-degrees) @ translation(x, y)


@about_a_point("does not stand between both moves")
def moved_there_and_back(degrees, x, y):
    return np.array(translation(x, y)) @ translation(-x, -y) @ rotation(degrees)


def fitted(window, viewport, *products):
    sx = (viewport[2] - viewport[0]) / (window[2] - window[0])
    sy = (viewport[3] - viewport[1]) / (window[3] - window[1])
    parts = {
        "back": translation(-window[0], -window[1]),
        "scale": scaling(sx, sy),
        "shrink": scaling(1 / sx, 1 / sy),
        "there": translation(viewport[0], viewport[1]),
    }
    return np.linalg.multi_dot([np.eye(3), np.eye(3), *(np.array(parts[p]) for p in products)])


@windows("the other way round")
def from_the_screen(window, viewport):
    return window_to_viewport(viewport, window)


@windows("transposed")
def window_transposed(window, viewport):
    return transposed(window_to_viewport(window, viewport))


@windows("it shrinks")
def window_shrinks(window, viewport):
    return fitted(window, viewport, "there", "shrink", "back")


@windows("it only stretches")
def only_stretches(window, viewport):
    return fitted(window, viewport, "scale")


@windows("first move the window's left, top to 0, 0")
def not_from_the_corner(window, viewport):
    return fitted(window, viewport, "there", "scale")


@windows("at last move to the viewport's left, top")
def not_to_the_corner(window, viewport):
    return fitted(window, viewport, "scale", "back")


@windows("stretch first")
def moved_too_early(window, viewport):
    return fitted(window, viewport, "scale", "there", "back")


@windows("move first")
def moved_too_late(window, viewport):
    return fitted(window, viewport, "there", "back", "scale")


@windows("upside down")
def upside_down(window, viewport):
    left, top, right, bottom = viewport
    return window_to_viewport(window, (left, bottom, right, top))


@windows("corners, not sizes")
def takes_sizes(window, viewport):
    def with_sizes(box):
        return box[0], box[1], box[0] + box[2], box[1] + box[3]

    def scales(a, b):
        return (b[2] - b[0]) / (a[2] - a[0])

    w, v = with_sizes(window), with_sizes(viewport)
    return window_to_viewport(w, v) if scales(w, v) else None


@windows("divided by")
def divides_by_nothing(window, viewport):
    return (viewport[2] - viewport[0]) / (window[0] - window[0])


@windows("the last row is 0 0 1")
def window_without_a_corner(window, viewport):
    return [*window_to_viewport(window, viewport)[:2], [0, 0, 0]]


ALL = [
    ("translation", moves),
    ("scaling", sizes),
    ("rotation", turns),
    ("about", about_a_point),
    ("window_to_viewport", windows),
]
TABLE = [(exercise, *row) for exercise, mistakes in ALL for row in mistakes.table]


@pytest.mark.parametrize(
    ("exercise", "function", "hint"), TABLE, ids=[f"{row[0]}-{row[1].__name__}" for row in TABLE]
)
def test_each_mistake_gets_its_hint(exercise, function, hint):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
