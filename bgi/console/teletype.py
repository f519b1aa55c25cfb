"""The video BIOS: the text mode, its cursor, and characters written as a teletype writes them."""

from __future__ import annotations

import re
from typing import Protocol

from bgi.console.glyphs import DOS_ATTRIBUTE, GlyphPage, HiddenPage
from bgi.constants import C80
from bgi.graphics import Graphics
from bgi.kernel import modes
from bgi.kernel.textmodes import TEXT_MODES, TextMode
from bgi.memory.card import BLINKING, MONOCHROME, Card
from bgi.memory.cells import CellPage
from bgi.memory.palette import Palette
from bgi.raster.lines import Box

NORMAL_ATTRIBUTE = 7
"""Light grey on black: what a screen begins in."""

BELL, BACKSPACE, LINE_FEED, RETURN = 7, 8, 10, 13

_COLORS = modes.window(640, 400)
"""A mode with the palette of text: the same sixteen colours, each any of 64."""

TAB = 8
CONTROLS = (BELL, BACKSPACE, LINE_FEED, RETURN)

runs = re.compile(rb"[\a\b\n\r]|[^\a\b\n\r]+").findall
"""Cut a text into control characters, and runs of others."""

CURSORS = {8: 0x0607, 14: 0x0B0C, 16: 0x0D0E}
"""The shape of a new mode's cursor by the height of its characters: first and last row."""
HIDDEN = 0x2000
"""The shape of a cursor that is not seen."""


class TextPage(Protocol):
    """What the BIOS writes on: `CellPage` says what each method means."""

    columns: int
    rows: int

    def write(self, x: int, y: int, codes: bytes, attribute: int) -> None: ...
    def rewrite(self, x: int, y: int, codes: bytes, color: int = ...) -> None: ...
    def fill(self, box: Box, attribute: int) -> None: ...
    def scroll(self, box: Box, lines: int, attribute: int) -> None: ...
    def cell(self, x: int, y: int) -> int: ...


class Bios:
    """The screen as a teletype: `x` and `y` are the cursor's column and row, from 0 on."""

    page: TextPage
    """What the BIOS writes on: the cells, or the picture in a graphics mode."""
    cells: CellPage | HiddenPage
    """The text mode's own memory."""

    def __init__(self, card: Card) -> None:
        self.card = card
        self._cursor = card.cursor
        self.mode = self.mode_before = TEXT_MODES[C80]
        self.x = self.y = 0
        self.is_text = False

    def enter_text(self, mode: TextMode) -> None:
        """Set a text mode: an empty screen, the cursor in its corner."""
        if mode is not self.mode:
            self.mode_before, self.mode = self.mode, mode
        attributes = MONOCHROME if mode.monochrome else BLINKING
        self.card.set_text_mode(mode.columns, mode.rows, mode.cell_height, attributes)
        self.palette = Palette(_COLORS, self.card.palette)
        self.cells = self.page = CellPage(self.card.page(0), mode.columns, mode.rows)
        self.is_text = True
        self.page.fill((0, 0, mode.columns - 1, mode.rows - 1), NORMAL_ATTRIBUTE)
        self.shape_cursor(CURSORS[mode.cell_height])
        self.move(0, 0)

    def enter_graphics(self, graphics: Graphics) -> None:
        """A graphics mode has been set: characters go over its picture, from the corner on."""
        self.page = GlyphPage(graphics)
        own = graphics.mode.is_window  # which has no text mode of its own behind it
        size = self.page if own else self.mode
        self.cells = HiddenPage(size.columns, size.rows)
        self.is_text = False
        self.move(0, 0)

    # The cursor

    def move(self, x: int, y: int) -> None:
        """Put the cursor into a cell."""
        self.x, self.y = x, y
        if self.is_text:
            self._cursor[0] = y * self.cells.columns + x

    def shape_cursor(self, shape: int) -> None:
        """Give the cursor its rows of pixels: 256 * first + last; first > last hides it."""
        self._cursor[1] = shape

    # Writing

    def teletype(self, codes: bytes, color: int = DOS_ATTRIBUTE) -> None:
        """Write some characters and move on; at the end of the last row the screen scrolls.

        Line feed goes down only, return to the left edge, backspace one to the left; the bell is
        silent. Every other code is a picture. Over a picture the colour counts.
        """
        for run in runs(codes):
            if run[0] in CONTROLS:
                self._control(run[0])
                continue
            while run:
                if self.x >= self.page.columns:
                    self._new_line()
                here = run[: self.page.columns - self.x]
                self.page.rewrite(self.x, self.y, here, color)
                run = run[len(here) :]
                self.x += len(here)
            if self.x >= self.page.columns:
                self._new_line()
        self.move(self.x, self.y)

    def print(self, codes: bytes) -> None:
        """Write as C's standard output and DOS do.

        Line feed begins a new line, a tab is blanks up to the next column that eight divides.
        """
        first, *others = codes.replace(b"\n", b"\r\n").split(b"\t")
        self.teletype(first)
        for part in others:
            self.teletype(b" " * (TAB - self.x % TAB) + part)

    def erase(self) -> None:
        """Take back the last character, also from the end of the row above."""
        if self.x > 0:
            x, y = self.x - 1, self.y
        else:
            x, y = self.page.columns - 1, max(self.y - 1, 0)
        self.page.rewrite(x, y, b" ")
        self.move(x, y)

    def _new_line(self) -> None:
        self._control(RETURN)
        self._control(LINE_FEED)

    def _control(self, code: int) -> None:
        columns, last = self.page.columns, self.page.rows - 1
        if code == RETURN:
            self.x = 0
        elif code == BACKSPACE:
            self.x = max(self.x - 1, 0)
        elif code == LINE_FEED and self.y < last:
            self.y += 1
        elif code == LINE_FEED:
            self.y = last
            attribute = self.page.cell(min(self.x, columns - 1), last) >> 8
            self.page.scroll((0, 0, columns - 1, last), 1, attribute)
