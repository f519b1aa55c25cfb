"""How lines are drawn: what line style, line width and write mode come to together."""

from functools import lru_cache
from typing import NamedTuple

from bgi.constants import COPY_PUT, THICK_WIDTH
from bgi.raster.patterns import SOLID_BITS, Dashes, dashes, highest_first


class LineStyle(NamedTuple):
    """A way to draw lines, as the questions that drawing asks."""

    dashes: Dashes
    xor: bool
    thick: bool
    """Three thin lines, or more."""
    wide: bool
    """More: by a brush, which leaves no gaps."""
    plain: bool
    """Thin and solid, not by XOR."""
    bold: bool
    """Three solid lines, not by XOR."""


@lru_cache(maxsize=64)
def line_style(pattern: int, width: int, write_mode: int, packed: bool) -> LineStyle:
    """The way of a pattern, a width and a write mode; a packed page reads the pattern backward."""
    wide, thick, xor = width > THICK_WIDTH, width >= THICK_WIDTH, write_mode != COPY_PUT
    bits = SOLID_BITS if wide else pattern
    solid = bits == SOLID_BITS and not xor
    style = dashes(highest_first(bits) if packed else bits)
    return LineStyle(style, xor, thick, wide, solid and not thick, solid and thick and not wide)
