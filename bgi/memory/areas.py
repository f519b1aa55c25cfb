"""Areas of a page: boxes, polygons, ellipses and floods, filled in a pattern."""

from functools import lru_cache
from typing import Any

import numpy as np

from bgi.memory.pixmap import Mask, Pixels, Pixmap
from bgi.raster.arrays import repeat
from bgi.raster.floodfill import flood
from bgi.raster.lines import Box, Ints, grouped
from bgi.raster.patterns import EMPTY_ROWS, SOLID_ROWS, Ink, ink
from bgi.raster.polygons import Rows
from bgi.raster.regions import FigureRows, Region
from bgi.raster.spans import Spans

FAR = 1 << 40
"""Nothing of a figure so far away can be seen; below it int64 holds its points."""
KEPT_INKS = 1 << 21
"""Bytes of patterns in colours that a page keeps."""
OWNER = np.dtype(np.int16)
"""Of the numbers of polygons that are filled together: numpy sets pixels fast in their own type."""
_TOGETHER = 1 << 14
"""Pixels of rows that are set at once; no row has more."""
_STEPS = np.arange(_TOGETHER)
_NEAR = 40
"""Pixels around a flood's seed: most floods stay within."""
_BORDER = b"\1"
"""Yes, of a pixel."""
_WIDE = 64
"""From here on SDL writes rows past the processor's cache, which takes far longer than numpy."""


class Areas(Pixmap):
    """A page to fill areas on."""

    def __init__(self, memory: memoryview, width: int, height: int, pixel_bytes: int = 1) -> None:
        """Lay it over `memory`, as a `Pixmap`."""
        super().__init__(memory, width, height, pixel_bytes)
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
        pieces = _pieces(color, width, self.flat.dtype)
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
            y *= width
            pixels[y + a : y + b] = pieces[b - a]

    def _patterned(self, place: Ints, colors: Ints, rows: bytes) -> Ints:
        """What a fill writes at those places."""
        if rows == SOLID_ROWS:
            return colors
        ones: Ints = self._ink(1, rows).block.ravel()
        return ones[place % (8 * self.width)] * colors

    def fill_spans(
        self, spans: Spans, fills: Ints, rows: bytes, last: Pixels | None = None
    ) -> None:
        """The rows of many polygons one after another; `fills` are the polygons' colours.

        In `last`, a number for each pixel of the page, stands then which polygon filled it last.
        """
        left, right = np.maximum(spans.left, self._left), np.minimum(spans.right, self._right)
        lengths, starts = np.maximum(right - left + 1, 0), spans.y * self.width + left
        inks, owners = fills.astype(self.flat.dtype)[spans.owner], spans.owner.astype(OWNER)
        for part in grouped(lengths, _TOGETHER):
            length = lengths[part]
            place = repeat(starts[part] - (np.cumsum(length) - length), length)
            place += _STEPS[: len(place)]
            self.flat[place] = self._patterned(place, repeat(inks[part], length), rows)
            if last is not None:
                last[place] = repeat(owners[part], length)

    def fill_figure(self, x: int, y: int, rows: FigureRows, color: int, pattern: bytes) -> None:
        """The rows of a figure at x, y, in a fill pattern."""
        ys, left, right = rows
        if abs(x) < FAR and abs(y) < FAR:
            first, last = ys.searchsorted((self._top - y, self._bottom + 1 - y)).tolist()
            shown = slice(first, last)
            ends = (left[shown] + x).tolist(), (right[shown] + x).tolist()
            self.fill_rows(((ys[shown] + y).tolist(), *ends), color, pattern)

    def fill_region(self, x: int, y: int, region: Region, color: int, pattern: bytes) -> bool:
        """Fill a kept region at x, y; False, and nothing is done, if the clipping box cuts it."""
        rows, left, top, right, bottom = region
        if not self.holds(x + left, y + top, x + right, y + bottom):
            return not self.meets(x + left, y + top, x + right, y + bottom)
        place = (y + top) * self.width + x + left
        pixels = self._row[place:]
        if pattern == SOLID_ROWS:
            pieces = _pieces(color, self.width, self.flat.dtype)
            for here, _, length in rows:
                pixels[here] = pieces[length]
        else:
            inked = self._ink(color, pattern).block.ravel().data[place % (8 * self.width) :]
            for here, there, _ in rows:
                pixels[here] = inked[there]
        return True

    # Floods

    def area(self, x: int, y: int, border: int, color: int, rows: bytes) -> Rows:
        """The area around x, y up to a border colour, as a fill with that colour would find it."""
        left, top, right, bottom = view = self.box
        if not (left <= x <= right and top <= y <= bottom):
            return [], [], []
        near = (
            max(x - _NEAR, left),
            max(y - _NEAR, top),
            min(x + _NEAR, right),
            min(y + _NEAR, bottom),
        )
        if near != view and not self._opens(near, x, y, border):
            found = self._area_within(near, x, y, border, color, rows)
            if not _leaves(found, near, view):
                return found
        return self._area_within(view, x, y, border, color, rows)

    def _opens(self, box: Box, x: int, y: int, border: int) -> bool:
        """Whether the pixels beside x, y lead to a side of a box that is none of the viewport's."""
        left, _, right, _ = box
        row = (self.array[y, left : right + 1] == self.numbers[border]).tobytes()
        return (left > self._left and row.rfind(_BORDER, 0, x - left) < 0) or (
            right < self._right and row.find(_BORDER, x - left) < 0
        )

    def _area_within(self, box: Box, x: int, y: int, border: int, color: int, rows: bytes) -> Rows:
        """What of an area a flood finds that stays within a box."""
        left, top, right, bottom = box
        width = right - left + 2
        place = (y - top + 1) * width + x - left
        pixels = np.full((bottom - top + 3, width), border, self.flat.dtype)  # and a rim
        pixels[1:-1, :-1] = self.array[top : bottom + 1, left : right + 1]
        inside = pixels != self.numbers[border]
        if not inside.item(place):
            return [], [], []
        ways = self._unfilled(pixels, box, color, rows)
        ways &= inside
        # The driver looks for a pixel to go on from between the outer columns only.
        if left == self._left:
            ways[:, 0] = False
        if right == self._right:
            ways[:, -2] = False
        starts, ends = flood(bytearray(inside), bytearray(ways), width, place)
        first = top - 1
        return (
            [start // width + first for start in starts],
            [start % width + left for start in starts],
            [(end - 1) % width + left for end in ends],
        )

    def _unfilled(self, pixels: Pixels, box: Box, color: int, rows: bytes) -> Mask:
        """Which pixels of a box, and of the rim around, a fill would change.

        Rows that the pattern leaves empty count whole, so that the flood crosses them.
        """
        if rows == SOLID_ROWS:
            changed: Mask = pixels != self.numbers[color]
            return changed
        left, top, right, bottom = box
        row = np.arange(top, bottom + 1) & 7
        inked = pixels.copy()
        inked[1:-1, :-1] = self._ink(color, rows).block[row, left : right + 1]
        changed = pixels != inked
        empty = np.frombuffer(rows, np.uint8)[row] == 0
        changed[1:-1] |= empty[:, np.newaxis]
        return changed


def _leaves(area: Rows, box: Box, view: Box) -> bool:
    """Whether an area comes to a side of a box that is none of the viewport's."""
    y, first, last = area
    reached = zip(box, view, (first, y, last, y), strict=True)
    return any(side != end and side in places for side, end, places in reached)


class _Pieces(dict[int, memoryview]):
    """Pieces of a row of one colour, to copy from, by their length."""

    def __init__(self, row: memoryview) -> None:
        super().__init__()
        self._row = row

    def __missing__(self, length: int) -> memoryview:
        piece = self[length] = self._row[:length]
        return piece


@lru_cache(maxsize=64)
def _pieces(color: int, width: int, dtype: np.dtype[Any]) -> _Pieces:
    """Pieces of a row of that width."""
    return _Pieces(np.full(width, color, dtype).data)
