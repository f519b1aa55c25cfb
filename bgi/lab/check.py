"""Exercises that check themselves.

    from bgi import putpixel
    from bgi.lab import check

    def my_line(x1, y1, x2, y2, color):
        ...

    check.line(my_line)

Each check tries a function with hundreds of cases, on a screen that nobody sees, and prints what it
found: the first case that is wrong, and a hint where the mistake may be. The picture of it, yours,
expected and the difference, appears in a window until a key is pressed, or in the notebook. A check
returns a `Verdict`, which is true if the function is right: `assert check.line(my_line)`.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from bgi.lab import ovals, showing, straight
from bgi.lab.drawn import DrawingExercise
from bgi.lab.verdict import Verdict

save: str | os.PathLike[str] | None = None
"""A folder: the pictures of mistakes are written there, as line.png and so on. None: nowhere."""
show: bool = True
"""Whether a window opens for the picture, where there is a display."""

Function = Callable[..., Any]


def line(function: Function, exactly: bool = False) -> Verdict:
    """Check a function that draws lines by putpixel.

    Args:
        function: my_line(x1, y1, x2, y2, color); both ends belong to the line.
        exactly: True for the very pixels of bgi's own line(); otherwise any that are nearest to the
            true line, so that DDA, midpoint and Bresenham are all right.
    """
    return _checked(straight.exercise(exactly), function)


def circle(function: Function, exactly: bool = False) -> Verdict:
    """Check a function that draws circles by putpixel.

    Args:
        function: my_circle(x, y, radius, color); a circle of radius 0 is its centre.
        exactly: True for the very pixels of bgi's own circle().
    """
    return _checked(ovals.circle(exactly), function)


def ellipse(function: Function, exactly: bool = False) -> Verdict:
    """Check a function that draws ellipses by putpixel.

    Args:
        function: my_ellipse(x, y, xradius, yradius, color).
        exactly: True for the very pixels of bgi's own ellipse().
    """
    return _checked(ovals.ellipse(exactly), function)


def _checked(exercise: DrawingExercise, function: Function) -> Verdict:
    verdict = exercise.check(function)
    showing.show(verdict, show, save)
    return verdict
