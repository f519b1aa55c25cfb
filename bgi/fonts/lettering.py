"""Stroked letters as pixels, kept: those of one font, size and direction, and texts made of them.

A letter is drawn from its strokes once, and then from its offsets wherever the pen begins. Where an
edge cuts it the strokes are clipped, one by one, and their pixels may be others: that is not kept.
A text is kept as a whole when it is met for the second time: the one of a score, or of a clock,
never comes again.
"""

from functools import lru_cache
from itertools import accumulate
from operator import add
from typing import NamedTuple

import numpy as np

from bgi.fonts import layout
from bgi.fonts.chr import StrokedFont
from bgi.fonts.codepage import REMEMBERED
from bgi.fonts.layout import Scale
from bgi.raster.kept import Kept
from bgi.raster.lines import Trace
from bgi.raster.offsets import Offsets, figure, odd, offsets, reach

KEPT_OF_A_LETTER, KEPT_OF_A_TEXT = 2048, 8192
"""Pixels of a letter and of a text that are kept, eight bytes each; larger ones are not. All that
is kept of letters takes at most 32 megabytes."""


class Lettering:
    """A way to draw letters: equal to itself only, a quick key for caches."""

    def __init__(
        self, font: StrokedFont, scale: Scale, vertical: bool, xor: bool, trace: Trace, width: int
    ) -> None:
        """In a font, size and direction, on pages of that width, by XOR or not."""
        self.font, self.scale, self.vertical = font, scale, vertical
        self.xor, self.trace, self.width = xor, trace, width


lettering = lru_cache(maxsize=64)(Lettering)


class Letter(NamedTuple):
    """A letter's pixels, seen from where the pen begins; how far the pen moves on."""

    pixels: Offsets | None
    """None if there are too many to keep."""
    across: int
    down: int


@lru_cache(maxsize=2048)
def letter(way: Lettering, code: int) -> Letter:
    """One letter."""
    advance = layout.advance(way.font, code, way.scale)
    move = (0, -advance) if way.vertical else (advance, 0)
    strokes = layout.strokes(way.font, code, way.scale, way.vertical)
    x1, y1, x2, y2 = strokes.T
    if (np.maximum(abs(x2 - x1), abs(y2 - y1)) + 1).sum() > KEPT_OF_A_LETTER:
        return Letter(None, *move)
    x, y, _, _ = way.trace((x1, y1, x2, y2))
    return Letter(figure(x, y, reach(x, y), way.width, way.xor), *move)


def text(way: Lettering, codes: bytes, horiz: int, vert: int) -> Offsets | tuple[()] | None:
    """A justified text that is met again, seen from its point; nothing if it is too large."""
    return TEXTS.again(way, codes, horiz, vert) if len(codes) <= REMEMBERED else None


def _text(way: Lettering, codes: bytes, horiz: int, vert: int) -> Offsets | tuple[()]:
    letters = [letter(way, code) for code in codes]
    pixels = [one.pixels for one in letters]
    if not pixels or None in pixels:
        return ()
    place, left, top, right, bottom = zip(*pixels, strict=True)
    _, across, down = zip(*letters, strict=True)
    counts = list(map(len, place))
    if sum(counts) > KEPT_OF_A_TEXT:
        return ()
    x, y = layout.anchor(way.font, codes, way.scale, way.vertical, horiz, vert)
    pens = accumulate(across[:-1], initial=x), accumulate(down[:-1], initial=y)
    xs, ys = map(list, pens)
    xs_left, ys_top = list(map(add, xs, left)), list(map(add, ys, top))
    # A letter without pixels reaches from nowhere: no place has so many bits.
    corners = zip(xs_left, ys_top, counts, strict=True)
    starts = [x + y * way.width if count else 0 for x, y, count in corners]
    places = np.concatenate(place)
    places += np.array(starts).repeat(counts)
    extent = min(xs_left), min(ys_top), max(map(add, xs, right)), max(map(add, ys, bottom))
    return offsets(odd(places) if way.xor else places, extent, way.width)


TEXTS = Kept(_text, 1 << 23)
"""By the way they are written, by their characters, and by how they are justified."""
