"""Transformations of the plane, as matrices: what is right, and the usual slips.

Points are columns: x' = a x + b y + c, y' = d x + e y + f for [[a, b, c], [d, e, f], [0, 0, 1]]. A
positive angle turns the x axis toward the y axis, as in the textbook's matrix [[cos, -sin], [sin,
cos]]; on the screen, where y grows downwards, that is clockwise.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from math import cos, radians, sin
from typing import Any

from bgi.lab.answered import AnswerExercise, Slip, matrix

Matrix = list[list[float]]
Box = tuple[float, float, float, float]


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
    return _product(translation(x, y), rotation(degrees), translation(-x, -y))


def window_to_viewport(window: Box, viewport: Box) -> Matrix:
    """Brings the corners of the window to those of the viewport: left to left, top to top."""
    left, top, right, bottom = window
    to_left, to_top, to_right, to_bottom = viewport
    scale = scaling((to_right - to_left) / (right - left), (to_bottom - to_top) / (bottom - top))
    return _product(translation(to_left, to_top), scale, translation(-left, -top))


def _turn(angle: float) -> Matrix:
    c, s = cos(angle), sin(angle)
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def _product(*factors: Matrix) -> Matrix:
    one, *others = factors
    for other in others:
        columns = list(zip(*other, strict=True))
        one = [[sum(a * b for a, b in zip(row, c, strict=True)) for c in columns] for row in one]
    return one


def _transposed(formula: Callable[..., Matrix]) -> Slip:
    hint = "the matrix is transposed: here points are columns, and what moves stands at the right"
    return Slip(lambda *given: list(zip(*formula(*given), strict=True)), hint)


def _cornerless(formula: Callable[..., Matrix]) -> Slip:
    """Whose last row is nothing."""
    hint = "the last row is 0 0 1: without that 1 nothing is moved"
    return Slip(lambda *given: [*formula(*given)[:2], [0, 0, 0]], hint)


def _other_sense(formula: Callable[..., Matrix]) -> Slip:
    hint = "it turns the other way, or is transposed: the rows begin cos, -sin and sin, cos"
    return Slip(lambda degrees, *given: formula(-degrees, *given), hint)


RADIANS = "the angle comes in degrees, cos and sin want radians: math.radians(degrees)"
ANGLES = 90, 180, 45, 30, -30, 60, 270, 360, 0, 10, 123, -200, 400
STEPS = -40, -3, 0, 2.5, 100

EXERCISES = {
    "translation": AnswerExercise(
        "translation",
        ("tx", "ty"),
        lambda: [(5, 3), *product(STEPS, STEPS)],
        translation,
        matrix,
        [
            _transposed(translation),
            _cornerless(translation),
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
        ],
    ),
    "scaling": AnswerExercise(
        "scaling",
        ("sx", "sy"),
        lambda: [(2, 3), *product((0.5, 1, 2, -1, 10), (0.25, 1, 3, -2))],
        scaling,
        matrix,
        [
            _cornerless(scaling),
            Slip(lambda sx, sy: scaling(sy, sx), "sx and sy are exchanged"),
            Slip(lambda sx, sy: scaling(1 / sx, 1 / sy), "it shrinks where it should stretch"),
            Slip(lambda sx, sy: scaling(sx, sx), "sy is not used"),
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
            _cornerless(rotation),
            _other_sense(rotation),
            Slip(lambda degrees: rotation(2 * degrees), "it turns twice as far"),
            Slip(lambda degrees: rotation(90 - degrees), "cos and sin are exchanged"),
            Slip(lambda degrees: _unlike(degrees, 1, 1), "one of the two sines has a minus"),
            Slip(lambda degrees: _unlike(degrees, -1, -1), "only one of the two sines has a minus"),
            Slip(lambda degrees: _swapped(degrees), "cos and sin are exchanged"),
            Slip(
                lambda degrees: _turn(degrees * 180 / 3.14),
                "that is degrees from radians: multiply by pi, and divide by 180",
            ),
            Slip(lambda degrees: _turn(degrees * 3.14 / 180), "3.14 is too rough: use math.pi"),
            Slip(
                lambda degrees: _turn(degrees / 360),
                "a whole turn is 2 pi: math.radians(degrees)",
            ),
        ],
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
                lambda degrees, x, y: _product(rotation(degrees), translation(-x, -y)),
                "the point is moved to 0, 0 and turned there, but not moved back",
            ),
            Slip(
                lambda degrees, x, y: _product(translation(x, y), rotation(degrees)),
                "first of all the point must be moved to 0, 0",
            ),
            Slip(
                lambda degrees, x, y: _product(rotation(degrees), translation(x, y)),
                "first of all the point must be moved to 0, 0, by -x and -y",
            ),
            Slip(lambda degrees, x, y: about(degrees, y, x), "x and y are exchanged"),
            Slip(lambda degrees, x, y: _about(_turn(degrees), x, y), RADIANS),
            _other_sense(about),
            _transposed(about),
            _cornerless(about),
            Slip(
                lambda degrees, x, y: _about(list(zip(*rotation(degrees), strict=True)), -x, -y),
                "the matrices are multiplied in the wrong order, and turned the wrong way",
            ),
        ],
    ),
}


def _about(turn: Any, x: float, y: float) -> Matrix:
    return _product(translation(x, y), turn, translation(-x, -y))


def _unlike(degrees: float, one: int, other: int) -> Matrix:
    """A rotation with other signs."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, one * s, 0], [other * s, c, 0], [0, 0, 1]]


def _swapped(degrees: float) -> Matrix:
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[s, -c, 0], [c, s, 0], [0, 0, 1]]


WINDOW, VIEWPORT = (0, 0, 100, 50), (200, 100, 400, 300)
BOXES = [
    (WINDOW, VIEWPORT),
    ((0, 0, 1, 1), (0, 0, 639, 479)),
    ((-3, -2, 5, 7), (10, 20, 50, 90)),
    ((-1, 1, 1, -1), (0, 0, 639, 479)),  # a window whose y grows upwards
    ((10, 10, 20, 30), (10, 10, 20, 30)),
    ((-10, -1, -5, 1), (300, 0, 639, 20)),
]


def _fitted(window: Box, viewport: Box, *, shift: str = "both", divide: bool = False) -> Matrix:
    """As `window_to_viewport`, with a mistake."""
    left, top, right, bottom = window
    to_left, to_top, to_right, to_bottom = viewport
    across, down = (to_right - to_left) / (right - left), (to_bottom - to_top) / (bottom - top)
    scale = scaling(1 / across, 1 / down) if divide else scaling(across, down)
    there, back = translation(to_left, to_top), translation(-left, -top)
    products = {
        "both": (there, scale, back),
        "none": (scale,),
        "there": (there, scale),
        "back": (scale, back),
        "early": (scale, there, back),
        "late": (there, back, scale),
    }
    return _product(*products[shift])


EXERCISES["window_to_viewport"] = AnswerExercise(
    "window_to_viewport",
    ("window", "viewport"),
    lambda: BOXES,
    window_to_viewport,
    matrix,
    [
        Slip(
            lambda window, viewport: window_to_viewport(viewport, window),
            "it goes from the viewport to the window: the other way round",
        ),
        _transposed(window_to_viewport),
        _cornerless(window_to_viewport),
        Slip(
            lambda window, viewport: _fitted(window, viewport, divide=True),
            "it shrinks where it should stretch: the viewport's size through the window's",
        ),
        Slip(
            lambda window, viewport: _fitted(window, viewport, shift="none"),
            "it only stretches: left, top of the window must come to left, top of the viewport",
        ),
        Slip(
            lambda window, viewport: _fitted(window, viewport, shift="there"),
            "first move the window's left, top to 0, 0",
        ),
        Slip(
            lambda window, viewport: _fitted(window, viewport, shift="back"),
            "at last move to the viewport's left, top",
        ),
        Slip(
            lambda window, viewport: _fitted(window, viewport, shift="early"),
            "it is moved to the viewport before it is stretched: stretch first",
        ),
        Slip(
            lambda window, viewport: _fitted(window, viewport, shift="late"),
            "it is stretched before it is moved to 0, 0: move first",
        ),
        Slip(
            lambda window, viewport: window_to_viewport(
                window, (viewport[0], viewport[3], viewport[2], viewport[1])
            ),
            "it is upside down: top of the window comes to top of the viewport",
        ),
        Slip(
            lambda window, viewport: _fitted(
                window, (*viewport[:2], viewport[0] + viewport[2], viewport[1] + viewport[3])
            ),
            "right and bottom are corners, not sizes: the width is right - left",
        ),
        Slip(
            lambda window, viewport: _fitted(
                (*window[:2], window[0] + window[2], window[1] + window[3]),
                (*viewport[:2], viewport[0] + viewport[2], viewport[1] + viewport[3]),
            ),
            "right and bottom are corners, not sizes: the width is right - left",
        ),
    ],
    {"ZeroDivisionError": "is it top - top, or left - left, that is divided by?"},
)
