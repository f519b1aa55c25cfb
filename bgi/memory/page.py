"""One page of a screen: what draws on it. Pages are the only place where a pixel is set.

All coordinates are absolute; everything is clipped to the box given to `clip_to`.
"""

from functools import reduce
from operator import and_

import numpy as np

from bgi.memory.areas import OWNER
from bgi.memory.boxes import within
from bgi.memory.pixmap import Pixels
from bgi.memory.strokes import Strokes
from bgi.raster import lines
from bgi.raster.ellipses import Curve
from bgi.raster.lines import Ints, Segments
from bgi.raster.offsets import Offsets
from bgi.raster.patterns import SOLID_ROWS, Dashes
from bgi.raster.spans import Spans


class Page(Strokes):
    """A page to draw lines, curves and polygons with their outlines on."""

    # Polygons

    def paint(
        self,
        spans: Spans,
        fills: Ints,
        rows: bytes,
        sides: Segments,
        owners: Ints,
        colors: Ints,
        style: Dashes,
    ) -> None:
        """Polygons in painter's order: one's spans and sides, then the next one's over them.

        `fills` and `colors` are the polygons' colours, `owners` says whose side each segment is.
        """
        covered = len(spans.owner) and len(owners) and spans.owner[-1] > owners[0]
        last_fill = np.full(self.flat.shape, -1, dtype=OWNER) if covered else None
        self.fill_spans(spans, fills, rows, last_fill)
        if not len(owners):
            return
        visible, kept = lines.clip_many(sides, self.box)
        owners, inks = owners[kept].astype(OWNER), colors.astype(self.flat.dtype)
        for edge, side in self._trace(visible, style):
            drawn_by = owners[side]
            if last_fill is not None:
                # A pixel of a side stays unless a later polygon's fill covers it.
                survives = last_fill[edge] <= drawn_by
                edge, drawn_by = edge[survives], drawn_by[survives]
            self.flat[edge] = inks[drawn_by]

    # Curves

    def curve(self, x: int, y: int, curve: Curve, color: int) -> None:
        """A thin curve around x, y."""
        if not self.put_offsets(x, y, curve.pixels, color, False):
            self.put_cut(x, y, curve, color)

    def put_mirrored(self, x: int, y: int, quadrant: Ints, color: int) -> None:
        """A thin ellipse around x, y, by the points of its upper right quadrant."""
        across, up = quadrant
        if not len(up):
            return
        rx, ry = int(across[-1]), int(up[0])
        if self.holds(x - rx, y - ry, x + rx, y + ry):
            place, rows, ink = y * self.width + x, up * self.width, self.numbers[color]
            for part in (across - rows, across + rows):
                self.flat[place + part] = ink
                self.flat[place - part] = ink
        elif self.meets(x - rx, y - ry, x + rx, y + ry):
            left, right, above, below = x - across, x + across, y - up, y + up
            xs = np.concatenate((right, left, right, left))
            ys = np.concatenate((above, above, below, below))
            seen = within(xs, ys, self.box)
            self.flat[(ys * self.width + xs)[seen]] = color

    def put_cut(self, x: int, y: int, curve: Curve, color: int) -> None:
        """What is seen of a thin curve that the clipping box cuts."""
        dx, dy, (place, left, top, right, bottom) = curve
        cut = []  # by one edge mostly
        if x + left < self._left:
            cut.append(dx >= self._left - x)
        if x + right > self._right:
            cut.append(dx <= self._right - x)
        if y + top < self._top:
            cut.append(dy >= self._top - y)
        if y + bottom > self._bottom:
            cut.append(dy <= self._bottom - y)
        seen = place.compress(reduce(and_, cut))
        self.flat[seen + ((y + top) * self.width + x + left)] = color

    def put_seen(self, x: int, y: int, figure: Offsets, color: int, xor: bool) -> None:
        """What is seen of a kept figure that the clipping box cuts and changes nowhere else."""
        down = figure.place // self.width
        across = figure.place - down * self.width
        left, top = x + figure.left, y + figure.top
        seen = figure.place[within(across + left, down + top, self.box)] + (top * self.width + left)
        if xor:
            self.flat[seen] ^= self.numbers[color]
        else:
            self.flat[seen] = color

    def fill_offsets(self, x: int, y: int, figure: Offsets, color: int, pattern: bytes) -> bool:
        """`put_offsets` in a fill pattern, for x, y within the clipping box."""
        if pattern == SOLID_ROWS:
            return self.put_offsets(x, y, figure, color, False)
        eight_rows = 8 * self.width
        start = ((y + figure.top) * self.width + x + figure.left) % eight_rows
        inks = self._ink(color, pattern).block.ravel()[(figure.place + start) % eight_rows]
        return self.put_offsets(x, y, figure, inks, False)

    def put_offsets(self, x: int, y: int, figure: Offsets, color: int | Pixels, xor: bool) -> bool:
        """Draw a kept figure at x, y; False, and nothing is drawn, if the clipping box cuts it."""
        place, left, top, right, bottom = figure
        if (
            self._left <= x + left
            and x + right <= self._right
            and self._top <= y + top
            and y + bottom <= self._bottom
        ):
            pixels = self.flat[(y + top) * self.width + x + left :]
            if type(color) is int:
                color = self.numbers[color]
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
