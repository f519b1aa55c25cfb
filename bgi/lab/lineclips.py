"""Lines cut at the edges of a window, compared with the exact answer, and the usual slips."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from operator import floordiv, truediv
from typing import Any, cast

from bgi.constants import DARKGRAY, YELLOW
from bgi.graphics import Graphics
from bgi.lab import answered
from bgi.lab.answered import Answer, AnswerExercise, Arguments, Slip, numbers

Box = tuple[int, int, int, int]
Point = tuple[float, float]
Ends = tuple[float, float, float, float]

BOX: Box = (100, 80, 300, 200)


def clip_line(
    x1: int, y1: int, x2: int, y2: int, left: int, top: int, right: int, bottom: int
) -> Ends | None:
    """The part of a line inside, or None: Liang and Barsky's, with fractions."""
    start, end = _inside(x1, y1, x2, y2, left, top, right, bottom)
    return _cut(x1, y1, x2, y2, start, end) if start <= end else None


def _inside(x1: int, y1: int, x2: int, y2: int, *box: int) -> tuple[Fraction, Fraction]:
    """From which part of a line to which it is inside; the second is less if it never is.

    Y.-D. Liang, B. A. Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on
    Graphics 3, 1984.
    """
    left, top, right, bottom = box
    dx, dy = x2 - x1, y2 - y1
    start, end = Fraction(0), Fraction(1)
    for step, room in ((-dx, x1 - left), (dx, right - x1), (-dy, y1 - top), (dy, bottom - y1)):
        if step == 0 and room < 0:
            return Fraction(1), Fraction(0)
        if step < 0:
            start = max(start, Fraction(room, step))
        elif step > 0:
            end = min(end, Fraction(room, step))
    return start, end


def _cut(x1: int, y1: int, x2: int, y2: int, start: Fraction, end: Fraction) -> Ends:
    dx, dy = x2 - x1, y2 - y1
    ends = x1 + start * dx, y1 + start * dy, x1 + end * dx, y1 + end * dy
    a, b, c, d = map(float, ends)
    return a, b, c, d


def _lines() -> Iterator[Arguments]:
    """Lines inside, outside, through each side and corner; then lines anywhere."""
    left, top, right, bottom = BOX
    middle_x, middle_y = (left + right) // 2, (top + bottom) // 2
    yield 150, 100, 250, 180, *BOX
    for x, y in ((350, middle_y), (50, middle_y), (middle_x, 30), (middle_x, 260)):
        yield middle_x, middle_y, x, y, *BOX
        yield x, y, middle_x, middle_y, *BOX
    special: list[Box] = [
        (50, 140, 350, 140),
        (200, 20, 200, 260),
        (40, 60, 370, 230),
        (20, 30, 30, 250),
        (10, 20, 350, 40),
        (90, 130, 150, 60),  # past a corner, outside
        (left, top, right, bottom),
        (left, 20, left, 260),  # along a side
        (350, 100, 350, 180),
        (150, 100, 150, 100),
        (10, 10, 10, 10),
    ]
    yield from (ends + BOX for ends in special)
    chance = random.Random(3)
    for _ in range(200):
        ends = tuple(
            chance.randrange(400) if i % 2 == 0 else chance.randrange(280) for i in range(4)
        )
        yield *ends, *BOX


def _four(value: Any) -> Answer:
    """A line, or None."""
    if value is None:
        return None
    return numbers(value, 4, "None, or four numbers (x1, y1, x2, y2)")


def _same_line(one: Answer, other: Answer, arguments: Arguments) -> bool:
    """Whether two lines are equal; one that only touches a corner may be None."""
    touches = [answer for answer in (one, other) if answer and answer[:2] == answer[2:]]
    is_point = arguments[:2] == arguments[2:4]
    return answered.same(one, other) or (None in (one, other) and bool(touches) and not is_point)


def _with_box(change: Any) -> Any:
    """`clip_line` with another box."""

    def formula(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
        return clip_line(x1, y1, x2, y2, *change(*box))

    return formula


def _one_end(first: bool) -> Any:
    """Only the first end, or only the second, is moved."""

    def formula(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
        start, end = _inside(x1, y1, x2, y2, *box)
        if start > end:
            return None
        return _cut(x1, y1, x2, y2, start if first else Fraction(0), Fraction(1) if first else end)

    return formula


def _whole(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
    found = clip_line(x1, y1, x2, y2, *box)
    return None if found is None else (x1, y1, x2, y2)


def _only_inside(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
    left, top, right, bottom = box
    inside = all(left <= x <= right for x in (x1, x2)) and all(top <= y <= bottom for y in (y1, y2))
    return (x1, y1, x2, y2) if inside else None


def _both_outside(x1: int, y1: int, x2: int, y2: int, *box: int) -> bool:
    left, top, right, bottom = box
    ends = (x1, y1), (x2, y2)
    return not any(left <= x <= right and top <= y <= bottom for x, y in ends)


def _clamped(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
    left, top, right, bottom = box
    if clip_line(x1, y1, x2, y2, *box) is None:
        return None
    return (
        *(min(max(x1, left), right), min(max(y1, top), bottom)),
        *(min(max(x2, left), right), min(max(y2, top), bottom)),
    )


def _exchanged(*given: int) -> Ends | None:
    found = clip_line(*given)
    return found and (*found[2:], *found[:2])


Code = Callable[[float, float, Box], int]


def _code(x: float, y: float, box: Box) -> int:
    """Cohen and Sutherland's: 1 left, 2 right, 4 below, 8 above."""
    left, top, right, bottom = box
    return (x < left) + 2 * (x > right) + 4 * (y > bottom) + 8 * (y < top)


def _exchanging(one: int, other: int) -> Code:
    """With two bits exchanged."""

    def code(x: float, y: float, box: Box) -> int:
        right = _code(x, y, box)
        kept = right & ~(one | other)
        return kept | (other if right & one else 0) | (one if right & other else 0)

    return code


def _by_codes(code: Code, turns: int = 9, divided: Any = truediv) -> Any:
    """Cohen and Sutherland's, with a mistake; ValueError where it would not end."""

    def formula(x1: float, y1: float, x2: float, y2: float, *given: int) -> Ends | None:
        left, top, right, bottom = box = cast(Box, given)
        for _ in range(turns):
            one, other = code(x1, y1, box), code(x2, y2, box)
            if one & other:
                return None
            if not one | other:
                return x1, y1, x2, y2
            out = one or other
            if out & 12:
                y = float(top if out & 8 else bottom)
                x = x1 + divided((x2 - x1) * (y - y1), y2 - y1)
            else:
                x = float(left if out & 1 else right)
                y = y1 + divided((y2 - y1) * (x - x1), x2 - x1)
            if one:
                x1, y1 = x, y
            else:
                x2, y2 = x, y
        if turns == 1:
            return x1, y1, x2, y2
        raise ValueError

    return formula


def _loosely(limits: tuple[int, int], takes: Any, tests: str = "side aside") -> Any:
    """Liang and Barsky's, with a mistake: other limits of t, other ones taken, tests left out."""

    def formula(x1: int, y1: int, x2: int, y2: int, *box: int) -> Ends | None:
        left, top, right, bottom = box
        dx, dy = x2 - x1, y2 - y1
        found = [Fraction(limit) for limit in limits]
        for step, room in ((-dx, x1 - left), (dx, right - x1), (-dy, y1 - top), (dy, bottom - y1)):
            if step == 0 and room < 0 and "aside" in tests:
                return None
            if step:
                which = step > 0
                found[which] = takes[which](found[which], Fraction(room, step))
        if found[0] > found[1] and "side" in tests.split():
            return None
        return _cut(x1, y1, x2, y2, *found)

    return formula


FAR = 10**6
SLIPS = [
    Slip(
        lambda *given: clip_line(*given) or (0, 0, 0, 0),
        "where nothing is inside the answer is None, no line",
    ),
    Slip(
        _by_codes(_exchanging(1, 2)),
        "left and right are exchanged: an end moves to the edge that it is beyond",
    ),
    Slip(
        _by_codes(_exchanging(4, 8)),
        "top and bottom are exchanged: an end moves to the edge that it is beyond",
    ),
    Slip(_by_codes(_code, divided=floordiv), "// cuts off: divide by /"),
    Slip(
        lambda *given: None if _both_outside(*given) else clip_line(*given),
        "two ends outside are not yet nothing: the line may pass through. Only where both are"
        " beyond the same edge it is: code1 & code2, not code1 and code2",
    ),
    Slip(
        _loosely((0, 1), (max, min), "side"),
        "a line along an edge, beside the window: where p is 0 and q is less than 0 it is None",
    ),
    Slip(
        _loosely((0, 1), (max, min), "aside"),
        "where the first t is larger than the second one nothing is inside: None",
    ),
    Slip(
        _loosely((0, 1), (min, max)),
        "the first t is the largest of those where the line comes in, the second one the smallest"
        " of those where it goes out: max and min are exchanged",
    ),
    Slip(
        _loosely((-FAR, FAR), (max, min)),
        "t begins with 0 and ends with 1: the line does not go on beyond its ends",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left, top, left + right, top + bottom)),
        "right and bottom are edges, not sizes",
    ),
    Slip(_exchanged, "the ends are exchanged: the first end stays the first"),
    Slip(_whole, "what is outside is known, but nothing is cut off from the other lines"),
    Slip(lambda *given: given[:4], "nothing is cut off"),
    Slip(
        _only_inside,
        "a line that is only partly inside is not nothing: its part inside is wanted",
    ),
    Slip(_one_end(True), "the second end is not moved to the edge, only the first"),
    Slip(_one_end(False), "the first end is not moved to the edge, only the second"),
    Slip(
        _clamped,
        "the end is pushed to the edge, so that the line gets another slope: of x and y both move"
        " along the line",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (-FAR, top, right, bottom)),
        "the left edge does not cut",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left, -FAR, right, bottom)),
        "the top edge does not cut",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left, top, FAR, bottom)),
        "the right edge does not cut",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left, top, right, FAR)),
        "the bottom edge does not cut",
    ),
    Slip(
        lambda *given: None,
        "it is always None: is there a return? And y grows downwards: top is less than bottom",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left, top, right - 1, bottom - 1)),
        "the right and bottom edges belong to the window: <=, not <",
    ),
    Slip(
        _with_box(lambda left, top, right, bottom: (left + 1, top + 1, right - 1, bottom - 1)),
        "the edges belong to the window: <=, not <",
    ),
    Slip(
        _by_codes(_code, turns=1),
        "one end, at one edge, is not enough: go on until both ends are inside",
    ),
]


def _draw_line(screen: Graphics, arguments: Arguments, answer: Answer) -> None:
    x1, y1, x2, y2, left, top, right, bottom = arguments
    screen.rectangle(left, top, right, bottom, DARKGRAY)
    screen.line(x1, y1, x2, y2, DARKGRAY)
    if answer is not None:
        a, b, c, d = answer
        screen.line(a, b, c, d, YELLOW)


EDGES = "left", "top", "right", "bottom"
UPRIGHT = {
    "ZeroDivisionError": "a line that is upright, or level: with one of the edges it never meets",
    "endless": "each turn must move an end to an edge, and find out anew where that end is: on the"
    " edge it is inside. Where both ends are beyond one edge, nothing is",
}
EXERCISE = AnswerExercise(
    "clip_line",
    ("x1", "y1", "x2", "y2", *EDGES),
    _lines,
    clip_line,
    _four,
    SLIPS,
    UPRIGHT,
    _same_line,
    _draw_line,
    parts=("x1", "y1", "x2", "y2"),
    otherwise="an end that is beyond an edge moves to it along the line: at the left edge x is"
    " left, and y is y1 + (left - x1) * (y2 - y1) / (x2 - x1), with the old x1",
)
