"""Lines on a page: thin or thick, solid or in a pattern, copied or by XOR.

What is usual goes the fastest way: pygame's for slanted solid lines, slices of the page for level
and upright ones, whole numbers in numpy for patterns and XOR.
"""

from collections.abc import Iterator

import numpy as np

from bgi.memory.areas import Areas
from bgi.memory.backend import draw_box, draw_line
from bgi.memory.boxes import within
from bgi.raster import lines
from bgi.raster.lines import Ints, Segments
from bgi.raster.patterns import SOLID, Dashes

_LONG = 48
"""Steps of a line on average: from here on one line after another is faster than all at once."""


class Strokes(Areas):
    """A page to draw lines on."""

    trace = staticmethod(lines.trace_many)
    course = staticmethod(lines.course)
    """How the driver draws lines."""

    def line(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """A thin solid line."""
        if (
            x1 < self._left
            or x1 > self._right
            or x2 < self._left
            or x2 > self._right
            or y1 < self._top
            or y1 > self._bottom
            or y2 < self._top
            or y2 > self._bottom
        ):
            visible = lines.clip(x1, y1, x2, y2, self.box)
            if visible is None:
                return
            x1, y1, x2, y2 = visible
        if y1 == y2:
            first, last = (x1, x2) if x1 < x2 else (x2, x1)
            row = y1 * self.width
            self.flat[row + first : row + last + 1] = color
        elif x1 == x2:
            first, last = (y1, y2) if y1 < y2 else (y2, y1)
            self.array[first : last + 1, x1] = color
        # From its lower end to its upper one, pygame's line (Bresenham's, too) sets exactly the
        # driver's pixels: ties step to the same side.
        elif y1 < y2:
            draw_line(self._surface, color, (x2, y2), (x1, y1))
        else:
            draw_line(self._surface, color, (x1, y1), (x2, y2))

    def thick_line(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """A thick solid line: three thin ones, each clipped on its own."""
        if y1 == y2:
            self.fill(x1, y1 - 1, x2, y1 + 1, color)
        elif x1 == x2:
            self.fill(x1 - 1, y1, x1 + 1, y2, color)
        elif (
            self._left < x1 < self._right
            and self._left < x2 < self._right
            and self._top < y1 < self._bottom
            and self._top < y2 < self._bottom
            and x2 - x1 != y2 - y1 != x1 - x2  # pygame widens diagonals in x, the kernel in y
        ):
            if y1 < y2:
                x1, y1, x2, y2 = x2, y2, x1, y1
            draw_line(self._surface, color, (x1, y1), (x2, y2), 3)
        else:
            for strand in lines.strands(x1, y1, x2, y2):
                self.line(*strand, color)

    def styled_line(
        self, x1: int, y1: int, x2: int, y2: int, color: int, style: Dashes, xor: bool
    ) -> None:
        """A thin line in a pattern, from its first clipped pixel on."""
        if (
            x1 < self._left
            or x1 > self._right
            or x2 < self._left
            or x2 > self._right
            or y1 < self._top
            or y1 > self._bottom
            or y2 < self._top
            or y2 > self._bottom
        ):
            visible = lines.clip(x1, y1, x2, y2, self.box)
            if visible is None:
                return
            x1, y1, x2, y2 = visible
        course = first, n, m, along, across = self.course(x1, y1, x2, y2, self.width)
        if m == 0 or m == n:  # level, upright or diagonal
            self._put_evenly(first, along + across if m else along, n, color, style, xor)
            return
        place = lines.places(course)
        if style is not SOLID:
            place = place[style.upto(n)]
        if xor:  # no pixel occurs twice
            pixels = self.flat[place]
            pixels ^= self.numbers[color]
            self.flat[place] = pixels
        else:
            self.flat[place] = self.numbers[color]

    def _put_evenly(
        self, first: int, step: int, n: int, color: int, style: Dashes, xor: bool
    ) -> None:
        """A line whose n steps all lead as far over the page."""
        pixels = self.flat[first::step]
        if style is not SOLID:
            place = style.upto(n)
            if xor:
                pixels[place] ^= self.numbers[color]
            else:
                pixels[place] = color
        elif xor:
            pixels = pixels[: n + 1]
            pixels ^= self.numbers[color]
        else:
            pixels[: n + 1] = color

    def styled_outline(
        self, left: int, top: int, right: int, bottom: int, color: int, style: Dashes, xor: bool
    ) -> None:
        """The four sides of a box as four thin lines in a pattern."""
        inside = (
            self._left <= left <= self._right
            and self._left <= right <= self._right
            and self._top <= top <= self._bottom
            and self._top <= bottom <= self._bottom
        )
        if inside and style is SOLID and xor and left != right and top != bottom:
            self._xor_outline(left, top, right, bottom, color)
            return
        for side in (
            (left, top, right, top),
            (right, top, right, bottom),
            (right, bottom, left, bottom),
            (left, bottom, left, top),
        ):
            if inside:
                first, n, _, along, _ = self.course(*side, self.width)
                self._put_evenly(first, along, n, color, style, xor)
            else:
                self.styled_line(*side, color, style, xor)

    def _xor_outline(self, left: int, top: int, right: int, bottom: int, color: int) -> None:
        """The sides of a box within the clipping box, two at a time; its corners twice."""
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        box = self.array[top : bottom + 1, left : right + 1]
        ink = self.numbers[color]
        for sides in (box[:: bottom - top], box[:, :: right - left]):
            np.bitwise_xor(sides, ink, sides)

    def line_many(self, segments: Segments, colors: Ints, style: Dashes, xor: bool) -> None:
        """Thin lines one after another, each in its colour."""
        visible, kept = lines.clip_many(segments, self.box)
        colors = colors[kept]
        if lines.steps_of(visible).sum() > _LONG * len(kept):
            each = zip(*(numbers.tolist() for numbers in (*visible, colors)), strict=True)
            if style is SOLID and not xor:
                for x1, y1, x2, y2, color in each:
                    self.line(x1, y1, x2, y2, color)
            else:
                for x1, y1, x2, y2, color in each:
                    self.styled_line(x1, y1, x2, y2, color, style, xor)
            return
        inks = colors.astype(self.flat.dtype)
        for place, which in self._trace(visible, style):
            if xor:  # where lines cross, both count
                np.bitwise_xor.at(self.flat, place, inks[which])
            else:
                self.flat[place] = inks[which]

    def thick_lines(self, segments: Segments, color: int, xor: bool) -> None:
        """The thick solid lines of one figure, in any order.

        What nothing clips is traced at once; an edge cuts a few lines only.
        """
        left, top, right, bottom = self.box
        x1, y1, x2, y2 = segments
        inner = left + 1, top + 1, right - 1, bottom - 1
        whole = within(x1, y1, inner) & within(x2, y2, inner)
        x, y, _ = lines.trace_strands(self.trace, (x1[whole], y1[whole], x2[whole], y2[whole]))
        place = y * self.width + x
        if xor:
            np.bitwise_xor.at(self.flat, place, self.numbers[color])
        else:
            self.flat[place] = color
        cut = ~(whole | lines.beyond(segments, (left - 1, top - 1, right + 1, bottom + 1)))
        for side in np.stack(segments, axis=-1)[cut].tolist():
            for strand in lines.strands(*side):
                self.styled_line(*strand, color, SOLID, xor)

    def _trace(self, segments: Segments, style: Dashes) -> Iterator[tuple[Ints, Ints]]:
        """The pixels of many lines within the clipping box, and which line each belongs to."""
        x1, y1, x2, y2 = (end.astype(np.int64, copy=False) for end in segments)
        for part in lines.grouped(lines.steps_of(segments) + 1, lines.CHUNK):
            x, y, step, which = self.trace((x1[part], y1[part], x2[part], y2[part]))
            place = y * self.width + x
            which += part.start
            if style is not SOLID:
                drawn = style.drawn[step]
                place, which = place[drawn], which[drawn]
            yield place, which

    def outline(self, left: int, top: int, right: int, bottom: int, color: int) -> None:
        """The four sides of a box, thin and solid; corners in any order."""
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        if (
            left >= self._left
            and top >= self._top
            and right <= self._right
            and bottom <= self._bottom
        ):
            draw_box(self._surface, color, (left, top, right - left + 1, bottom - top + 1), 1)
            return
        self.line(left, top, right, top, color)
        self.line(right, top, right, bottom, color)
        self.line(right, bottom, left, bottom, color)
        self.line(left, bottom, left, top, color)
