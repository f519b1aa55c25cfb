"""Monitors: what shows the card's memory and sends keys back, and the choice between them.

A monitor is anything that keeps the contract `Monitor`. `window.Window` is a window, drawn by a
child process (`child.py`); `web.pagewindow.PageWindow` is one that a browser shows;
`headless.Headless` shows nothing.
"""

import functools
import os
import sys
from collections.abc import Callable
from typing import Protocol

from bgi.errors import BGIError
from bgi.machine import display_exists
from bgi.memory.card import Card
from bgi.monitor.headless import Headless
from bgi.monitor.keyqueue import KeyQueue
from bgi.monitor.plan import Plan
from bgi.monitor.pointer import Mouse
from bgi.monitor.protocol import TITLE
from bgi.monitor.web.pagewindow import PageWindow
from bgi.monitor.window import Window

__all__ = ["Headless", "Monitor", "PageWindow", "Window", "choose"]

_ASKED_FOR: dict[str, type[Window]] = {"window": Window, "web": PageWindow}


class Monitor(Protocol):
    """What a program may ask of a monitor; any of it raises BGIError once the monitor is lost."""

    describe: Callable[[], list[str]]
    """What the board says of the program's screen, a line each; another thread may ask."""

    def show(self) -> None:
        """Return when the visible page, as it is now, has been shown."""

    def flip(self) -> None:
        """Another page is visible; it need not be waited for."""

    def keep_picture(self) -> None:
        """A text screen takes the picture's place: remember it for the picture that is planned."""

    def key_waiting(self) -> bool:
        """Whether `read_key` would return at once."""

    def read_key(self) -> int:
        """Wait for a key and return its code; keys without a character are 0, then a scan code."""

    def read_keystroke(self) -> bytes:
        """Wait for a key and return all of it, one byte or two."""

    @property
    def keys(self) -> KeyQueue:
        """The program's keyboard: the keys that wait, and those that are down."""

    @property
    def mouse(self) -> Mouse:
        """The mouse."""

    def sound(self, hertz: int) -> None:
        """Play a pitch from now on; 0 is silence."""

    def time(self) -> float:
        """The time, in seconds since 1970."""

    def sleep(self, milliseconds: float) -> None:
        """Let that time pass."""

    def set_title(self, title: str) -> None:
        """Name the window."""

    def notebook_html(self) -> str:
        """What a notebook shows of the screen while it runs; "" where that is a picture."""

    def magnify(self, times: int, follows: str) -> None:
        """Enlarge what is at the `mouse`, or the `pixels` that are set last; 0: no more."""

    def linger(self) -> None:
        """The program has ended: let the screen be read, if somebody is there. Never raises."""

    def close(self) -> None:
        """Let go of everything; a second time does nothing. Never raises."""


def choose(
    card: Card,
    title: str = TITLE,
    on_lost: Callable[[BGIError], None] = lambda error: None,
    beside: Monitor | None = None,
) -> Monitor:
    """The monitor that BGI_MONITOR names, or a window where there is a display.

    `beside` is one that the program has already: they have one keyboard, and one counted time.
    `on_lost` is called, mostly from another thread, with the error that every call raises from then
    on: when the user closes the window, its process dies or the planned end comes. Where a window
    cannot be opened one line says why, and drawing goes on without it; but BGIError is raised if
    BGI_MONITOR asks for it, or for a page. ValueError if BGI_MONITOR is neither `window`, `web` nor
    `none`, or the plan makes no sense.
    """
    wish = os.environ.get("BGI_MONITOR", "")
    if wish == "tab":
        from bgi.monitor.tab import Tab  # late: it needs the page around it

        return Tab(card, title, beside)
    if wish not in ("", "none", *_ASKED_FOR):
        raise ValueError(f"BGI_MONITOR is {wish!r}; it may be 'window', 'web' or 'none'")
    plan = Plan.from_environment()
    if wish in _ASKED_FOR:
        return _ASKED_FOR[wish](card, title, on_lost, plan, beside)
    if not wish:
        try:
            if not display_exists():
                raise BGIError("no display found")
            return Window(card, title, on_lost, plan, beside)
        except BGIError as error:
            _say_that_there_is_no_window(str(error))
    return Headless(title=title, card=card, plan=plan, on_lost=on_lost, beside=beside)


@functools.cache  # once is enough
def _say_that_there_is_no_window(reason: str) -> None:
    x11 = sys.platform not in ("win32", "darwin")
    advice = "for a window set DISPLAY or use ssh -X; " if x11 else ""
    print(
        f"bgi: {reason}; drawing goes on without a window "
        f"({advice}BGI_MONITOR=none silences this line)",
        file=sys.stderr,
    )
