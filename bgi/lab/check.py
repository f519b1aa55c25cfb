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

from bgi.lab import (
    floods,
    interiors,
    lineclips,
    matrices,
    ovals,
    pictured,
    polygonclips,
    showing,
    spaceviews,
    splines,
    straight,
    windowmaps,
)
from bgi.lab.answered import AnswerExercise
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


def polygon(function: Function) -> Verdict:
    """Check a function that fills polygons, row by row.

    Args:
        function: my_fill(points, color); points are [(x, y), ...], the last one joined to the
            first. It may use line() for level lines. Pixels that touch a side are free: whether
            they are filled does not matter. Sides may cross: the even-odd rule says what is inside.
    """
    return _checked(interiors.EXERCISE, function)


def boundary(function: Function, deep: bool = True) -> Verdict:
    """Check a function that fills the area around a place as far as a border.

    Args:
        function: my_fill(x, y, color, border); everything is inside that can be reached from x, y
            by steps to the four neighbours without meeting the colours `border` or `color`. It may
            use line() for level lines.
        deep: False leaves out the large area, for a function that calls itself for each pixel.
    """
    return _checked(floods.boundary(deep), function)


def flood(function: Function, deep: bool = True) -> Verdict:
    """Check a function that gives an area of one colour another one.

    Args:
        function: my_fill(x, y, color); of the colour that is found at x, y everything is inside
            that can be reached by steps to the four neighbours. It may use line() for level lines.
        deep: False leaves out the large area, for a function that calls itself for each pixel.
    """
    return _checked(floods.flood(deep), function)


def clip_line(function: Function) -> Verdict:
    """Check a function that cuts a line at the edges of a window.

    Args:
        function: my_clip(x1, y1, x2, y2, left, top, right, bottom); returns (x1, y1, x2, y2), not
            rounded, of the part inside, or None. The edges belong to the window; top is less than
            bottom, as y grows downwards.
    """
    return _checked(lineclips.EXERCISE, function)


def clip_polygon(function: Function) -> Verdict:
    """Check a function that cuts a polygon at the edges of a window.

    Args:
        function: my_clip(points, left, top, right, bottom); points are [(x, y), ...], the last one
            joined to the first; returns such a list, which is empty if nothing is inside. What lies
            on an edge may be in it or not, as Sutherland and Hodgman's algorithm has it.
    """
    return _checked(polygonclips.EXERCISE, function)


def translation(function: Function) -> Verdict:
    """Check a function that returns the matrix that moves everything.

    Args:
        function: my_translation(tx, ty); a matrix is three rows of three numbers, for points that
            are columns: what moves stands in the last column.
    """
    return _checked(matrices.EXERCISES["translation"], function)


def rotation(function: Function) -> Verdict:
    """Check a function that returns the matrix that turns everything around 0, 0.

    Args:
        function: my_rotation(degrees); a positive angle turns the x axis toward the y axis: the
            rows begin cos, -sin and sin, cos. Where y grows downwards that is clockwise.
    """
    return _checked(matrices.EXERCISES["rotation"], function)


def scaling(function: Function) -> Verdict:
    """Check a function that returns the matrix that stretches everything, away from 0, 0.

    Args:
        function: my_scaling(sx, sy).
    """
    return _checked(matrices.EXERCISES["scaling"], function)


def about(function: Function) -> Verdict:
    """Check a function that returns the matrix that turns everything about a point.

    Args:
        function: my_turn(degrees, x, y); the sense of the angle is that of `rotation`.
    """
    return _checked(matrices.EXERCISES["about"], function)


def window_to_viewport(function: Function) -> Verdict:
    """Check a function that returns the matrix from a window in the plane to one on the screen.

    Args:
        function: my_map(window, viewport), both (left, top, right, bottom): left goes to left, top
            to top.
    """
    return _checked(windowmaps.EXERCISE, function)


def bezier(function: Function) -> Verdict:
    """Check a function that returns a point of a cubic Bézier curve.

    Args:
        function: my_bezier(points, t); four points [(x, y), ...], t is 0..1; returns (x, y).
    """
    return _checked(splines.EXERCISES["bezier"], function)


def casteljau(function: Function) -> Verdict:
    """Check a function that returns a point of a Bézier curve of any number of points.

    Args:
        function: my_casteljau(points, t); two points or more, t is 0..1; returns (x, y).
    """
    return _checked(splines.EXERCISES["casteljau"], function)


def bspline(function: Function) -> Verdict:
    """Check a function that returns a point of a uniform cubic B-spline.

    Args:
        function: my_spline(points, t); the four points of one segment, t is 0..1; returns (x, y).
    """
    return _checked(splines.EXERCISES["bspline"], function)


def projection(function: Function) -> Verdict:
    """Check a function that projects a point of space onto the screen, in perspective.

    Args:
        function: my_projection(x, y, z, distance); the screen is the plane z = 0, the eye is
            `distance` before its point 0, 0, and z grows away from the eye; returns (x, y).
    """
    return _checked(spaceviews.EXERCISES["projection"], function)


def paper(function: Function) -> Verdict:
    """Check a function that maps a point of space to the screen by the paper's equation 1.

    Args:
        function: my_map(x, y, z, theta, x0, y0); theta in radians; returns (x', y').
    """
    return _checked(spaceviews.EXERCISES["paper"], function)


def picture(file: str | os.PathLike[str]) -> Verdict:
    """Compare the screen, as it is now, with a picture in a file.

    Args:
        file: a PNG or another picture, of the size of the screen: every pixel must have its colour.

    Raises BGIError if there is no screen, and OSError or ValueError if there is no such picture.
    """
    return _told(pictured.compare(file))


def _checked(exercise: DrawingExercise | AnswerExercise, function: Function) -> Verdict:
    return _told(exercise.check(function))


def _told(verdict: Verdict) -> Verdict:
    showing.show(verdict, show, save)
    return verdict
