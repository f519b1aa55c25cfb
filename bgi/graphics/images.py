"""Pieces of the screen, in memory and on disk."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.constants import COPY_PUT, NOT_PUT, grError
from bgi.errors import brief
from bgi.graphics.screen import State
from bgi.kernel.arguments import Number, octets, whole
from bgi.kernel.state import KERNEL
from bgi.memory.image import Image, byte_size
from bgi.memory.imagefile import MAX_PIXELS, Picture, load, png, save
from bgi.memory.matching import nearest, shown, tagged

Buffer = bytes | bytearray | memoryview


class Images(State):
    """A screen to take pieces from and to put them on."""

    def _repr_png_(self) -> bytes:
        """The active page, for notebooks."""
        return png(self.page.array, self.card.palette)

    def _repr_html_(self) -> str | None:
        """The running screen, for notebooks, where a browser can show it; else None."""
        return self.monitor.notebook_html() or None

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
        if not type(left) is type(top) is type(right) is type(bottom) is int:
            left, top = whole("left", left), whole("top", top)
            right, bottom = whole("right", right), whole("bottom", bottom)
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        width, height = right - left + 1, bottom - top + 1
        if width * height > MAX_PIXELS:
            raise ValueError(
                f"left, top, right, bottom may hold {MAX_PIXELS:,} pixels at most,"
                f" not {brief(width)} x {brief(height)}"
            )
        taken = self.page.copy(left + self._dx, top + self._dy, width, height)
        image = Image.of_screen(taken, self.mode.colors, self.palette.shown.copy())
        if buffer is not None:
            _store(bytes(image), buffer)
        return image

    def putimage(self, left: Number, top: Number, image: Image | Buffer, op: Number) -> None:
        """Put an image on the active page, if only the bottom of the screen would cut it.

        In a window, which is WinBGIm's, every edge may.
        """
        if not type(left) is type(top) is type(op) is int:
            left, top, op = whole("left", left), whole("top", top), whole("op", op)
        if not isinstance(image, Image):
            image = Image.frombytes(image, self.mode.colors)
        x, y, array = left + self._dx, top + self._dy, image.array
        if not COPY_PUT <= op <= NOT_PUT:
            KERNEL.result.set(grError)
        elif self.mode.is_window or (x >= 0 and y >= 0 and x + array.shape[1] <= self.mode.width):
            self.page.combine(x, y, array, op, self._bits)

    def readimagefile(
        self,
        filename: str | os.PathLike[str],
        left: Number = 0,
        top: Number = 0,
        right: Number | None = None,
        bottom: Number | None = None,
    ) -> None:
        """Put a picture file on the active page, in the nearest colours."""
        left, width = _extent("left", left, "right", right)
        top, height = _extent("top", top, "bottom", bottom)
        picture = load(filename)
        rows, columns = picture.pixels.shape[:2]
        x, seen_columns = _seen(left + self._dx, width or columns, columns, self.mode.width)
        y, seen_rows = _seen(top + self._dy, height or rows, rows, self.mode.height)
        if len(seen_rows) and len(seen_columns):
            part = picture.part(seen_rows, seen_columns)
            under = self.page.copy(x, y, len(seen_columns), len(seen_rows))
            self.page.combine(x, y, self._matched(part, under), COPY_PUT, self._bits)

    def _matched(self, picture: Picture, under: NDArray[Any]) -> NDArray[Any]:
        """A picture in this screen's numbers, laid over the pixels that are there."""
        palette = self.card.palette
        rgba = picture.rgba
        colors, alpha = rgba[..., :3], rgba[..., 3:]
        if self.mode.pixel_bytes == 1 and picture.colors is not None:
            table = nearest(picture.colors[:, :3], palette[: self.mode.colors])
            same = np.flatnonzero((picture.colors[:, :3] == palette).all(axis=1))
            same = same[same < self.mode.colors]
            table[same] = same  # of equal colours the index that the picture has
            numbers: NDArray[Any] = table[picture.pixels]
        else:
            if ((alpha > 0) & (alpha < 255)).any():
                mixed = alpha * 1.0 * colors + (255 - alpha * 1.0) * shown(under, palette)
                colors = (mixed / 255 + 0.5).astype(np.uint8)
            if self.mode.pixel_bytes == 4:
                numbers = tagged(colors)
            else:
                numbers = nearest(colors, palette[: self.mode.colors])
        return np.where(alpha[..., 0] > 0, numbers, under)

    def writeimagefile(
        self,
        filename: str | os.PathLike[str],
        left: Number = 0,
        top: Number = 0,
        right: Number | None = None,
        bottom: Number | None = None,
    ) -> None:
        """Save a part of the active page in the format that the name says."""
        x1, width = _extent("left", left, "right", self.getmaxx() if right is None else right)
        y1, height = _extent("top", top, "bottom", self.getmaxy() if bottom is None else bottom)
        rows = slice(max(y1, 0), max(y1 + (height or 0), 0))
        part = self.page.array[rows, max(x1, 0) : max(x1 + (width or 0), 0)]
        if not part.size:
            raise ValueError(f"nothing of {left}, {top}, {right}, {bottom} is on the screen")
        save(filename, part, self.card.palette)


def _extent(
    start_name: str, start: Number, end_name: str, end: Number | None
) -> tuple[int, int | None]:
    """Where a side begins and how long it is, its ends in any order; None for no end."""
    first = whole(start_name, start)
    if end is None:
        return first, None
    last = whole(end_name, end)
    return min(first, last), abs(last - first) + 1


def _seen(start: int, length: int, kept: int, size: int) -> tuple[int, NDArray[np.int64]]:
    """Of a side of `kept` pixels stretched to `length`: where on the screen what is seen begins,
    and which of its pixels that are.
    """
    first, end = max(start, 0), min(start + length, size)
    places = range(first - start, max(end, first) - start)
    return first, np.array([place * kept // length for place in places], np.int64)


def _store(data: bytes, buffer: bytearray | memoryview) -> None:
    """Copy into the caller's buffer, as getimage() does in C."""
    view = octets("buffer", buffer)
    if view.readonly:
        raise TypeError("buffer must be writable; bytes are not: use bytearray(imagesize(...))")
    if len(view) < len(data):
        raise ValueError(f"buffer must hold {len(data)} bytes (imagesize), not {len(view)}")
    view[: len(data)] = data
