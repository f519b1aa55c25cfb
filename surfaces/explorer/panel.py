"""Lines of text below the picture, as many characters wide as the screen has room for."""

from collections.abc import Sequence
from textwrap import wrap

from bgi import (
    BLACK,
    DARKGRAY,
    LIGHTGRAY,
    SOLID_FILL,
    bar,
    getmaxx,
    getmaxy,
    line,
    outtextxy,
    setcolor,
    setfillstyle,
)

MARGIN, ROW, ROWS = 8, 12, 5
PANEL = ROWS * ROW + MARGIN
"""The height of the panel: five lines of text."""
CHARACTER = 8
HINT_ROW = 3
"""The first of two lines that tell of keys."""


def columns() -> int:
    """How many characters there are in a line."""
    return (getmaxx() + 1 - 2 * MARGIN) // CHARACTER


def row_top(row: int) -> int:
    """The top of a line of text."""
    return getmaxy() + 1 - PANEL + MARGIN + ROW * row


def write(row: int, text: str, color: int) -> None:
    """A line of text, as much of it as there is room for."""
    setcolor(color)
    outtextxy(MARGIN, row_top(row), text[: columns()])


def paragraph(row: int, text: str, color: int) -> None:
    """A text in as many lines as it needs, and there are."""
    for number, part in enumerate(wrap(text, columns())[: ROWS - row]):
        write(row + number, part, color)


def rule() -> None:
    """The line between the picture and the panel."""
    line(0, getmaxy() + 1 - PANEL, getmaxx(), getmaxy() + 1 - PANEL, DARKGRAY)


def hints(phrases: Sequence[str]) -> None:
    """Two dark lines on a light ground: as many of the phrases as fit, each of them whole."""
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    bar(0, row_top(HINT_ROW) - 3, getmaxx(), getmaxy())
    for number, text in enumerate(packed(phrases, columns())[: ROWS - HINT_ROW]):
        write(HINT_ROW + number, text, BLACK)


def packed(phrases: Sequence[str], width: int) -> list[str]:
    """Phrases in lines of at most so many characters, none of them broken."""
    lines = [""]
    for phrase in phrases:
        longer = f"{lines[-1]}  {phrase}" if lines[-1] else phrase
        if len(longer) <= width:
            lines[-1] = longer
        else:
            lines.append(phrase)
    return lines
