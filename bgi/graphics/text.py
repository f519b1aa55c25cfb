"""Text in the built-in font of cells and in the stroked fonts."""

from __future__ import annotations

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
from bgi.fonts.lettering import letter, lettering
from bgi.fonts.lettering import text as whole_text
from bgi.graphics.screen import State
from bgi.kernel.arguments import Number, whole
from bgi.kernel.state import KERNEL
from bgi.raster.lines import Segment
from bgi.raster.patterns import SOLID
from bgi.settings import textsettingstype

MAX_CHARSIZE = 10
"""The largest size of a stroked font; what is larger, or negative, is drawn in this size."""

MAX_FACTOR = 32767
"""The factors of setusercharsize() are 16-bit numbers."""


class Text(State):
    """A screen to write on."""

    # Settings

    def settextstyle(self, font: Number, direction: Number, charsize: Number) -> None:
        """Choose font, direction and size; a font that cannot be had gives the built-in one."""
        number = font if type(font) is int else whole("font", font)
        way = direction if type(direction) is int else whole("direction", direction)
        size = charsize if type(charsize) is int else whole("charsize", charsize)
        style = self.settings.text
        if number == DEFAULT_FONT:
            self._font = None
        elif number != style.font or KERNEL.fonts.is_registered(number):
            self._font = self._load(number)
        style.font = DEFAULT_FONT if self._font is None else number
        style.direction, style.charsize = way, size
        self._use_charsize(size)

    def _load(self, number: int) -> StrokedFont | None:
        """A stroked font, or None, and graphresult() says why."""
        font = None
        try:
            font = KERNEL.fonts.load(number, self.path)
        except FontError as error:
            KERNEL.result.set(error.code)
        KERNEL.result.font_file = KERNEL.fonts.file(number) or KERNEL.result.font_file
        return font

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
        KERNEL.user_scale = scale
        self.settings.text.charsize = USER_CHAR_SIZE

    def gettextsettings(self) -> textsettingstype:
        """Font, direction, size and justification."""
        now = self.settings.text
        return textsettingstype(now.font, now.direction, now.charsize, now.horiz, now.vert)

    # Measures

    def _scale(self) -> Scale:
        size = self.settings.text.charsize
        if size == USER_CHAR_SIZE:
            return KERNEL.user_scale
        return layout.SIZES.get(size, layout.SIZES[MAX_CHARSIZE])

    def textwidth(self, text: str | bytes) -> int:
        """The width of a text in pixels."""
        font, codes = self._font, encode(text)
        if font is None:
            return self._cell[0] * len(codes)
        return layout.textwidth(font, codes, self._scale())

    def textheight(self, text: str | bytes) -> int:
        """The height of a text in pixels: the same for every text."""
        font = self._font
        encode(text)
        return self._cell[1] if font is None else layout.textheight(font, self._scale())

    # Writing

    def outtext(self, text: str | bytes) -> None:
        """Write at the current position, which moves on if the text is level and left-justified."""
        here, style = self.settings, self.settings.text
        self.outtextxy(here.x, here.y, text)
        if style.direction == HORIZ_DIR and style.horiz == LEFT_TEXT:
            here.x += self.textwidth(text)

    def outtextxy(self, x: Number, y: Number, text: str | bytes) -> None:
        """Write at x, y."""
        left = (x if type(x) is int else whole("x", x)) + self._dx
        top = (y if type(y) is int else whole("y", y)) + self._dy
        font, codes = self._font, encode(text)
        if font is not None:
            self._write_strokes(font, left, top, codes)
        elif self.settings.text.direction == VERT_DIR:
            self._write_upwards(left, top, codes)
        else:
            self._write_level(left, top, codes)

    def _write_level(self, x: int, y: int, text: bytes) -> None:
        """Cells side by side; one that the viewport would cut is left out, and its room stays.

        If the first one begins left of the screen, all are left out.
        """
        style, (width, height) = self.settings.text, self._cell
        length = width * len(text)
        if style.horiz != LEFT_TEXT:
            x -= _back(length, style.horiz, RIGHT_TEXT)
        if style.vert != TOP_TEXT:
            y -= height - _share(height, style.vert, TOP_TEXT)
        left, top, right, bottom = self.page.box
        if x < 0 or y < top or y + height - 1 > bottom:
            return
        if x < left or x + length - 1 > right:
            first, last = _whole_cells(x, width, len(text), left, right)
            x, text = x + first * width, text[first : max(last, 0)]
        if text:
            turned = style.direction != HORIZ_DIR
            mask = bitmap.mask(text, width // bitmap.CELL, height // bitmap.CELL, turned)
            self.page.stamp(x, y, mask, self._ink)

    def _write_upwards(self, x: int, y: int, text: bytes) -> None:
        """Cells on top of each other, the first one lowest; RIGHT_TEXT stands left of x, too."""
        style, (width, height) = self.settings.text, self._cell
        length = width * len(text)
        x -= _back(height, style.horiz, style.horiz)
        y -= length - _share(length, style.vert, TOP_TEXT)
        left, top, right, bottom = self.page.box
        first, last = _whole_cells(y, width, len(text), top, bottom)
        if left <= x and x + height - 1 <= right and first < last:
            shown = text[len(text) - last : len(text) - first]
            mask = bitmap.mask(shown, width // bitmap.CELL, height // bitmap.CELL)
            self.page.stamp(x, y + first * width, np.rot90(mask), self._ink)

    def _write_strokes(self, font: StrokedFont, x: int, y: int, text: bytes) -> None:
        """Thin solid lines, each clipped on its own."""
        style, scale = self.settings.text, self._scale()
        vertical = style.direction == VERT_DIR
        way = lettering(font, scale, vertical, self._xor, self.page.trace, self.mode.width)
        drawn = whole_text(way, text, style.horiz, style.vert)
        if drawn and self.page.put_offsets(x, y, drawn, self._ink, self._xor):
            return
        dx, dy = layout.anchor(font, text, scale, vertical, style.horiz, style.vert)
        x, y = x + dx, y + dy
        put, ink, xor = self.page.put_offsets, self._ink, self._xor
        for code in text:
            pixels, across, down = letter(way, code)
            if pixels is None or not put(x, y, pixels, ink, xor):
                self._write_letter(x, y, layout.strokes(font, code, scale, vertical).tolist())
            x += across
            y += down

    def _write_letter(self, x: int, y: int, strokes: list[Segment]) -> None:
        """One letter that an edge cuts, or a large one."""
        page, ink = self.page, self._ink
        if self._xor:
            for x1, y1, x2, y2 in strokes:
                page.styled_line(x + x1, y + y1, x + x2, y + y2, ink, SOLID, True)
        else:
            for x1, y1, x2, y2 in strokes:
                page.line(x + x1, y + y1, x + x2, y + y2, ink)


def _share(length: int, justification: int, whole_at: int) -> int:
    """All of a length, half of it, or nothing."""
    if justification == CENTER_TEXT:
        return length // 2
    return length if justification == whole_at else 0


def _back(length: int, justification: int, whole_at: int) -> int:
    """How far across text begins before its point: centred it is a pixel less than half."""
    return _share(length, justification, whole_at) - (justification == CENTER_TEXT)


def _whole_cells(start: int, size: int, count: int, low: int, high: int) -> tuple[int, int]:
    """Which of the cells in a row lie within low..high: the first, and the one after the last."""
    return max(0, -((start - low) // size)), min(count, (high + 1 - start) // size)
