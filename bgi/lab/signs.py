"""What mistakes look like that learners make in more than one drawing exercise."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from bgi.lab.drawn import Evidence, Fault, Place, Sign

Test = Callable[[Evidence], bool]

INSTEAD = "set the pixels by putpixel: the exercise is to find out which"


def nothing(evidence: Evidence) -> bool:
    """Nothing is drawn, ever: what is right needs nothing."""
    return evidence.mostly and evidence.always(lambda fault: not fault.drawn)


def _returned(evidence: Evidence) -> bool:
    """It answers instead."""
    return nothing(evidence) and evidence.always(lambda fault: fault.outcome.value is not None)


def _printed(evidence: Evidence) -> bool:
    return nothing(evidence) and evidence.always(lambda fault: bool(fault.outcome.printed.strip()))


def wrong_color(evidence: Evidence) -> bool:
    """All is in its place, but in another colour."""
    return evidence.always(lambda fault: fault.drawn == fault.wanted and bool(fault.recolored))


def transposed(evidence: Evidence) -> bool:
    """x and y are exchanged, as far as that can be seen on the screen."""

    def seems(fault: Fault) -> bool:
        there = {(y, x) for x, y in fault.wanted if x < 480}
        return len(there ^ fault.drawn) <= len(there) // 4

    return evidence.mostly and evidence.always(seems)


def _always_the_same(evidence: Evidence) -> bool:
    """What is drawn does not depend on the arguments."""
    first = evidence.faults[0].drawn
    return (
        evidence.mostly
        and len(evidence.faults) > 2
        and bool(first)
        and evidence.always(lambda fault: fault.drawn == first)
    )


COMMON: list[Sign] = [
    (_returned, "what it returns is not looked at: it must draw, by putpixel(x, y, color)"),
    (_printed, "it prints: putpixel(x, y, color) is what sets a pixel"),
    (nothing, "does it call putpixel(x, y, color)?"),
    (wrong_color, "give putpixel the colour that the function is given"),
    (transposed, "x and y are exchanged: putpixel(x, y, color), x to the right, y down"),
    (
        _always_the_same,
        "it draws the same each time: use the arguments that the function is given, no variables"
        " from outside",
    ),
]


def only(test: Callable[[Fault], bool]) -> Test:
    """A sign that every fault shows by itself."""
    return lambda evidence: evidence.always(test)


def first_about(*kinds: str) -> Test:
    """A sign: the first trial that goes wrong is of such a kind."""
    return lambda evidence: evidence.faults[0].trial.about in kinds


def off_by_one(evidence: Evidence) -> bool:
    """Pixels lie beside those that are expected."""

    def beside(fault: Fault) -> bool:
        return fault.missing <= around(fault.drawn) and fault.extra <= around(fault.wanted)

    return evidence.always(beside) and any(fault.extra for fault in evidence.faults)


def around(pixels: Iterable[Place]) -> set[Place]:
    """All pixels that touch one of these."""
    return {(x + dx, y + dy) for x, y in pixels for dx in (-1, 0, 1) for dy in (-1, 0, 1)}


def moved(flip: int) -> Test:
    """Everything is there, but elsewhere, by as much each time; upside down if `flip` is -1."""

    def seems(evidence: Evidence) -> bool:
        first = evidence.faults[0]
        if evidence.right or not first.drawn:
            return False
        (x1, y1), (x2, y2) = map(_corner, (_turned(first, flip), first.drawn))
        right, down = x2 - x1, y2 - y1
        return (right, down, flip) != (0, 0, 1) and evidence.always(
            lambda fault: _is_there(fault, flip, right, down)
        )

    return seems


def _turned(fault: Fault, flip: int) -> set[Place]:
    return {(x, flip * y) for x, y in fault.wanted}


def _corner(pixels: set[Place]) -> Place:
    return min(x for x, _ in pixels), min(y for _, y in pixels)


def _is_there(fault: Fault, flip: int, right: int, down: int) -> bool:
    """Whether what is wanted lies so much farther, as far as that is on the screen."""
    height, width = fault.got.shape
    there = {(x + right, y + down) for x, y in _turned(fault, flip)}
    seen = {(x, y) for x, y in there if 0 <= x < width and 0 <= y < height}
    return seen <= around(fault.drawn) and fault.drawn <= around(seen)


MOVED: list[Sign] = [
    (moved(1), "all is there, but elsewhere: is something added to x or y that is not asked for?"),
    (moved(-1), "it is upside down: 0, 0 is the upper left corner, and y grows downwards"),
]
