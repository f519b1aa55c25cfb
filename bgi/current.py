"""The screen that the module-level functions draw on.

`screen` is what a call reaches. While there is none to reach, before initgraph, in text mode, or
after the window was closed, a stand-in sits there whose every use raises the right error; so the
drawing functions need not look. `loaded` is the screen that closegraph() would close.
"""

from typing import NoReturn, cast

from bgi.card import Card
from bgi.errors import BGIError
from bgi.graphics import Graphics
from bgi.modes import GraphicsMode
from bgi.monitor import choose


class _Absent:
    """Stands where a screen would."""

    def __init__(self, kind: type[BGIError], text: str) -> None:
        self._kind = kind
        self._text = text

    def __getattr__(self, name: str) -> NoReturn:
        raise self._kind(self._text)


def _absent(kind: type[BGIError], text: str) -> Graphics:
    return cast(Graphics, _Absent(kind, text))


_NOT_LOADED = _absent(BGIError, "BGI Error: Graphics not initialized (use 'initgraph')")
_TEXT_MODE = _absent(BGIError, "BGI Error: Not in graphics mode")

screen: Graphics = _NOT_LOADED
loaded: Graphics | None = None


def open_screen(mode: GraphicsMode) -> None:
    """Enter a mode: on the screen there is, or on a new one with its monitor."""
    global screen, loaded
    if loaded is None or screen not in (loaded, _TEXT_MODE):
        close_screen()
        card = Card()
        card.set_mode(mode.width, mode.height, mode.pages)
        loaded = Graphics(mode, card, choose(card, on_lost=_lost))
        loaded.monitor.key_waiting()  # raises if the window was closed as soon as it opened
    else:
        loaded.enter(mode)
    screen = loaded


def reachable() -> Graphics:
    """The screen that is loaded, in text mode too; raises as any call does if there is none."""
    return loaded if loaded is not None and screen is _TEXT_MODE else screen


def leave_graphics() -> None:
    """Go to text mode: the screen stays loaded, and dark."""
    global screen
    screen.enter(screen.mode)
    screen = _TEXT_MODE


def close_screen() -> None:
    """Let go of the screen, its monitor and its memory, if there is one."""
    global screen, loaded
    closing, loaded, screen = loaded, None, _NOT_LOADED
    if closing is not None:
        closing.monitor.close()
        closing.card.close()


def _lost(error: BGIError) -> None:
    """The window is gone (called by the monitor's thread): the next call says so."""
    global screen
    if loaded is not None:
        screen = _absent(type(error), str(error))
