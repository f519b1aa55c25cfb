"""Pictures on disk: a page written so that it keeps its palette and indices, and pictures read.

Four formats are promised and no other is tried, each known by its first bytes: what a user was
sent may be malformed, and some of SDL's readers crash on that. PNG, BMP and JPEG are read by SDL,
whose readers of these do not (or by `bgi.memory.backend` without it); GIF by `bgi.memory.gif`.
"""

from __future__ import annotations

import io
import os
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from bgi.errors import brief
from bgi.memory import backend, gif, jpeg
from bgi.memory.matching import shown

if TYPE_CHECKING:
    from pathlib import Path

Filename = str | os.PathLike[str]
Indices = NDArray[np.uint8]
Colors = NDArray[np.uint8]

MAX_PIXELS = 1 << 26
"""Pixels that a picture may have: 8192 x 8192, far more than any screen."""

# Writing


def png(pixels: NDArray[Any], palette: Colors) -> bytes:
    """Pixels (height, width) with their palette (256, 3) as a PNG."""
    return encode(pixels, palette, "png")


def encode(pixels: NDArray[Any], palette: Colors, form: str) -> bytes:
    """Pixels (height, width) with their palette (256, 3) as a file: "png", "bmp", "jpg" or "gif".

    Indices are kept as they are, except in JPEG; pixels of four bytes become the colours that they
    mean. ValueError for "gif" where Pillow is not installed.
    """
    indexed = pixels.dtype == np.uint8 and form != "jpg"
    picture = pixels if indexed else shown(pixels, palette)
    write = _write_gif if form == "gif" else backend.write_picture
    return write(np.ascontiguousarray(picture), palette if indexed else None, form)


def _write_gif(picture: NDArray[np.uint8], palette: Colors | None, form: str) -> bytes:
    try:
        from PIL import Image
    except ImportError:
        raise ValueError(
            "a GIF is written by Pillow, which is not installed (pip install pillow); "
            "or choose a name that ends in .png, .bmp or .jpg"
        ) from None
    image = Image.fromarray(picture)
    if palette is not None:
        image.putpalette(palette.tobytes())  # the image is in colours of its own from here on
    file = io.BytesIO()
    image.save(file, format=form, optimize=False)
    return file.getvalue()


ENDINGS = {"": "png", ".png": "png", ".bmp": "bmp", ".jpg": "jpg", ".jpeg": "jpg", ".gif": "gif"}


def save(filename: Filename, pixels: NDArray[Any], palette: Colors) -> None:
    """Write a picture in the format that the name's ending says, a PNG without one.

    OSError if the file cannot be written; ValueError for another ending.
    """
    path = path_of(filename)
    form = ENDINGS.get(path.suffix.lower())
    if form is None:
        raise ValueError(
            f"{path.name}: a picture is written as .png, .bmp, .jpg or .gif, not {path.suffix!r}"
        )
    path.write_bytes(encode(pixels, palette, form))


def path_of(filename: Filename) -> Path:
    """A file's name as a path; TypeError for what is none, such as an int: C's descriptors.

    ValueError for a name that no file can have.
    """
    from pathlib import Path  # late, as it takes a while

    try:
        name = os.fsdecode(os.fspath(filename))
        possible = name != "" and b"\0" not in os.fsencode(name)
    except TypeError:
        raise TypeError(
            f"filename must be a str or a path, not {type(filename).__name__}: {brief(filename)}"
        ) from None
    except UnicodeError:
        possible = False
    if not possible:
        raise ValueError(f"filename must be what a file can be called, not {brief(filename)}")
    return Path(name)


# Reading


@dataclass(frozen=True)
class Picture:
    """A picture read: indices (height, width) and their colours, or RGBA (height, width, 4)."""

    pixels: NDArray[np.uint8]
    colors: Colors | None
    """(256, 4), red, green, blue and alpha; None where the pixels are colours themselves."""

    def part(self, rows: NDArray[np.int64], columns: NDArray[np.int64]) -> Picture:
        """Only these rows and columns, in this order, any of them as often as named."""
        return Picture(self.pixels[rows[:, None], columns], self.colors)

    @property
    def rgba(self) -> NDArray[np.uint8]:
        """The colours, shape (height, width, 4)."""
        return self.pixels if self.colors is None else self.colors[self.pixels]


def load(filename: Filename) -> Picture:
    """Read a PNG, BMP, JPEG or GIF (its first picture).

    OSError if it cannot be read, ValueError if it is none of these, malformed, or larger than
    MAX_PIXELS: that is looked up before any of it is unpacked.
    """
    path = path_of(filename)
    data = path.read_bytes()
    for signature, reader in _READERS.items():
        if data.startswith(signature):
            try:
                return reader(data)
            except ValueError as error:
                raise ValueError(f"{path.name} cannot be read: {error}") from None
    raise ValueError(f"{path.name} is not a picture that can be read: a PNG, BMP, JPEG or GIF file")


def _check_size(width: int, height: int) -> None:
    if not 0 < width * height <= MAX_PIXELS:
        raise ValueError(f"{width}x{height} pixels, and at most {MAX_PIXELS:,} are read")


def _read_png(data: bytes) -> Picture:
    _check_size(*_fields(">II", data, 16))
    return _read(data, "png")


def _read_bmp(data: bytes) -> Picture:
    (length,) = _fields("<I", data, 14)
    width, height = _fields("<HH" if length == 12 else "<ii", data, 18)
    _check_size(width, abs(height))  # upside down if negative
    return _read(data, "bmp")


def _read_jpeg(data: bytes) -> Picture:
    head = jpeg.head(data)
    _check_size(head.width, head.height)
    if head.components == 4:
        raise ValueError("its colours are for print (CMYK); save it as RGB")
    picture = _read(data, "jpg")
    upright = _UPRIGHT[head.orientation]
    return Picture(np.ascontiguousarray(upright(picture.rgba)), None)


def _read_gif(data: bytes) -> Picture:
    _check_size(*gif.size(data))
    return Picture(*gif.read(data))


def _fields(form: str, data: bytes, at: int) -> tuple[int, ...]:
    try:
        return struct.unpack_from(form, data, at)
    except struct.error:
        raise ValueError("it ends too soon") from None


def _read(data: bytes, form: str) -> Picture:
    return Picture(*backend.read_picture(data, form))


_READERS: dict[bytes, Callable[[bytes], Picture]] = {
    b"\x89PNG\r\n\x1a\n": _read_png,
    b"BM": _read_bmp,
    b"\xff\xd8\xff": _read_jpeg,
    b"GIF87a": _read_gif,
    b"GIF89a": _read_gif,
}

# What brings a picture upright, by Exif's orientation.
_UPRIGHT: dict[int, Callable[[NDArray[np.uint8]], NDArray[np.uint8]]] = {
    1: lambda p: p,
    2: lambda p: p[:, ::-1],
    3: lambda p: p[::-1, ::-1],
    4: lambda p: p[::-1],
    5: lambda p: p.swapaxes(0, 1),
    6: lambda p: p.swapaxes(0, 1)[:, ::-1],
    7: lambda p: p[::-1, ::-1].swapaxes(0, 1),
    8: lambda p: p.swapaxes(0, 1)[::-1],
}
