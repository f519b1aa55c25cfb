"""Areas filled from a place inside: what is right, what is tried, and the usual mistakes.

Neighbours are the four pixels right, left, above and below, as for `floodfill`: a thin circle,
whose pixels touch at their corners only, keeps a fill inside.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from bgi.constants import SOLID_FILL, WHITE
from bgi.graphics import Graphics
from bgi.lab.comparison import Pixels
from bgi.lab.drawn import DrawingExercise, Evidence, Fault, Sign, Trial, by_bgi
from bgi.lab.signs import COMMON, around, first_about
from bgi.lab.supervision import DEEPEST

Draw = Callable[[Graphics], None]

BORDER, INSIDE = WHITE, 2
DEEP = 500
"""Calls inside each other: more are too many, for Python allows a thousand."""
LARGE = 60
"""Pixels across the area that is too large for a function that calls itself for each pixel."""


def filled(picture: Pixels, x: int, y: int, color: int, stops: Callable[[int], bool]) -> Pixels:
    """The same with an area filled: from x, y on to all neighbours where nothing stops it."""
    found = picture.copy()
    height, width = found.shape
    waiting = [(x, y)]
    seen = set(waiting)
    while waiting:
        x, y = waiting.pop()
        if stops(int(picture[y, x])):
            continue
        found[y, x] = color
        for place in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if 0 <= place[0] < width and 0 <= place[1] < height and place not in seen:
                seen.add(place)
                waiting.append(place)
    return found


# What is drawn before


def _outline(points: list[tuple[int, int]], screen: Graphics) -> None:
    screen.drawpoly([*points, points[0]], None, BORDER)


def _box(side: int, screen: Graphics) -> None:
    screen.rectangle(30, 20, 31 + side, 21 + side, BORDER)


def _circle(screen: Graphics) -> None:
    screen.circle(40, 40, 8, BORDER)


def _island(screen: Graphics) -> None:
    _box(14, screen)
    screen.rectangle(35, 25, 39, 28, BORDER)


def _picture(screen: Graphics) -> None:
    _box(12, screen)
    screen.setfillstyle(SOLID_FILL, INSIDE)
    screen.bar(34, 24, 37, 30)


def _corner(screen: Graphics) -> None:
    """The upper left corner of the screen, cut off."""
    screen.line(0, 12, 14, 12, BORDER)
    screen.line(14, 0, 14, 12, BORDER)


def _far_corner(screen: Graphics) -> None:
    screen.line(628, 468, 639, 468, BORDER)
    screen.line(628, 468, 628, 479, BORDER)


def _patch(screen: Graphics) -> None:
    """An area of one colour among others, without a border."""
    screen.setfillstyle(SOLID_FILL, 3)
    screen.bar(15, 15, 40, 40)
    screen.setfillstyle(SOLID_FILL, INSIDE)
    screen.bar(20, 20, 30, 29)
    screen.bar(31, 30, 36, 36)  # touches at a corner only
    screen.setfillstyle(SOLID_FILL, 5)
    screen.bar(22, 22, 24, 24)


WAYS = [(20, 20), (34, 20), (34, 34), (20, 34), (20, 30), (30, 30), (30, 24), (20, 24)]
STAIRS = [(20, 20), (24, 20), (24, 24), (28, 24), (28, 28), (32, 28), (32, 36), (20, 36)]

PLACES: list[tuple[str, int, int, Draw]] = [
    ("plain", 35, 25, partial(_box, 8)),
    ("plain", 31, 21, partial(_box, 8)),
    ("plain", 38, 28, partial(_box, 8)),
    ("plain", 31, 21, partial(_box, 1)),
    ("winding", 22, 22, partial(_outline, WAYS)),
    ("winding", 22, 32, partial(_outline, WAYS)),
    ("winding", 30, 34, partial(_outline, STAIRS)),
    ("island", 32, 22, _island),
    ("thin", 40, 40, _circle),
    ("edge", 5, 5, _corner),
    ("edge", 0, 0, _corner),
    ("edge", 635, 475, _far_corner),
]
"""What is special, where to begin, and what is drawn before."""


def _again(draw: Draw, x: int, y: int, color: int, screen: Graphics) -> None:
    """The same, filled already."""
    draw(screen)
    screen.setfillstyle(SOLID_FILL, color)
    screen.floodfill(x, y, BORDER)


def _boundary_trials(deep: bool) -> Iterator[Trial]:
    places: list[tuple[str, int, int, Draw]] = [
        *PLACES,
        ("picture", 32, 22, _picture),
        ("picture", 35, 25, _picture),
        ("on the border", 30, 25, partial(_box, 8)),
        *([("large", 50, 50, partial(_box, LARGE))] if deep else []),
    ]
    for number, (about, x, y, draw) in enumerate(places):
        color = (4, 9, 14)[number % 3]
        yield _boundary_trial(about, x, y, color, draw)
    yield _boundary_trial("again", 35, 25, 4, partial(_again, partial(_box, 8), 35, 25, 4))


def _boundary_trial(about: str, x: int, y: int, color: int, draw: Draw) -> Trial:
    return Trial(
        (x, y, color, BORDER),
        partial(_after, draw, x, y, color, lambda found: found in (BORDER, color)),
        draw,
        DEEP if about == "large" else DEEPEST,
        about,
    )


def _flood_trials(deep: bool) -> Iterator[Trial]:
    places: list[tuple[str, int, int, Draw]] = [
        *PLACES,
        ("picture", 21, 21, _patch),
        ("picture", 33, 33, _patch),
        ("picture", 23, 23, _patch),
        *([("large", 50, 50, partial(_box, LARGE))] if deep else []),
    ]
    for number, (about, x, y, draw) in enumerate(places):
        color = (4, 9, 14)[number % 3]
        yield _flood_trial(about, x, y, color, draw)
    yield _flood_trial("again", 21, 21, INSIDE, _patch)
    yield _flood_trial("again", 35, 25, 0, partial(_box, 8))


def _flood_trial(about: str, x: int, y: int, color: int, draw: Draw) -> Trial:
    return Trial(
        (x, y, color),
        partial(_after, draw, x, y, color, None),
        draw,
        DEEP if about == "large" else DEEPEST,
        about,
    )


def _after(
    draw: Draw, x: int, y: int, color: int, stops: Callable[[int], bool] | None, got: Pixels
) -> Pixels:
    """What should be there: of one colour alone if nothing else stops it."""
    before = by_bgi(draw)(got)
    old = int(before[y, x])
    return filled(before, x, y, color, stops or (lambda found: found != old))


# The signs


def _seed_only(evidence: Evidence) -> bool:
    return evidence.always(lambda fault: len(fault.drawn) == 1)


def _one_line(evidence: Evidence) -> bool:
    """What is filled lies in one row or one column."""

    def seems(fault: Fault) -> bool:
        across, down = zip(*fault.drawn, strict=True) if fault.drawn else ((), ())
        return min(len(set(across)), len(set(down))) == 1 < len(fault.missing)

    return evidence.always(seems)


def _half(dx: int, dy: int) -> Callable[[Evidence], bool]:
    """All that is missing lies on one side of the place."""

    def seems(fault: Fault) -> bool:
        x, y, *_ = fault.arguments
        return not fault.extra and all(
            (px - x) * dx + (py - y) * dy > 0 for px, py in fault.missing
        )

    return _plain(seems)


def _plain(test: Callable[[Fault], bool]) -> Callable[[Evidence], bool]:
    """A sign that the first fault shows, if it is in a plain box, and pixels are missing there."""
    return lambda evidence: (
        first_about("plain")(evidence)
        and bool(evidence.faults[0].missing)
        and test(evidence.faults[0])
    )


def _two_ways(fault: Fault) -> bool:
    """All that is filled lies in one quarter, seen from the place."""
    x, y, *_ = fault.arguments
    seen = [(px - x, py - y) for px, py in fault.drawn]
    return bool(seen) and any(
        all(dx * right >= 0 and dy * down >= 0 for dx, dy in seen)
        for right in (1, -1)
        for down in (1, -1)
    )


def _chequered(fault: Fault) -> bool:
    """Every second pixel is filled, as on a chessboard."""
    return len({(x + y) % 2 for x, y in fault.drawn}) == 1


def _not_reached(evidence: Evidence) -> bool:
    """Far away there is filled, too, and nothing is missing."""
    first = evidence.faults[0]
    far = not first.extra <= around(first.wanted)
    return first_about("plain")(evidence) and far and not first.missing


def _on_the_border(evidence: Evidence) -> bool:
    """What is filled too much touches what is wanted, and no more."""

    def seems(fault: Fault) -> bool:
        return (
            not fault.missing
            and bool(fault.wanted)
            and bool(fault.extra)
            and fault.extra <= around(fault.wanted)
        )

    return seems(evidence.faults[0])


_FOUR = "it slips through where a thin border touches at corners only: four neighbours, not eight"
_NOT_INSIDE = "a place on the border is not inside: nothing is filled there"
_REPLACED = (
    "only the colour that is found at the place is replaced, and all of it that can be reached:"
    " remember that colour first"
)

SIGNS: list[Sign] = [
    *COMMON,
    (
        _seed_only,
        "only the first pixel is set: its four neighbours are filled in the same way, and the old"
        " colour is found out before that pixel is set",
    ),
    (_one_line, "only one line is filled: go to the neighbours above and below, too"),
    (
        _plain(_chequered),
        "every second pixel: neighbours are right, left, above and below, not at the corners",
    ),
    (_plain(_two_ways), "it goes in two directions only: x + 1, x - 1, y + 1 and y - 1 are four"),
    (_not_reached, "only what can be reached from the place: it goes from pixel to neighbour"),
    (_half(-1, 0), "nothing is filled to the left of the place: four neighbours, x - 1 is one"),
    (_half(1, 0), "nothing is filled to the right of the place: four neighbours, x + 1 is one"),
    (_half(0, -1), "nothing is filled above the place: four neighbours, y - 1 is one"),
    (_half(0, 1), "nothing is filled below the place: four neighbours, y + 1 is one"),
    (
        first_about("on the border"),
        _NOT_INSIDE,
    ),
    (first_about("thin"), _FOUR),
    (_on_the_border, "the border is painted over: ask before a pixel is set, not after"),
    (
        first_about("winding"),
        "it does not go around corners: from every filled pixel on to its neighbours, not from the"
        " first one only",
    ),
    (first_about("island"), "behind an island the area goes on: rows have more than one piece"),
    (first_about("edge"), "the edge of the screen: 0 and getmaxx() belong to it"),
    (first_about("again"), "what has the colour already needs no filling: nothing may change"),
]
BOUNDARY_SIGNS: list[Sign] = [
    *SIGNS,
    (
        first_about("picture"),
        "all that is not border is inside, whatever its colour: it need not be black",
    ),
]
FLOOD_SIGNS: list[Sign] = [
    *SIGNS,
    (
        first_about("picture"),
        _REPLACED,
    ),
]

_LOST = "the same places come again and again: ask whether a pixel has the colour already"
_THROUGH = (
    "it goes through the border: go on only where a pixel is not border and not of the colour"
)
_EVERYWHERE = (
    "it goes everywhere: find out the old colour once, before the first pixel is set, and go on"
    " only where a pixel still has it"
)
TROUBLES = {
    "thin": _FOUR,
    "edge": "it runs off the screen: go on only where 0 <= x <= getmaxx() and 0 <= y <= getmaxy()",
    "large": "recursion too deep: keep the places that wait in a list, or fill whole rows at once",
    "again": "what has the colour already must stop it: otherwise it never ends",
    "picture": _REPLACED,
    "on the border": _NOT_INSIDE,
}
"""The hints for a function that runs on for ever, by what is special about the trial."""


def _trouble(far: str, fault: Fault) -> str:
    """The hint for an error, or no end; `far` is the one for a fill that gets out."""
    trouble = fault.outcome.trouble
    assert trouble is not None
    if isinstance(trouble.error, IndexError):
        return "nothing waits any more: that is the end, while waiting: not while True:"
    if trouble.kind not in ("endless", "deep"):
        return ""
    if fault.trial.about in TROUBLES:
        return TROUBLES[fault.trial.about]
    x, y, *_ = fault.arguments
    if (y, x) in fault.drawn and not fault.drawn & fault.wanted:
        return "x and y are exchanged: getpixel(x, y) and putpixel(x, y, color)"
    return _LOST if fault.extra <= around(fault.wanted) else far


INSTEAD = "set the pixels by putpixel, or level lines by line(): the exercise is to find them"


def boundary(deep: bool) -> DrawingExercise:
    """Filling as far as a border."""
    names = "x", "y", "color", "border"
    trials = partial(_boundary_trials, deep)
    trouble = partial(_trouble, _THROUGH)
    return DrawingExercise("boundary", names, trials, BOUNDARY_SIGNS, trouble, ("line",), INSTEAD)


def flood(deep: bool) -> DrawingExercise:
    """Filling an area of one colour."""
    names = "x", "y", "color"
    trials = partial(_flood_trials, deep)
    trouble = partial(_trouble, _EVERYWHERE)
    return DrawingExercise("flood", names, trials, FLOOD_SIGNS, trouble, ("line",), INSTEAD)
