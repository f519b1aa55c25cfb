"""The mouse as the program knows it: what the monitor last said, and what has happened since.

Events are numbered by the bits of the mouse driver's event mask. `hear` is called by the monitor's
thread, everything else by the program. Handlers run in a thread of their own, so that they may draw
and wait like any other part of the program.
"""

import queue
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import NamedTuple

from bgi.constants import (
    WM_LBUTTONDBLCLK,
    WM_LBUTTONDOWN,
    WM_LBUTTONUP,
    WM_MBUTTONDBLCLK,
    WM_MBUTTONDOWN,
    WM_MBUTTONUP,
    WM_MOUSEMOVE,
    WM_RBUTTONDBLCLK,
    WM_RBUTTONDOWN,
    WM_RBUTTONUP,
)

MOVED = 1
LEFT, RIGHT, MIDDLE = range(3)
"""A button of the mouse."""

DOUBLE_CLICK_SECONDS, DOUBLE_CLICK_PIXELS = 0.5, 4
MAX_WAITING = 1000  # clicks that wait to be asked for; older ones are lost

_DOWN = {LEFT: WM_LBUTTONDOWN, RIGHT: WM_RBUTTONDOWN, MIDDLE: WM_MBUTTONDOWN}
_UP = {LEFT: WM_LBUTTONUP, RIGHT: WM_RBUTTONUP, MIDDLE: WM_MBUTTONUP}
_DOUBLE = {LEFT: WM_LBUTTONDBLCLK, RIGHT: WM_RBUTTONDBLCLK, MIDDLE: WM_MBUTTONDBLCLK}
KINDS = WM_MOUSEMOVE, *_DOWN.values(), *_UP.values(), *_DOUBLE.values()


def pressed(button: int) -> int:
    """The event that a button goes down."""
    return 2 << 2 * button


def released(button: int) -> int:
    """The event that a button comes up."""
    return 4 << 2 * button


class Event(NamedTuple):
    """Something that happened: which event, what Windows calls it, where, and the buttons held."""

    event: int
    message: int
    x: int
    y: int
    buttons: int


class Count(NamedTuple):
    """How often a button went down or up, and where it last did."""

    times: int = 0
    x: int = 0
    y: int = 0


Handler = Callable[[Event], object]


class Mouse:
    """Position (in the program's pixels), buttons (bit 0 left, 1 right, 2 middle), and history.

    `tell` sends a message to the monitor (`bgi.monitor.protocol`).
    """

    def __init__(self, tell: Callable[..., None]) -> None:
        self.x = self.y = 0
        self.buttons = 0
        self.handlers: dict[int, Handler] = {}
        """Whom to call for a message of Windows; 0 stands for all of them."""
        self._tell = tell
        self._lock = threading.RLock()  # a signal handler may come in between
        self._hidden = 1  # the driver's counter, with the sign changed
        self._limits: tuple[int, int, int, int] | None = None
        self._counts: dict[int, Count] = {}
        self._moved = (0, 0)
        self._rolled = 0
        self._clicks = {kind: deque[tuple[int, int]](maxlen=1) for kind in KINDS}
        self._last_click = (-1, 0, 0, 0.0)
        self._events: queue.SimpleQueue[Event] | None = None

    def hear(self, event: int, x: int, y: int, buttons: int) -> None:
        """Take note of an event."""
        with self._lock:
            self._moved = self._moved[0] + x - self.x, self._moved[1] + y - self.y
            self.x, self.y, self.buttons = x, y, buttons
            if event != MOVED:
                self._counts[event] = Count(self._counts.get(event, Count()).times + 1, x, y)
            message = self._message(event, x, y)
            self._clicks[message].append((x, y))
        if self.handlers:
            self._dispatch(Event(event, message, x, y, buttons))

    def roll(self, clicks: int) -> None:
        """Take note of a turn of the wheel."""
        with self._lock:
            self._rolled += clicks

    def _message(self, event: int, x: int, y: int) -> int:
        """What WinBGIm, that is Windows, calls an event."""
        if event == MOVED:
            return WM_MOUSEMOVE
        button = next(b for b in _DOWN if event in (pressed(b), released(b)))
        if event == released(button):
            return _UP[button]
        last, last_x, last_y, then = self._last_click
        now = time.monotonic()
        near = max(abs(x - last_x), abs(y - last_y)) <= DOUBLE_CLICK_PIXELS
        if last == button and near and now - then < DOUBLE_CLICK_SECONDS:
            self._last_click = (-1, 0, 0, 0.0)  # a third click begins anew
            return _DOUBLE[button]
        self._last_click = button, x, y, now
        return _DOWN[button]

    # The mouse driver

    def reset(self, x: int, y: int) -> None:
        """Hide the pointer, put it at x, y, forget counts, limits and the driver's handler."""
        with self._lock:
            self._hidden = 1
            self._limits = None
            self._counts.clear()
            self._moved = (0, 0)
            self._rolled = 0
            self.handlers.pop(0, None)
        self._tell("limits")
        self._tell("pointer", "system")
        self._tell("shape")
        self.move(x, y)

    def show(self) -> None:
        """Count one show: the pointer is seen once there was one for every hide."""
        self._hidden = max(self._hidden - 1, 0)
        self._tell("pointer", "hidden" if self._hidden else "shown")

    def hide(self) -> None:
        """Count one hide."""
        self._hidden += 1
        self._tell("pointer", "hidden")

    def shape(self, x: int, y: int, masks: Sequence[int]) -> None:
        """Give the pointer a look, as `bgi.monitor.art.from_masks` has it."""
        self._tell("shape", x, y, *masks)

    def move(self, x: int, y: int) -> None:
        """Put the pointer there, or as near as its limits allow."""
        with self._lock:
            if self._limits is not None:
                left, top, right, bottom = self._limits
                x, y = min(max(x, left), right), min(max(y, top), bottom)
            self.x, self.y = x, y
        self._tell("move", x, y)

    def limit(self, left: int, top: int, right: int, bottom: int) -> None:
        """Keep the pointer within a rectangle, corners included."""
        self._limits = left, top, right, bottom
        self._tell("limits", left, top, right, bottom)
        self.move(self.x, self.y)

    @property
    def limits(self) -> tuple[int, int, int, int] | None:
        """The rectangle of `limit`; None if it is the whole page."""
        return self._limits

    def take_count(self, event: int) -> Count:
        """How often a button's event has happened since it was last asked for, and where."""
        with self._lock:
            count = self._counts.get(event, Count())
            self._counts[event] = Count(0, count.x, count.y)
            return count

    def take_motion(self) -> tuple[int, int]:
        """How far the mouse has moved since this was last asked for."""
        with self._lock:
            moved, self._moved = self._moved, (0, 0)
            return moved

    def take_wheel(self) -> int:
        """How far the wheel has been turned since this was last asked for."""
        with self._lock:
            rolled, self._rolled = self._rolled, 0
            return rolled

    # Windows

    def keep_all(self, kind: int, status: bool) -> None:
        """Whether all events of a kind wait to be asked for, or only the latest."""
        self._clicks[kind] = deque(self._clicks[kind], maxlen=MAX_WAITING if status else 1)

    def has(self, kind: int) -> bool:
        """Whether an event of that kind waits."""
        return bool(self._clicks[kind])

    def take(self, kind: int) -> tuple[int, int] | None:
        """Where the oldest waiting event of that kind happened; None if there is none."""
        with self._lock:
            waiting = self._clicks[kind]
            return waiting.popleft() if waiting else None

    # Handlers

    def _dispatch(self, event: Event) -> None:
        if self._events is None:
            self._events = queue.SimpleQueue()
            threading.Thread(target=self._serve, name="bgi mouse", daemon=True).start()
        self._events.put(event)

    def _serve(self) -> None:
        """Call the handlers, one event after another."""
        assert self._events is not None
        while True:
            self._serve_one(self._events.get())

    def _serve_one(self, event: Event) -> None:
        """Call the handlers of an event; an error in one is printed and no more."""
        for kind in (event.message, 0):
            handler = self.handlers.get(kind)
            if handler is not None:
                try:
                    handler(event)
                except Exception:
                    import traceback  # late, as most programs make no mistake

                    traceback.print_exc()
