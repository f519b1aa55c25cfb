"""The pixels of a page: set one by one, and moved as pictures.

They are a numpy array, a memoryview and a surface (`bgi.memory.backend`) over the same bytes, each
used where it is fastest: the memoryview for one pixel or a row, the surface for solid lines and
small boxes, numpy for everything that is many. All coordinates are absolute.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.memory import backend
from bgi.memory.boxes import overlap, within
from bgi.memory.operators import OPERATORS
from bgi.memory.scrolling import scroll
from bgi.raster.arrays import keep_memory
from bgi.raster.lines import Box, Ints

Mask = NDArray[np.bool_]
Pixels = NDArray[Any]

_PIXEL: dict[int, np.dtype[Any]] = {1: np.dtype(np.uint8), 4: np.dtype("<u4")}


class Numbers(dict[int, Pixels]):
    """Numbers for pixels as arrays of no dimensions: numpy takes them sooner than ints."""

    MOST = 256
    """As many as one byte can be; of RGB colours the latest are kept."""

    def __init__(self, pixel: np.dtype[Any]) -> None:
        """None yet, of that type."""
        super().__init__()
        self._pixel = pixel

    def __missing__(self, number: int) -> Pixels:
        if len(self) >= self.MOST:
            self.clear()
        made = self[number] = np.array(number, self._pixel)
        return made


class Pixmap:
    """The pixels of one screen, and the box that drawing is clipped to."""

    def __init__(self, memory: memoryview, width: int, height: int, pixel_bytes: int = 1) -> None:
        """Lay a page over `memory`, rows from top to bottom.

        A pixel is a palette index of one byte, or four bytes that hold an index or an RGB colour:
        to a page both are just numbers.
        """
        keep_memory()
        self.width = width
        self.height = height
        self.flat: Pixels = np.frombuffer(memory, dtype=_PIXEL[pixel_bytes])
        self.array = self.flat.reshape(height, width)
        self.numbers = Numbers(self.flat.dtype)
        self._pixels = self.array.data
        self._row = self.flat.data
        self._surface = backend.surface(memory, width, height, pixel_bytes)
        self._all = 0, 0, width - 1, height - 1
        self.clip_to(self._all)

    def clip_to(self, box: Box) -> None:
        """Confine all drawing to left, top, right, bottom (inclusive, within the page)."""
        self.box = left, top, right, bottom = box
        self._left, self._top, self._right, self._bottom = left, top, right, bottom

    def holds(self, left: int, top: int, right: int, bottom: int) -> bool:
        """Whether the clipping box cuts nothing of another box."""
        return (
            self._left <= left
            and self._top <= top
            and right <= self._right
            and bottom <= self._bottom
        )

    def meets(self, left: int, top: int, right: int, bottom: int) -> bool:
        """Whether the clipping box shows something of another box."""
        return (
            left <= self._right
            and right >= self._left
            and top <= self._bottom
            and bottom >= self._top
        )

    def replay(self, before: Pixels, places: Ints, at_once: int) -> Iterator[int]:
        """Set once more what has been set since `before`: so many pixels at once, in that order.

        Yields how many they were, after each part.
        """
        after = self.flat.copy()
        self.flat[:] = before
        try:
            for start in range(0, len(places), at_once):
                part = places[start : start + at_once]
                self.flat[part] = after[part]
                yield len(part)
        finally:  # also where the program ends meanwhile
            self.flat[places] = after[places]

    # Pixels

    def get(self, x: int, y: int) -> int:
        """The index at x, y, wherever the clipping box is; 0 off the page."""
        if 0 <= x < self.width and 0 <= y < self.height:
            return int(self._pixels[y, x])
        return 0

    def put(self, x: int, y: int, value: int) -> None:
        """Set one pixel."""
        if self._left <= x <= self._right and self._top <= y <= self._bottom:
            self._pixels[y, x] = value

    def get_many(self, x: Ints, y: Ints) -> Pixels:
        """`get` for arrays."""
        inside = within(x, y, self._all)
        values = np.zeros(len(x), dtype=self.flat.dtype)
        place = y[inside] * self.width + x[inside]
        values[inside] = self.flat[place.astype(np.int64, copy=False)]
        return values

    def put_many(self, x: Ints, y: Ints, values: Ints | int) -> None:
        """`put` for arrays, in order: of two at the same place the later one stays."""
        if len(x) == 0:
            return
        left, top, right, bottom = self.box
        if x.min() < left or x.max() > right or y.min() < top or y.max() > bottom:
            inside = within(x, y, self.box)
            x = x[inside].astype(np.int64, copy=False)
            y = y[inside].astype(np.int64, copy=False)
            values = values if isinstance(values, int) else values[inside]
        self.flat[y * self.width + x] = values

    # Pictures

    def stamp(self, x: int, y: int, mask: Mask, color: int) -> None:
        """Put a colour wherever `mask`, which lies on the page with its corner at x, y, is True."""
        height, width = mask.shape
        self.array[y : y + height, x : x + width][mask] = color

    def print(self, x: int, y: int, mask: Mask, color: int) -> None:
        """Put a colour where `mask` is True and index 0 where it is not, whatever the clipping box.

        So the BIOS writes; what is off the page is cut.
        """
        found = overlap(x, y, mask.shape, self._all)
        if found:
            here, there = found
            number = self.flat.dtype.type
            self.array[here] = np.where(mask[there], number(color), number(0))

    def scroll(self, box: Box, lines: int) -> None:
        """Move a box up by so many rows (less than 0: down), whatever the clipping box.

        Index 0 comes behind. What is off the page is cut.
        """
        left, top, right, bottom = box
        scroll(self.array[top : bottom + 1, left : right + 1], lines, 0)

    def copy(self, x: int, y: int, width: int, height: int) -> Pixels:
        """A copy of the pixels from x, y on, wherever the clipping box is; 0 off the page."""
        if x >= 0 and y >= 0 and x + width <= self.width and y + height <= self.height:
            return self.array[y : y + height, x : x + width].copy()
        taken = np.zeros((height, width), dtype=self.flat.dtype)
        found = overlap(x, y, taken.shape, self._all)
        if found:
            here, there = found
            taken[there] = self.array[here]
        return taken

    def combine(self, x: int, y: int, image: Pixels, op: int, mask: Any) -> None:
        """Put an image with its corner at x, y by a putimage operator, cut at the page's edges.

        `mask` has the bits that a pixel may have, as a number of the page.
        """
        height, width = image.shape
        if x >= 0 and y >= 0 and x + width <= self.width and y + height <= self.height:
            OPERATORS[op](self.array[y : y + height, x : x + width], image, mask)
        elif found := overlap(x, y, image.shape, self._all):
            here, there = found
            OPERATORS[op](self.array[here], image[there], mask)

    def clear(self) -> None:
        """The whole page becomes index 0, whatever the clipping box."""
        self.flat.fill(0)
