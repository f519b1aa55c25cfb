"""What the one does who types, as messages to the program: keys, keys held, mouse."""

from collections.abc import Callable

from bgi.monitor import pointer
from bgi.monitor.keycodes import encode, name_of, shift_flags
from bgi.monitor.web.browserkeys import translated


class PageInputs:
    """Keys and mouse of the page that types.

    Args:
        send: says something to the program; False if it does not listen.
        size: width and height of the picture.
        moved: is called with the mouse's place, for the other pages.
    """

    def __init__(
        self,
        send: Callable[..., bool],
        size: Callable[[], tuple[int, int]],
        moved: Callable[[int, int], None],
    ) -> None:
        self._send = send
        self._size = size
        self._moved = moved
        self._down: dict[str, str] = {}  # the names of the keys that are down, by their places
        self._shifts = 0
        self._told: tuple[int, frozenset[str]] = 0, frozenset()
        self._buttons = 0
        self._place = 0, 0
        self._limits: tuple[int, ...] = ()

    def press(self, mods: int, code: str, key: str) -> None:
        """A key goes down."""
        found = translated(mods, code, key, "ShiftRight" in self._down)
        if name := name_of(found.key, found.unicode):
            self._down[code] = name
        self._hold(mods)
        if keystroke := encode(*found):
            self._send("key", *keystroke)

    def release(self, mods: int, code: str) -> None:
        """A key comes up."""
        self._down.pop(code, None)
        self._hold(mods)

    def let_go(self) -> None:
        """Nobody holds anything any more."""
        self._down.clear()
        self._hold(0)
        for button in (pointer.LEFT, pointer.RIGHT, pointer.MIDDLE):
            if self._buttons & 1 << button:
                held = self._buttons & ~(1 << button)
                self.point(pointer.released(button), *self._place, held)

    def _hold(self, mods: int) -> None:
        self._shifts = shift_flags(translated(mods, "", "", "ShiftRight" in self._down).mod)
        now = self._shifts, frozenset(self._down.values())
        if now != self._told and self._send("held", self._shifts, *sorted(now[1])):
            self._told = now

    def point(self, event: int, x: int, y: int, held: int) -> None:
        """An event of the mouse; its place is put within the picture and the program's limits."""
        width, height = self._size()
        left, top, right, bottom = self._limits or (0, 0, width - 1, height - 1)
        self._place = x, y = min(max(x, left), right), min(max(y, top), bottom)
        self._buttons = held
        self._send("mouse", event, x, y, held)
        self._moved(x, y)

    def roll(self, clicks: int) -> None:
        """Its wheel is turned."""
        self._send("wheel", clicks)

    def limit(self, *limits: int) -> None:
        """Keep the pointer within left, top, right, bottom; nothing: everywhere."""
        self._limits = limits
