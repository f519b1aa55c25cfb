"""The mouse driver of DOS, interrupt 33h, as plain functions: `from bgi import mouse`.

Coordinates are pixels of the screen in every mode, those of text too, where a character is 8 wide
and mostly 16 high (DOS counted by two in modes 320 wide, and a character as 8 by 8). The pointer is
drawn by the monitor, over the picture and not into it: there is no need to hide it while drawing.
Before initgraph() the first call opens a text screen. Buttons are 0 left, 1 right, 2 middle; sets
of buttons are sums of 1, 2 and 4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from bgi import current
from bgi.errors import brief
from bgi.kernel.arguments import Number, check_function, length, whole
from bgi.monitor.pointer import LEFT, MIDDLE, RIGHT, Count, pressed, released

__all__ = [
    "LEFT",
    "MIDDLE",
    "RIGHT",
    "buttons",
    "hide",
    "mickeys",
    "on_event",
    "position",
    "presses",
    "releases",
    "reset",
    "set_graphics_cursor",
    "set_horizontal_range",
    "set_position",
    "set_vertical_range",
    "show",
    "wheel",
]


CURSOR_SIZE = 16
"""Width and height of a pointer in pixels."""


def reset() -> int:
    """Put everything back: an arrow, hidden and in the middle, no limits, no handler (AX = 0).

    Returns the number of buttons, 3.
    """
    mode = current.shown()
    current.screen.monitor.mouse.reset(mode.width // 2, mode.height // 2)
    return 3


def show() -> None:
    """Show the pointer (AX = 1).

    Calls are counted: after two calls of hide() two of show() are needed.
    """
    current.screen.monitor.mouse.show()


def hide() -> None:
    """Hide the pointer (AX = 2)."""
    current.screen.monitor.mouse.hide()


def position() -> tuple[int, int]:
    """Return where the mouse is: x, y (AX = 3)."""
    mouse = current.screen.monitor.mouse
    return mouse.x, mouse.y


def buttons() -> int:
    """Return which buttons are down: 1 left + 2 right + 4 middle (AX = 3)."""
    return current.screen.monitor.mouse.buttons


def set_position(x: Number, y: Number) -> None:
    """Move the pointer to x, y, or as near as the ranges allow (AX = 4)."""
    mode, mouse = current.shown(), current.screen.monitor.mouse
    place = whole("x", x), whole("y", y)
    mouse.move(_within(place[0], mode.width), _within(place[1], mode.height))


def presses(button: Number) -> Count:
    """Return how often a button was pressed since this was last asked: times, x, y (AX = 5).

    x and y are where it was last pressed. ValueError if button is not 0, 1 or 2.
    """
    return current.screen.monitor.mouse.take_count(pressed(_button(button)))


def releases(button: Number) -> Count:
    """Return how often a button was released since this was last asked: times, x, y (AX = 6).

    x and y are where it was last released. ValueError if button is not 0, 1 or 2.
    """
    return current.screen.monitor.mouse.take_count(released(_button(button)))


def set_horizontal_range(low: Number, high: Number) -> None:
    """Keep the pointer's x from low to high, in either order; moves it there at once (AX = 7)."""
    left, right = _range(low, high, current.shown().width)
    _, top, _, bottom = _limits()
    current.screen.monitor.mouse.limit(left, top, right, bottom)


def set_vertical_range(low: Number, high: Number) -> None:
    """Keep the pointer's y from low to high, in either order; moves it there at once (AX = 8)."""
    top, bottom = _range(low, high, current.shown().height)
    left, _, right, _ = _limits()
    current.screen.monitor.mouse.limit(left, top, right, bottom)


def set_graphics_cursor(x: Number, y: Number, masks: Sequence[Number]) -> None:
    """Give the pointer another look, 16 by 16 pixels (AX = 9); reset() gives the arrow back.

    Args:
        x, y: its hot spot, the pixel that points, counted from its left upper corner; -16 to 16.
        masks: 32 numbers of 16 bits: the rows of the screen mask, then those of the cursor mask,
            the highest bit leftmost. A pixel is black where both have 0, white for 0 and 1; 1 and 0
            show what is there, and 1 and 1 its opposite.

    ValueError for another number of rows, or a hot spot that is farther away.
    """
    spot = whole("x", x), whole("y", y)
    if max(map(abs, spot)) > CURSOR_SIZE:
        raise ValueError(f"x and y, the hot spot, must be within -16 and 16, not {brief(spot)}")
    if length("masks", masks) != 2 * CURSOR_SIZE:
        raise ValueError(f"masks must be 32 numbers, 16 rows of each mask; not {len(masks)}")
    rows = [whole(f"masks[{place}]", row) & 0xFFFF for place, row in enumerate(masks)]
    current.shown()
    current.screen.monitor.mouse.shape(*spot, rows)


def mickeys() -> tuple[int, int]:
    """Return how far the mouse has moved since this was last asked, across and down (AX = 0Bh).

    By the driver's default a pixel is one mickey across and two down.
    """
    across, down = current.screen.monitor.mouse.take_motion()
    return across, 2 * down


def wheel() -> int:
    """Return how far the wheel was turned since this was last asked, in clicks; up is negative.

    Later mouse drivers had it (BH of AX = 3).
    """
    return current.screen.monitor.mouse.take_wheel()


def on_event(mask: Number, handler: Callable[[int, int, int, int], object] | None) -> None:
    """Have a function called for events (AX = 0Ch).

    Args:
        mask: which, as a sum of 1 mouse moved, 2 and 4 left button pressed and released, 8 and 16
            right, 32 and 64 middle.
        handler: called with the event, the buttons down, x and y, in a thread of its own; None:
            no function any more.
    """
    wanted = whole("mask", mask)
    check_function("handler", handler)
    handlers = current.screen.monitor.mouse.handlers
    if handler is None:
        handlers.pop(0, None)
        return

    handlers[0] = lambda event: (
        handler(event.event, event.buttons, event.x, event.y) if event.event & wanted else None
    )


def _range(low: Number, high: Number, size: int) -> tuple[int, int]:
    """A range in either order, as far as it lies on a screen of that size."""
    ends = _within(whole("low", low), size), _within(whole("high", high), size)
    return min(ends), max(ends)


def _within(place: int, size: int) -> int:
    """The place on a screen of that size which is nearest."""
    return min(max(place, 0), size - 1)


def _limits() -> tuple[int, int, int, int]:
    mode = current.shown()
    limits = current.screen.monitor.mouse.limits
    return limits or (0, 0, mode.width - 1, mode.height - 1)


def _button(button: Number) -> int:
    number = whole("button", button)
    if number not in (LEFT, RIGHT, MIDDLE):
        raise ValueError(f"button must be 0 (left), 1 (right) or 2 (middle), not {brief(number)}")
    return number
