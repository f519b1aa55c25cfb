"""Memory of the PC by segment and offset: the screen's text and pixels, and the BIOS's data.

What nobody listens to keeps what is written there. A scripted program meets nothing else, so that
all runs are the same.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bgi
from bgi import bios, conio, current
from bgi.turboc.runtime.memory import Pointer

TEXT, MONO_TEXT, PICTURE, BIOS = 0xB800, 0xB000, 0xA000, 0x40

_KEYBOARD_ENDS = {0x1A: 0x1E, 0x1B: 0, 0x1C: 0x1E, 0x1D: 0}
"""Where in the BIOS's data its queue of keys begins and ends: it is empty."""


class Segment:
    """64 KB of memory, a byte at a time."""

    def __init__(self, number: int) -> None:
        self.number = number
        self._kept: dict[int, int] = {}

    def get(self, offset: int) -> int:
        """A byte."""
        return self._kept.get(offset & 0xFFFF, 0)

    def put(self, offset: int, value: int) -> None:
        """Store a byte."""
        self._kept[offset & 0xFFFF] = value & 0xFF


class TextSegment(Segment):
    """The cells of the text screen: a character, then its attribute."""

    def _cell(self, offset: int) -> tuple[int, int]:
        row, column = divmod((offset & 0xFFFF) // 2, conio.gettextinfo().screenwidth)
        return column + 1, row + 1

    def get(self, offset: int) -> int:
        x, y = self._cell(offset)
        cell = conio.gettext(x, y, x, y) if not current.is_open() or current.crt else b""
        return cell[offset & 1] if cell else super().get(offset)

    def put(self, offset: int, value: int) -> None:
        super().put(offset, value)
        x, y = self._cell(offset)
        cell = bytearray(conio.gettext(x, y, x, y) or b"")
        if cell:
            cell[offset & 1] = value & 0xFF
            conio.puttext(x, y, x, y, bytes(cell))


class PictureSegment(Segment):
    """The pixels of a picture with 256 colours, 320 in a row."""

    def _place(self, offset: int) -> tuple[int, int] | None:
        if not current.is_open() or bgi.getmaxx() != 319 or bgi.getmaxcolor() != 255:
            return None
        y, x = divmod(offset & 0xFFFF, 320)
        return x, y

    def get(self, offset: int) -> int:
        place = self._place(offset)
        return bgi.getpixel(*place) if place else super().get(offset)

    def put(self, offset: int, value: int) -> None:
        super().put(offset, value)
        if place := self._place(offset):
            bgi.putpixel(*place, value & 0xFF)


class BiosSegment(Segment):
    """What the BIOS knows: the Shift keys, the timer."""

    def get(self, offset: int) -> int:
        if offset in _KEYBOARD_ENDS:
            return _KEYBOARD_ENDS[offset]
        if offset == 0x17:
            return bios.bioskey(2) if current.is_open() else 0
        if 0x6C <= offset <= 0x6F:
            return bios.biostime(0) >> 8 * (offset - 0x6C) & 0xFF
        return super().get(offset)


_KINDS: dict[int, Callable[[int], Segment]] = {
    **{TEXT: TextSegment, MONO_TEXT: TextSegment, PICTURE: PictureSegment, BIOS: BiosSegment},
}


class FarView:
    """A segment as a memory of numbers of so many bytes."""

    def __init__(self, segment: Segment, size: int) -> None:
        self.segment, self._size = segment, size

    def __len__(self) -> int:
        return 0x10000 // self._size

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[one] for one in range(*index.indices(len(self)))]
        begin = index * self._size
        bytes_ = bytes(self.segment.get(begin + i) for i in range(self._size))
        return int.from_bytes(bytes_, "little", signed=self._size > 1)

    def __setitem__(self, index: int, value: int) -> None:
        begin = index * self._size
        for i in range(self._size):
            self.segment.put(begin + i, value >> 8 * i)

    def typed(self, size: int, at: int) -> Pointer:
        """A pointer to the same place, for numbers of another size."""
        return Pointer(FarView(self.segment, size), at * self._size // size)


class FarMemory:
    """All segments."""

    def __init__(self, scripted: bool) -> None:
        self._kinds = {} if scripted else _KINDS
        self._segments: dict[int, Segment] = {}
        self._shown: dict[int, Any] = {}

    def segment(self, number: int) -> Segment:
        """A segment by its number."""
        number &= 0xFFFF
        if number not in self._segments:
            self._segments[number] = self._kinds.get(number, Segment)(number)
        return self._segments[number]

    def pointer(self, segment: int, offset: int) -> Pointer | None:
        """A far pointer to bytes; null is none."""
        number = segment & 0xFFFF
        if number in self._shown:
            return Pointer(self._shown[number], offset & 0xFFFF)
        if not number and not offset & 0xFFFF:
            return None
        return Pointer(FarView(self.segment(number), 1), offset & 0xFFFF)

    def address(self, pointer: Pointer | None) -> tuple[int, int]:
        """Segment and offset of a pointer; one of the program's memory gets a number of its own."""
        if pointer is None:
            return 0, 0
        if isinstance(pointer.memory, FarView):
            return pointer.memory.segment.number, pointer.at & 0xFFFF
        for number, memory in self._shown.items():
            if memory is pointer.memory:
                return number, pointer.at & 0xFFFF
        number = 0x2000 + len(self._shown)
        self._shown[number] = pointer.memory
        return number, pointer.at & 0xFFFF
