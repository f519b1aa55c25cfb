"""Points, lines and outlines.

Coordinates are relative to the viewport, y grows downwards, and any int is legal: what falls
outside is cut off. A float is truncated toward zero. Wherever numbers go, arrays (or lists) of
numbers go too: they broadcast as numpy's do, and mean the same call once for every element, in
order. An array has at most 16,777,216 numbers and 32 dimensions; ValueError for more.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from bgi import current
from bgi.kernel.arguments import Number, Numbers
from bgi.settings import linesettingstype

# fmt: off
__all__ = [
    "putpixel", "getpixel",
    "line", "lineto", "linerel", "rectangle", "drawpoly",
    "setlinestyle", "getlinesettings", "setwritemode",
]
# fmt: on


def putpixel(x: Numbers, y: Numbers, color: Numbers) -> None:
    """Set a pixel to a colour.

    Args:
        x, y: where, relative to the viewport; outside it (or the screen) nothing happens.
        color: the palette index, cut to the mode's bits.

    Arrays set many pixels; where two coincide the later one stays. Ignores colour, write mode and
    current position.
    """
    current.screen.putpixel(x, y, color)


@overload
def getpixel(x: Number, y: Number) -> int: ...
@overload
def getpixel(x: Numbers, y: Numbers) -> Any: ...
def getpixel(x: Numbers, y: Numbers) -> int | NDArray[np.uint8]:
    """Return the palette index of a pixel of the active page.

    Args:
        x, y: which, relative to the viewport, inside it or not; 0 off the screen.

    Arrays return an array of their shape.
    """
    return current.screen.getpixel(x, y)


def line(x1: Numbers, y1: Numbers, x2: Numbers, y2: Numbers, color: Numbers | None = None) -> None:
    """Draw a line, both ends included.

    Args:
        x1, y1, x2, y2: its ends, relative to the viewport.
        color: this line's colour; the drawing colour if None.

    In the line style, width and write mode; leaves the current position. Arrays draw many lines.
    Pixels: always drawn downwards, clipped lines redrawn from the clipped end, as the driver did.
    """
    current.screen.line(x1, y1, x2, y2, color)


def lineto(x: Number, y: Number) -> None:
    """Draw a line from the current position to x, y, which becomes the current position.

    As line(), but a level line begins its pattern at x, y.
    """
    current.screen.lineto(x, y)


def linerel(dx: Number, dy: Number) -> None:
    """Draw a line from the current position by dx, dy, where the current position goes.

    As lineto().
    """
    current.screen.linerel(dx, dy)


def rectangle(
    left: Numbers, top: Numbers, right: Numbers, bottom: Numbers, color: Numbers | None = None
) -> None:
    """Draw the outline of a box, its corners in any order.

    Args:
        left, top, right, bottom: two opposite corners, relative to the viewport, both drawn.
        color: this box's colour; the drawing colour if None.

    Four lines, top, right, bottom, left: in XOR mode the corners, hit twice, stay as they were.
    Arrays draw many boxes.
    """
    current.screen.rectangle(left, top, right, bottom, color)


def drawpoly(points: Numbers, flat: Numbers | None = None, color: Numbers | None = None) -> None:
    """Draw lines from point to point; repeat the first point to close the figure.

    Args:
        points: [(x, y), ...], an array of shape (k, 2), or a flat list x, y, x, y, ...; shape
            (n, k, 2) draws n polygons. As in C: the number of points, followed by `flat`.
        color: their colour, or n colours; the drawing colour if None.

    Back at its first point the figure ends, and the next point begins another. Draws as line().
    ValueError, and nothing is drawn, for more than 16,777,216 numbers.
    """
    current.screen.drawpoly(points, flat, color)


def setlinestyle(style: Number, pattern: Number, width: Number) -> None:
    """Choose how lines look.

    Args:
        style: SOLID_LINE, DOTTED_LINE, CENTER_LINE, DASHED_LINE or USERBIT_LINE.
        pattern: sixteen bits for USERBIT_LINE, the lowest drawn first; 1 draws, 0 leaves a gap.
        width: NORM_WIDTH (1) or THICK_WIDTH (3); 0 and 2 are drawn like 1. In a window of
            initwindow() up to 4096: more than 3 is drawn without gaps, by a round brush.

    graphresult() says -11, and nothing changes, for any other style or width. (On CGA and Hercules
    the highest bit is drawn first, and lines run to the right, not downwards.)
    """
    current.screen.setlinestyle(style, pattern, width)


def getlinesettings() -> linesettingstype:
    """Return line style, pattern and width as setlinestyle() was given them: 0, 0, 1 at first."""
    return current.screen.getlinesettings()


def setwritemode(mode: Number) -> None:
    """Choose whether lines replace what they cross or are XORed with it.

    Args:
        mode: COPY_PUT or XOR_PUT; of any other number only the lowest bit counts.

    XORed twice, a line is gone. Works on lines, rectangles, polygons' outlines and thick curves;
    never on pixels, thin curves, fills and text.
    """
    current.screen.setwritemode(mode)
