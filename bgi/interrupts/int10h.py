"""Interrupt 10h, the video BIOS: modes, the cursor, characters, pixels, and the palette.

Over a picture characters are the ROM's letters in the colour asked for, whose bit 7 means XOR where
there are fewer than 256. Of text there is one page. What lies off the screen is ignored.
"""

from __future__ import annotations

import numpy as np

from bgi import current
from bgi.console.crt import Crt
from bgi.console.glyphs import XOR
from bgi.console.teletype import CURSORS
from bgi.constants import (
    C80,
    CGA,
    CGAC1,
    CGAHI,
    EGAMONO,
    EGAMONOHI,
    MCGA,
    MCGAHI,
    MONO,
    VGA,
    VGAHI,
    VGALO,
    VGAMED,
)
from bgi.interrupts.registers import REGS, SREGS, Function, nothing, numbers, room
from bgi.kernel.modes import BIOS_ONLY, GraphicsMode, find
from bgi.kernel.textmodes import TEXT_MODES
from bgi.memory.card import BLINKING, BRIGHT, NO_CURSOR
from bgi.memory.palette import Palette

_FOUND = {
    0x04: find(CGA, CGAC1),
    0x05: find(CGA, CGAC1),
    0x06: find(CGA, CGAHI),
    0x0E: find(VGA, VGALO),
    0x0F: find(EGAMONO, EGAMONOHI),
    0x10: find(VGA, VGAMED),
    0x11: find(MCGA, MCGAHI),
    0x12: find(VGA, VGAHI),
    **{mode.number: mode for mode in BIOS_ONLY},
}
PICTURES = {number: mode for number, mode in _FOUND.items() if mode is not None}
"""The BIOS's graphics modes by number."""


def _shape(mode: GraphicsMode) -> tuple[int, int, int]:
    return mode.width, mode.height, mode.colors


_NUMBERS = {_shape(mode): number for number, mode in reversed(PICTURES.items())}


def _crt() -> Crt:
    return current.crt or current.console()


# Modes


def set_mode(r: REGS, s: SREGS) -> None:
    """AL: the mode. It begins empty, also where bit 7 asks to keep what is there."""
    number = r.h.al & 0x7F
    if number in PICTURES:
        current.open_screen(PICTURES[number])
    elif number in TEXT_MODES and number <= MONO:
        current.set_text_mode(TEXT_MODES[number])
    else:
        raise ValueError(f"the BIOS has no video mode {number:02X}h here")


def get_mode(r: REGS, s: SREGS) -> None:
    """Returns AL the mode, AH its columns, BH the page. A mode of others is text to the BIOS."""
    crt = _crt()
    mode, text = current.shown(), crt.mode.number if crt.mode.number <= MONO else C80
    r.h.al = _NUMBERS.get(_shape(mode), text) if isinstance(mode, GraphicsMode) else text
    r.h.ah, r.h.bh = crt.page.columns, 0


def get_adapter(r: REGS, s: SREGS) -> None:
    """Returns AL 1Ah, BL 8: a VGA with a colour monitor."""
    r.h.al, r.x.bx = 0x1A, 8


def get_ega(r: REGS, s: SREGS) -> None:
    """BL 10h: returns BH 0, colour, and BL 3, 256 KB. Nothing else is there to be asked."""
    if r.h.bl == 0x10:
        r.x.bx = 3


def show_page(r: REGS, s: SREGS) -> None:
    """AL: the page to show, of a picture."""
    if not _crt().is_text:
        current.reachable().setvisualpage(r.h.al)


# The cursor


def shape_cursor(r: REGS, s: SREGS) -> None:
    """CH, CL: its first and last row; 20h in CH hides it. Both below 8: as if of 8 rows."""
    first, last, crt = r.h.ch, r.h.cl, _crt()
    high = crt.mode.cell_height
    if (first, last) == (6, 7):
        first, last = divmod(CURSORS[high], 256)
    elif max(first, last) < 8:
        first, last = first * high // 8, (last + 1) * high // 8 - 1
    crt.shape_cursor(first << 8 | last)


def move_cursor(r: REGS, s: SREGS) -> None:
    """DH, DL: its row and column; outside the screen it is hidden."""
    crt = _crt()
    x, y = min(r.h.dl, crt.page.columns - 1), min(r.h.dh, crt.page.rows - 1)
    crt.move(x, y)
    if (x, y) != (r.h.dl, r.h.dh):
        crt.card.cursor[0] = NO_CURSOR


def get_cursor(r: REGS, s: SREGS) -> None:
    """Returns CX its shape, DH, DL its row and column."""
    crt = _crt()
    r.x.cx, r.h.dh, r.h.dl = crt.card.cursor[1], crt.y, crt.x


# Characters


def scroll_up(r: REGS, s: SREGS) -> None:
    """AL: lines, or 0 for all; CH, CL, DH, DL: rows and columns of the box; BH: the new cells'."""
    _scroll(r, 1)


def scroll_down(r: REGS, s: SREGS) -> None:
    """The same the other way."""
    _scroll(r, -1)


def _scroll(r: REGS, up: int) -> None:
    page = _crt().page
    left, top = r.h.cl, r.h.ch
    right, bottom = min(r.h.dl, page.columns - 1), min(r.h.dh, page.rows - 1)
    if left <= right and top <= bottom:
        page.scroll((left, top, right, bottom), up * (r.h.al or page.rows), r.h.bh)


def read_cell(r: REGS, s: SREGS) -> None:
    """Returns AL the character at the cursor, AH its attribute."""
    crt = _crt()
    r.x.ax = crt.page.cell(crt.x, crt.y)


def write_cells(r: REGS, s: SREGS) -> None:
    """AL: a character, CX times from the cursor on, which stays, in attribute or colour BL."""
    crt = _crt()
    crt.page.write(crt.x, crt.y, _repeated(r, crt), r.h.bl)


def rewrite_cells(r: REGS, s: SREGS) -> None:
    """The same in the attributes that the cells have; over a picture in colour BL."""
    crt = _crt()
    crt.page.rewrite(crt.x, crt.y, _repeated(r, crt), r.h.bl)


def _repeated(r: REGS, crt: Crt) -> bytes:
    """A character as often as asked for: to the end of the screen, of a picture's row."""
    rows = crt.page.rows - crt.y if crt.is_text else 1
    count: int = min(r.x.cx, max(rows * crt.page.columns - crt.x, 0))
    return bytes([r.h.al]) * count


def teletype(r: REGS, s: SREGS) -> None:
    """AL: a character, after which the cursor moves on; over a picture in colour BL."""
    _crt().teletype(bytes([r.h.al]), r.h.bl)


# Pixels

_ONE = np.ones((1, 1), np.bool_)


def put_pixel(r: REGS, s: SREGS) -> None:
    """AL: the colour of the pixel at CX, DX, wherever the viewport is."""
    if _crt().is_text:
        return
    graphics, color = current.reachable(), r.h.al
    page, most = graphics.page, graphics.mode.maxcolor
    before = page.get(r.x.cx, r.x.dx) if color & XOR > most else 0
    page.print(r.x.cx, r.x.dx, _ONE, before ^ color & most)


def get_pixel(r: REGS, s: SREGS) -> None:
    """Returns AL: the colour of the pixel at CX, DX; 0 off the screen, and in a text mode."""
    r.h.al = 0 if _crt().is_text else current.reachable().page.get(r.x.cx, r.x.dx)


# The palette


def _palette() -> Palette:
    crt = _crt()
    return crt.palette if crt.is_text else current.reachable().palette


def set_background(r: REGS, s: SREGS) -> None:
    """BH 0, BL: the background of a picture, as setbkcolor() does; else nothing."""
    if r.h.bh == 0 and not _crt().is_text:
        current.reachable().setbkcolor(r.h.bl & 15)


def set_register(r: REGS, s: SREGS) -> None:
    """BL, BH: an index of the palette, and its value."""
    _palette().set(r.h.bl, r.h.bh)


def set_registers(r: REGS, s: SREGS) -> None:
    """ES: the values of indices 0 to 15, and one for the border, which is black here."""
    _palette().set_all(numbers("es", s.es, 17)[:16])


def set_blinking(r: REGS, s: SREGS) -> None:
    """BL: 0 makes bit 7 of an attribute a bright background, 1 blinking."""
    crt = _crt()
    if crt.is_text and not crt.mode.monochrome:
        crt.card.attributes = BLINKING if r.h.bl & 1 else BRIGHT
        crt.card.touch()


def get_register(r: REGS, s: SREGS) -> None:
    """BL: an index. Returns BH its value."""
    values = _palette().values
    r.h.bh = values[r.h.bl] if r.h.bl < len(values) else 0


def set_color(r: REGS, s: SREGS) -> None:
    """BX: a register of the DAC; DH, CH, CL: red, green and blue, 0 to 63."""
    _palette().load([r.x.bx], [(r.h.dh, r.h.ch, r.h.cl)])


def set_colors(r: REGS, s: SREGS) -> None:
    """BX, CX: the first register and how many; ES: three numbers for each."""
    count = min(r.x.cx, 256)
    found = numbers("es", s.es, 3 * count)
    colors = list(zip(found[::3], found[1::3], found[2::3], strict=True))
    _palette().load([r.x.bx + place for place in range(count)], colors)


def get_color(r: REGS, s: SREGS) -> None:
    """BX: a register of the DAC. Returns DH, CH, CL."""
    r.h.dh, r.h.ch, r.h.cl = _palette().loaded(r.x.bx)


def get_colors(r: REGS, s: SREGS) -> None:
    """BX, CX: the first register and how many; ES: a bytearray for three numbers of each."""
    count, palette = min(r.x.cx, 256), _palette()
    found = [number for place in range(count) for number in palette.loaded(r.x.bx + place)]
    room("es", s.es, 3 * count)[: 3 * count] = bytes(found)


PALETTE: dict[int, Function] = {
    0x00: set_register,
    0x01: nothing,  # the colour of the border
    0x02: set_registers,
    0x03: set_blinking,
    0x07: get_register,
    0x10: set_color,
    0x12: set_colors,
    0x15: get_color,
    0x17: get_colors,
}


def change_palette(r: REGS, s: SREGS) -> None:
    """AL: what to do."""
    if r.h.al not in PALETTE:
        there = ", ".join(f"{known:02X}h" for known in PALETTE)
        raise ValueError(
            f"function 10h of interrupt 10h takes in AL only {there}, not {r.h.al:02X}h"
        )
    PALETTE[r.h.al](r, s)


FUNCTIONS: dict[int, Function] = {
    0x00: set_mode,
    0x01: shape_cursor,
    0x02: move_cursor,
    0x03: get_cursor,
    0x05: show_page,
    0x06: scroll_up,
    0x07: scroll_down,
    0x08: read_cell,
    0x09: write_cells,
    0x0A: rewrite_cells,
    0x0B: set_background,
    0x0C: put_pixel,
    0x0D: get_pixel,
    0x0E: teletype,
    0x0F: get_mode,
    0x10: change_palette,
    0x12: get_ega,
    0x1A: get_adapter,
}
