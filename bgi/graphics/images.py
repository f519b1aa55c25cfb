"""Pieces of the screen, in memory and on disk."""

from __future__ import annotations

import os
from typing import Any

from numpy.typing import NDArray

from bgi.constants import COPY_PUT, NOT_PUT, grError
from bgi.graphics.screen import State
from bgi.kernel.arguments import Number, whole
from bgi.kernel.state import KERNEL
from bgi.memory.image import MAX_PIXELS, Image, byte_size
from bgi.memory.imagefile import load, nearest, png, save_png, tagged

Buffer = bytes | bytearray | memoryview


class Images(State):
    """A screen to take pieces from and to put them on."""

    def _repr_png_(self) -> bytes:
        """The active page, for notebooks."""
        return png(self.page.array, self.card.palette)

    def imagesize(self, left: Number, top: Number, right: Number, bottom: Number) -> int:
        """The bytes of Borland's layout; 65535 and -11 from 64K on."""
        width = abs(whole("right", right) - whole("left", left)) + 1
        height = abs(whole("bottom", bottom) - whole("top", top)) + 1
        size = byte_size(width, height, self.mode.colors)
        if size >= 0xFFFF:
            KERNEL.result.set(grError)
            return 0xFFFF
        return size

    def getimage(
        self,
        left: Number,
        top: Number,
        right: Number,
        bottom: Number,
        buffer: bytearray | memoryview | None = None,
    ) -> Image:
        """Copy a rectangle of the active page."""
        x1, x2 = sorted((whole("left", left), whole("right", right)))
        y1, y2 = sorted((whole("top", top), whole("bottom", bottom)))
        width, height = x2 - x1 + 1, y2 - y1 + 1
        if width * height > MAX_PIXELS:
            raise ValueError(f"an image of {width}x{height} pixels is too large")
        image = Image(self.page.copy(x1 + self._dx, y1 + self._dy, width, height), self.mode.colors)
        if buffer is not None:
            _store(bytes(image), buffer)
        return image

    def putimage(self, left: Number, top: Number, image: Image | Buffer, op: Number) -> None:
        """Put an image on the active page."""
        x, y, operator = whole("left", left), whole("top", top), whole("op", op)
        if not isinstance(image, Image):
            image = Image.frombytes(image, self.mode.colors)
        if COPY_PUT <= operator <= NOT_PUT:
            self.page.combine(x + self._dx, y + self._dy, image.array, operator, self._mask)
        else:
            KERNEL.result.set(grError)

    def readimagefile(
        self,
        filename: str | os.PathLike[str],
        left: Number = 0,
        top: Number = 0,
        right: Number | None = None,
        bottom: Number | None = None,
    ) -> None:
        """Put a picture file on the active page, in the nearest colours."""
        x, width = _extent(whole("left", left), None if right is None else whole("right", right))
        y, height = _extent(whole("top", top), None if bottom is None else whole("bottom", bottom))
        if (width or 1) * (height or 1) > MAX_PIXELS:
            raise ValueError(f"a picture of {width}x{height} pixels is too large")
        picture = load(filename, width, height)
        pixels: NDArray[Any] = (
            tagged(picture)
            if self.mode.pixel_bytes == 4
            else nearest(picture, self.card.palette[: self.mode.colors])
        )
        self.page.combine(x + self._dx, y + self._dy, pixels, COPY_PUT, self._mask)

    def writeimagefile(
        self,
        filename: str | os.PathLike[str],
        left: Number = 0,
        top: Number = 0,
        right: Number | None = None,
        bottom: Number | None = None,
    ) -> None:
        """Save a part of the active page as a PNG."""
        x1, y1 = max(0, whole("left", left)), max(0, whole("top", top))
        x2 = self.getmaxx() if right is None else whole("right", right)
        y2 = self.getmaxy() if bottom is None else whole("bottom", bottom)
        part = self.page.array[y1 : max(y2 + 1, 0), x1 : max(x2 + 1, 0)]
        if not part.size:
            raise ValueError(f"nothing of {left}, {top}, {right}, {bottom} is on the screen")
        save_png(filename, part, self.card.palette)


def _extent(start: int, end: int | None) -> tuple[int, int | None]:
    """Where a side begins and how long it is, its ends in any order; None for no end."""
    return (start, None) if end is None else (min(start, end), abs(end - start) + 1)


def _store(data: bytes, buffer: bytearray | memoryview) -> None:
    """Copy into the caller's buffer, as getimage() does in C."""
    try:
        view = memoryview(buffer).cast("B")
    except TypeError:
        raise TypeError(
            f"buffer must be a bytearray or another writable buffer, not {type(buffer).__name__}"
        ) from None
    if view.readonly:
        raise TypeError("buffer must be writable; bytes are not: use bytearray(imagesize(...))")
    if len(view) < len(data):
        raise ValueError(f"buffer must hold {len(data)} bytes (imagesize), not {len(view)}")
    view[: len(data)] = data
