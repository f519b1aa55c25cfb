"""Pieces of the screen, in memory and on disk.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

import os

from bgi import current
from bgi.kernel.arguments import Number
from bgi.memory.image import Image

# fmt: off
__all__ = [
    "imagesize", "getimage", "putimage",
    "readimagefile", "writeimagefile",
]
# fmt: on


def imagesize(left: Number, top: Number, right: Number, bottom: Number) -> int:
    """Return how many bytes an image takes in Borland's layout.

    Args:
        left, top, right, bottom: its corners, all inside.

    From 64K on it returns 65535 and graphresult() says -11; getimage() works all the same.
    """
    return current.screen.imagesize(left, top, right, bottom)


def getimage(
    left: Number,
    top: Number,
    right: Number,
    bottom: Number,
    buffer: bytearray | memoryview | None = None,
) -> Image:
    """Copy a rectangle of the active page, to be put elsewhere by putimage().

    Args:
        left, top, right, bottom: its corners, relative to the viewport but not clipped by it; what
            lies off the screen is 0.
        buffer: as in C, a writable buffer of imagesize() bytes that is filled as well.

    The image has .width, .height and .array, indices of shape (height, width); bytes(image) is
    Borland's layout, bgi.Image.frombytes() reads it. ValueError for a short buffer, and for more
    than 67,108,864 pixels.
    """
    return current.screen.getimage(left, top, right, bottom, buffer)


def putimage(
    left: Number, top: Number, image: Image | bytes | bytearray | memoryview, op: Number
) -> None:
    """Put an image on the active page.

    Args:
        left, top: where its upper left corner goes, relative to the viewport.
        image: from getimage(), or bytes in Borland's layout for this mode.
        op: COPY_PUT; XOR_PUT, OR_PUT, AND_PUT, which combine it with what is there; or NOT_PUT, its
            complement.

    Not clipped by the viewport. Nothing is drawn if any part would lie left of the screen, above it
    or right of it; only its bottom edge cuts an image off, as in the original. In a window of
    initwindow() every edge does, as in WinBGIm. graphresult() says -11 for another op; ValueError
    for too few bytes. In Borland's layout an image has at most 65,536 pixels a side; `Image(array)`
    takes 16,777,216 pixels.
    """
    current.screen.putimage(left, top, image, op)


def readimagefile(
    filename: str | os.PathLike[str],
    left: Number = 0,
    top: Number = 0,
    right: Number | None = None,
    bottom: Number | None = None,
) -> None:
    """Put a picture from a file on the active page.

    Args:
        filename: a PNG, BMP, JPEG or GIF (its first picture), whatever its name.
        left, top: where its upper left corner goes, relative to the viewport.
        right, bottom: its lower right corner; None keeps the picture's own width or height.

    In a window in its own colours, elsewhere in the nearest of the palette (an index of the file
    whose colour is the screen's stays that index). What is transparent leaves what is there. Cut at
    the edges of the screen. OSError if the file cannot be read; ValueError, and nothing drawn, if
    it is none of these, malformed, in colours for print (CMYK), or has more than 67,108,864 pixels.
    Source: WinBGIm.
    """
    current.screen.readimagefile(filename, left, top, right, bottom)


def writeimagefile(
    filename: str | os.PathLike[str],
    left: Number = 0,
    top: Number = 0,
    right: Number | None = None,
    bottom: Number | None = None,
) -> None:
    """Save the active page, or a part of it, as a picture file with its palette.

    Args:
        filename: where to; an existing file is replaced. Its ending says the format: .png (also
            without an ending), .bmp, .jpg (which blurs a little), or .gif (needs Pillow).
        left, top, right, bottom: two opposite corners of the part, in screen coordinates; what
            lies outside is left out.

    Raises OSError if the file cannot be written, ValueError for another ending, or if no part of
    the screen is meant. Source: WinBGIm (which writes BMP).
    """
    current.screen.writeimagefile(filename, left, top, right, bottom)
