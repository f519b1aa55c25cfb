"""One page of pixels: the only place where a pixel is set.

A page is a numpy array, a memoryview and a pygame surface over the same bytes, each used where it
is fastest: the memoryview for one pixel, pygame for solid lines and boxes, numpy for everything
that is many. All coordinates are absolute; everything is clipped to the box given to `clip_to`.
"""

from collections.abc import Iterator
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bgi.memory.boxes import overlap, within
from bgi.memory.operators import OPERATORS
from bgi.memory.scrolling import scroll
from bgi.memory.sdl import pygame
from bgi.raster import lines
from bgi.raster.ellipses import Offset, Outline
from bgi.raster.floodfill import flood
from bgi.raster.lines import Box, Ints, Segments
from bgi.raster.offsets import Offsets
from bgi.raster.patterns import EMPTY_ROWS, SOLID_MASK, SOLID_ROWS, screen_mask
from bgi.raster.polygons import Rows
from bgi.raster.spans import Spans

Mask = NDArray[np.bool_]
Cuts = dict[int, memoryview]
Pixels = NDArray[Any]

_PIXEL: dict[int, np.dtype[Any]] = {1: np.dtype(np.uint8), 4: np.dtype("<u4")}
_FORMAT: dict[int, Literal["P", "RGBX"]] = {1: "P", 4: "RGBX"}

FAR = 1 << 40
"""Nothing of a curve or text so far away can be seen; below it int64 holds its points."""


class Page:
    """The pixels of one screen, and the box that drawing is clipped to."""

    def __init__(self, memory: memoryview, width: int, height: int, pixel_bytes: int = 1) -> None:
        """Lay a page over `memory`, rows from top to bottom.

        A pixel is a palette index of one byte, or four bytes that hold an index or an RGB colour:
        to a page both are just numbers.
        """
        self.width = width
        self.height = height
        self.flat: Pixels = np.frombuffer(memory, dtype=_PIXEL[pixel_bytes])
        self.array = self.flat.reshape(height, width)
        self._pixels = self.array.data
        self._row = self.flat.data
        self._surface = pygame.image.frombuffer(memory, (width, height), _FORMAT[pixel_bytes])
        self._marks = bytearray(width * height), bytearray(width * height)
        self._all = 0, 0, width - 1, height - 1
        self.clip_to(self._all)

    def clip_to(self, box: Box) -> None:
        """Confine all drawing to left, top, right, bottom (inclusive, within the page)."""
        self.box = box
        self._left, self._top, self._right, self._bottom = box
        left, top, right, bottom = box
        self._surface.set_clip((left, top, right - left + 1, bottom - top + 1))

    # Pixels

    def get(self, x: int, y: int) -> int:
        """The index at x, y, wherever the clipping box is; 0 off the page."""
        if 0 <= x < self.width and 0 <= y < self.height:
            return int(self._pixels[y, x])
        return 0

    def put(self, x: int, y: int, value: int) -> None:
        """Set one pixel."""
        if self._left <= x <= self._right and self._top <= y <= self._bottom:
            self._pixels[y, x] = value

    def get_many(self, x: Ints, y: Ints) -> Pixels:
        """`get` for arrays."""
        inside = within(x, y, self._all)
        values = np.zeros(len(x), dtype=self.flat.dtype)
        place = y[inside] * self.width + x[inside]
        values[inside] = self.flat[place.astype(np.int64, copy=False)]
        return values

    def put_many(self, x: Ints, y: Ints, values: Ints | int) -> None:
        """`put` for arrays, in order: of two at the same place the later one stays."""
        if len(x) == 0:
            return
        left, top, right, bottom = self.box
        if x.min() < left or x.max() > right or y.min() < top or y.max() > bottom:
            inside = within(x, y, self.box)
            x = x[inside].astype(np.int64, copy=False)
            y = y[inside].astype(np.int64, copy=False)
            values = values if isinstance(values, int) else values[inside]
        self.flat[y * self.width + x] = values

    # Lines

    def line(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """A thin solid line."""
        left, top, right, bottom = self.box
        if not (
            left <= x1 <= right
            and left <= x2 <= right
            and top <= y1 <= bottom
            and top <= y2 <= bottom
        ):
            visible = lines.clip(x1, y1, x2, y2, self.box)
            if visible is None:
                return
            x1, y1, x2, y2 = visible
        # From its lower end to its upper one, pygame's line (Bresenham's, too) sets exactly the
        # driver's pixels: ties step to the same side.
        if y1 < y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        pygame.draw.line(self._surface, color, (x1, y1), (x2, y2))

    def styled_line(self, segment: lines.Segment, color: int, pattern: Mask, xor: bool) -> None:
        """A thin line in a pattern, from its first clipped pixel on."""
        visible = lines.clip(*segment, self.box)
        if visible is None:
            return
        place = self._places(visible)
        if pattern is not SOLID_MASK:
            place = place[pattern[: len(place)]]
        if xor:  # no pixel occurs twice in one line
            self.flat[place] ^= color
        else:
            self.flat[place] = color

    def _places(self, segment: lines.Segment) -> Ints:
        """The pixels of a thin line within the clipping box, in drawing order."""
        return lines.places(segment, 1, self.width)

    def line_many(self, segments: Segments, colors: Ints, pattern: Mask, xor: bool) -> None:
        """Thin lines one after another, each in its colour."""
        for place, which in self._trace(segments, pattern):
            if xor:  # where lines cross, both count
                np.bitwise_xor.at(self.flat, place, colors[which].astype(self.flat.dtype))
            else:
                self.flat[place] = colors[which]

    def _trace(self, segments: Segments, pattern: Mask) -> Iterator[tuple[Ints, Ints]]:
        """The pixels of many lines, clipped: their places, and which line each belongs to."""
        visible, kept = lines.clip_many(segments, self.box)
        x1, y1, x2, y2 = (end.astype(np.int64, copy=False) for end in visible)
        lengths = np.maximum(abs(x2 - x1), abs(y2 - y1)) + 1
        for part in lines.grouped(lengths, lines.CHUNK):
            x, y, step, which = self._pixels_of((x1[part], y1[part], x2[part], y2[part]))
            place = y * self.width + x
            if pattern is not SOLID_MASK:
                drawn = pattern[step]
                place, which = place[drawn], which[drawn]
            yield place, kept[part][which]

    def _pixels_of(self, segments: Segments) -> tuple[Ints, Ints, Ints, Ints]:
        """The pixels of thin lines within the clipping box, as `lines.trace_many` returns them."""
        return lines.trace_many(segments)

    # Boxes

    def fill(self, box: Box, color: int, rows: bytes = SOLID_ROWS) -> None:
        """A box, both corners included, in a fill pattern of eight rows."""
        left, top = max(box[0], self._left), max(box[1], self._top)
        right, bottom = min(box[2], self._right), min(box[3], self._bottom)
        if left > right or top > bottom:
            return
        if rows in (SOLID_ROWS, EMPTY_ROWS):
            shown = color if rows == SOLID_ROWS else 0
            self._surface.fill(shown, (left, top, right - left + 1, bottom - top + 1))
        else:
            part = slice(top, bottom + 1), slice(left, right + 1)
            mask = screen_mask(rows, self.width, self.height)
            self.array[part] = self._inked(mask[part], color)

    def outline(self, left: int, top: int, right: int, bottom: int, color: int) -> None:
        """The four sides of a box, thin and solid; corners in any order."""
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        # A side that cannot be seen goes beside the clipping box: pygame takes small numbers only.
        if left < self._left:
            left = self._left - 1
        if top < self._top:
            top = self._top - 1
        if right > self._right:
            right = self._right + 1
        if bottom > self._bottom:
            bottom = self._bottom + 1
        if left <= right and top <= bottom:
            box = (left, top, right - left + 1, bottom - top + 1)
            pygame.draw.rect(self._surface, color, box, 1)

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
            mask = screen_mask(rows, self.width, self.height)[part]
            np.not_equal(self.array[part], self._inked(mask, color), out=marks[part])
            marks[part] |= ~mask.any(axis=1, keepdims=True)

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

    def _inked(self, mask: Mask, color: int) -> Pixels:
        """A colour where the mask is set, index 0 elsewhere."""
        number = self.flat.dtype.type
        inked: Pixels = np.where(mask, number(color), number(0))
        return inked

    # Polygons

    def fill_rows(self, where: Rows, color: int, pattern: bytes) -> None:
        """Rows of pixels, each y within the clipping box, in a fill pattern."""
        left, right, width, pixels = self._left, self._right, self.width, self._row
        whole, cut = _row_of(color, width, self.flat.dtype)
        mask = None if pattern == SOLID_ROWS else screen_mask(pattern, width, self.height)
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
            if mask is not None:
                self.array[y, a:b] = self._inked(mask[y, a:b], color)
                continue
            try:
                ink = cut[b - a]
            except KeyError:
                ink = cut[b - a] = whole[: b - a]
            y *= width
            pixels[y + a : y + b] = ink

    def _patterned(self, place: Ints, colors: Ints, rows: bytes) -> Ints:
        """What a fill writes at those places."""
        if rows == SOLID_ROWS:
            return colors
        return np.where(screen_mask(rows, self.width, self.height).ravel()[place], colors, 0)

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

    def paint(
        self,
        spans: Spans,
        fills: Ints,
        rows: bytes,
        sides: Segments,
        owners: Ints,
        colors: Ints,
        pattern: Mask,
    ) -> None:
        """Polygons in painter's order: one's spans and sides, then the next one's over them.

        `fills` and `colors` are the polygons' colours, `owners` says whose side each segment is.
        """
        place, lengths = self.fill_spans(spans, fills, rows)
        covered = len(spans.owner) and len(owners) and spans.owner[-1] > owners[0]
        if covered:
            last_fill = np.full(self.flat.shape, -1, dtype=np.int32)
            last_fill[place] = np.repeat(spans.owner, lengths)
        for edge, side in self._trace(sides, pattern):
            drawn_by = owners[side]
            if covered:  # a pixel of a side stays unless a later polygon's fill covers it
                survives = last_fill[edge] <= drawn_by
                edge, drawn_by = edge[survives], drawn_by[survives]
            self.flat[edge] = colors[drawn_by]

    # Curves, stamps and whole pages

    def curve(self, x: int, y: int, outline: Outline, color: int) -> None:
        """A thin curve around x, y."""
        dx, dy, place, left, top, right, bottom = outline
        if (
            self._left <= x + left
            and x + right <= self._right
            and self._top <= y + top
            and y + bottom <= self._bottom
        ):
            self.flat[place + (y * self.width + x)] = color
        elif max(abs(x), abs(y)) < FAR:
            self.put_many(x + dx, y + dy, color)

    def put_offsets(self, x: int, y: int, figure: Offsets, color: int, xor: bool) -> bool:
        """Draw a kept figure at x, y; False, and nothing is drawn, if the clipping box cuts it."""
        place, left, top, right, bottom = figure
        if (
            self._left <= x + left
            and x + right <= self._right
            and self._top <= y + top
            and y + bottom <= self._bottom
        ):
            if xor:
                self.flat[place + (y * self.width + x)] ^= color
            else:
                self.flat[place + (y * self.width + x)] = color
            return True
        return (
            x + right < self._left
            or x + left > self._right
            or y + bottom < self._top
            or y + top > self._bottom
        )

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

    def stamp(self, x: int, y: int, mask: Mask, color: int) -> None:
        """Put a colour wherever `mask`, which lies on the page with its corner at x, y, is True."""
        height, width = mask.shape
        self.array[y : y + height, x : x + width][mask] = color

    def print(self, x: int, y: int, mask: Mask, color: int) -> None:
        """Put a colour where `mask` is True and index 0 where it is not, whatever the clipping box.

        So the BIOS writes; what is off the page is cut.
        """
        found = overlap(x, y, mask.shape, self._all)
        if found:
            here, there = found
            self.array[here] = self._inked(mask[there], color)

    def scroll(self, box: Box, lines: int) -> None:
        """Move a box up by so many rows (less than 0: down), whatever the clipping box.

        Index 0 comes behind. What is off the page is cut.
        """
        left, top, right, bottom = box
        scroll(self.array[top : bottom + 1, left : right + 1], lines, 0)

    def copy(self, x: int, y: int, width: int, height: int) -> Pixels:
        """A copy of the pixels from x, y on, wherever the clipping box is; 0 off the page."""
        taken = np.zeros((height, width), dtype=self.flat.dtype)
        found = overlap(x, y, taken.shape, self._all)
        if found:
            here, there = found
            taken[there] = self.array[here]
        return taken

    def combine(self, x: int, y: int, image: Pixels, op: int, mask: int) -> None:
        """Put an image with its corner at x, y by a putimage operator, cut at the page's edges."""
        found = overlap(x, y, image.shape, self._all)
        if found:
            here, there = found
            bits = self.flat.dtype.type(mask)
            OPERATORS[op](self.array[here], image[there] & bits, bits)

    def clear(self) -> None:
        """The whole page becomes index 0, whatever the clipping box."""
        self.flat.fill(0)


@lru_cache(maxsize=64)
def _row_of(color: int, width: int, dtype: np.dtype[Any]) -> tuple[memoryview, Cuts]:
    """A row of one colour to copy from, and what has been cut from its beginning, by length."""
    return np.full(width, color, dtype).data, {}
