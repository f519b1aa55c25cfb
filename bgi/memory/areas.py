"""Areas of a page: boxes, polygons, ellipses and floods, filled in a pattern."""

from functools import lru_cache
from typing import Any

import numpy as np

from bgi.memory.pixmap import Pixels, Pixmap
from bgi.raster.ellipses import Offset
from bgi.raster.floodfill import flood
from bgi.raster.lines import Ints
from bgi.raster.patterns import EMPTY_ROWS, SOLID_ROWS, Ink, ink
from bgi.raster.polygons import Rows
from bgi.raster.spans import Spans

Cuts = dict[int, memoryview]

KEPT_INKS = 1 << 21
"""Bytes of patterns in colours that a page keeps."""
_WIDE = 64
"""From here on SDL writes rows past the processor's cache, which takes far longer than numpy."""


class Areas(Pixmap):
    """A page to fill areas on."""

    def __init__(self, memory: memoryview, width: int, height: int, pixel_bytes: int = 1) -> None:
        """Lay it over `memory`, as a `Pixmap`."""
        super().__init__(memory, width, height, pixel_bytes)
        self._marks = bytearray(width * height), bytearray(width * height)
        self._inks: dict[tuple[bytes, int], Ink] = {}

    # Boxes

    def fill(
        self, left: int, top: int, right: int, bottom: int, color: int, rows: bytes = SOLID_ROWS
    ) -> None:
        """A box in a fill pattern of eight rows; two opposite corners, both included."""
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        if left < self._left:
            left = self._left
        if top < self._top:
            top = self._top
        width = (right if right < self._right else self._right) - left + 1
        height = (bottom if bottom < self._bottom else self._bottom) - top + 1
        if width <= 0 or height <= 0:
            return
        if rows == EMPTY_ROWS:
            color, rows = 0, SOLID_ROWS
        if rows != SOLID_ROWS:
            block = self._ink(color, rows).block
            self._fill_pattern(left, top, left + width, top + height, block)
        elif width < _WIDE:
            self._surface.fill(color, (left, top, width, height))
        else:
            self.array[top : top + height, left : left + width] = color

    def _fill_pattern(self, left: int, top: int, right: int, bottom: int, block: Pixels) -> None:
        """A box within the page, its right and bottom excluded: eight rows at a time, then less."""
        start, rest = top & 7, top
        if bottom - top > 8:
            rest += bottom - top & ~7
            eights = self.array[top:rest].reshape(-1, 8, self.width)
            eights[:, :, left:right] = block[start : start + 8, left:right]
        self.array[rest:bottom, left:right] = block[start : start + bottom - rest, left:right]

    def _ink(self, color: int, pattern: bytes) -> Ink:
        """A fill pattern in a colour, made once."""
        try:
            return self._inks[pattern, color]
        except KeyError:
            made = ink(pattern, color, self.width, self.flat.dtype)
            if (len(self._inks) + 1) * made.block.nbytes > KEPT_INKS:
                self._inks.clear()
            self._inks[pattern, color] = made
            return made

    # Rows

    def fill_rows(self, where: Rows, color: int, pattern: bytes) -> None:
        """Rows of pixels, each y within the clipping box, in a fill pattern."""
        left, right, width, pixels = self._left, self._right, self.width, self._row
        whole, cut = _row_of(color, width, self.flat.dtype)
        inked = None if pattern == SOLID_ROWS else self._ink(color, pattern).rows
        for y, a, b in zip(*where, strict=True):
            if a > b:
                a, b = b, a
            if a < left:
                a = left
            if b > right:
                b = right
            if a > b:
                continue
            b += 1
            if inked is not None:
                place = y * width
                pixels[place + a : place + b] = inked[y & 7][a:b]
                continue
            try:
                piece = cut[b - a]
            except KeyError:
                piece = cut[b - a] = whole[: b - a]
            y *= width
            pixels[y + a : y + b] = piece

    def _patterned(self, place: Ints, colors: Ints, rows: bytes) -> Ints:
        """What a fill writes at those places."""
        if rows == SOLID_ROWS:
            return colors
        ones: Ints = self._ink(1, rows).block.ravel()
        return ones[place % (8 * self.width)] * colors

    def fill_spans(self, spans: Spans, fills: Ints, rows: bytes) -> tuple[Ints, Ints]:
        """The rows of many polygons one after another; `fills` are the polygons' colours.

        Returns the places filled, and how many of them each span has.
        """
        left, right = np.maximum(spans.left, self._left), np.minimum(spans.right, self._right)
        lengths = np.maximum(right - left + 1, 0)
        starts = spans.y * self.width + left - (np.cumsum(lengths) - lengths)
        place = np.repeat(starts, lengths)
        place += np.arange(len(place))
        inks = np.repeat(fills.astype(self.flat.dtype)[spans.owner], lengths)
        self.flat[place] = self._patterned(place, inks, rows)
        return place, lengths

    def fill_symmetric(
        self, x: int, y: int, steps: list[Offset], color: int, pattern: bytes
    ) -> None:
        """An ellipse: for each step (i, j) the rows y - j and y + j, from x - i to x + i."""
        _, top, _, bottom = self.box
        rows = [(y + s * j, x - i, x + i) for i, j in steps for s in (-1, 1)]
        rows = [row for row in rows if top <= row[0] <= bottom]
        self.fill_rows(
            ([r[0] for r in rows], [r[1] for r in rows], [r[2] for r in rows]), color, pattern
        )

    # Floods

    def mark_unfilled(self, color: int, rows: bytes, area: bytearray) -> None:
        """Mark in `area`, a byte a pixel, the pixels of the clipping box that a fill would change.

        Rows that the pattern leaves empty are marked whole, so that the flood crosses them.
        """
        part = slice(self._top, self._bottom + 1), slice(self._left, self._right + 1)
        marks = np.frombuffer(area, np.bool_).reshape(self.height, self.width)
        marks.fill(False)
        if rows == SOLID_ROWS:
            np.not_equal(self.array[part], self.flat.dtype.type(color), out=marks[part])
        else:
            row = np.arange(self._top, self._bottom + 1) & 7
            inked = self._ink(color, rows).block[row, self._left : self._right + 1]
            np.not_equal(self.array[part], inked, out=marks[part])
            empty = np.frombuffer(rows, np.uint8)[row] == 0
            marks[part] |= empty[:, np.newaxis]

    def area(self, x: int, y: int, border: int, color: int, rows: bytes) -> Rows:
        """The area around x, y up to a border colour, as a fill with that colour would find it."""
        inside, unfilled = self._marks
        if self._left <= x <= self._right and self._top <= y <= self._bottom:
            self.mark_unfilled(border, SOLID_ROWS, inside)
            if inside[y * self.width + x]:
                self.mark_unfilled(color, rows, unfilled)
                # The driver looks for a pixel to go on from between the outer columns only.
                shape = self.height, self.width
                seen = np.frombuffer(unfilled, np.bool_).reshape(shape)
                seen[:, [self._left, self._right]] = False
                return flood(inside, unfilled, self.width, x, y)
        return [], [], []


@lru_cache(maxsize=64)
def _row_of(color: int, width: int, dtype: np.dtype[Any]) -> tuple[memoryview, Cuts]:
    """A row of one colour to copy from, and what has been cut from its beginning, by length."""
    return np.full(width, color, dtype).data, {}
