"""The video memory: pixels, palette and visible page in one buffer that two processes map.

The program writes, a monitor (`bgi.monitor`) looks. Neither waits for the other: there are no
locks, a picture caught in the middle of a stroke is put right a sixtieth of a second later.

The buffer is an anonymous file (Linux: memfd; elsewhere a temporary file already unlinked; Windows:
a tagged mapping). It has no name that outlives its last user, so nothing can be left behind, not
even when both processes are killed with SIGKILL. That is why this is not
`multiprocessing.shared_memory`, whose names survive a killed process.

Layout, little-endian, for whoever wants to write another monitor:

    ======  ====  ======================================================================
    offset  size  field
    ======  ====  ======================================================================
         0     8  magic, the bytes `BGICARD` and a zero
         8     4  version of this layout: 2
        12     4  width in pixels, in a text mode in characters; 0 = no mode is set, show nothing
        16     4  height, likewise
        20     4  number of pages
        24     4  bytes per pixel: 1 or 4; 2 = a text mode, whose cells have two bytes
        28     4  visible page, 0 ... pages - 1
        32     4  changes: grows (modulo 2**32) with every change of mode or visible page
        36     4  1 if pixels are square, 0 if the page fills a monitor of 4:3
        40     4  in a text mode: height of a character, 8, 14 or 16 pixels
        44     4  the cell of the cursor, counted row by row; beyond the last: no cursor
        48     4  the shape of the cursor: 256 * its first row of pixels + its last
        52     4  what bit 7 of an attribute means: 0 = blinking, 1 = a bright background, 2 =
                  blinking, and the other bits are those of a monochrome monitor
        64   768  palette: 256 times red, green, blue
      4096        pixels: page after page, rows from top to bottom, no padding
    ======  ====  ======================================================================

A pixel of one byte is an index into the palette. One of four bytes is a little-endian number: below
16 it is an index too, and any other value is a colour in its low 24 bits, red lowest. A cell of a
text mode is a character of code page 437 and its attribute: the index of its colour in bits 0 to 3,
of its background in bits 4 to 6, blinking in bit 7. Characters are 8 pixels wide.

A change of mode writes the width last and sets it to 0 first. A monitor that finds the same header
twice in a row has therefore not read half of one.
"""

from __future__ import annotations

import contextlib
import mmap
import os
import struct
import sys
import weakref
import zlib
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from bgi.kernel.textmodes import CELL_WIDTH

# numpy is imported late: the window's process opens the window without it, in half of the time.
if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

MAGIC = b"BGICARD\0"
VERSION = 2
DEPTHS = (1, 4)  # bytes per pixel
CELL_BYTES = 2
CELL_HEIGHTS = (8, 14, 16)
MAX_SIDE = 4096  # pixels: no mode is wider or higher; a header that says so is damaged
CAPACITY = 2 * 1024 * 768  # bytes of pixels that every card holds: two pages of the largest mode
BLINKING, BRIGHT, MONOCHROME = 0, 1, 2  # what bit 7 of an attribute means: see the layout
NO_CURSOR = 0xFFFFFFFF  # the cell of a cursor that is not shown: beyond any last one
ATTEMPTS = 10  # at a copy of a page, while the program changes the visible page all the time

# Offsets.
_AT_WIDTH, _AT_HEIGHT, _AT_PAGES, _AT_PIXEL_BYTES = 12, 16, 20, 24
_AT_VISIBLE, _AT_CHANGES, _AT_SQUARE = 28, 32, 36
_AT_CELL_HEIGHT, _AT_CURSOR, _AT_ATTRIBUTES = 40, 44, 52
AT_PALETTE, PALETTE_BYTES = 64, 256 * 3
AT_PIXELS = 4096

_HEADER = struct.Struct("<8s12I")  # magic and the twelve numbers that follow it
_U32 = struct.Struct("<I")


class TextFrame(NamedTuple):
    """What a frame of a text mode has beside its cells."""

    columns: int
    rows: int
    cell_height: int
    cursor: int
    """The cell that the cursor is in; beyond the last one: none."""
    shape: int
    attributes: int
    phase: int = 0
    """What is dark just now of all that blinks: 1 the cursor, 2 characters too."""


class Frame(NamedTuple):
    """What there is to see at a moment: a mode, and a copy of the visible page.

    Width and height are those of the picture in pixels, also in a text mode, whose `pixels` are the
    bytes of its cells.
    """

    width: int
    height: int
    pixel_bytes: int
    square: bool
    pixels: bytes
    text: TextFrame | None = None


class Card:
    """A graphics card: pages of pixels, 256 colours, and the number of the page that is shown.

    `capacity` is the memory for pixels in bytes.
    """

    def __init__(self, capacity: int = CAPACITY) -> None:
        size = AT_PIXELS + capacity
        if sys.platform == "win32":
            name = f"bgi-{os.getpid()}-{os.urandom(8).hex()}"
            self._take(mmap.mmap(-1, size, tagname=name), f"tag:{name}:{size}", None)
        else:
            fd = _anonymous_file(size)
            self._take(mmap.mmap(fd, size), f"fd:{fd}:{size}", fd)
        _HEADER.pack_into(self._map, 0, MAGIC, VERSION, 0, 0, 0, 1, *[0] * 7)

    @classmethod
    def attach(cls, handle: str) -> Self:
        """Map the card of another process, given its `handle`: the monitor's side.

        Raises ValueError when the handle is malformed or what it names is not a card.
        """
        kind, _, rest = handle.partition(":")
        name, _, digits = rest.rpartition(":")
        if kind not in ("fd", "tag") or not name or not digits.isdecimal():
            raise ValueError(f"not the handle of a graphics card: {handle!r}")
        size = int(digits)
        if size < AT_PIXELS:
            raise ValueError(f"{handle!r} is too small to be a graphics card")
        card = cls.__new__(cls)
        card._take(_mapped(name, size), handle, None if sys.platform == "win32" else int(name))
        magic, version = _HEADER.unpack_from(card._map)[:2]
        if (magic, version) != (MAGIC, VERSION):
            card.close()
            raise ValueError(f"{handle!r} is not a graphics card of version {VERSION}")
        return card

    def _take(self, memory: mmap.mmap, handle: str, fd: int | None) -> None:
        self._map = memory
        self.handle = handle  # for the command line of a monitor
        # For the pass_fds of subprocess.
        self.inherit: tuple[int, ...] = () if fd is None else (fd,)
        self._release = weakref.finalize(self, _close_all, self.inherit)

    def set_mode(
        self, width: int, height: int, pages: int, pixel_bytes: int = 1, square: bool = False
    ) -> None:
        """Give the memory a new shape, all pixels 0, page 0 visible; the palette stays.

        `pixel_bytes` is 1 for palette indices and 4 for colours; `square` says that pixels are, so
        that the page is not to be stretched to 4:3. Raises ValueError when the mode does not fit
        into the card.
        """
        if pixel_bytes not in DEPTHS:
            raise ValueError(f"a pixel has 1 or 4 bytes, not {pixel_bytes}")
        self._set_shape(width, height, pages, pixel_bytes, square=square)

    def set_text_mode(self, columns: int, rows: int, cell_height: int, attributes: int = 0) -> None:
        """Give the memory the shape of a text mode, one page of zero bytes, without a cursor.

        ValueError when there is no such mode.
        """
        if cell_height not in CELL_HEIGHTS:
            raise ValueError(f"a character is 8, 14 or 16 pixels high, not {cell_height}")
        self._set_shape(columns, rows, 1, CELL_BYTES, cell_height, attributes)

    def _set_shape(
        self,
        width: int,
        height: int,
        pages: int,
        pixel_bytes: int,
        cell_height: int = 0,
        attributes: int = 0,
        square: bool = False,
    ) -> None:
        used = width * height * pages * pixel_bytes
        if not (0 < width <= MAX_SIDE and 0 < height <= MAX_SIDE and pages > 0):
            raise ValueError(f"no mode has {pages} pages of {width} x {height} pixels")
        if used > self.capacity:
            raise ValueError(
                f"{pages} pages of {width} x {height} pixels need {used} bytes, "
                f"the card has {self.capacity}"
            )
        self._set(_AT_WIDTH, 0)
        self._map[AT_PIXELS : AT_PIXELS + used] = bytes(used)
        self._set(_AT_HEIGHT, height)
        self._set(_AT_PAGES, pages)
        self._set(_AT_PIXEL_BYTES, pixel_bytes)
        self._set(_AT_SQUARE, square)
        self._set(_AT_CELL_HEIGHT, cell_height)
        self._set(_AT_ATTRIBUTES, attributes)
        self._set(_AT_CURSOR, NO_CURSOR)
        self._set(_AT_VISIBLE, 0)
        self.touch()
        self._set(_AT_WIDTH, width)

    @property
    def capacity(self) -> int:
        """The memory for pixels, in bytes."""
        return len(self._map) - AT_PIXELS

    @property
    def width(self) -> int:
        """The width of the mode in pixels; 0 before `set_mode`."""
        return self._get(_AT_WIDTH)

    @property
    def height(self) -> int:
        """The height of the mode in pixels."""
        return self._get(_AT_HEIGHT)

    @property
    def pages(self) -> int:
        """The number of pages."""
        return self._get(_AT_PAGES)

    @property
    def pixel_bytes(self) -> int:
        """The bytes of a pixel: 1 or 4."""
        return self._get(_AT_PIXEL_BYTES)

    @property
    def square(self) -> bool:
        """Whether pixels are square; otherwise the page fills a monitor of 4:3."""
        return bool(self._get(_AT_SQUARE))

    @property
    def changes(self) -> int:
        """How often mode or visible page changed, modulo 2**32."""
        return self._get(_AT_CHANGES)

    @property
    def visible(self) -> int:
        """The number of the page on show."""
        return self._get(_AT_VISIBLE)

    @visible.setter
    def visible(self, number: int) -> None:
        self._set(_AT_VISIBLE, self._existing(number))
        self.touch()

    @property
    def cursor(self) -> memoryview:
        """The text cursor's cell and shape, two numbers: a view, write to it."""
        return memoryview(self._map)[_AT_CURSOR : _AT_CURSOR + 8].cast("I")

    @property
    def attributes(self) -> int:
        """What the attributes of a text mode mean: see the layout."""
        return self._get(_AT_ATTRIBUTES)

    @attributes.setter
    def attributes(self, number: int) -> None:
        self._set(_AT_ATTRIBUTES, number)

    def touch(self) -> None:
        """Count one more change."""
        self._set(_AT_CHANGES, (self.changes + 1) & 0xFFFFFFFF)

    @property
    def palette(self) -> npt.NDArray[np.uint8]:
        """The colours as a (256, 3) array of red, green, blue: a view, write to it."""
        import numpy as np

        return np.frombuffer(self._map, np.uint8, PALETTE_BYTES, AT_PALETTE).reshape(256, 3)

    def colors(self) -> bytes:
        """A copy of the palette: red, green, blue of each index."""
        return self._map[AT_PALETTE : AT_PALETTE + PALETTE_BYTES]

    def page(self, number: int) -> memoryview:
        """The bytes of one page, writable, row by row; ValueError if there is no such page."""
        size = self.width * self.height * self.pixel_bytes
        start = AT_PIXELS + self._existing(number) * size
        return memoryview(self._map)[start : start + size]

    def frame(self) -> Frame | None:
        """What to show now; None for nothing.

        For monitors: believes nothing in the header that it has not checked.
        """
        for _ in range(ATTEMPTS):
            header = _HEADER.unpack_from(self._map)
            frame = self._copy(header)
            # If another page has become visible meanwhile, the program may have drawn on this one.
            if header == _HEADER.unpack_from(self._map):
                return frame
        return None

    def _copy(self, header: tuple[Any, ...]) -> Frame | None:
        _, _, width, height, pages, pixel_bytes, visible, _, square, cell, *text = header
        size = width * height * pixel_bytes
        if not (0 < width <= MAX_SIDE and 0 < height <= MAX_SIDE and visible < pages):
            return None
        if pixel_bytes not in (*DEPTHS, CELL_BYTES) or size * pages > self.capacity:
            return None
        start = AT_PIXELS + visible * size
        pixels = self._map[start : start + size]
        if pixel_bytes != CELL_BYTES:
            return Frame(width, height, pixel_bytes, bool(square), pixels)
        if cell not in CELL_HEIGHTS or max(width * CELL_WIDTH, height * cell) > MAX_SIDE:
            return None
        details = TextFrame(width, height, cell, *text)
        return Frame(width * CELL_WIDTH, height * cell, CELL_BYTES, False, pixels, details)

    def checksum(self) -> int:
        """A number that tells whether anything has changed: any pixel, colour or setting."""
        import numpy as np

        used = AT_PIXELS + self.width * self.height * self.pages * self.pixel_bytes
        return int(np.frombuffer(self._map, np.uint64, used // 8).sum())

    def fingerprint(self) -> int:
        """As `checksum`, but slower: what has moved is not taken for the same."""
        used = AT_PIXELS + self.width * self.height * self.pages * self.pixel_bytes
        with memoryview(self._map) as everything:
            return zlib.crc32(everything[:used])

    def close(self) -> None:
        """Let go of the memory; views that somebody still holds stay valid until dropped."""
        # A view that somebody holds keeps the mapping; both end together when it is dropped.
        with contextlib.suppress(BufferError):
            self._map.close()
        self._release()

    def _get(self, offset: int) -> int:
        number: int = _U32.unpack_from(self._map, offset)[0]
        return number

    def _set(self, offset: int, number: int) -> None:
        _U32.pack_into(self._map, offset, number)

    def _existing(self, number: int) -> int:
        if not 0 <= number < self.pages:
            raise ValueError(f"there is no page {number}; the mode has {self.pages}")
        return number


def _anonymous_file(size: int) -> int:
    """A descriptor of `size` zero bytes that have no name in any directory."""
    if sys.platform == "linux":
        fd = _above_standard(os.memfd_create("bgi-card"))
        os.truncate(fd, size)
        return fd
    # Imported late: it imports random, and many a program has a random.py of its own beside it.
    import tempfile

    with tempfile.TemporaryFile() as file:
        # Written, not only truncated: a full disk must be noticed here, not at some later pixel.
        file.write(bytes(size))
        file.flush()
        return _above_standard(os.dup(file.fileno()))


def _above_standard(fd: int) -> int:
    """The same file by a descriptor beyond 0, 1 and 2.

    Those are free in a program that was started with a standard stream closed, and the next pipe to
    a process would take the card's place.
    """
    if sys.platform == "win32" or fd > 2:
        return fd
    import fcntl

    above = fcntl.fcntl(fd, fcntl.F_DUPFD_CLOEXEC, 3)
    os.close(fd)
    return above


def _mapped(name: str, size: int) -> mmap.mmap:
    """The memory with that name (Windows), or behind that descriptor."""
    try:
        if sys.platform == "win32":
            return mmap.mmap(-1, size, tagname=name)
        return mmap.mmap(int(name), size)
    except (OSError, ValueError) as error:
        raise ValueError(f"cannot map {name!r} as a graphics card: {error}") from None


def _close_all(descriptors: tuple[int, ...]) -> None:
    for fd in descriptors:
        os.close(fd)
