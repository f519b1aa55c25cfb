"""The text screen: its modes, window, cursor and attributes, and pieces of it.

Source: conio.h.
"""

from __future__ import annotations

from bgi import current
from bgi.console.teletype import NORMAL_ATTRIBUTE
from bgi.constants import LASTMODE
from bgi.errors import brief
from bgi.kernel.arguments import Number, whole
from bgi.kernel.textmodes import TEXT_MODES
from bgi.memory.cells import CellPage
from bgi.raster.lines import Box
from bgi.settings import text_info

# fmt: off
__all__ = [
    "textmode", "window", "clrscr", "clreol", "gotoxy", "wherex", "wherey",
    "textattr", "textcolor", "textbackground", "highvideo", "lowvideo", "normvideo",
    "gettextinfo", "gettext", "puttext", "movetext", "_setcursortype",
]
# fmt: on

_INTENSE = 8


def textmode(newmode: Number) -> None:
    """Set a text mode: an empty screen, the window all of it, light grey on black.

    Args:
        newmode: BW40, C40, BW80, C80 (the usual one), MONO, C4350 (80 columns, 50 rows), or
            LASTMODE, the one before.

    Leaves a graphics mode as restorecrtmode() does. An unknown mode is ignored.
    """
    number = whole("newmode", newmode)
    if number == LASTMODE:
        current.set_text_mode(current.console().mode_before)
    elif number in TEXT_MODES:
        current.set_text_mode(TEXT_MODES[number])


def window(left: Number, top: Number, right: Number, bottom: Number) -> None:
    """Write within a part of the screen from now on; the cursor goes to its corner.

    Args:
        left, top, right, bottom: its corners on the screen, both included, from 1 on.

    Ignored unless it lies on the screen.
    """
    crt = current.crt or current.console()
    box = _box(left, top, right, bottom)
    if box is not None:
        crt.open_window(box)


def _box(left: Number, top: Number, right: Number, bottom: Number) -> Box | None:
    """A box of cells as it is counted inside, or None if it does not lie on the screen."""
    crt = current.crt or current.console()
    x1, y1 = whole("left", left), whole("top", top)
    x2, y2 = whole("right", right), whole("bottom", bottom)
    if 1 <= x1 <= x2 <= crt.cells.columns and 1 <= y1 <= y2 <= crt.cells.rows:
        return x1 - 1, y1 - 1, x2 - 1, y2 - 1
    return None


def clrscr() -> None:
    """Empty the window in the attribute of now, the cursor in its corner."""
    (current.crt or current.console()).clear()


def clreol() -> None:
    """Empty the row from the cursor to the window's edge."""
    (current.crt or current.console()).clear_line()


def gotoxy(x: Number, y: Number) -> None:
    """Put the cursor into a cell of the window.

    Args:
        x, y: column and row, from 1 on.

    Ignored outside the window. Over a picture it moves the place where `bgi.stdio` writes.
    """
    crt = current.crt or current.console()
    left, top, right, bottom = crt.window
    column, row = left + whole("x", x) - 1, top + whole("y", y) - 1
    if left <= column <= right and top <= row <= bottom:
        crt.move(column, row)


def wherex() -> int:
    """Return the cursor's column in the window, from 1 on."""
    crt = current.crt or current.console()
    return crt.x - crt.window[0] + 1


def wherey() -> int:
    """Return the cursor's row in the window, from 1 on."""
    crt = current.crt or current.console()
    return crt.y - crt.window[1] + 1


# Attributes


def textattr(newattr: Number) -> None:
    """Write in an attribute from now on: colour + 16 * background + BLINK.

    Args:
        newattr: 0..255; the low byte counts.
    """
    (current.crt or current.console()).attribute = whole("newattr", newattr) & 0xFF


def textcolor(newcolor: Number) -> None:
    """Write in a colour from now on.

    Args:
        newcolor: 0..15, plus BLINK to blink.
    """
    crt = current.crt or current.console()
    crt.attribute = crt.attribute & 0x70 | whole("newcolor", newcolor) & 0x8F


def textbackground(newcolor: Number) -> None:
    """Write on a background from now on.

    Args:
        newcolor: 0..7; the low three bits count.
    """
    crt = current.crt or current.console()
    crt.attribute = crt.attribute & 0x8F | (whole("newcolor", newcolor) & 7) << 4


def highvideo() -> None:
    """Write in bright colours from now on."""
    (current.crt or current.console()).attribute |= _INTENSE


def lowvideo() -> None:
    """Write in dark colours from now on."""
    (current.crt or current.console()).attribute &= ~_INTENSE


def normvideo() -> None:
    """Write as at first, in light grey on black."""
    (current.crt or current.console()).attribute = NORMAL_ATTRIBUTE


def _setcursortype(cur_t: Number) -> None:
    """Choose the look of the cursor.

    Args:
        cur_t: _NOCURSOR, _SOLIDCURSOR or _NORMALCURSOR; others are ignored.
    """
    (current.crt or current.console()).choose_cursor(whole("cur_t", cur_t))


def gettextinfo() -> text_info:
    """Return the window, the attribute, the mode, its size, and the cursor."""
    crt = current.crt or current.console()
    left, top, right, bottom = crt.window
    return text_info(
        left + 1,
        top + 1,
        right + 1,
        bottom + 1,
        crt.attribute,
        NORMAL_ATTRIBUTE,
        crt.mode.number,
        crt.cells.rows,
        crt.cells.columns,
        wherex(),
        wherey(),
    )


# Pieces of the screen


def gettext(left: Number, top: Number, right: Number, bottom: Number) -> bytes:
    """Return what stands in a box of the screen, two bytes a cell: character and attribute.

    Args:
        left, top, right, bottom: its corners on the screen, both included, from 1 on.

    Returns the cells row by row, or b"" (C's 0) if the box does not lie on the screen, or while a
    graphics mode is set.
    """
    cells = (current.crt or current.console()).cells
    box = _box(left, top, right, bottom)
    return cells.copy(box) if box is not None and isinstance(cells, CellPage) else b""


def puttext(
    left: Number, top: Number, right: Number, bottom: Number, source: bytes | bytearray
) -> int:
    """Put back into a box what gettext() returned.

    Args:
        left, top, right, bottom: its corners on the screen, both included, from 1 on.
        source: two bytes a cell, row by row; more than the box needs are not used.

    Returns 1, or 0 if the box does not lie on the screen, or while a graphics mode is set.
    ValueError if `source` is too short.
    """
    cells = (current.crt or current.console()).cells
    if not isinstance(source, (bytes, bytearray)):
        raise TypeError(f"source must be bytes, not {type(source).__name__}: {brief(source)}")
    box = _box(left, top, right, bottom)
    if box is None or not isinstance(cells, CellPage):
        return 0
    needed = 2 * (box[2] - box[0] + 1) * (box[3] - box[1] + 1)
    if len(source) < needed:
        raise ValueError(f"source must hold {needed} bytes, two a cell; not {len(source)}")
    cells.put(box, bytes(source[:needed]))
    return 1


def movetext(
    left: Number, top: Number, right: Number, bottom: Number, destleft: Number, desttop: Number
) -> int:
    """Copy a box of the screen to another place, which may overlap it.

    Args:
        left, top, right, bottom: its corners on the screen, both included, from 1 on.
        destleft, desttop: where its first corner goes.

    Returns 1, or 0 if one of both does not lie on the screen.
    """
    x, y = whole("destleft", destleft), whole("desttop", desttop)
    wide, high = (
        whole("right", right) - whole("left", left),
        whole("bottom", bottom) - whole("top", top),
    )
    cells = gettext(left, top, right, bottom)
    return puttext(x, y, x + wide, y + high, cells) if cells else 0
