"""Text in the built-in font of cells and in the stroked fonts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from bgi.constants import (
    CENTER_TEXT,
    DEFAULT_FONT,
    HORIZ_DIR,
    LEFT_TEXT,
    RIGHT_TEXT,
    TOP_TEXT,
    USER_CHAR_SIZE,
    VERT_DIR,
    grError,
)
from bgi.fonts import bitmap, layout
from bgi.fonts.chr import FontError, StrokedFont
from bgi.fonts.codepage import encode
from bgi.fonts.layout import Scale
from bgi.graphics.screen import State
from bgi.kernel.arguments import Number, whole
from bgi.kernel.state import KERNEL
from bgi.memory.page import FAR
from bgi.raster.patterns import SOLID_MASK
from bgi.settings import textsettingstype

MAX_CHARSIZE = 10
"""A larger size is taken as this one."""

MAX_FACTOR = 32767
"""The factors of setusercharsize() are 16-bit numbers."""


class Text(State):
    """A screen to write on."""

    # Settings

    def settextstyle(self, font: Number, direction: Number, charsize: Number) -> None:
        """Choose font, direction and size; a font that cannot be had gives the built-in one."""
        number, way = whole("font", font), whole("direction", direction)
        size = min(max(whole("charsize", charsize), USER_CHAR_SIZE), MAX_CHARSIZE)
        self._font = None
        if number != DEFAULT_FONT:
            try:
                self._font = KERNEL.fonts.load(number, self.path)
            except FontError as error:
                KERNEL.result.set(error.code, error.file)
                number = DEFAULT_FONT
        style = self.settings.text
        self.settings.text = textsettingstype(
            number,
            VERT_DIR if way == VERT_DIR else HORIZ_DIR,
            size,
            style.horiz,
            style.vert,
        )

    def settextjustify(self, horiz: Number, vert: Number) -> None:
        """Choose which point of a text its coordinates mean; -11 unless both are 0..2."""
        across, down = whole("horiz", horiz), whole("vert", vert)
        if LEFT_TEXT <= across <= RIGHT_TEXT and LEFT_TEXT <= down <= TOP_TEXT:
            self.settings.text.horiz, self.settings.text.vert = across, down
        else:
            KERNEL.result.set(grError)

    def setusercharsize(self, multx: Number, divx: Number, multy: Number, divy: Number) -> None:
        """Stretch stroked fonts freely, at once; -11 for a divisor of 0, or beyond 16 bits."""
        scale = Scale(
            whole("multx", multx), whole("divx", divx), whole("multy", multy), whole("divy", divy)
        )
        if scale.dx == 0 or scale.dy == 0 or max(map(abs, scale)) > MAX_FACTOR:
            KERNEL.result.set(grError)
            return
        self.settings.user_scale = scale
        self.settings.text.charsize = USER_CHAR_SIZE

    def gettextsettings(self) -> textsettingstype:
        """Font, direction, size and justification."""
        return replace(self.settings.text)

    # Measures

    def _scale(self) -> Scale:
        size = self.settings.text.charsize
        return self.settings.user_scale if size == USER_CHAR_SIZE else layout.SIZES[size]

    def _cell(self) -> int:
        return bitmap.CELL * max(1, self.settings.text.charsize)

    def textwidth(self, text: str | bytes) -> int:
        """The width of a text in pixels."""
        font, codes = self._font, encode(text)
        if font is None:
            return self._cell() * len(codes)
        return layout.textwidth(font, codes, self._scale())

    def textheight(self, text: str | bytes) -> int:
        """The height of a text in pixels: the same for every text."""
        font = self._font
        encode(text)
        return self._cell() if font is None else layout.textheight(font, self._scale())

    # Writing

    def outtext(self, text: str | bytes) -> None:
        """Write at the current position, which moves on if the text is level and left-justified."""
        here, style = self.settings, self.settings.text
        self.outtextxy(here.x, here.y, text)
        if style.direction == HORIZ_DIR and style.horiz == LEFT_TEXT:
            here.x += self.textwidth(text)

    def outtextxy(self, x: Number, y: Number, text: str | bytes) -> None:
        """Write at x, y."""
        left, top = whole("x", x) + self._dx, whole("y", y) + self._dy
        font, codes = self._font, encode(text)
        if font is not None:
            self._write_strokes(font, left, top, codes)
        elif self.settings.text.direction == VERT_DIR:
            self._write_upwards(left, top, codes)
        else:
            self._write(left, top, codes)

    def _write(self, x: int, y: int, text: bytes) -> None:
        """Horizontal cells: a character that the viewport would cut is left out as a whole."""
        style, cell = self.settings.text, self._cell()
        x -= _share(cell * len(text), style.horiz, RIGHT_TEXT)
        y -= cell - _share(cell, style.vert, TOP_TEXT)
        left, top, right, bottom = self.page.box
        first = max(0, -((x - left) // cell))
        last = max(first, min(len(text), (right + 1 - x) // cell))
        if not top <= y <= bottom + 1 - cell:
            last = first
        # With clipping off, a text that does not fit on the screen as a whole is left out.
        if first < last and (self.settings.view.clip or last - first == len(text)):
            mask = bitmap.mask(text[first:last], cell // bitmap.CELL)
            self.page.stamp(x + first * cell, y, mask, self.settings.color)

    def _write_upwards(self, x: int, y: int, text: bytes) -> None:
        """Vertical cells, cut pixel by pixel; RIGHT_TEXT is drawn like LEFT_TEXT: left of x."""
        style, cell = self.settings.text, self._cell()
        length = cell * len(text)
        x -= cell // 2 if style.horiz == CENTER_TEXT else cell
        y -= length - _share(length, style.vert, TOP_TEXT)
        _, top, _, bottom = self.page.box
        # The first character is the lowest: leave out what lies below and above the box.
        first = max(0, (y + length - 1 - bottom) // cell)
        last = min(len(text), -((top - y - length) // cell))
        if first < last:
            mask = np.rot90(bitmap.mask(text[first:last], cell // bitmap.CELL))
            self.page.stamp(x, y + length - last * cell, mask, self.settings.color)

    def _write_strokes(self, font: StrokedFont, x: int, y: int, text: bytes) -> None:
        """Thin solid lines, each clipped on its own."""
        style, scale = self.settings.text, self._scale()
        vertical = style.direction == VERT_DIR
        dx, dy = layout.anchor(font, text, scale, vertical, style.horiz, style.vert)
        strokes = layout.segments(font, text, scale, vertical)
        if max(abs(x), abs(y)) > FAR:
            return
        x1, y1, x2, y2 = (strokes + np.array([x + dx, y + dy] * 2)).T
        colors = np.broadcast_to(self.settings.color, len(strokes))
        self.page.line_many((x1, y1, x2, y2), colors, SOLID_MASK, self._xor)


def _share(length: int, justification: int, whole_at: int) -> int:
    """All of a length, half of it, or nothing."""
    if justification == CENTER_TEXT:
        return length // 2
    return length if justification == whole_at else 0
