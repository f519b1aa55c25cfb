"""Lines of text below a picture, and one of them to type in."""

from dataclasses import dataclass
from textwrap import wrap

from bgi import (
    BLUE,
    LIGHTGRAY,
    LIGHTRED,
    SOLID_FILL,
    WHITE,
    YELLOW,
    bar,
    getch,
    getmaxy,
    outtextxy,
    setcolor,
    setfillstyle,
)
from surfaces.formulas import FUNCTIONS, LONGEST, NAMES, FormulaError

ENTER, ESC, TAB, BACKSPACE, SPACE = 13, 27, 9, 8, 32
# What getch() gives as 0 and a second code, we count from 256 on.
EXTENDED = 256
HOME, UP, PAGE_UP, LEFT, RIGHT, END, DOWN, PAGE_DOWN, DELETE, F2, F3 = (
    EXTENDED + code for code in (71, 72, 73, 75, 77, 79, 80, 81, 83, 60, 61)
)
MARGIN, ROW, ROWS = 8, 12, 5
PANEL = ROWS * ROW + MARGIN
"""The height of what stands below the picture: five lines of text."""
WIDE = 78
"""Characters in a line of it."""


def read_key() -> int:
    """The next key, those without a character from EXTENDED on."""
    return getch() or EXTENDED + getch()


def row_top(number: int) -> int:
    """The top of a line of text below the picture."""
    return getmaxy() + 1 - PANEL + MARGIN + ROW * number


def write(row: int, text: str, color: int) -> None:
    """A line of text."""
    setcolor(color)
    outtextxy(MARGIN, row_top(row), text)


def paragraph(row: int, text: str, color: int) -> None:
    """A text in as many lines as it needs, and there are."""
    for number, part in enumerate(wrap(text, WIDE)[: ROWS - row]):
        write(row + number, part, color)


@dataclass
class Editor:
    """A line of text that is being typed."""

    past: list[str]
    """What Up and Down bring."""
    text: str = ""
    cursor: int = 0
    place: int = 0
    selected: bool = False
    """Whether the first character typed takes the place of all that is there."""
    error: FormulaError | None = None

    def begin(self, text: str, error: FormulaError | None = None) -> None:
        """Edit a text, the cursor at its end or where it goes wrong."""
        self.text, self.error, self.selected = text, error, error is None
        self.cursor = len(text) if error is None else min(error.column, len(text))

    def press(self, key: int) -> None:
        """Obey a key; one that is a character is typed."""
        typed = SPACE <= key < EXTENDED
        if self.selected and (typed or key in (BACKSPACE, DELETE)):
            self.text, self.cursor = "", 0
        self.selected = False
        before, after = self.text[: self.cursor], self.text[self.cursor :]
        if key in (UP, DOWN):
            self.place = (self.place + (1 if key == DOWN else -1)) % len(self.past)
            self.begin(self.past[self.place])
        elif key in (LEFT, RIGHT, HOME, END):
            steps = {LEFT: -1, RIGHT: 1, HOME: -LONGEST, END: LONGEST}
            self.cursor = min(max(self.cursor + steps[key], 0), len(self.text))
        elif key == BACKSPACE:
            self.text, self.cursor = before[:-1] + after, max(self.cursor - 1, 0)
        elif key == DELETE:
            self.text = before + after[1:]
        elif typed and len(self.text) < LONGEST:
            self.text = before + bytes([key]).decode("cp437") + after
            self.cursor += 1

    def keep(self) -> None:
        """Remember the text for Up and Down."""
        self.past = [text for text in self.past if text != self.text] + [self.text]
        self.place = 0

    def draw(self) -> None:
        """The line with its cursor; below it what is wrong, or what may be written."""
        room = WIDE - 5
        start = max(0, self.cursor - room)
        shown = self.text[start : start + room + 1]
        left, top = MARGIN + 8 * 4, row_top(0)
        if self.selected and shown:
            setfillstyle(SOLID_FILL, BLUE)
            bar(left, top - 2, left + 8 * len(shown) - 1, top + 8)
        write(0, f"z = {shown}", WHITE)
        left += 8 * (self.cursor - start)
        setfillstyle(SOLID_FILL, YELLOW)
        bar(left, top + 8, left + 7, top + 9)
        if self.error is None:
            words = " ".join(("Enter draws it, Esc leaves, ↑ ↓ examples:", *NAMES, *FUNCTIONS))
            paragraph(2, words, LIGHTGRAY)
        else:
            caret = self.error.caret[start:][: room + 1]
            write(1, f"    {caret}", LIGHTRED)
            paragraph(2, self.error.problem, LIGHTRED)
