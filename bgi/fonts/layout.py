"""From a string to pen strokes on the screen, by the kernel's integer rules.

Every coordinate is multiplied, divided, and truncated toward zero, on its own. The pen advances
after each character by the character's truncated width, but `textwidth` truncates only the sum:
drawn text can be a little narrower than it says. A character without strokes does not move the pen,
although `textwidth` counts it; a blank is one movement. Vertical text is the same turned by 90
degrees counter-clockwise, so that it reads upward.
"""

from functools import lru_cache
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

KEPT_STROKES = 128
"""Strokes of a letter that are kept, 32 bytes each: Borland's letters have up to 126, those of
another font file may have thousands. All that is kept takes at most 4 megabytes."""


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
    return _scaled(sum(map(font.every_width.__getitem__, text)), scale.mx, scale.dx)


_known_width = lru_cache(maxsize=1024)(_width)


def textheight(font: StrokedFont, scale: Scale) -> int:
    """The height of every text in this font: from capitals to descenders."""
    return _scaled(font.cap - font.dec, scale.my, scale.dy)


def advance(font: StrokedFont, code: int, scale: Scale) -> int:
    """How far the pen moves on after a character."""
    return _scaled(font.every_width[code], scale.mx, scale.dx) if font.operations(code) else 0


def strokes(font: StrokedFont, code: int, scale: Scale, vertical: bool) -> NDArray[np.int64]:
    """The lines of a character, rows x1, y1, x2, y2 from where its pen starts, y downward.

    The array is read-only. A row whose ends are one point is a dot. Characters outside the font
    draw nothing.
    """
    find = _known_strokes if font.longest <= KEPT_STROKES else _strokes
    return find(font, code, scale, vertical)


def _strokes(font: StrokedFont, code: int, scale: Scale, vertical: bool) -> NDArray[np.int64]:
    mx, dx, my, dy = scale
    rows, pen = [], None  # which starts lifted
    for draw, x, y in font.operations(code):
        right, up = _scaled(x, mx, dx), _scaled(y, my, dy)
        point = (-up, -right) if vertical else (right, -up)
        if draw and pen is not None:
            rows.append((*pen, *point))
        pen = point
    lines = np.array(rows, dtype=np.int64).reshape(-1, 4)
    lines.flags.writeable = False
    return lines


_known_strokes = lru_cache(maxsize=1024)(_strokes)


def anchor(
    font: StrokedFont, text: bytes, scale: Scale, vertical: bool, horiz: int, vert: int
) -> tuple[int, int]:
    """What to add to x, y of outtextxy to find where the pen starts.

    BOTTOM_TEXT puts the baseline, not the descenders, on y; TOP_TEXT puts it a whole text height
    below, so that a gap stays above the capitals. That is the kernel's rule.
    """
    width, height = textwidth(font, text, scale), textheight(font, scale)
    back = height if vertical else width
    across = (horiz == CENTER_TEXT) - _part(back, horiz, RIGHT_TEXT)
    if vertical:
        return height + across, _part(width, vert, TOP_TEXT)
    return across, _part(height, vert, TOP_TEXT)


def _part(length: int, justification: int, whole: int) -> int:
    """All of a length if justified as `whole` says, half of it if centred, else nothing."""
    if justification == CENTER_TEXT:
        return _scaled(length, 1, 2)
    return length if justification == whole else 0
