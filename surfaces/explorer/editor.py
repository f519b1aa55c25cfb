"""A line of text that is being typed: a formula, and below it what is wrong with it."""

from dataclasses import dataclass

from bgi import BLUE, LIGHTGRAY, LIGHTRED, SOLID_FILL, WHITE, YELLOW, bar, setfillstyle
from surfaces.explorer.keys import (
    BACKSPACE,
    DELETE,
    DOWN,
    END,
    EXTENDED,
    HOME,
    LEFT,
    RIGHT,
    SPACE,
    UP,
)
from surfaces.explorer.panel import CHARACTER, MARGIN, columns, paragraph, row_top, write
from surfaces.formulas import FUNCTIONS, LONGEST, NAMES, FormulaError

PROMPT = "z = "
CURSOR_MOVES = {LEFT: -1, RIGHT: 1, HOME: -LONGEST, END: LONGEST}
PAST_MOVES = {UP: -1, DOWN: 1}


@dataclass
class Editor:
    """A line of text with a cursor."""

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

    def keep(self) -> None:
        """Remember the text for Up and Down."""
        self.past = [text for text in self.past if text != self.text] + [self.text]
        self.place = 0

    def press(self, key: int) -> None:
        """Obey a key; one that is a character is typed, one that means nothing does nothing."""
        if key in PAST_MOVES:
            self.place = (self.place + PAST_MOVES[key]) % len(self.past)
            self.begin(self.past[self.place])
        elif key in CURSOR_MOVES:
            self.selected = False
            self.cursor = min(max(self.cursor + CURSOR_MOVES[key], 0), len(self.text))
        elif key in (BACKSPACE, DELETE) or SPACE <= key < EXTENDED:
            self._edit(key)

    def _edit(self, key: int) -> None:
        if self.selected:
            self.text, self.cursor, self.selected = "", 0, False
        before, after = self.text[: self.cursor], self.text[self.cursor :]
        if key == BACKSPACE:
            self.text, self.cursor = before[:-1] + after, max(self.cursor - 1, 0)
        elif key == DELETE:
            self.text = before + after[1:]
        elif len(self.text) < LONGEST:
            self.text = before + bytes([key]).decode("cp437") + after
            self.cursor += 1

    def draw(self) -> None:
        """The line with its cursor; below it what is wrong, or what may be written."""
        room = columns() - len(PROMPT) - 1
        start = max(0, self.cursor - room)
        shown = self.text[start : start + room + 1]
        left, top = MARGIN + CHARACTER * len(PROMPT), row_top(0)
        if self.selected and shown:
            setfillstyle(SOLID_FILL, BLUE)
            bar(left, top - 2, left + CHARACTER * len(shown) - 1, top + CHARACTER)
        write(0, PROMPT + shown, WHITE)
        left += CHARACTER * (self.cursor - start)
        setfillstyle(SOLID_FILL, YELLOW)
        bar(left, top + 8, left + CHARACTER - 1, top + 9)
        if self.error is None:
            words = " ".join(("Enter draws it, Esc leaves, ↑ ↓ examples:", *NAMES, *FUNCTIONS))
            paragraph(2, words, LIGHTGRAY)
        else:
            caret = self.error.caret[start:][: room + 1]
            write(1, " " * len(PROMPT) + caret, LIGHTRED)
            paragraph(2, self.error.problem, LIGHTRED)
