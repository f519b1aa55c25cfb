"""Interrupt 33h, the mouse driver: `bgi.mouse` in the registers and the coordinates of DOS.

The driver counted modes 320 wide by two, and characters as 8 by 8, or 16 by 8 where there are 40 in
a row.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from bgi import current, mouse
from bgi.interrupts.registers import REGS, SREGS, Function, nothing, numbers
from bgi.kernel.textmodes import CELL_WIDTH, TextMode
from bgi.monitor.pointer import Count

PRESENT = 0xFFFF
VIRTUAL_WIDTH = 640


class Step(NamedTuple):
    """The smallest step that the driver counts, across or down: in its units, and in pixels."""

    units: int
    pixels: int

    def to_units(self, pixel: int) -> int:
        """What the driver says for a pixel."""
        return pixel // self.pixels * self.units

    def to_pixels(self, unit: int) -> int:
        """The pixel that the driver means."""
        return unit // self.units * self.pixels


def _steps() -> tuple[Step, Step]:
    """The steps across and down of the mode on show."""
    mode = current.shown()
    if isinstance(mode, TextMode):
        return Step(VIRTUAL_WIDTH // mode.columns, CELL_WIDTH), Step(8, mode.cell_height)
    return Step(2 if mode.width == VIRTUAL_WIDTH // 2 else 1, 1), Step(1, 1)


def _units(x: int, y: int) -> tuple[int, int]:
    across, down = _steps()
    return across.to_units(x), down.to_units(y)


def _signed(word: int) -> int:
    return word - ((word & 0x8000) << 1)


def reset(r: REGS, s: SREGS) -> None:
    """Returns AX: FFFFh, a driver is there; BX: how many buttons."""
    r.x.ax, r.x.bx = PRESENT, mouse.reset()


def show(r: REGS, s: SREGS) -> None:
    """Show the pointer."""
    mouse.show()


def hide(r: REGS, s: SREGS) -> None:
    """Hide the pointer."""
    mouse.hide()


def position(r: REGS, s: SREGS) -> None:
    """Returns BX: the buttons down; CX, DX: where the pointer is."""
    r.x.bx = mouse.buttons()
    r.x.cx, r.x.dx = _units(*mouse.position())


def move(r: REGS, s: SREGS) -> None:
    """CX, DX: where the pointer is to be."""
    across, down = _steps()
    mouse.set_position(across.to_pixels(_signed(r.x.cx)), down.to_pixels(_signed(r.x.dx)))


def presses(r: REGS, s: SREGS) -> None:
    """BX: a button. Returns AX the buttons down, BX how often it was pressed, CX, DX where last."""
    _tell(r, mouse.presses(r.x.bx))


def releases(r: REGS, s: SREGS) -> None:
    """BX: a button. Returns AX the buttons down, BX how often it came up, CX, DX where last."""
    _tell(r, mouse.releases(r.x.bx))


def _tell(r: REGS, count: Count) -> None:
    r.x.ax, r.x.bx = mouse.buttons(), count.times
    r.x.cx, r.x.dx = _units(count.x, count.y)


def set_horizontal_range(r: REGS, s: SREGS) -> None:
    """CX, DX: the least and the largest x."""
    across, _ = _steps()
    mouse.set_horizontal_range(across.to_pixels(_signed(r.x.cx)), across.to_pixels(_signed(r.x.dx)))


def set_vertical_range(r: REGS, s: SREGS) -> None:
    """CX, DX: the least and the largest y."""
    _, down = _steps()
    mouse.set_vertical_range(down.to_pixels(_signed(r.x.cx)), down.to_pixels(_signed(r.x.dx)))


def set_graphics_cursor(r: REGS, s: SREGS) -> None:
    """BX, CX: the hot spot; ES: sixteen rows of the screen mask, then of the cursor mask."""
    mouse.set_graphics_cursor(_signed(r.x.bx), _signed(r.x.cx), numbers("es", s.es, 32)[:32])


def motion(r: REGS, s: SREGS) -> None:
    """Returns CX, DX: how far the mouse has moved, in mickeys."""
    r.x.cx, r.x.dx = mouse.mickeys()


def set_handler(r: REGS, s: SREGS) -> None:
    """CX: for which events; ES: a function, called with the event, the buttons down, x and y."""
    handler: Callable[[int, int, int, int], object] | None = s.es
    if handler is None or r.x.cx == 0:
        mouse.on_event(0, None)
        return
    call = handler
    mouse.on_event(r.x.cx, lambda event, buttons, x, y: call(event, buttons, *_units(x, y)))


FUNCTIONS: dict[int, Function] = {
    0x00: reset,
    0x01: show,
    0x02: hide,
    0x03: position,
    0x04: move,
    0x05: presses,
    0x06: releases,
    0x07: set_horizontal_range,
    0x08: set_vertical_range,
    0x09: set_graphics_cursor,
    0x0A: nothing,  # the look of the pointer on a text screen: an arrow, as elsewhere
    0x0B: motion,
    0x0C: set_handler,
    0x0F: nothing,  # how many mickeys a pixel is
    0x21: reset,
}
