"""What getimage() takes from the screen, and Borland's byte layout of it.

Two words, width - 1 and height - 1, little-endian; then row after row, the first pixel in the
highest bit; then an unused word. With 16 colours a row is four bit-planes one after another:
intensity, red, green, blue. With 2, 4 or 256 colours its pixels are packed, 1, 2 or 8 bits each.
Every plane of a row fills whole bytes; with 4 colours they are two for every eight pixels. (A
RIPscrip .ICN file is such a block.)
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.errors import brief
from bgi.kernel.arguments import check_count, octets
from bgi.memory.imagefile import png
from bgi.memory.palette import DEFAULTS

_LAYOUTS = {2: (1, 1), 4: (1, 2), 16: (4, 1), 256: (1, 8)}
_HEADER = struct.Struct("<HH")
_TRAILER = b"\0\0"


def row_layout(colors: int) -> tuple[int, int]:
    """Planes of a row, and bits that a pixel takes in each."""
    return _LAYOUTS[colors]


def byte_size(width: int, height: int, colors: int) -> int:
    """The bytes that an image takes in Borland's layout."""
    planes, _ = row_layout(colors)
    return _HEADER.size + height * planes * _plane_bytes(width, colors) + len(_TRAILER)


def _plane_bytes(width: int, colors: int) -> int:
    """The bytes of one plane of a row."""
    _, bits = row_layout(colors)
    return width if bits == 8 else bits * -(-width // 8)


def _check_colors(colors: object) -> None:
    if type(colors) is not int or colors not in _LAYOUTS:
        known = ", ".join(map(str, _LAYOUTS))
        raise ValueError(f"an image has one of {known} colours, not {brief(colors)}")


@dataclass(frozen=True, eq=False, slots=True)
class Image:
    """A rectangle of palette indices: `array` has shape (height, width)."""

    array: NDArray[np.uint8]
    colors: int = 16
    palette: NDArray[np.uint8] | None = None
    """(256, 3): how its indices look in a notebook; None: as screens begin."""

    def __post_init__(self) -> None:
        """Refuse what is not an image; ValueError or TypeError says why."""
        check_count("array", self.array)
        array = np.asarray(self.array)
        if array.dtype.kind not in "ui":
            raise TypeError(f"an image's array must hold integers, not {array.dtype}")
        if array.ndim != 2 or array.size == 0:
            raise ValueError(f"an image's array must have shape (height, width), not {array.shape}")
        _check_colors(self.colors)
        own_colors = array.dtype == np.uint32  # pixels of a window
        if not own_colors and (array.min() < 0 or array.max() >= self.colors):
            raise ValueError(f"an image of {self.colors} colours holds 0..{self.colors - 1}")
        object.__setattr__(self, "array", array if own_colors else array.astype(np.uint8))

    @classmethod
    def of_screen(cls, array: NDArray[Any], colors: int, palette: NDArray[np.uint8]) -> Image:
        """An image of pixels that come from a page: they need no check."""
        image, put = object.__new__(cls), object.__setattr__  # frozen: its own would refuse
        put(image, "array", array)
        put(image, "colors", colors)
        put(image, "palette", palette)
        return image

    @property
    def width(self) -> int:
        """Pixels across."""
        return int(self.array.shape[1])

    @property
    def height(self) -> int:
        """Pixels down."""
        return int(self.array.shape[0])

    def __repr__(self) -> str:
        """Size and colours, not the pixels."""
        return f"<Image {self.width}x{self.height}, {self.colors} colours>"

    def _repr_png_(self) -> bytes:
        """The image for notebooks."""
        if self.palette is not None:
            return png(self.array, self.palette)
        return png(self.array, np.array(DEFAULTS["IBM8514"][1], dtype=np.uint8))

    def __bytes__(self) -> bytes:
        """The image in Borland's layout; ValueError for what that cannot hold."""
        if self.width > 0x10000 or self.height > 0x10000:
            raise ValueError(f"{self!r} is too large for Borland's layout: 65536 pixels a side")
        if self.array.max() >= self.colors:
            raise ValueError(f"{self!r} holds RGB colours: Borland's layout has only indices")
        planes, bits = row_layout(self.colors)
        shifts = np.arange(planes * bits - 1, -1, -1, dtype=np.uint8)
        every = self.array[:, :, None] >> shifts & 1  # (height, width, bit), highest first
        if planes > 1:
            every = every.transpose(0, 2, 1)  # plane by plane
        packed = np.packbits(every.reshape(self.height, planes, -1), axis=2)
        rows = np.zeros((self.height, planes, _plane_bytes(self.width, self.colors)), np.uint8)
        rows[:, :, : packed.shape[2]] = packed
        header = _HEADER.pack(self.width - 1, self.height - 1)
        return header + rows.tobytes() + _TRAILER

    @classmethod
    def frombytes(cls, data: bytes | bytearray | memoryview, colors: int = 16) -> Image:
        """Read an image from Borland's layout, as a screen of that number of colours has it.

        ValueError if the data end before the image does, or for another number of colours.
        """
        block = octets("image", data)
        if len(block) < _HEADER.size:
            raise ValueError(f"an image needs a header of 4 bytes, not {len(block)} bytes")
        width, height = (side + 1 for side in _HEADER.unpack(block[: _HEADER.size].tobytes()))
        _check_colors(colors)
        planes, bits = row_layout(colors)
        needed = byte_size(width, height, colors) - len(_TRAILER)
        if len(block) < needed:
            raise ValueError(
                f"an image of {width}x{height} in {colors} colours needs {needed} bytes,"
                f" not {len(block)}"
            )
        rows = np.frombuffer(block[_HEADER.size : needed].tobytes(), np.uint8)
        every = np.unpackbits(rows.reshape(height, planes, -1), axis=2)[:, :, : width * bits]
        every = every.transpose(0, 2, 1) if planes > 1 else every.reshape(height, width, bits)
        weights = 1 << np.arange(planes * bits - 1, -1, -1)
        return cls((every @ weights).astype(np.uint8), colors)
