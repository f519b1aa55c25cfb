"""Transformations of the plane, as matrices: what is right, and the usual slips.

Points are columns: x' = a x + b y + c, y' = d x + e y + f for [[a, b, c], [d, e, f], [0, 0, 1]]. A
positive angle turns the x axis toward the y axis, as in the textbook's matrix [[cos, -sin], [sin,
cos]]; on the screen, where y grows downwards, that is clockwise.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, radians, sin
from operator import mul
from typing import Any

from bgi.lab.answered import AnswerExercise, Slip, matrix

Matrix = list[list[float]]


def translation(tx: float, ty: float) -> Matrix:
    """Moves everything by tx, ty."""
    return [[1, 0, tx], [0, 1, ty], [0, 0, 1]]


def scaling(sx: float, sy: float) -> Matrix:
    """Stretches everything, away from 0, 0."""
    return [[sx, 0, 0], [0, sy, 0], [0, 0, 1]]


def rotation(degrees: float) -> Matrix:
    """Turns everything around 0, 0."""
    return _turn(radians(degrees))


def about(degrees: float, x: float, y: float) -> Matrix:
    """Turns everything around x, y."""
    return product(translation(x, y), rotation(degrees), translation(-x, -y))


def _turn(angle: float) -> Matrix:
    c, s = cos(angle), sin(angle)
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def product(*factors: Matrix) -> Matrix:
    """Rows by columns; what stands at the right is done first."""
    one, *others = factors
    for other in others:
        columns = list(zip(*other, strict=True))
        one = [[sum(a * b for a, b in zip(row, c, strict=True)) for c in columns] for row in one]
    return one


def transposed(formula: Callable[..., Matrix]) -> Slip:
    """For points that are rows."""
    hint = "the matrix is transposed: here points are columns, and what moves stands at the right"
    return Slip(lambda *given: list(zip(*formula(*given), strict=True)), hint)


def cornerless(formula: Callable[..., Matrix]) -> Slip:
    """Whose last row is nothing."""
    hint = "the last row is 0 0 1: without that 1 nothing is moved"
    return Slip(lambda *given: [*formula(*given)[:2], [0, 0, 0]], hint)


def _other_sense(formula: Callable[..., Matrix]) -> Slip:
    hint = "it turns the other way, or is transposed: the rows begin cos, -sin and sin, cos"
    return Slip(lambda degrees, *given: formula(-degrees, *given), hint)


RADIANS = "the angle comes in degrees, cos and sin want radians: math.radians(degrees)"
ENTRIES = tuple(f"row {row}, column {column}" for row in (1, 2, 3) for column in (1, 2, 3))
ANGLES = 90, 180, 45, 30, -30, 60, 270, 360, 0, 10, 123, -200, 400
STEPS = -40, -3, 0, 2.5, 100

EXERCISES = {
    "translation": AnswerExercise(
        "translation",
        ("tx", "ty"),
        lambda: [(5, 3), *((tx, ty) for tx in STEPS for ty in STEPS)],
        translation,
        matrix,
        [
            transposed(translation),
            cornerless(translation),
            Slip(lambda tx, ty: translation(ty, tx), "tx and ty are exchanged"),
            Slip(lambda tx, ty: translation(-tx, -ty), "it moves the other way"),
            Slip(lambda tx, ty: translation(tx, tx), "ty is not used"),
            Slip(scaling, "that is scaling: what moves stands in the last column"),
            Slip(lambda tx, ty: [[tx, 0, 0], [0, ty, 0], [0, 0, 1]], "that is scaling"),
            Slip(
                lambda tx, ty: [[0, 0, tx], [0, 0, ty], [0, 0, 1]],
                "x and y are lost: ones belong on the diagonal",
            ),
            Slip(
                lambda tx, ty: [[1, 0, tx], [0, 1, ty], [0, 0, 0]],
                "the last row is 0 0 1",
            ),
            Slip(lambda tx, ty: translation(0, 0), "tx and ty are not used: nothing moves"),
            Slip(
                lambda tx, ty: [[1, 0, tx], [0, 1, ty], [tx, ty, 1]],
                "what moves stands in the last column only: the last row is 0 0 1",
            ),
            Slip(
                lambda tx, ty: [[1, 1, tx], [1, 1, ty], [0, 0, 1]],
                "ones belong on the diagonal only",
            ),
            Slip(lambda tx, ty: scaling(1 + tx, 1 + ty), "that is scaling"),
        ],
        parts=ENTRIES,
    ),
    "scaling": AnswerExercise(
        "scaling",
        ("sx", "sy"),
        lambda: [(2, 3), *((sx, sy) for sx in (0.5, 1, 2, -1, 10) for sy in (0.25, 1, 3, -2))],
        scaling,
        matrix,
        [
            cornerless(scaling),
            Slip(lambda sx, sy: scaling(sy, sx), "sx and sy are exchanged"),
            Slip(lambda sx, sy: scaling(1 / sx, 1 / sy), "it shrinks where it should stretch"),
            Slip(lambda sx, sy: scaling(sx, sx), "sy is not used"),
            Slip(lambda sx, sy: scaling(sy, sy), "sx is not used"),
            Slip(
                lambda sx, sy: scaling(sx / 100, sy / 100),
                "sx and sy are no percentages: 1 leaves everything as it is",
            ),
            Slip(translation, "that is translation: what stretches stands on the diagonal"),
            Slip(lambda sx, sy: scaling(sx + 1, sy + 1), "1 leaves everything as it is, not 0"),
            Slip(
                lambda sx, sy: [[sx, sy, 0], [0, 0, 0], [0, 0, 1]],
                "sy belongs into the second row",
            ),
            Slip(
                lambda sx, sy: [[0, sx, 0], [sy, 0, 0], [0, 0, 1]],
                "the numbers belong on the other diagonal, from the upper left",
            ),
            Slip(
                lambda sx, sy: [[sx, 0, 0], [0, sy, 0], [0, 0, sx]],
                "the last row is 0 0 1",
            ),
        ],
        parts=ENTRIES,
    ),
    "rotation": AnswerExercise(
        "rotation",
        ("degrees",),
        lambda: [(angle,) for angle in ANGLES],
        rotation,
        matrix,
        [
            Slip(_turn, RADIANS),
            Slip(lambda degrees: _turn(-degrees), RADIANS),
            cornerless(rotation),
            _other_sense(rotation),
            Slip(lambda degrees: rotation(2 * degrees), "it turns twice as far"),
            Slip(lambda degrees: rotation(90 - degrees), "cos and sin are exchanged"),
            Slip(lambda degrees: _unlike(degrees, 1, 1), "one of the two sines has a minus"),
            Slip(lambda degrees: _unlike(degrees, -1, -1), "only one of the two sines has a minus"),
            Slip(lambda degrees: _swapped(degrees), "cos and sin are exchanged"),
            Slip(
                lambda degrees: _turn(degrees * 180 / pi),
                "that is degrees from radians: multiply by pi, and divide by 180",
            ),
            Slip(
                lambda degrees: rotation(degrees / 2),
                "it turns half as far: pi / 180 is a degree, a whole turn is 2 pi",
            ),
            Slip(
                lambda degrees: _turn(degrees * pi // 180),
                "// cuts the angle off: divide by /",
            ),
            Slip(lambda degrees: _turn(degrees * 3.14 / 180), "3.14 is too rough: use math.pi"),
            Slip(
                lambda degrees: _turn(degrees / 360),
                "a whole turn is 2 pi: math.radians(degrees)",
            ),
        ],
        parts=ENTRIES,
        otherwise="the rows are cos, -sin, 0 and sin, cos, 0 and 0, 0, 1",
    ),
    "about": AnswerExercise(
        "about",
        ("degrees", "x", "y"),
        lambda: [(90, 10, 20), *((a, x, y) for a in ANGLES for x, y in ((320, 240), (-5, 8)))],
        about,
        matrix,
        [
            Slip(
                lambda degrees, x, y: rotation(degrees),
                "it turns about 0, 0: the point is not used, or the turn does not stand between"
                " both moves",
            ),
            Slip(
                lambda degrees, x, y: about(degrees, -x, -y),
                "the moves are in the wrong order: what stands at the right is done first,"
                " translation(x, y) * rotation * translation(-x, -y)",
            ),
            Slip(
                lambda degrees, x, y: product(rotation(degrees), translation(-x, -y)),
                "the point is moved to 0, 0 and turned there, but not moved back",
            ),
            Slip(
                lambda degrees, x, y: product(translation(x, y), rotation(degrees)),
                "first of all the point must be moved to 0, 0",
            ),
            Slip(
                lambda degrees, x, y: product(rotation(degrees), translation(x, y)),
                "first of all the point must be moved to 0, 0, by -x and -y",
            ),
            Slip(lambda degrees, x, y: about(degrees, y, x), "x and y are exchanged"),
            Slip(lambda degrees, x, y: _about(_turn(degrees), x, y), RADIANS),
            _other_sense(about),
            transposed(about),
            cornerless(about),
            Slip(
                lambda degrees, x, y: _about(list(zip(*rotation(degrees), strict=True)), -x, -y),
                "the matrices are multiplied in the wrong order, and turned the wrong way",
            ),
            Slip(
                lambda degrees, x, y: _combined(mul, degrees, x, y),
                "* multiplies number by number: the product of matrices is @",
            ),
            Slip(
                lambda degrees, x, y: product(
                    translation(x, y), rotation(degrees), translation(x, y)
                ),
                "both moves go the same way: first by -x and -y, at last by x and y",
            ),
            Slip(
                lambda degrees, x, y: product(
                    translation(-x, -y), rotation(degrees), translation(-x, -y)
                ),
                "both moves go the same way: first by -x and -y, at last by x and y",
            ),
            Slip(
                lambda degrees, x, y: product(_as_row(-x, -y), rotation(degrees), _as_row(x, y)),
                "the moves are matrices for points that are rows: here what moves stands in the"
                " last column",
            ),
        ],
        {"TypeError": "are matrices multiplied? Lists are not: numpy.array(...) @, or three loops"},
        parts=ENTRIES,
        otherwise="three matrices are multiplied, rows by columns: translation(x, y) * rotation"
        " * translation(-x, -y); what stands at the right is done first",
    ),
}


def _about(turn: Any, x: float, y: float) -> Matrix:
    return product(translation(x, y), turn, translation(-x, -y))


def _as_row(x: float, y: float) -> Matrix:
    """A translation for points that are rows."""
    return [[1, 0, 0], [0, 1, 0], [x, y, 1]]


def _combined(operation: Callable[[float, float], float], *given: float) -> Matrix:
    """The three matrices of a turn about a point, number by number."""
    degrees, x, y = given
    factors = translation(x, y), rotation(degrees), translation(-x, -y)
    return [
        [operation(operation(a, b), c) for a, b, c in zip(*rows, strict=True)]
        for rows in zip(*factors, strict=True)
    ]


def _unlike(degrees: float, one: int, other: int) -> Matrix:
    """A rotation with other signs."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, one * s, 0], [other * s, c, 0], [0, 0, 1]]


def _swapped(degrees: float) -> Matrix:
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[s, -c, 0], [c, s, 0], [0, 0, 1]]
