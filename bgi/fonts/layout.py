"""From a string to pen strokes on the screen, by the kernel's integer rules.

Every coordinate is multiplied, divided, and truncated toward zero, on its own. The pen advances
after each character by the character's truncated width, but `textwidth` truncates only the sum:
drawn text can be a little narrower than it says. A character without strokes does not move the pen,
although `textwidth` counts it; a blank is one movement. Vertical text is the same turned by 90
degrees counter-clockwise, so that it reads upward.
"""

from functools import lru_cache
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bgi.constants import CENTER_TEXT, RIGHT_TEXT, TOP_TEXT
from bgi.fonts.chr import StrokedFont
from bgi.fonts.codepage import REMEMBERED


class Scale(NamedTuple):
    """Width times mx / dx, height times my / dy; 16-bit numbers as in C, divisors not 0."""

    mx: int
    dx: int
    my: int
    dy: int


SIZES = {
    size: Scale(mult, div, mult, div)
    for size, (mult, div) in enumerate(
        [(3, 5), (2, 3), (3, 4), (1, 1), (4, 3), (5, 3), (2, 1), (5, 2), (3, 1), (4, 1)], start=1
    )
}
"""What settextstyle's sizes 1..10 mean for stroked fonts."""


MAX_CHARACTERS = 1 << 16
"""Of a text in a stroked font: C's strings are no longer."""

KEPT_OF_A_LETTER, KEPT_OF_A_TEXT = 128, 8192
"""Strokes of a letter and of a text that are kept, 32 bytes each: Borland's letters have up to 126,
those of another font file may have thousands. All that is kept takes at most 4 and 32 megabytes."""

_NOTHING = np.empty((0, 4), dtype=np.int64)


def _scaled(number: int, mult: int, div: int) -> int:
    """number * mult / div, truncated toward zero as C does."""
    product = number * mult
    quotient = abs(product) // abs(div)
    return quotient if (product < 0) == (div < 0) else -quotient


def textwidth(font: StrokedFont, text: bytes, scale: Scale) -> int:
    """The width of a text: the sum of its characters' widths, then truncated once.

    ValueError for a text that is too long.
    """
    if len(text) <= REMEMBERED:
        return _known_width(font, text, scale)
    if len(text) > MAX_CHARACTERS:
        raise ValueError(
            f"text may have {MAX_CHARACTERS:,} characters at most in a stroked font,"
            f" not {len(text):,}"
        )
    return _width(font, text, scale)


def _width(font: StrokedFont, text: bytes, scale: Scale) -> int:
    return _scaled(sum(map(font.width, text)), scale.mx, scale.dx)


_known_width = lru_cache(maxsize=1024)(_width)


def textheight(font: StrokedFont, scale: Scale) -> int:
    """The height of every text in this font: from capitals to descenders."""
    return _scaled(font.cap - font.dec, scale.my, scale.dy)


def segments(
    font: StrokedFont, text: bytes, scale: Scale, vertical: bool = False
) -> NDArray[np.int64]:
    """The lines of a text, rows x1, y1, x2, y2 from where its pen starts, y downward; read-only.

    A row whose ends are one point is a dot. Characters outside the font draw nothing.
    """
    kept = len(text) <= REMEMBERED and len(text) * font.longest <= KEPT_OF_A_TEXT
    return (_remembered if kept else _segments)(font, text, scale, vertical)


def _segments(font: StrokedFont, text: bytes, scale: Scale, vertical: bool) -> NDArray[np.int64]:
    find = _known_glyph if font.longest <= KEPT_OF_A_LETTER else _glyph
    glyphs = [find(font, code, scale) for code in text]
    widths = [
        _scaled(font.width(code), scale.mx, scale.dx) if font.operations(code) else 0
        for code in text
    ]
    lines = np.concatenate([_NOTHING, *glyphs])
    starts = np.array([0, *accumulate(widths)][:-1], dtype=np.int64)
    lines[:, ::2] += starts.repeat([len(glyph) for glyph in glyphs])[:, np.newaxis]
    if vertical:
        lines = -lines[:, [1, 0, 3, 2]]
    else:
        lines[:, 1::2] *= -1
    lines.flags.writeable = False
    return lines


_remembered = lru_cache(maxsize=128)(_segments)


def _glyph(font: StrokedFont, code: int, scale: Scale) -> NDArray[np.int64]:
    """The lines of one character, scaled, y upward. Its pen starts lifted."""
    mx, dx, my, dy = scale
    rows, pen = [], None
    for draw, x, y in font.operations(code):
        point = _scaled(x, mx, dx), _scaled(y, my, dy)
        if draw and pen is not None:
            rows.append((*pen, *point))
        pen = point
    return np.array(rows, dtype=np.int64).reshape(-1, 4)


_known_glyph = lru_cache(maxsize=1024)(_glyph)


def anchor(
    font: StrokedFont, text: bytes, scale: Scale, vertical: bool, horiz: int, vert: int
) -> tuple[int, int]:
    """What to add to x, y of outtextxy to find where the pen starts.

    BOTTOM_TEXT puts the baseline, not the descenders, on y; TOP_TEXT puts it a whole text height
    below, so that a gap stays above the capitals. That is the kernel's rule.
    """
    width, height = textwidth(font, text, scale), textheight(font, scale)
    back = height if vertical else width
    across = {CENTER_TEXT: 1 - _scaled(back, 1, 2), RIGHT_TEXT: -back}.get(horiz, 0)
    if vertical:
        return height + across, _part(width, vert, TOP_TEXT)
    return across, _part(height, vert, TOP_TEXT)


def _part(length: int, justification: int, whole: int) -> int:
    """All of a length if justified as `whole` says, half of it if centred, else nothing."""
    if justification == CENTER_TEXT:
        return _scaled(length, 1, 2)
    return length if justification == whole else 0
