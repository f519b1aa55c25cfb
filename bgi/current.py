"""The screens that are open, and the one that the module-level functions reach.

`screen` is what a call of graphics.h reaches. While there is none to reach, before initgraph, in a
text mode, or after the window was closed, a stand-in sits there whose every use raises the right
error; so the drawing functions need not look. `crt` is what a call of conio.h reaches, once there
is one: see `console`. Screens are numbered as they open, like WinBGIm's windows.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import NoReturn, cast

from bgi.console.crt import Crt
from bgi.constants import ALL_WINDOWS, C80, CURRENT_WINDOW, NO_CURRENT_WINDOW
from bgi.errors import BGIError, TimeIsUp
from bgi.graphics import Graphics
from bgi.graphics.slow import Slow, parse_rate
from bgi.graphics.strict import Strict
from bgi.kernel.modes import GraphicsMode
from bgi.kernel.state import KERNEL, Result
from bgi.kernel.textmodes import TEXT_MODES, TextMode
from bgi.memory.card import CAPACITY, Card
from bgi.monitor import Headless, Monitor, choose, moment
from bgi.monitor.ending import at_a_prompt, follow_program, interrupt
from bgi.monitor.plan import Plan
from bgi.monitor.protocol import TITLE


class _Absent:
    """Stands where a screen would."""

    def __init__(self, error: Callable[[], BGIError]) -> None:
        self._error = error

    def __getattr__(self, name: str) -> NoReturn:
        raise self._error()


class _TextScreen(_Absent):
    """Stands there in a text mode: of all that a screen has there is the monitor, and its keys."""

    def __init__(self, error: Callable[[], BGIError], monitor: Monitor) -> None:
        super().__init__(error)
        self.monitor = monitor


class _Nothing(_Absent):
    """Stands there before anything is open: who asks for a key gets a text screen for it."""

    @property
    def monitor(self) -> Monitor:
        console()
        return screen.monitor


def _not_loaded() -> BGIError:
    why = KERNEL.why_no_screen and f": {KERNEL.why_no_screen}"
    return BGIError(f"BGI Error: Graphics not initialized (use 'initgraph'){why}")


def _text_mode() -> BGIError:
    return BGIError("BGI Error: Not in graphics mode")


def _in_a_fork() -> BGIError:
    return BGIError(
        "the window belongs to the process that opened it, this is a fork of it: "
        "initgraph() opens one of its own"
    )


_NOT_LOADED = cast(Graphics, _Nothing(_not_loaded))
_IN_A_FORK = cast(Graphics, _Absent(_in_a_fork))


@dataclass(eq=False)
class Adapter:
    """What a window is made of: a card, the monitor on it, and what is shown there."""

    card: Card
    monitor: Monitor
    reached: Graphics = _NOT_LOADED
    """What a call of graphics.h reaches once this is the current one: `graphics`, or a stand-in."""
    graphics: Graphics | None = None
    """The graphics screen; in a text mode the one that setgraphmode() leads back to."""
    crt: Crt | None = None
    """The text screen, from when it is first used."""
    lost: BGIError | None = None
    """Why the window is gone."""

    def enter_graphics(self, mode: GraphicsMode) -> None:
        """Set a graphics mode."""
        new = Graphics(mode, self.card, self.monitor)
        if self.graphics is not None:
            new.path = self.graphics.path
        self.graphics = self.reached = new
        self.monitor.describe = new.describe
        if self.crt is not None:
            self.crt.enter_graphics(new)

    def enter_text(self, mode: TextMode | None = None) -> None:
        """Set a text mode, by default the last one."""
        if self.reached is self.graphics:
            self.monitor.keep_picture()
        why = _not_loaded if self.graphics is None else _text_mode
        self.reached = cast(Graphics, _TextScreen(why, self.monitor))
        crt = self.crt = self.crt or Crt(self.card)
        crt.enter_text(mode or crt.mode)

    def use_text(self) -> Crt:
        """The text screen, over the picture while a graphics mode is set."""
        if self.crt is None:
            if self.graphics is None:
                self.enter_text()
            else:
                self.crt = Crt(self.card)
                self.crt.enter_graphics(self.graphics)
        assert self.crt is not None
        return self.crt


# The program's own thread writes all of these. A monitor's thread writes `reached`, `screen` and
# `crt`, too, when its window is lost (`_lost`): by single assignments, so that no lock is needed.
screen: Graphics = _NOT_LOADED
"""What a call of graphics.h reaches: the current screen, or a stand-in."""
crt: Crt | None = None
"""The current text screen, if it is in use; `console` begins to use it."""
number: int = NO_CURRENT_WINDOW
"""Which screen is current."""
_open: dict[int, Adapter] = {}
"""The open screens by number; one in text mode or without its window is open, too."""
_aside: dict[int, Adapter] | None = None
"""The same while others take their place: see `aside`."""


_parents: list[Adapter] = []
"""In a fork, the screens of the process it was made from: kept, and never touched."""


def _leave_to_parent() -> None:
    """In a fork: the screens that are open are the parent's, and so is their memory."""
    global screen, crt, number
    if _open:
        _parents.extend(_open.values())
        _open.clear()
        number, screen, crt = NO_CURRENT_WINDOW, _IN_A_FORK, None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_to_parent)


def is_open() -> bool:
    """Whether there is a current screen, if only of text, or one whose window is gone."""
    return number in _open


def shown() -> GraphicsMode | TextMode:
    """The mode on show; the first use opens a text screen where there is no window yet."""
    text = console() if screen is _NOT_LOADED else crt
    return text.mode if text is not None and text.is_text else screen.mode


def now() -> float:
    """Seconds since 1970, by the monitor's clock where there is one: without a window it counts."""
    return screen.monitor.time() if is_open() else moment.now()


def loaded() -> Graphics | None:
    """The current graphics screen, even while it is in text mode or its window gone."""
    here = _open.get(number)
    return here.graphics if here else None


def reachable() -> Graphics:
    """The current graphics screen, in text mode too; raises as any call does if there is none."""
    here = _open.get(number)
    if here is None or here.lost or here.graphics is None:
        return screen
    return here.graphics


def console() -> Crt:
    """The current text screen; the first use opens a window for it where there is none.

    Over a picture it is the BIOS's. Raises as any call does once the window is gone.
    """
    here = _open.get(number)
    if here is None or here.lost:
        if screen is not _NOT_LOADED:
            return cast(Crt, screen.mode)  # raises
        here = _open_adapter(None)
    found = here.use_text()
    _aim()
    return found


def set_text_mode(mode: TextMode | None) -> None:
    """Enter a text mode, None for the last one; a graphics screen stays loaded."""
    console()
    _open[number].enter_text(mode)
    _aim()


def open_screen(mode: GraphicsMode) -> Graphics:
    """Enter a mode: on the current screen, or on a new one if there is none or its window gone."""
    here = _open.get(number)
    if here is None or here.lost:
        close_screen(CURRENT_WINDOW)
        open_window(mode)
    else:
        here.enter_graphics(mode)
        _aim()
    KERNEL.why_no_screen = ""
    found = loaded()
    assert found is not None
    return found


def open_window(mode: GraphicsMode, title: str = TITLE) -> int:
    """Open another screen with a monitor of its own, and make it the current one.

    A screen that has shown text only gives way to it, as it would to initgraph().
    """
    here = _open.get(number)
    if here is not None and here.graphics is None:
        close_screen(CURRENT_WINDOW)
    _open_adapter(mode, title)
    KERNEL.why_no_screen = ""
    return number


def _open_adapter(mode: GraphicsMode | None, title: str = TITLE) -> Adapter:
    """Open a window in a graphics mode, or in the usual text mode; make it the current one."""
    _follow_program()
    _begin_slowly()
    new = next(n for n in range(len(_open) + 1) if n not in _open)
    card = _card_for(mode)
    beside = next((other.monitor for other in _open.values()), None)
    adapter = Adapter(card, choose(card, title, lambda error: _lost(new, error), beside))
    if mode is None:
        adapter.enter_text()
    else:
        adapter.enter_graphics(mode)
    _open[new] = adapter
    select(new)
    adapter.monitor.key_waiting()  # raises if the window was closed as soon as it opened
    return adapter


def _card_for(mode: GraphicsMode | None) -> Card:
    """A card that is in that mode already: so the window opens in the right size."""
    if mode is None:
        card, text = Card(), TEXT_MODES[C80]
        card.set_text_mode(text.columns, text.rows, text.cell_height)
        return card
    needed = mode.width * mode.height * mode.pages * mode.pixel_bytes
    card = Card(max(needed, CAPACITY))
    card.set_mode(mode.width, mode.height, mode.pages, mode.pixel_bytes, mode.square)
    return card


@functools.cache  # once is enough
def _follow_program() -> None:
    follow_program(end, close_screen)


@functools.cache
def _begin_slowly() -> None:
    """Draw slowly if the environment asks for it."""
    rate, stepping = os.environ.get("BGI_SLOW", ""), bool(os.environ.get("BGI_STEP"))
    if rate or stepping:
        be_slow(parse_rate(rate or "0"), stepping)


def end() -> None:
    """The program ends: what stands on its text screen may still be read; then all is let go of."""
    here = _open.get(number)
    shows_text = here is not None and here.crt is not None and here.crt.is_text
    if here is not None and shows_text and not here.lost and not at_a_prompt():
        here.monitor.linger()
    close_screen()


def select(which: int) -> None:
    """Make an open screen the current one; an unknown number is ignored."""
    global number
    if which in _open:
        number = which
        _aim()


def leave_graphics() -> None:
    """Go to text mode: the screen stays loaded."""
    _ = screen.mode  # raises if there is none
    _open[number].enter_text()
    _aim()


def close_graphics() -> None:
    """Let go of all graphics screens; the current one's window stays if it has shown text, too."""
    here = _open.get(number)
    stays = here is not None and here.crt is not None and not here.lost
    for which in [which for which, one in _open.items() if not (stays and one is here)]:
        close_screen(which)
    if stays and here is not None and here.graphics is not None:
        here.enter_text()
        here.graphics = None
        here.reached = cast(Graphics, _TextScreen(_not_loaded, here.monitor))
        _aim()


def close_screen(which: int = ALL_WINDOWS) -> None:
    """Let go of a screen, of the current one, or of all: monitor, memory and all."""
    global number
    which = number if which == CURRENT_WINDOW else which
    # The current one last: of several pictures of the end, its stays.
    everyone = sorted(_open, key=lambda one: one == number)
    for closing in everyone if which == ALL_WINDOWS else [which]:
        gone = _open.pop(closing, None)
        if gone is not None:
            gone.monitor.close()
            gone.card.close()
    if not _open:
        KERNEL.typed = ""
    if number not in _open:
        number = NO_CURRENT_WINDOW
        _aim()


def be_strict(on: bool) -> None:
    """Make every error an exception, or do so no longer."""
    KERNEL.result.strict = on
    _aim()


def be_slow(rate: int, stepping: bool) -> tuple[int, bool]:
    """Draw so many pixels a second, 0 for full speed; returns what was so before."""
    pace = KERNEL.pace
    before = pace.rate, pace.stepping
    pace.rate, pace.stepping = rate, stepping
    _aim()
    return before


@contextmanager
def aside(mode: GraphicsMode, guard: Callable[[Graphics], object]) -> Iterator[Graphics]:
    """Put all screens aside meanwhile: calls reach a new one, behind its `guard`, that nobody sees.

    So a function can be tried while its program draws. Whatever it opens is closed at the end.
    """
    global _open, _aside, number
    kept = _open, _aside, number, KERNEL.typed, KERNEL.result
    card = _card_for(mode)
    adapter = Adapter(card, Headless(title="", card=card, plan=Plan()))
    adapter.enter_graphics(mode)
    assert adapter.graphics is not None
    adapter.reached = cast(Graphics, guard(adapter.graphics))
    _open, _aside, number, KERNEL.result = {0: adapter}, _aside or _open, 0, Result()
    _aim()
    try:
        yield adapter.graphics
    finally:
        close_screen()
        _open, _aside, number, KERNEL.typed, KERNEL.result = kept
        _aim()


def _aim() -> None:
    """Have the calls reach what belongs to the current screen."""
    global screen, crt
    here = _open.get(number)
    target = here.reached if here else _NOT_LOADED
    if isinstance(target, Graphics):
        if KERNEL.pace.is_slow:
            target = cast(Graphics, Slow(target))
        if KERNEL.result.strict:
            target = cast(Graphics, Strict(target))
    screen = target
    crt = here.crt if here and not here.lost else None


def _lost(which: int, error: BGIError) -> None:
    """A window is gone (called by its monitor, mostly by a thread of it): the next call says so."""
    gone = (_open if _aside is None else _aside).get(which)
    if gone is not None:
        gone.reached = cast(Graphics, _Absent(lambda: error.with_traceback(None)))
        gone.lost = error
        _aim()
        if (
            isinstance(error, TimeIsUp)
            and threading.current_thread() is not threading.main_thread()
        ):
            interrupt(error)
