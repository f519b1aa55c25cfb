"""From a window to a viewport, as a matrix: what is right, and the usual slips."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.lab.answered import AnswerExercise, Slip, matrix
from bgi.lab.matrices import (
    ENTRIES,
    Matrix,
    cornerless,
    product,
    scaling,
    translation,
    transposed,
)

Box = tuple[float, float, float, float]


def window_to_viewport(window: Box, viewport: Box) -> Matrix:
    """Brings the corners of the window to those of the viewport: left to left, top to top."""
    left, top, right, bottom = window
    to_left, to_top, to_right, to_bottom = viewport
    scale = scaling((to_right - to_left) / (right - left), (to_bottom - to_top) / (bottom - top))
    return product(translation(to_left, to_top), scale, translation(-left, -top))


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
    return product(*products[shift])


def _scaled(window: Box, viewport: Box, change: Callable[[float, float], Any]) -> Matrix:
    """As it should be, but with other scales."""
    (sx, _, _), (_, sy, _), _ = _fitted(window, viewport, shift="none")
    scale = scaling(*change(sx, sy))
    return product(translation(*viewport[:2]), scale, translation(-window[0], -window[1]))


def _evenly(window: Box, viewport: Box, choose: Callable[[float, float], float]) -> Matrix:
    """With one scale for both."""
    return _scaled(window, viewport, lambda across, down: (choose(across, down),) * 2)


def _reordered(box: Box) -> Box:
    """Taken for left, right, top, bottom."""
    return box[0], box[2], box[1], box[3]


EXERCISE = AnswerExercise(
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
        transposed(window_to_viewport),
        cornerless(window_to_viewport),
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
        *(
            Slip(
                lambda window, viewport, choose=choose: _evenly(window, viewport, choose),
                "across and down it is stretched by numbers of their own",
            )
            for choose in (min, max, lambda across, down: across, lambda across, down: down)
        ),
        Slip(
            lambda window, viewport: _scaled(window, viewport, lambda a, b: (b, a)),
            "the two scales are exchanged: width by width is for x",
        ),
        Slip(
            lambda window, viewport: _scaled(window, viewport, lambda a, b: (a // 1, b // 1)),
            "// cuts the scale off: divide by /",
        ),
        Slip(
            lambda window, viewport: _fitted(
                window, (*viewport[:2], viewport[2] + 1, viewport[3] + 1)
            ),
            "right - left is wanted, without 1 more: right comes to right",
        ),
        Slip(
            lambda window, viewport: product(
                translation(*viewport[:2]),
                product(_fitted(window, viewport, shift="none"), translation(*window[:2])),
            ),
            "the window's left, top is moved the wrong way: by -left and -top",
        ),
        Slip(
            lambda window, viewport: window_to_viewport(_reordered(window), _reordered(viewport)),
            "the four numbers are left, top, right, bottom, in this order",
        ),
    ],
    {"ZeroDivisionError": "is it top - top, or left - left, that is divided by?"},
    parts=ENTRIES,
    otherwise="translation(viewport's left, top) * scaling * translation(-left, -top of the"
    " window): what stands at the right is done first",
)
