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
from bgi.lab.drawn import (
    COMMON,
    INSTEAD,
    DrawingExercise,
    Evidence,
    Fault,
    Place,
    Sign,
    Trial,
    by_bgi,
    off_by_one,
    only,
)

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


def _gaps(evidence: Evidence) -> bool:
    """Steep lines have a pixel in every column, where there should be one in every row."""
    return evidence.always(
        lambda fault: _steep(fault) and len(fault.drawn) <= abs(_run(fault)[0]) + 1
    )


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
    return evidence.always(lambda fault: bool(fault.extra) and not fault.missing)


def _only_gentle_right(evidence: Evidence) -> bool:
    """The first octant is right, and most others are not."""
    wrong = {_octant(*_run(fault)) for fault in evidence.faults} - {None}
    return len(wrong) > 5 and _octant(9, 4) not in wrong


def _some_octants(evidence: Evidence) -> bool:
    wrong = {_octant(*_run(fault)) for fault in evidence.faults} - {None}
    return 0 < len(wrong) < 8


def _octant(dx: int, dy: int) -> tuple[bool, bool, bool] | None:
    """Which of the eight directions: steep, to the left, up; None on the borders between them."""
    if dx == 0 or dy == 0 or abs(dx) == abs(dy):
        return None
    return abs(dy) > abs(dx), dx < 0, dy < 0


SIGNS: list[Sign] = [
    *COMMON,
    (
        only(lambda fault: _run(fault) == (0, 0)),
        "a line from a point to itself is that one pixel",
    ),
    (
        only(lambda fault: _lacks(fault, 2)),
        "the last pixel is missing: both ends belong to a line, and range(a, b) stops before b",
    ),
    (only(lambda fault: _lacks(fault, 0)), "the first pixel is missing: set x1, y1 as well"),
    (_beyond, "the line goes on beyond its end: how many steps are there?"),
    (
        _only_backwards(0),
        "nothing is drawn from right to left: exchange the ends then, or step by -1",
    ),
    (_only_backwards(1), "nothing is drawn upwards: exchange the ends then, or step by -1"),
    (
        _gaps,
        "there are gaps where the line is steep: one pixel for each x is too few, step along y",
    ),
    (
        off_by_one,
        "off by one: the pixel nearest to the true line is wanted; int() cuts off, round() does not"
        ", and Bresenham's d begins with 2 * dy - dx",
    ),
    (_doubled, "there is more than one pixel for a step along the longer side"),
    (
        only(lambda fault: _run(fault)[0] == 0),
        "upright lines are wrong: x stays, y runs from y1 to y2",
    ),
    (only(lambda fault: _run(fault)[1] == 0), "level lines are wrong: y stays, x runs"),
    (
        _only_gentle_right,
        "only lines that go gently to the right and down are right: seven octants are missing."
        " Exchange x and y where a line is steep, and step by -1 where it goes left or up",
    ),
    (
        only(lambda fault: _steep(fault) and _run(fault)[0] != 0),
        "steep lines are wrong: exchange the roles of x and y there",
    ),
    (
        only(lambda fault: _run(fault)[1] < 0),
        "lines that go up are wrong: step along y by -1 there",
    ),
    (
        only(lambda fault: _run(fault)[0] < 0),
        "lines that go left are wrong: step along x by -1 there",
    ),
    (
        only(lambda fault: _run(fault)[0] * _run(fault)[1] < 0),
        "lines that go up to the right, and down to the left, are wrong: think of the step's sign",
    ),
    (_some_octants, "some of the eight octants are right, others are not"),
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
    )
