"""Filled shapes, in the fill pattern and colour of setfillstyle().

Patterns are opaque (their gaps become index 0) and anchored to the screen, so that neighbouring
fills join without a seam. Fills ignore the write mode.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

from collections.abc import Sequence

from bgi import current
from bgi.kernel.arguments import Number, Numbers
from bgi.settings import fillsettingstype

# fmt: off
__all__ = [
    "setfillstyle", "getfillsettings", "setfillpattern", "getfillpattern",
    "bar", "bar3d", "fillpoly", "floodfill",
]
# fmt: on


def setfillstyle(pattern: Number, color: Number) -> None:
    """Choose pattern and colour of fills.

    Args:
        pattern: EMPTY_FILL (0), SOLID_FILL (1) ... CLOSE_DOT_FILL (11); a pattern of your own is
            set by setfillpattern().
        color: 0..getmaxcolor(); more bits than the mode has are cut off.

    graphresult() says -11, and nothing changes, for any other pattern.
    """
    current.screen.setfillstyle(pattern, color)


def getfillsettings() -> fillsettingstype:
    """Return fill pattern (12 after setfillpattern) and colour, as given."""
    return current.screen.getfillsettings()


def setfillpattern(pattern: bytes | Sequence[Number], color: Number) -> None:
    """Fill with a pattern of your own.

    Args:
        pattern: eight bytes, the top row first, its highest bit leftmost.
        color: 0..getmaxcolor().

    graphresult() says -11, and nothing changes, for an unknown colour; ValueError for more or less
    than eight numbers. Of each the low byte counts.
    """
    current.screen.setfillpattern(pattern, color)


def getfillpattern() -> bytes:
    """Return the eight bytes last given to setfillpattern(), at first all FF."""
    return current.screen.getfillpattern()


def bar(
    left: Numbers, top: Numbers, right: Numbers, bottom: Numbers, fill: Numbers | None = None
) -> None:
    """Fill a box, without an outline; its corners in any order.

    Args:
        left, top, right, bottom: two opposite corners, relative to the viewport, both filled.
        fill: this box's fill colour; that of setfillstyle() if None.

    EMPTY_FILL erases to index 0. Leaves the current position. Arrays fill many boxes.
    """
    current.screen.bar(left, top, right, bottom, fill)


def bar3d(
    left: Numbers,
    top: Numbers,
    right: Numbers,
    bottom: Numbers,
    depth: Numbers,
    topflag: Numbers,
) -> None:
    """Fill a box, outline it, and draw its right side and top in depth.

    Args:
        left, top, right, bottom: two opposite corners, relative to the viewport. One below 0 counts
            as the right or the lower one, as in the original.
        depth: how far the back lies to the right, in pixels, and 3/4 of that up; 0 draws no side.
            Of a negative one the back lies far above the screen.
        topflag: 1 to draw the top, 0 to leave room for a bar on top of it.

    Outlined as by line(); side and top are not filled. Arrays draw many.
    """
    current.screen.bar3d(left, top, right, bottom, depth, topflag)


def fillpoly(
    points: Numbers,
    flat: Numbers | None = None,
    fill: Numbers | None = None,
    color: Numbers | None = None,
) -> None:
    """Fill a polygon and draw its outline; it is closed for you.

    Args:
        points: [(x, y), ...], an array of shape (k, 2), or a flat list x, y, x, y, ...; shape
            (n, k, 2) means n polygons. As in C: the number of points, followed by `flat`.
        fill: the fill colour, or n of them; that of setfillstyle() if None.
        color: the outline's colour, or n of them; the drawing colour if None; 0 draws none (16,
            though, draws it in index 0).

    Even-odd rule; back at its first point the figure ends, and the next point begins another.
    Rows are filled from the topmost to the one above the lowest, both ends included, so that a
    pixel may stick out of the outline, as in the original. EMPTY_FILL fills nothing. The outline
    is drawn as by line(). ValueError, and nothing is drawn, for more than 16,777,216 numbers.
    """
    current.screen.fillpoly(points, flat, fill, color)


def floodfill(x: Numbers, y: Numbers, border: Numbers) -> None:
    """Fill the area around a point in the fill pattern, up to a border of one colour.

    Args:
        x, y: the point, relative to the viewport; nothing happens outside it or on the border.
        border: the colour that stops the filling; any other colour is painted over.

    Spreads up, down, left and right, within the viewport (with clipping off, the screen). What
    looks filled already stops it too, as in the original, and a way on is not looked for in the
    first and the last column. But its shape may be anything: there is no limit of memory.
    """
    current.screen.floodfill(x, y, border)
