"""From a window to a viewport, as a matrix: what is right, and the usual slips."""

from __future__ import annotations

from collections.abc import Callable

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


Scales = tuple[float, float]


def _scales(window: Box, viewport: Box) -> Scales:
    """Across and down, as they should be."""
    (across, _, _), (_, down, _), _ = window_to_viewport(window, viewport)
    return across, down


def _moved(*order: str) -> Callable[[Box, Box], Matrix]:
    """The three matrices in another order, or some of them."""

    def made(window: Box, viewport: Box) -> Matrix:
        matrices = {
            "to": translation(*viewport[:2]),
            "scale": scaling(*_scales(window, viewport)),
            "back": translation(-window[0], -window[1]),
            "there": translation(*window[:2]),
        }
        return product(*(matrices[name] for name in order))

    return made


def _scaled(change: Callable[[float, float], Scales]) -> Callable[[Box, Box], Matrix]:
    """As it should be, but with other scales."""

    def made(window: Box, viewport: Box) -> Matrix:
        scale = scaling(*change(*_scales(window, viewport)))
        return product(translation(*viewport[:2]), scale, translation(-window[0], -window[1]))

    return made


def _summed(box: Box) -> Box:
    """Right and bottom taken for sizes."""
    return *box[:2], box[0] + box[2], box[1] + box[3]


def _reordered(box: Box) -> Box:
    """Taken for left, right, top, bottom."""
    return box[0], box[2], box[1], box[3]


CORNERS = "right and bottom are corners, not sizes: the width is right - left"

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
            _scaled(lambda across, down: (1 / across, 1 / down)),
            "it shrinks where it should stretch: the viewport's size through the window's",
        ),
        Slip(
            _moved("scale"),
            "it only stretches: left, top of the window must come to left, top of the viewport",
        ),
        Slip(_moved("to", "scale"), "first move the window's left, top to 0, 0"),
        Slip(_moved("scale", "back"), "at last move to the viewport's left, top"),
        Slip(
            _moved("scale", "to", "back"),
            "it is moved to the viewport before it is stretched: stretch first",
        ),
        Slip(
            _moved("to", "back", "scale"),
            "it is stretched before it is moved to 0, 0: move first",
        ),
        Slip(
            lambda window, viewport: window_to_viewport(
                window, (viewport[0], viewport[3], viewport[2], viewport[1])
            ),
            "it is upside down: top of the window comes to top of the viewport",
        ),
        Slip(lambda window, viewport: window_to_viewport(window, _summed(viewport)), CORNERS),
        Slip(
            lambda window, viewport: window_to_viewport(_summed(window), _summed(viewport)),
            CORNERS,
        ),
        *(
            Slip(_scaled(change), "across and down it is stretched by numbers of their own")
            for change in (
                lambda across, down: (min(across, down),) * 2,
                lambda across, down: (max(across, down),) * 2,
                lambda across, down: (across, across),
                lambda across, down: (down, down),
            )
        ),
        Slip(
            _scaled(lambda across, down: (down, across)),
            "the two scales are exchanged: width by width is for x",
        ),
        Slip(
            _scaled(lambda across, down: (across // 1, down // 1)),
            "// cuts the scale off: divide by /",
        ),
        Slip(
            lambda window, viewport: window_to_viewport(
                window, (*viewport[:2], viewport[2] + 1, viewport[3] + 1)
            ),
            "right - left is wanted, without 1 more: right comes to right",
        ),
        Slip(
            _moved("to", "scale", "there"),
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
