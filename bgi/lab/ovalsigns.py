"""The usual mistakes with circles and ellipses; circles too small to tell are left out."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import cos, sin

from bgi.lab.drawn import Evidence, Fault, Place, Sign
from bgi.lab.signs import COMMON, off_by_one, only

Test = Callable[[Fault], bool]

TELLING = 3
"""The radius from which on a mistake has a shape."""


def _every(test: Test) -> Callable[[Evidence], bool]:
    """Every fault that is large enough shows it."""

    def seems(evidence: Evidence) -> bool:
        large = [fault for fault in evidence.faults if min(_radii(fault)) >= TELLING]
        return all(map(test, large or evidence.faults))

    return seems


def _radii(fault: Fault) -> Place:
    radii = fault.arguments[2:-1]
    return radii[0], radii[-1]


def _around(fault: Fault, pixels: Iterable[Place]) -> set[Place]:
    """Pixels as they are seen from the centre."""
    x, y = fault.arguments[:2]
    return {(px - x, py - y) for px, py in pixels}


# On the curve, and near it


def _value(x: float, y: float, radii: Place) -> float:
    """Below 1 inside, above 1 outside."""
    rx, ry = (max(radius, 0.1) for radius in radii)
    return (x / rx) ** 2 + (y / ry) ** 2


def _meets(pixel: Place, radii: Place, low: float = -0.5, high: float = 0.5) -> bool:
    """Whether the curve goes through the square from pixel + low to pixel + high."""
    spans = [(v + low - 1e-9, v + high + 1e-9) for v in pixel]
    near, nearer = (0 if a < 0 < b else min(abs(a), abs(b)) for a, b in spans)
    far, farther = (max(abs(a), abs(b)) for a, b in spans)
    return _value(near, nearer, radii) <= 1 <= _value(far, farther, radii)


def _all_meet(fault: Fault, low: float = -0.5, high: float = 0.5) -> bool:
    return all(_meets(p, _radii(fault), low, high) for p in _around(fault, fault.drawn))


def _by_angles(fault: Fault) -> bool:
    """As it comes from x + radius cos, rounded: the curve goes through all pixels, and more."""
    return _all_meet(fault) and bool(fault.drawn)


def _cut_off(fault: Fault) -> bool:
    """The same, cut off: it lies up and to the left."""
    return bool(fault.extra) and _all_meet(fault, 0, 1)


def _in_degrees(fault: Fault) -> bool:
    """cos and sin were given degrees: the points of some such loop are there, exactly."""
    (x, y), (rx, ry) = fault.arguments[:2], _radii(fault)
    for cut in (round, int):
        for step in (1, 2, 5, 10):
            angles = range(0, 360, step)
            spots = {(cut(x + rx * cos(a)), cut(y + ry * sin(a))) for a in angles}
            if len(fault.drawn ^ spots) <= 1:  # the angle 360 may be one, too
                return True
    return False


def _thick(fault: Fault) -> bool:
    """Nothing is missing, and what is too much is near."""
    return not fault.missing and bool(fault.extra)


def _near(fault: Fault) -> bool:
    """Every pixel of a ring around the circle."""
    radius = _radii(fault)[0]
    extra = _around(fault, fault.extra)
    return not fault.missing and all(abs((x * x + y * y) ** 0.5 - radius) <= 0.5 for x, y in extra)


def _exactly(fault: Fault) -> bool:
    """Only what lies on the curve to the last digit."""
    rx, ry = _radii(fault)
    exact = {
        (x, y)
        for x, y in _around(fault, fault.wanted)
        if ry * ry * x * x + rx * rx * y * y == rx * rx * ry * ry
    }
    return _around(fault, fault.drawn) <= exact and 2 * len(exact) < len(fault.wanted)


def _filled(fault: Fault) -> bool:
    """Most of what lies inside is set."""
    rx, ry = _radii(fault)
    inside = [p for p in _around(fault, fault.drawn) if _value(*p, (rx, ry)) < 1]
    return len(inside) > 0.8 * 3.14 * (rx - 1) * (ry - 1) and len(inside) > len(fault.wanted) // 2


# Another one


def _same_as(change: Callable[[Fault], tuple[Place, Place]]) -> Callable[[Evidence], bool]:
    """What is drawn is another one: `change` says its centre and radii."""

    def seems(fault: Fault) -> bool:
        (cx, cy), radii = change(fault)
        if min(radii) < 1 or ((cx, cy), radii) == (fault.arguments[:2], _radii(fault)):
            return True  # too small to tell, or the same
        on = [p for p in fault.drawn if _meets((p[0] - cx, p[1] - cy), radii)]
        return 10 * len(on) >= 9 * len(fault.drawn) > 0

    return _every(seems)


def _one_place(evidence: Evidence) -> bool:
    """All are drawn around one place, though their centres differ."""
    faults = [fault for fault in evidence.faults if fault.drawn]
    middles = {
        tuple(min(side) + max(side) for side in zip(*fault.drawn, strict=True)) for fault in faults
    }
    return len(middles) == 1 and len({fault.arguments[:2] for fault in faults}) > 2


def _larger(by: int, times: float = 1) -> Callable[[Fault], tuple[Place, Place]]:
    def change(fault: Fault) -> tuple[Place, Place]:
        rx, ry = _radii(fault)
        return fault.arguments[:2], (int(rx * times) + by, int(ry * times) + by)

    return change


OTHERS: list[Sign] = [
    (
        _same_as(lambda fault: ((0, 0), _radii(fault))),
        "it is drawn around 0, 0: add the centre's x and y to every pixel",
    ),
    (_one_place, "it is always drawn around the same place: the centre is x, y, as they are given"),
    (
        _same_as(lambda fault: (fault.arguments[:2], (fault.arguments[-1],) * 2)),
        "it is as large as the colour's number: are radius and colour exchanged?",
    ),
    (_same_as(_larger(-1)), "the radius is too small by one: range(a, b) stops before b"),
    (_same_as(_larger(1)), "the radius is too large by one"),
    (_same_as(_larger(0, 2)), "it is twice as large: the radius goes from the centre to the rim"),
    (_same_as(_larger(0, 0.5)), "it is half as large: what is given is the radius, no diameter"),
]

# Parts that are missing


def _parts(pixels: set[Place], radii: Place) -> set[tuple[bool, ...]]:
    """The eighths in which pixels lie; those between two eighths are in none."""
    rx, ry = radii
    return {
        (dx < 0, dy < 0, ry * ry * abs(dx) < rx * rx * abs(dy))
        for dx, dy in pixels
        if dx and dy and ry * ry * abs(dx) != rx * rx * abs(dy)
    }


def _empty_parts(number: int) -> Callable[[Evidence], bool]:
    """So many eighths are empty at least, and nothing else is wrong."""

    def seems(fault: Fault) -> bool:
        drawn = _parts(_around(fault, fault.drawn), _radii(fault))
        wanted = _parts(_around(fault, fault.wanted), _radii(fault))
        return not fault.extra and len(wanted - drawn) >= min(number, len(wanted))

    return _every(seems)


def _other_parts(fault: Fault) -> bool:
    """Some eighths are right, and others are not."""
    radii = _radii(fault)
    wrong = _parts(_around(fault, fault.missing), radii)
    return bool(fault.extra) and bool(wrong) and wrong < _parts(_around(fault, fault.wanted), radii)


def _side(dx: int, dy: int) -> Callable[[Evidence], bool]:
    """All lies on one side of the centre."""
    return _every(
        lambda fault: (
            len(fault.drawn) > 2
            and all(x * dx + y * dy >= 0 for x, y in _around(fault, fault.drawn))
            and bool(fault.missing)
        )
    )


def _quarter(fault: Fault) -> bool:
    seen = _around(fault, fault.drawn) or {(0, 0)}
    across, down = ({(v > 0) - (v < 0) for v in side} - {0} for side in zip(*seen, strict=True))
    return len(across) == len(down) == 1


def _sides(points: str) -> list[Sign]:
    """For each half, that it is missing."""
    halves = {"left": (1, 0), "right": (-1, 0), "upper": (0, 1), "lower": (0, -1)}
    words = (
        f" half is missing: a computed point gives {points} pixels, a root has two signs, and an"
        " angle goes from 0 to 360 degrees"
    )
    return [(_side(*side), f"the {name}{words}") for name, side in halves.items()]


def _axes(fault: Fault) -> bool:
    """Only points right, left, above and below are missing."""
    missing = _around(fault, fault.missing)
    return bool(missing) and not fault.extra and all(dx == 0 or dy == 0 for dx, dy in missing)


def _corners(fault: Fault) -> bool:
    """Only the pixels on the diagonals are missing."""
    missing = _around(fault, fault.missing)
    return bool(missing) and not fault.extra and all(abs(dx) == abs(dy) for dx, dy in missing)


def _on_a_diagonal(fault: Fault) -> bool:
    return 1 <= len({x - y for x, y in fault.drawn}) <= 2


def _gaps(fault: Fault) -> bool:
    """Pixels are missing at the left and right sides only."""
    rx, ry = _radii(fault)
    missing = _around(fault, fault.missing)
    return not fault.extra and all(ry * ry * abs(dx) > rx * rx * abs(dy) for dx, dy in missing)


def _holes(evidence: Evidence) -> bool:
    """Pixels are missing all around, in large ones only."""
    smallest = min(max(_radii(fault)) for fault in evidence.faults)
    return evidence.always(lambda fault: not fault.extra) and smallest > 8


ANGLES: list[Sign] = [
    (_every(_on_a_diagonal), "it is a line: x goes with cos, y with sin"),
    (_every(_in_degrees), "cos and sin want radians: math.radians(degrees)"),
    (
        _every(_cut_off),
        "it lies up and to the left: int() cuts off, and so does putpixel with what is not whole;"
        " round() takes the nearest pixel",
    ),
]
STEPS = (
    "the steps of the angle do not fit: where they are too long there are gaps, where they are"
    " short some places get two pixels instead of one. "
)

NO_CIRCLE = (
    "it is no circle yet. In each step of the upper eighth x grows by one, and y stays or falls by"
    " one: by the midpoint's d, or as the root of radius**2 - x**2"
)
CIRCLE_SIGNS: list[Sign] = [
    *COMMON,
    (
        only(lambda fault: _radii(fault) == (0, 0)),
        "the circle of radius 0 is its centre: that one pixel",
    ),
    (_every(_exactly), "hardly a pixel lies exactly on the circle: the nearest ones are wanted"),
    (
        _empty_parts(6),
        "a symmetric part is missing: an eighth, or two, is there. Each point that you compute"
        " gives eight pixels: x and y, exchanged, and with either sign",
    ),
    *OTHERS,
    (
        _every(_quarter),
        "only a quarter is there: an angle goes from 0 to 360 degrees; or mirror each pixel",
    ),
    *_sides("eight"),
    (_empty_parts(1), "a symmetric part is missing: which of the eight putpixel calls has gone?"),
    (
        _every(_axes),
        "points straight above and below, or left and right, are missing: begin with x = 0, and"
        " end with the radius",
    ),
    (only(_corners), "the pixels on the diagonals are missing: go on while x <= y"),
    (_every(_filled), "the circle is filled: only its rim is wanted"),
    *ANGLES,
    (
        _every(_gaps),
        "there are gaps at the left and right sides: one pixel for each x is too few where the"
        " circle is steep; compute an eighth and mirror it",
    ),
    (_holes, "there are gaps in large circles: the step of the angle is too large for them"),
    (
        _every(_near),
        "it is thick in places: each step along an eighth has one pixel, the nearest of its"
        " column; not all that are near the circle",
    ),
    (_every(_by_angles), f"{STEPS}Compute an eighth instead, a pixel for each x, and mirror it"),
    (
        _every(_thick),
        "there are pixels too many: each step along an eighth has one pixel, and the eighth ends"
        " where x is y",
    ),
    (
        _every(_other_parts),
        "some of the symmetric parts are right, others are not: look at each of the putpixel"
        " calls. The centre's x belongs to the first argument, its y to the second",
    ),
    (
        off_by_one,
        "off by one: of two neighbours the nearer one is wanted; int() cuts off, round() does not."
        " The midpoint's d begins with 1 - radius, and grows by 2 * x + 3, or by 2 * (x - y) + 5,"
        " with x and y as they are before the step",
    ),
]


def _region(level: bool) -> Callable[[Evidence], bool]:
    """Of two regions one is missing: where the curve is more level, or where it is more upright."""

    def seems(fault: Fault) -> bool:
        rx, ry = _radii(fault)
        missing = _around(fault, fault.missing)
        there = [p for p in missing if (ry * ry * abs(p[0]) <= rx * rx * abs(p[1])) == level]
        return not fault.extra and 10 * len(there) >= 9 * len(missing) > 0

    return lambda evidence: not evidence.right and evidence.always(seems)


def _eightfold(fault: Fault) -> bool:
    """The ellipse is there, and another one that stands on end."""
    radii = _radii(fault)[::-1]
    extra = _around(fault, fault.extra)
    on = [pixel for pixel in extra if _meets(pixel, radii)]
    return not fault.missing and 10 * len(on) >= 9 * len(extra) > 0


NO_ELLIPSE = (
    "it is no ellipse yet: on it (x / rx)**2 + (y / ry)**2 is 1. The first region, a pixel for each"
    " x, ends where ry**2 * x >= rx**2 * y, not where x is y; the second one, a pixel for each y,"
    " has a d of its own to begin with"
)
ELLIPSE_SIGNS: list[Sign] = [
    *COMMON,
    (_every(_exactly), "hardly a pixel lies exactly on the ellipse: the nearest ones are wanted"),
    (
        _same_as(lambda fault: (fault.arguments[:2], _radii(fault)[::-1])),
        "the radii are exchanged: the first one goes to the right, the second one down",
    ),
    (
        _same_as(lambda fault: (fault.arguments[:2], (_radii(fault)[0],) * 2)),
        "it is a circle: the second radius, which goes down, is not used",
    ),
    (
        _every(_axes),
        "points straight above and below, or left and right, are missing: begin with x = 0, and"
        " end with y = 0",
    ),
    (
        _region(level=False),
        "the sides are missing, or have gaps: where the ellipse is steep, step along y; that is the"
        " second region",
    ),
    (
        _region(level=True),
        "top and bottom are missing, or have gaps: where the ellipse is level, step along x; that"
        " is the first region",
    ),
    *OTHERS,
    (
        _every(_quarter),
        "only a quarter is there: each point that you compute gives four pixels; an angle goes"
        " from 0 to 360 degrees",
    ),
    *_sides("four"),
    (_empty_parts(2), "a symmetric part is missing: each point that you compute gives four pixels"),
    (_every(_filled), "the ellipse is filled: only its rim is wanted"),
    (
        _every(_eightfold),
        "an ellipse has four symmetric points, not eight: x and y stay as they are",
    ),
    *ANGLES,
    (_holes, "there are gaps in large ellipses: the step of the angle is too large for them"),
    (
        _every(_by_angles),
        f"{STEPS}Step along x where the ellipse is level, and along y where it is steep",
    ),
    (_every(_thick), "there are pixels too many: each step along a region has one pixel"),
    (
        off_by_one,
        "off by one: of two neighbours the nearer one is wanted; int() cuts off, round() does not,"
        " and each region has a d of its own to begin with",
    ),
]
