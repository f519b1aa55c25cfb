"""The mouse over the window, by WinBGIm's calls. What INT 33h could do is in `bgi.mouse`.

Source: WinBGIm.
"""

from __future__ import annotations

from collections.abc import Callable

from bgi import current
from bgi.constants import NO_CLICK
from bgi.errors import brief
from bgi.kernel.arguments import Number, check_function, flag, whole
from bgi.monitor.pointer import KINDS

# fmt: off
__all__ = [
    "mousex", "mousey",
    "ismouseclick", "getmouseclick", "clearmouseclick",
    "setmousequeuestatus", "registermousehandler",
]
# fmt: on


def mousex() -> int:
    """Return the mouse's x in pixels of the screen, however large the window."""
    return current.screen.monitor.mouse.x


def mousey() -> int:
    """Return the mouse's y in pixels of the screen, however large the window."""
    return current.screen.monitor.mouse.y


def ismouseclick(kind: Number) -> bool:
    """Tell whether an event of that kind waits to be taken.

    Args:
        kind: WM_MOUSEMOVE, WM_LBUTTONDOWN, WM_LBUTTONUP, WM_LBUTTONDBLCLK, or the same with R for
            the right or M for the middle button. The second click of a double click is a DBLCLK.

    ValueError for another kind.
    """
    return current.screen.monitor.mouse.has(_kind(kind))


def getmouseclick(kind: Number) -> tuple[int, int]:
    """Take an event of that kind and return where it happened, x and y.

    Args:
        kind: as for ismouseclick().

    (NO_CLICK, NO_CLICK), which is (-1, -1), if there is none. Of several that have not been taken
    only the latest is kept, unless setmousequeuestatus() says otherwise.
    """
    return current.screen.monitor.mouse.take(_kind(kind)) or (NO_CLICK, NO_CLICK)


def clearmouseclick(kind: Number) -> None:
    """Drop an event of that kind, if one waits.

    Args:
        kind: as for ismouseclick().
    """
    current.screen.monitor.mouse.take(_kind(kind))


def setmousequeuestatus(kind: Number, status: bool = True) -> None:
    """Keep all events of that kind until they are taken, or only the latest.

    Args:
        kind: as for ismouseclick().
        status: True for all of them (the last thousand), False for the latest.
    """
    current.screen.monitor.mouse.keep_all(_kind(kind), flag("status", status))


def registermousehandler(kind: Number, handler: Callable[[int, int], object] | None) -> None:
    """Have a function called for every event of that kind.

    Args:
        kind: as for ismouseclick().
        handler: called with x and y, in a thread of its own while the program goes on; it may draw,
            but should not take long. None: no function any more.

    An error in the function is printed, and the program goes on.
    """
    message = _kind(kind)
    check_function("handler", handler)
    handlers = current.screen.monitor.mouse.handlers
    if handler is None:
        handlers.pop(message, None)
    else:
        handlers[message] = lambda event: handler(event.x, event.y)


def _kind(kind: Number) -> int:
    number = whole("kind", kind)
    if number not in KINDS:
        known = "WM_MOUSEMOVE, WM_LBUTTONDOWN or the like"
        raise ValueError(f"kind must be {known}, not {brief(number)}")
    return number
