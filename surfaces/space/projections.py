"""The usual ways to draw space, as arrows for the one map: nothing but other numbers.

    name           x, y and z on the screen                                 lengths
    paper          the paper's: x down to the left, y right, z up           1 : 1 : 1
    cabinet        the same with x at half its length, as joiners draw      1/2 : 1 : 1
    military       the floor as on a map, turned by 45 degrees, z up        1 : 1 : 1
    isometric      seen straight along the diagonal of a cube               1 : 1 : 1
    dimetric       the engineer's: x short and steep, y nearly level        1/2 : 1 : 1
    top            as on a map: x right, y up, z toward the viewer          1 : 1 : 0
    front          from a little above: x right, y away                     1 : 1/4 : 0.97
    side           the same from the right: y right, x toward the viewer    1/4 : 1 : 0.97
    perspective    from near by: what is farther away is smaller            it depends

The first three are oblique: the lines of sight meet the paper aslant, so one face of a cube keeps
its shape, and a turning body seems to breathe. The others are orthographic, as a camera far away
sees it; `orthographic` gives all of these, and `perspective` what a camera near by sees.
"""

from __future__ import annotations

from math import asin, atan, cos, pi, sin, sqrt

from surfaces.space.mapping import Axonometry, Mapping, Projection
from surfaces.space.perspective import Perspective


def orthographic(azimuth: float, elevation: float) -> Axonometry:
    """The view from far away, straight at the surface.

    Args:
        azimuth: How far the eye is turned from the x axis toward y, in radians.
        elevation: How high it is above the floor, in radians; below zero it looks from below.

    Raises:
        ValueError: for an elevation of zero, where the floor is only a line, or beyond pi/2.
    """
    if not 0.0 < abs(elevation) <= pi / 2:
        raise ValueError(f"elevation must be from -pi/2 to pi/2 and not 0, not {elevation!r}")
    sa, ca, se, ce = sin(azimuth), cos(azimuth), sin(elevation), cos(elevation)
    return Axonometry(x=(-sa, se * ca), y=(ca, se * sa), z=(0.0, -ce))


HALF = sqrt(0.5)


def perspective(
    distance: float = 4.0, azimuth: float = pi / 4, elevation: float = 0.6
) -> Perspective:
    """The view of an eye near by, straight at the middle of the surface.

    Args:
        distance: How far the eye is from the middle, in the box that surfaces are fitted into: x
            and y are 2 wide there. Nearer shows more perspective; a large distance, almost none.
        azimuth: How far the eye is turned from the x axis toward y, in radians.
        elevation: How high it is above the floor, in radians; below zero it looks from below.

    Raises:
        ValueError: for a distance that is not above zero, or an elevation as in `orthographic`.
    """
    far = orthographic(azimuth, elevation)
    return Perspective(far.x, far.y, far.z, distance=distance)


PROJECTIONS: dict[str, Projection] = {
    "paper": Mapping(),
    "cabinet": Axonometry(x=(-HALF / 2, HALF / 2), y=(1.0, 0.0), z=(0.0, -1.0)),
    "military": Axonometry(x=(-HALF, HALF), y=(HALF, HALF), z=(0.0, -1.0)),
    "isometric": orthographic(pi / 4, atan(HALF)),
    # The two angles for which x is drawn half as long as y and z (ISO 5456-3).
    "dimetric": orthographic(asin(sqrt(1 / 8)), asin(1 / 3)),
    "top": orthographic(-pi / 2, pi / 2),
    "front": orthographic(-pi / 2, asin(1 / 4)),
    "side": orthographic(0.0, asin(1 / 4)),
    "perspective": perspective(),
}


def projection(view: str | Projection) -> Projection:
    """The projection of that name, or the one given; ValueError for an unknown name."""
    if isinstance(view, Projection):
        return view
    if not isinstance(view, str) or view not in PROJECTIONS:
        raise ValueError(f"projection must be one of {', '.join(PROJECTIONS)}, not {view!r}")
    return PROJECTIONS[view]
