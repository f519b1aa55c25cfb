"""Circles, ellipses, arcs and pies.

Angles are whole degrees, 0 at three o'clock, growing counter-clockwise; give 0..360, for what a
negative one means is not the same everywhere. The line style is ignored; the width is honoured, the
write mode only by thick curves. circle(), arc() and pieslice() take one radius, in pixels across,
and flatten the curve by the mode's aspect ratio; the others take both radii as they are. A circle
of radius 0 is drawn like 1; negative radii, and those above 6553, draw nothing. Arrays draw many.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

from bgi import current
from bgi.kernel.arguments import Number, Numbers
from bgi.settings import arccoordstype

# fmt: off
__all__ = [
    "circle", "arc", "ellipse", "getarccoords",
    "fillellipse", "pieslice", "sector",
    "setaspectratio", "getaspectratio",
]
# fmt: on


def circle(x: Numbers, y: Numbers, radius: Numbers, color: Numbers | None = None) -> None:
    """Draw a circle.

    Args:
        x, y: its centre, relative to the viewport.
        radius: in pixels across; the height follows the mode's aspect ratio, so that it looks
            round. 0 is drawn like 1; nothing for a negative radius, or one above 6553.
        color: this circle's colour; the drawing colour if None.

    Ignores the line style; honours the width, and the write mode only when thick. Arrays draw many.
    """
    current.screen.circle(x, y, radius, color)


def arc(
    x: Numbers,
    y: Numbers,
    stangle: Numbers,
    endangle: Numbers,
    radius: Numbers,
    color: Numbers | None = None,
) -> None:
    """Draw a part of a circle, counter-clockwise from one angle to another.

    Args:
        x, y: the centre, relative to the viewport.
        stangle, endangle: degrees; the arc passes through 0 if endangle is the lesser one. Nothing
            is drawn from -1.
        radius: in pixels across; the height follows the aspect ratio.
        color: this arc's colour; the drawing colour if None.

    0 to 360 is the full circle; equal angles draw nothing. A thick arc is the full circle also for
    equal angles, and from a negative angle to 0 or more. getarccoords() returns the ends.
    """
    current.screen.arc(x, y, stangle, endangle, radius, color)


def ellipse(
    x: Numbers,
    y: Numbers,
    stangle: Numbers,
    endangle: Numbers,
    xradius: Numbers,
    yradius: Numbers,
    color: Numbers | None = None,
) -> None:
    """Draw an ellipse, 0 to 360, or a part of one.

    Args:
        x, y: the centre, relative to the viewport.
        stangle, endangle: degrees on the circle that was flattened, as for arc().
        xradius, yradius: in pixels, not changed by the aspect ratio.
        color: this curve's colour; the drawing colour if None.

    getarccoords() returns its ends.
    """
    current.screen.ellipse(x, y, stangle, endangle, xradius, yradius, color)


def fillellipse(x: Numbers, y: Numbers, xradius: Numbers, yradius: Numbers) -> None:
    """Fill an ellipse in the fill pattern and draw its outline in the drawing colour.

    Args:
        x, y: the centre, relative to the viewport.
        xradius, yradius: in pixels, not changed by the aspect ratio.

    EMPTY_FILL erases the inside to index 0.
    """
    current.screen.fillellipse(x, y, xradius, yradius)


def pieslice(x: Numbers, y: Numbers, stangle: Numbers, endangle: Numbers, radius: Numbers) -> None:
    """Fill a slice of a circle in the fill pattern and draw its outline in the drawing colour.

    Args:
        x, y: the centre, relative to the viewport.
        stangle, endangle: degrees, from the lesser to the greater one in either order. A negative
            one is 65536 more: write 270, not -90, which is 286.
        radius: in pixels across; the height follows the aspect ratio.

    The arc is drawn by lines of the line style, so that a dotted style leaves it out; equal angles
    leave a dot. EMPTY_FILL fills nothing. getarccoords() returns its ends.
    """
    current.screen.pieslice(x, y, stangle, endangle, radius)


def sector(
    x: Numbers,
    y: Numbers,
    stangle: Numbers,
    endangle: Numbers,
    xradius: Numbers,
    yradius: Numbers,
) -> None:
    """Fill a slice of an ellipse in the fill pattern and draw its outline.

    Args:
        x, y: the centre, relative to the viewport.
        stangle, endangle: degrees, as for pieslice().
        xradius, yradius: in pixels, not changed by the aspect ratio.

    Otherwise as pieslice().
    """
    current.screen.sector(x, y, stangle, endangle, xradius, yradius)


def getarccoords() -> arccoordstype:
    """Return centre, start and end of the last arc, circle, ellipse, pie slice or sector.

    Relative to the viewport it was drawn in; all 0 at first. A thick arc, or one of no angle, moves
    only the centre, and start and end with it. Nothing resets them.
    """
    return current.screen.getarccoords()


def getaspectratio() -> tuple[int, int]:
    """Return the aspect ratio of circles, (xasp, yasp): 10000, 10000 where pixels are square."""
    return current.screen.getaspectratio()


def setaspectratio(xasp: Number, yasp: Number) -> None:
    """Set the aspect ratio of circles from now on: a circle is radius * xasp / yasp high.

    Args:
        xasp, yasp: 0 or more, and more than 0.

    graphresult() says -11, and nothing changes, for anything else. graphdefaults() leaves it, a
    new mode resets it.
    """
    current.screen.setaspectratio(xasp, yasp)
