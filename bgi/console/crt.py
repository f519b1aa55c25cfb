"""The screen as conio.h has it: a window in which text wraps and scrolls, and its attribute."""

from __future__ import annotations

from bgi.console.teletype import (
    BACKSPACE,
    CONTROLS,
    CURSORS,
    HIDDEN,
    LINE_FEED,
    NORMAL_ATTRIBUTE,
    RETURN,
    Bios,
    TextPage,
    runs,
)
from bgi.constants import _NOCURSOR, _NORMALCURSOR, _SOLIDCURSOR
from bgi.graphics import Graphics
from bgi.kernel.textmodes import TextMode
from bgi.memory.card import Card
from bgi.raster.lines import Box

_FIRST_PLAIN = 14
"""Codes from here on are pictures, whatever the others are."""


class Crt(Bios):
    """One text screen: the BIOS's, with conio's window and attribute."""

    def __init__(self, card: Card) -> None:
        super().__init__(card)
        self.attribute = NORMAL_ATTRIBUTE
        self._window: Box = (0, 0, 79, 24)
        self._base = 0
        self._quick = -1

    def enter_text(self, mode: TextMode) -> None:
        """Set a text mode; the window is the whole screen."""
        super().enter_text(mode)
        self._memory = self.card.page(0).cast("H")
        self.attribute = NORMAL_ATTRIBUTE
        self.open_window((0, 0, mode.columns - 1, mode.rows - 1))

    def enter_graphics(self, graphics: Graphics) -> None:
        """A graphics mode has been set; what is written into the window is hidden."""
        super().enter_graphics(graphics)
        self.open_window((0, 0, self.cells.columns - 1, self.cells.rows - 1))

    # The window and the cursor in it

    @property
    def window(self) -> Box:
        """Its corners, in cells from 0 on."""
        return self._window

    def open_window(self, box: Box) -> None:
        """Write within that box from now on, from its corner on."""
        self._window = box
        self.move(box[0], box[1])

    def move(self, x: int, y: int) -> None:
        """Put the cursor into a cell of the screen."""
        super().move(x, y)
        left, top, right, bottom = self._window
        self._base = y * self.cells.columns
        self._quick = right if self.is_text and left <= x and top <= y <= bottom else -1

    # Writing

    def put(self, code: int, scrolls: int, direct: int) -> None:
        """Write one character: `write` for what is written most."""
        x = self.x
        if x < self._quick and code >= _FIRST_PLAIN:
            at = self._base + x
            self._memory[at] = self.attribute << 8 | code
            self._cursor[0] = at + 1
            self.x = x + 1
        else:
            self.write(bytes([code]), scrolls, direct)

    def write(self, codes: bytes, scrolls: int, direct: int) -> None:
        """Write into the window: it wraps at its right edge and scrolls (`scrolls`) at its end.

        Line feed goes down only, return to the left edge, backspace one to the left; the bell is
        silent. `direct` writes go to the text mode's own memory, which a graphics mode hides.
        """
        left, _, right, _ = self._window
        page = self.cells if direct else self.page
        for run in runs(codes):
            if run[0] in CONTROLS:
                self._obey(run[0], scrolls, page)
                continue
            while run:
                here = run[: max(right + 1 - self.x, 1)]
                page.write(self.x, self.y, here, self.attribute)
                run = run[len(here) :]
                self.x += len(here)
                if self.x > right:
                    self.x = left
                    self._obey(LINE_FEED, scrolls, page)
        self.move(self.x, self.y)

    def _obey(self, code: int, scrolls: int, page: TextPage) -> None:
        left, _, _, bottom = self._window
        if code == RETURN:
            self.x = left
        elif code == BACKSPACE:
            self.x = max(self.x - 1, left)
        elif code == LINE_FEED:
            if self.y < bottom:
                self.y += 1
            elif scrolls:
                page.scroll(_part(self._window, page), 1, self.attribute)

    def choose_cursor(self, kind: int) -> None:
        """Hide the cursor, or show it as a block, or as at first."""
        high = self.mode.cell_height
        shapes = {_NOCURSOR: HIDDEN, _SOLIDCURSOR: high - 1, _NORMALCURSOR: CURSORS[high]}
        if kind in shapes:
            self.shape_cursor(shapes[kind])

    # Lines

    def clear(self) -> None:
        """Empty the window, the cursor in its corner."""
        left, top, _, _ = self._window
        self.page.fill(_part(self._window, self.page), self.attribute)
        self.move(left, top)

    def clear_line(self) -> None:
        """Empty the cursor's row from the cursor on."""
        _, _, right, _ = self._window
        self.page.fill(_part((self.x, self.y, right, self.y), self.page), self.attribute)

    def shift_lines(self, lines: int, direct: int) -> None:
        """Move the cursor's row and those below up by so many, or down if that is less than 0."""
        left, _, right, bottom = self._window
        page = self.cells if direct else self.page
        page.scroll(_part((left, self.y, right, bottom), page), lines, self.attribute)


def _part(box: Box, page: TextPage) -> Box:
    """The part of a box that is on a page: a picture may be smaller than its text screen."""
    left, top, right, bottom = box
    return left, top, min(right, page.columns - 1), min(bottom, page.rows - 1)
