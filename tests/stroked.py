"""Fonts made by hand for the tests."""

from bgi.fonts.chr import Operation, StrokedFont


def font_of(*strokes, first=65, widths=None, cap=7, dec=-2, name="TEST"):
    """A font whose characters are these strokes, each a list of (draw, x, y)."""
    glyphs = tuple(tuple(Operation(*operation) for operation in glyph) for glyph in strokes)
    return StrokedFont(name, first, cap, dec, tuple(widths or [5] * len(glyphs)), glyphs)
