"""One page of a screen: what draws on it. Pages are the only place where a pixel is set.

All coordinates are absolute; everything is clipped to the box given to `clip_to`.
"""

from collections.abc import Iterator

import numpy as np

from bgi.memory.areas import Areas
from bgi.memory.boxes import between
from bgi.memory.pixmap import Mask
from bgi.memory.sdl import pygame
from bgi.raster import lines
from bgi.raster.ellipses import Curve
from bgi.raster.lines import Ints, Segments
from bgi.raster.offsets import Offsets
from bgi.raster.patterns import SOLID_MASK
from bgi.raster.spans import Spans


class Page(Areas):
    """A page to draw lines, curves and polygons with their outlines on."""

    trace = staticmethod(lines.trace_many)
    """How the driver draws lines."""

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
            x, y, step, which = self.trace((x1[part], y1[part], x2[part], y2[part]))
            place = y * self.width + x
            if pattern is not SOLID_MASK:
                drawn = pattern[step]
                place, which = place[drawn], which[drawn]
            yield place, kept[part][which]

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

    # Polygons

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

    # Curves

    def curve(self, x: int, y: int, curve: Curve, color: int) -> None:
        """A thin curve around x, y."""
        dx, dy, pixels = curve
        if self.put_offsets(x, y, pixels, color, False):
            return
        place, left, top, right, bottom = pixels
        if x + left < self._left or x + right > self._right:
            seen = between(dx, self._left - x, self._right - x)
            place, dy = place[seen], dy[seen]
        if y + top < self._top or y + bottom > self._bottom:
            place = place[between(dy, self._top - y, self._bottom - y)]
        self.flat[place + ((y + top) * self.width + x + left)] = color

    def put_offsets(self, x: int, y: int, figure: Offsets, color: int, xor: bool) -> bool:
        """Draw a kept figure at x, y; False, and nothing is drawn, if the clipping box cuts it."""
        place, left, top, right, bottom = figure
        if (
            self._left <= x + left
            and x + right <= self._right
            and self._top <= y + top
            and y + bottom <= self._bottom
        ):
            pixels = self.flat[(y + top) * self.width + x + left :]
            if xor:
                pixels[place] ^= color
            else:
                pixels[place] = color
            return True
        return (
            x + right < self._left
            or x + left > self._right
            or y + bottom < self._top
            or y + top > self._bottom
        )
