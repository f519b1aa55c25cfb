"""Fonts made by hand for the tests, and the lines of a text."""

import numpy as np

from bgi.fonts import layout
from bgi.fonts.chr import Operation, StrokedFont


def font_of(*strokes, first=65, widths=None, cap=7, dec=-2, name="TEST"):
    """A font whose characters are these strokes, each a list of (draw, x, y)."""
    glyphs = tuple(tuple(Operation(*operation) for operation in glyph) for glyph in strokes)
    return StrokedFont(name, first, cap, dec, tuple(widths or [5] * len(glyphs)), glyphs)


def segments(font, text, scale, vertical=False):
    """The lines of a text, rows x1, y1, x2, y2 from where its pen starts."""
    pen, lines = 0, [np.empty((0, 4), dtype=np.int64)]
    for code in text:
        across, down = (0, -pen) if vertical else (pen, 0)
        strokes = layout.strokes(font, code, scale, vertical)
        lines.append(strokes + np.array([across, down] * 2))
        pen += layout.advance(font, code, scale)
    return np.concatenate(lines)
