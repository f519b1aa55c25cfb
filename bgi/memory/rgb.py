"""Colours as red, green and blue: the sixteen of the PC, and those that a window mixes.

In a window a colour of its own is one tagged number, as WinBGIm has it,
`0x03000000 | blue << 16 | green << 8 | red`. It goes wherever a colour index goes, and pixels of
both kinds live together on a page; the monitor tells them apart.
"""

RGB = tuple[int, int, int]
"""Red, green, blue, each 0..255."""

TAG = 0x03000000
MASK = 0x03FFFFFF
"""All the bits that a colour of a window may have."""

EGA_VALUES = [0, 1, 2, 3, 4, 5, 20, 7, 56, 57, 58, 59, 60, 61, 62, 63]
"""The EGA's hardware values of the sixteen colours."""


def ega_rgb(value: int) -> RGB:
    """The colour of an EGA value 0..63 (bits r g b R G B)."""
    return (
        0xAA * (value >> 2 & 1) + 0x55 * (value >> 5 & 1),
        0xAA * (value >> 1 & 1) + 0x55 * (value >> 4 & 1),
        0xAA * (value & 1) + 0x55 * (value >> 3 & 1),
    )


SIXTEEN = [ega_rgb(value) for value in EGA_VALUES]
"""The sixteen colours of COLORS, as everybody knows them."""


def join(red: int, green: int, blue: int) -> int:
    """The tagged number of a colour; of each component the lowest eight bits count."""
    return TAG | (blue & 255) << 16 | (green & 255) << 8 | red & 255


_INDEX = {join(*color): index for index, color in enumerate(SIXTEEN)}


def split(color: int) -> RGB:
    """Red, green and blue of a tagged number."""
    return color & 255, color >> 8 & 255, color >> 16 & 255


def is_rgb(color: int) -> bool:
    """Whether a number is an RGB colour; else it is an index."""
    return bool(color & TAG)


def number(red: int, green: int, blue: int) -> int:
    """The number of a colour in a window: its index if it is one of the sixteen, else tagged."""
    tagged = join(red, green, blue)
    return _INDEX.get(tagged, tagged)


def components(color: int) -> RGB:
    """Red, green and blue of either kind of number; an index as it looks at first."""
    return split(color) if is_rgb(color) else SIXTEEN[color & 15]
