"""Lines: which pixels a line may have, the lines to try, and the mistakes that are made with them.

The rule: of each column of a line that is more level than upright, and of each row of another one,
the pixel that is nearest to the true line, both ends included. Where the true line passes exactly
between two pixels either will do; so DDA, midpoint and Bresenham are all right, from either end.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from bgi.graphics import Graphics
from bgi.lab.comparison import Pixels
from bgi.lab.drawn import DrawingExercise, Evidence, Fault, Place, Sign, Trial, by_bgi
from bgi.lab.signs import COMMON, INSTEAD, MOVED, around, off_by_one, only

NAMES = "x1", "y1", "x2", "y2", "color"

Ends = tuple[int, int, int, int]


def steps(x1: int, y1: int, x2: int, y2: int) -> Iterator[tuple[Place, ...]]:
    """The pixel of each step along the longer axis; two of them where both are as near."""
    dx, dy = x2 - x1, y2 - y1
    length, height = max(abs(dx), abs(dy)), min(abs(dx), abs(dy))
    right, down = (dx > 0) - (dx < 0), (dy > 0) - (dy < 0)
    for step in range(length + 1):
        across, rest = divmod(2 * height * step + length, 2 * length or 1)
        tie = (across, across - 1) if step and rest == 0 and height else (across,)
        if abs(dx) >= abs(dy):
            yield tuple((x1 + right * step, y1 + down * one) for one in tie)
        else:
            yield tuple((x1 + right * one, y1 + down * step) for one in tie)


def _nearest(ends: Ends, color: int) -> Callable[[Pixels], Pixels]:
    def expected(got: Pixels) -> Pixels:
        picture = np.zeros_like(got)
        for choice in steps(*ends):
            x, y = next(((x, y) for x, y in choice if got[y, x]), choice[0])
            picture[y, x] = color
        return picture

    return expected


SIDE = 6
"""The short lines to try go so far, in every direction."""
LONG = 60
"""So many lines go anywhere."""


def _ends() -> Iterator[Ends]:
    """The lines to try, easy ones first."""
    for dx, dy in ((9, 0), (0, 9), (6, 6), (9, 4), (4, 9), (0, 0)):
        yield 20, 30, 20 + dx, 30 + dy
    for dx, dy in ((9, -4), (4, -9), (-9, 4), (-4, 9), (-9, -4), (-4, -9), (-9, 0), (0, -9)):
        yield 60, 30, 60 + dx, 30 + dy
    for dx in range(-SIDE, SIDE + 1):
        for dy in range(-SIDE, SIDE + 1):
            yield 100, 50, 100 + dx, 50 + dy
    chance = random.Random(1)
    for _ in range(LONG):
        x1, x2 = chance.randrange(640), chance.randrange(640)
        yield x1, chance.randrange(480), x2, chance.randrange(480)


def _trials(exactly: bool) -> Iterator[Trial]:
    for number, ends in enumerate(_ends()):
        color = 15 - number % 15
        if exactly:
            expected = by_bgi(partial(_line, ends=ends, color=color))
        else:
            expected = _nearest(ends, color)
        yield Trial((*ends, color), expected)


def _line(screen: Graphics, ends: Ends, color: int) -> None:
    screen.line(*ends, color)


# The signs


def _run(fault: Fault) -> Place:
    x1, y1, x2, y2, _ = fault.arguments
    return x2 - x1, y2 - y1


def _steep(fault: Fault) -> bool:
    dx, dy = _run(fault)
    return abs(dy) > abs(dx)


def _lacks(fault: Fault, end: int) -> bool:
    """Nothing but one end is wrong: 0 is the first one, 2 the second."""
    x, y = fault.arguments[end : end + 2]
    return fault.missing == {(x, y)} and not fault.extra and not fault.recolored


def _only_backwards(axis: int) -> Callable[[Evidence], bool]:
    """Hardly anything is drawn where the second end is left of the first one, or above it."""
    return lambda evidence: evidence.always(
        lambda fault: _run(fault)[axis] < 0 and len(fault.drawn) <= 1
    )


def _is_right(fault: Fault) -> bool:
    """It is a right line, where exactly that of bgi is wanted."""
    *ends, color = fault.arguments
    x1, y1, x2, y2 = ends
    return np.array_equal(fault.got, _nearest((x1, y1, x2, y2), color)(fault.got))


def _gaps(evidence: Evidence) -> bool:
    """Steep lines have a pixel in every column, where there should be one in every row."""
    return evidence.always(
        lambda fault: (
            _steep(fault) and not fault.extra and len(fault.drawn) <= abs(_run(fault)[0]) + 1
        )
    )


def _too_few(evidence: Evidence) -> bool:
    """What is there is right, or nearly."""
    return len(evidence.faults[0].missing) > 1 and evidence.always(
        lambda fault: len(fault.drawn) < len(fault.wanted) and fault.extra <= around(fault.wanted)
    )


def _where(test: Callable[[Fault], bool]) -> Callable[[Evidence], bool]:
    """Lines of one kind are wrong, and no others."""
    return lambda evidence: len(evidence.faults) > 1 and evidence.always(test)


def _lacks_ends(fault: Fault) -> bool:
    """Nothing but ends is missing."""
    ends = {fault.arguments[:2], fault.arguments[2:4]}
    return bool(fault.missing) and fault.missing <= ends and not fault.extra


def _short_backwards(fault: Fault) -> bool:
    """The last two pixels are missing where it goes left or up."""
    x2, y2 = fault.arguments[2:4]
    near = all(max(abs(x - x2), abs(y - y2)) <= 1 for x, y in fault.missing)
    return near and bool(fault.missing) and not fault.extra and min(_run(fault)) < 0


def _beyond(evidence: Evidence) -> bool:
    """The line goes on where it should end."""

    def outside(fault: Fault) -> bool:
        x1, y1, x2, y2, _ = fault.arguments
        return bool(fault.extra) and all(
            not (min(x1, x2) <= x <= max(x1, x2) and min(y1, y2) <= y <= max(y1, y2))
            for x, y in fault.extra
        )

    return evidence.always(lambda fault: outside(fault) and not fault.missing)


def _doubled(evidence: Evidence) -> bool:
    """More pixels than steps, all near the line."""
    return (
        evidence.always(lambda fault: len(fault.drawn) >= len(fault.wanted))
        and evidence.always(lambda fault: fault.missing <= around(fault.drawn))
        and sum(len(fault.drawn) > len(fault.wanted) for fault in evidence.faults)
        > 0.8 * len(evidence.faults)
    )


def _whole_steps(evidence: Evidence) -> bool:
    """Only straight or diagonal runs, where the line is neither."""

    def seems(fault: Fault) -> bool:
        kinds = {x for x, _ in fault.drawn}, {y for _, y in fault.drawn}
        slopes = {x - y for x, y in fault.drawn}, {x + y for x, y in fault.drawn}
        return len(fault.drawn) > 1 and 1 in map(len, (*kinds, *slopes))

    return evidence.always(lambda fault: _octant(*_run(fault)) is not None and seems(fault))


def _is_line(fault: Fault, *ends: int) -> bool:
    """Whether it is, more or less, the line between other ends, as far as that can be seen."""
    height, width = fault.got.shape
    spots = {choice[0] for choice in steps(*ends)}
    seen = {(x, y) for x, y in spots if 0 <= x < width and 0 <= y < height}
    return seen <= around(fault.drawn) and fault.drawn <= around(seen)


def _crossed(fault: Fault) -> bool:
    """It goes from x2, y1 to x1, y2."""
    x1, y1, x2, y2, _ = fault.arguments
    return _is_line(fault, x2, y1, x1, y2)


def _mirrored(evidence: Evidence) -> bool:
    """Every line that is not level goes up instead of down."""
    level = all(trial.arguments[1] == trial.arguments[3] for trial in evidence.right)

    def seems(fault: Fault) -> bool:
        x1, y1, x2, y2, _ = fault.arguments
        return _is_line(fault, x1, y1, x2, 2 * y1 - y2)

    return level and evidence.always(seems)


def _upturned(fault: Fault) -> bool:
    """dx / dy is taken for the slope."""
    x1, y1, x2, y2, _ = fault.arguments
    if y1 == y2 or not fault.drawn:
        return False
    slope = (x2 - x1) / (y2 - y1)
    return any(
        all(abs(top + slope * (x - left) - y) <= 1 for x, y in fault.drawn)
        for left, top in ((x1, y1), (x2, y2))
    )


def _from_zero(fault: Fault) -> bool:
    """The shorter side's start is not added, or no start is."""
    x1, y1, x2, y2, _ = fault.arguments
    dx, dy = x2 - x1, y2 - y1
    others = (0, 0, dx, dy), (x1, 0, x2, dy), (0, y1, dx, y2), (x2, 0, x1, -dy), (0, y2, -dx, y1)
    return any(_is_line(fault, *ends) for ends in others)


def _only_gentle_right(evidence: Evidence) -> bool:
    """The first octant is right, and no other one is."""
    wrong = {_octant(*_run(fault)) for fault in evidence.faults} - {None}
    return len(wrong) == 7 and _octant(9, 4) not in wrong


def _some_octants(evidence: Evidence) -> bool:
    wrong = {_octant(*_run(fault)) for fault in evidence.faults} - {None}
    return len(evidence.faults) > 1 and 0 < len(wrong) < 8


def _octant(dx: int, dy: int) -> tuple[bool, bool, bool] | None:
    """Which of the eight directions: steep, to the left, up; None on the borders between them."""
    if dx == 0 or dy == 0 or abs(dx) == abs(dy):
        return None
    return abs(dy) > abs(dx), dx < 0, dy < 0


OTHERWISE = (
    "it is another line. Along the longer side there are max(abs(dx), abs(dy)) steps of one pixel;"
    " after a step aside Bresenham's d gets smaller by twice the longer side"
)
SIGNS: list[Sign] = [
    *COMMON,
    (
        only(_is_right),
        "the line is right, but not bgi's: where two pixels are as near, which one is taken, and"
        " from which end is it drawn?",
    ),
    (
        only(lambda fault: _run(fault) == (0, 0)),
        "a line from a point to itself is that one pixel",
    ),
    (
        only(lambda fault: _lacks(fault, 2)),
        "the last pixel is missing: both ends belong to a line, and range(a, b) stops before b",
    ),
    (only(lambda fault: _lacks(fault, 0)), "the first pixel is missing: set x1, y1 as well"),
    (
        only(_lacks_ends),
        "an end is missing: both belong to a line, and range(a, b) stops before b",
    ),
    (_beyond, "the line goes on beyond its end: how many steps are there?"),
    (
        _only_backwards(0),
        "nothing is drawn from right to left: exchange the ends then, or step by -1",
    ),
    (_only_backwards(1), "nothing is drawn upwards: exchange the ends then, or step by -1"),
    (
        only(_short_backwards),
        "where it goes left or up the last pixels are missing: range(x1, x2 - 1, -1) ends at x2",
    ),
    (
        _where(lambda fault: _run(fault)[0] == 0),
        "upright lines are wrong: x stays, y runs from y1 to y2",
    ),
    (_where(lambda fault: _run(fault)[1] == 0), "level lines are wrong: y stays, x runs"),
    (
        _gaps,
        "there are gaps where the line is steep: one pixel for each x is too few, step along y",
    ),
    (
        _too_few,
        "there are gaps: the number of steps is the longer of both sides, max(abs(dx), abs(dy))",
    ),
    (
        _doubled,
        "there is more than one pixel for a step along the longer side: the number of steps is"
        " max(abs(dx), abs(dy))",
    ),
    (
        _whole_steps,
        "only level, upright and diagonal steps are made: divide by /, not //; x and y grow by"
        " parts of a pixel, and are rounded only for putpixel",
    ),
    *MOVED,
    (
        off_by_one,
        "off by one: the pixel nearest to the true line is wanted. int() cuts off, and so does"
        " putpixel: round(). Bresenham's d begins with 2 * dy - dx",
    ),
    (
        _only_gentle_right,
        "only lines that go gently to the right and down are right: seven octants are missing."
        " Exchange x and y where a line is steep, and step by -1 where it goes left or up",
    ),
    (
        only(_crossed),
        "it joins other corners: x1 belongs to y1, and x2 to y2. Who exchanges x1 and x2 must"
        " exchange y1 and y2 with them",
    ),
    (
        only(_upturned),
        "the slope is upside down: (y2 - y1) / (x2 - x1) for each x",
    ),
    (_mirrored, "it goes up where it should go down: y grows downwards, and is added"),
    (only(_from_zero), "it begins at 0: the steps are counted from x1 and y1, add these"),
    (
        _where(_steep),
        "steep lines are wrong: exchange the roles of x and y there, and exchange them back for"
        " putpixel",
    ),
    (
        _where(lambda fault: _run(fault)[1] < 0),
        "lines that go up are wrong: step along y by -1 there",
    ),
    (
        _where(lambda fault: _run(fault)[0] < 0),
        "lines that go left are wrong: step along x by -1 there",
    ),
    (
        _where(lambda fault: _run(fault)[0] * _run(fault)[1] < 0),
        "lines that go up to the right, and down to the left, are wrong: think of the step's sign",
    ),
    (
        _some_octants,
        "some of the eight octants are right, others are not. Is the line steep? Does it go left,"
        " or up? Then its step along x or y is -1",
    ),
]


def _trouble(fault: Fault) -> str:
    assert fault.outcome.trouble is not None
    dx, dy = _run(fault)
    error = fault.outcome.trouble.error
    if isinstance(error, ZeroDivisionError):
        if (dx, dy) == (0, 0):
            return "a line from a point to itself is one pixel: there is nothing to divide by"
        side = "an upright line: x2 - x1" if dx == 0 else "a level line: y2 - y1"
        return f"{side} is 0, and nothing can be divided by 0: treat it by itself"
    if fault.outcome.trouble.kind == "endless":
        if dx < 0 or dy < 0:
            return "it steps away from the second end: where that is left or above, step by -1"
        return (
            "the loop's end is never met: count the steps, and do not ask whether a float == x2"
            if fault.drawn
            else ""
        )
    return ""


def exercise(exactly: bool) -> DrawingExercise:
    """Lines; exactly those of bgi, or any that are right."""
    return DrawingExercise(
        name="line",
        parameters=NAMES,
        trials=partial(_trials, exactly),
        signs=SIGNS,
        troubles=_trouble,
        instead=INSTEAD,
        otherwise=OTHERWISE,
    )
