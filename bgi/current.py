"""The screens that are open, and the one that the module-level functions draw on.

`screen` is what a call reaches. While there is none to reach, before initgraph, in text mode, or
after the window was closed, a stand-in sits there whose every use raises the right error; so the
drawing functions need not look. Screens are numbered as they open, like WinBGIm's windows.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable
from typing import NoReturn, cast

from bgi.constants import ALL_WINDOWS, CURRENT_WINDOW, NO_CURRENT_WINDOW
from bgi.errors import BGIError, TimeIsUp
from bgi.graphics import Graphics
from bgi.graphics.strict import Strict
from bgi.kernel.modes import GraphicsMode
from bgi.kernel.state import KERNEL
from bgi.memory.card import CAPACITY, Card
from bgi.monitor import choose
from bgi.monitor.ending import follow_program, interrupt
from bgi.monitor.protocol import TITLE


class _Absent:
    """Stands where a screen would."""

    def __init__(self, error: Callable[[], BGIError]) -> None:
        self._error = error

    def __getattr__(self, name: str) -> NoReturn:
        raise self._error()


def _absent(error: Callable[[], BGIError]) -> Graphics:
    return cast(Graphics, _Absent(error))


def _not_loaded() -> BGIError:
    why = KERNEL.why_no_screen and f": {KERNEL.why_no_screen}"
    return BGIError(f"BGI Error: Graphics not initialized (use 'initgraph'){why}")


_NOT_LOADED = _absent(_not_loaded)
_TEXT_MODE = _absent(lambda: BGIError("BGI Error: Not in graphics mode"))
_IN_A_FORK = _absent(
    lambda: BGIError(
        "the window belongs to the process that opened it, this is a fork of it: "
        "initgraph() opens one of its own"
    )
)

# The program's own thread writes all of these. A monitor's thread writes `_reached` and `screen`,
# too, when its window is lost (`_lost`): by single assignments, so that no lock is needed.
screen: Graphics = _NOT_LOADED
"""What a call reaches: the current screen, or a stand-in."""
number: int = NO_CURRENT_WINDOW
"""Which screen is current."""
_open: dict[int, Graphics] = {}
"""The open screens by number; one in text mode or without its window is open, too."""
_reached: dict[int, Graphics] = {}
"""What a call to each open screen reaches once it is current: itself, or a stand-in."""


_parents: list[Graphics] = []
"""In a fork, the screens of the process it was made from: kept, and never touched."""


def _leave_to_parent() -> None:
    """In a fork: the screens that are open are the parent's, and so is their memory."""
    global screen, number
    if _open:
        _parents.extend(_open.values())
        _open.clear()
        _reached.clear()
        number, screen = NO_CURRENT_WINDOW, _IN_A_FORK


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_to_parent)


def loaded() -> Graphics | None:
    """The current screen, even while it is in text mode or its window gone."""
    return _open.get(number)


def reachable() -> Graphics:
    """The current screen, in text mode too; raises as any call does if there is none."""
    return _open[number] if screen is _TEXT_MODE else screen


def open_screen(mode: GraphicsMode) -> Graphics:
    """Enter a mode: on the current screen, or on a new one if there is none or its window gone."""
    here = loaded()
    if here is None or _reached[number] not in (here, _TEXT_MODE):
        close_screen(CURRENT_WINDOW)
        open_window(mode)
    else:
        _enter(here, mode)
    return _open[number]


def _enter(here: Graphics, mode: GraphicsMode) -> None:
    """Enter a mode on the current screen's card."""
    new = Graphics(mode, here.card, here.monitor)
    new.path = here.path
    _open[number] = new
    _reach(number, new)


def open_window(mode: GraphicsMode, title: str = TITLE) -> int:
    """Open another screen with a monitor of its own, and make it the current one."""
    _follow_program()
    new = next(n for n in range(len(_open) + 1) if n not in _open)
    needed = mode.width * mode.height * mode.pages * mode.pixel_bytes
    card = Card(max(needed, CAPACITY))
    card.set_mode(mode.width, mode.height, mode.pages, mode.pixel_bytes, mode.square)
    beside = next((other.monitor for other in _open.values()), None)
    monitor = choose(card, title, lambda error: _lost(new, error), beside)
    _open[new] = Graphics(mode, card, monitor)
    _reach(new, _open[new])
    select(new)
    KERNEL.why_no_screen = ""
    monitor.key_waiting()  # raises if the window was closed as soon as it opened
    return new


@functools.cache  # once is enough
def _follow_program() -> None:
    follow_program(close_screen)


def select(which: int) -> None:
    """Make an open screen the current one; an unknown number is ignored."""
    global number
    if which in _open:
        number = which
        _aim()


def leave_graphics() -> None:
    """Go to text mode: the screen stays loaded, and dark."""
    _enter(screen, screen.mode)
    _reach(number, _TEXT_MODE)


def close_screen(which: int = ALL_WINDOWS) -> None:
    """Let go of a screen, of the current one, or of all: monitor, memory and all."""
    global number
    which = number if which == CURRENT_WINDOW else which
    # The current one last: of several pictures of the end, its stays.
    everyone = sorted(_open, key=lambda one: one == number)
    for closing in everyone if which == ALL_WINDOWS else [which]:
        gone = _open.pop(closing, None)
        _reached.pop(closing, None)
        if gone is not None:
            gone.monitor.close()
            gone.card.close()
    if number not in _open:
        number = NO_CURRENT_WINDOW
        _aim()


def be_strict(on: bool) -> None:
    """Make every error an exception, or do so no longer."""
    KERNEL.result.strict = on
    _aim()


def _reach(which: int, target: Graphics) -> None:
    _reached[which] = target
    _aim()


def _aim() -> None:
    """Have the calls reach what belongs to the current screen."""
    global screen
    target = _reached.get(number, _NOT_LOADED)
    strict = KERNEL.result.strict and isinstance(target, Graphics)
    screen = cast(Graphics, Strict(target)) if strict else target


def _lost(which: int, error: BGIError) -> None:
    """A window is gone (called by its monitor, mostly by a thread of it): the next call says so."""
    if which in _open:
        _reach(which, _absent(lambda: error.with_traceback(None)))
        if (
            isinstance(error, TimeIsUp)
            and threading.current_thread() is not threading.main_thread()
        ):
            interrupt(error)
