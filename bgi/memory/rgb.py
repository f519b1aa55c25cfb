"""Colours of their own in a window: red, green and blue in one tagged number, as WinBGIm has them.

`0x03000000 | blue << 16 | green << 8 | red`. In a window such a number goes wherever a colour index
goes, and pixels of both kinds live together on a page; the monitor tells them apart.
"""

TAG = 0x03000000
MASK = 0x03FFFFFF
"""All the bits that a colour of a window may have."""


def join(red: int, green: int, blue: int) -> int:
    """The tagged number of a colour, components 0..255."""
    return TAG | (blue & 255) << 16 | (green & 255) << 8 | red & 255


def is_rgb(color: int) -> bool:
    """Whether a number is an RGB colour; else it is an index."""
    return bool(color & TAG)


def split(color: int) -> tuple[int, int, int]:
    """Red, green and blue of a tagged number."""
    return color & 255, color >> 8 & 255, color >> 16 & 255
