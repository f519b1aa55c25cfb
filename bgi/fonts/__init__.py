"""Fonts: the built-in one of 8x8 pixels, Borland's stroked ones, and how a string is laid out."""

import os

# Not by importlib.resources: it imports random, and many a program has a random.py of its own. Nor
# by pathlib, which takes longer to import than all of the fonts.
DATA = os.path.join(os.path.dirname(__file__), "data")
"""Where the fonts that come with this package lie."""


def read(name: str) -> bytes:
    """The bytes of one of those files."""
    with open(os.path.join(DATA, name), "rb") as file:
        return file.read()
