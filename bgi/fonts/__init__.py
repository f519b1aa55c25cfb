"""Fonts: the built-in one of 8x8 pixels, Borland's stroked ones, and how a string is laid out."""

from pathlib import Path

# Not by importlib.resources: it imports random, and many a program has a random.py of its own.
DATA = Path(__file__).parent / "data"
"""Where the fonts that come with this package lie."""
