"""Fonts: the built-in one of 8x8 pixels, Borland's stroked ones, and how a string is laid out."""
