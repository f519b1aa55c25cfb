"""Cases: calls of graphics.h, the picture that they must leave, and what they must return."""

import dataclasses
import json
from pathlib import Path

import bgi
from bgi import current
from tests.pictures import read_indices

ORIGINAL = Path(__file__).parent / "original"
"""The captures of the original library; its README says what the files hold."""

FONTS = ORIGINAL / "fonts"
"""A small font of our own, which stands in for TRIP.CHR."""


def load():
    """All cases; a case's picture becomes a path."""
    cases = json.loads((ORIGINAL / "cases.json").read_text(encoding="utf-8"))
    return [{**case, "picture": ORIGINAL / "pictures" / case["picture"]} for case in cases]


def stands_for_itself(case):
    """Whether a case is compared: what printf prints is not drawn yet.

    Of those called unsure only stroked texts show what a case before them had left.
    """
    left_over = case["unsure"] and case["group"].endswith("stroke")
    return case["group"] != "console" and not left_over


def play(case, before=()):
    """Make a case's calls from a fresh initgraph on; returns the page and what the calls answered.

    The calls `before` are made first, in a graphics mode of their own.
    """
    if before:
        play({**case, "calls": before})
    assert bgi.initgraph(case["driver"], case["gmode"], str(FONTS)) == (
        case["driver"],
        case["gmode"],
    )
    answers, images = {}, {}
    for number, (name, *arguments) in enumerate(case["calls"]):
        if name == "getimage":
            *corners, kept = arguments
            images[kept] = bgi.getimage(*corners)
            continue
        if name == "putimage":
            arguments[2] = images[arguments[2]]
        taken = [a.encode("latin-1") if isinstance(a, str) else a for a in arguments]
        answers[str(number)] = as_written(getattr(bgi, name)(*taken))
    return current.screen.page.array.copy(), answers


def as_written(answer):
    """An answer as cases.json writes it: a string, or a flat list of numbers."""
    if isinstance(answer, str):
        return answer
    if dataclasses.is_dataclass(answer):
        answer = dataclasses.astuple(answer)
    values = answer if isinstance(answer, (tuple, bytes)) else [answer]
    return [item for value in values for item in (value if isinstance(value, list) else [value])]


def compared(case, before=()):
    """What we draw and what the case expects within its region, and our answers to its queries."""
    page, answers = play(case, before)
    x0, y0, x1, y1 = case["region"]
    region = slice(y0, y1 + 1), slice(x0, x1 + 1)
    asked = {number: answers[number] for number in case["results"]}
    return page[region], read_indices(case["picture"])[region], asked
