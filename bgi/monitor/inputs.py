"""What the user does at the window, as messages to the program: keys, keys held, mouse."""

import time
from collections.abc import Callable

from bgi.memory.sdl import pygame
from bgi.monitor import pointer as mouse
from bgi.monitor.display import Display
from bgi.monitor.keycodes import encode, name_of, shift_flags

_BUTTONS = {1: mouse.LEFT, 2: mouse.MIDDLE, 3: mouse.RIGHT}  # by pygame's numbers
_WHEEL = {4: -1, 5: 1}
_LOCKS = pygame.KMOD_NUM | pygame.KMOD_CAPS
REPEAT_SECONDS = 0.6  # longer than any keyboard waits before a key repeats
_MODIFIERS = pygame.KMOD_SHIFT | pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META


class Inputs:
    """Keys and mouse of one window; `hot_keys` are those that are for the window itself.

    They are called with nothing, by key and modifier (a mask such as pygame.KMOD_ALT, or 0).
    """

    def __init__(
        self,
        display: Display,
        send: Callable[..., bool],
        hot_keys: dict[tuple[int, int], Callable[[], None]],
    ) -> None:
        self._display = display
        self._send = send
        self._hot_keys = hot_keys
        self._hot = 0, 0.0  # the hot key that is down, and when that was last heard
        self._held: dict[int, str] = {}  # the names of the keys that are down, by pygame's numbers
        self._told = shift_flags(0), frozenset[str]()  # what is down, as the program knows it
        self._place = 0, 0
        self._buttons = 0
        self._moved = False
        self._limits: tuple[int, ...] = ()
        self._arrow = False

    def handle(self, event: pygame.event.Event) -> None:
        """Take note of an event; all that is not the user's is ignored."""
        if event.type == pygame.KEYDOWN:
            self._press(event)
        elif event.type == pygame.KEYUP:
            self._held.pop(event.key, None)
            if event.key == self._hot[0]:
                self._hot = 0, 0.0
        elif event.type == pygame.MOUSEMOTION:
            self._go(self._display.to_page(event.pos))
        elif event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            self._click(event)

    def flush(self) -> None:
        """Send what is sent once for many events: the mouse's place, the keys that are down."""
        if self._moved:
            self._moved = False
            self._send("mouse", mouse.MOVED, *self._place, self._buttons)
        # Whoever looks at another window holds no key down in this one.
        focused = pygame.key.get_focused()
        shifts = shift_flags(pygame.key.get_mods() & (-1 if focused else _LOCKS))
        down = shifts, frozenset(self._held.values() if focused else ())
        # If the program does not read, its pipe is full: then it learns of it next time.
        if down != self._told and self._send("held", shifts, *sorted(down[1])):
            self._told = down

    def _press(self, event: pygame.event.Event) -> None:
        held = event.mod & _MODIFIERS
        for (key, modifier), action in self._hot_keys.items():
            # Without others: Shift-F11 and Alt-F5 are keys like any other.
            if event.key == key and bool(held) == bool(modifier) and not held & ~modifier:
                last, then = self._hot
                self._hot = now = key, time.monotonic()
                # It must not repeat; but in a window that has just opened it may have been released
                # unheard.
                if key != last or now[1] - then > REPEAT_SECONDS:
                    action()
                return
        if name := name_of(event.key, event.unicode):
            self._held[event.key] = name
        if keystroke := encode(event.key, event.mod, event.unicode):
            self._send("key", *keystroke)

    def _click(self, event: pygame.event.Event) -> None:
        button = _BUTTONS.get(event.button)
        if button is None:
            if event.type == pygame.MOUSEBUTTONDOWN and event.button in _WHEEL:
                self._send("wheel", _WHEEL[event.button])
            return
        self._go(self._display.to_page(event.pos))
        self._moved = False
        if event.type == pygame.MOUSEBUTTONDOWN:
            self._buttons |= 1 << button
            self._send("mouse", mouse.pressed(button), *self._place, self._buttons)
        else:
            self._buttons &= ~(1 << button)
            self._send("mouse", mouse.released(button), *self._place, self._buttons)

    def _go(self, place: tuple[int, int]) -> None:
        x, y = place
        if self._limits:
            left, top, right, bottom = self._limits
            x, y = min(max(x, left), right), min(max(y, top), bottom)
        self._moved = self._moved or (x, y) != self._place
        self._place = x, y
        self._point()

    def _point(self) -> None:
        self._display.set_pointer(self._place if self._arrow else None)

    # What the program asks of the mouse

    def use_pointer(self, state: str) -> None:
        """Draw the mouse driver's arrow ("shown") or none ("hidden"), or the "system" its own."""
        self._arrow = state == "shown"
        pygame.mouse.set_visible(state == "system")
        self._point()

    def move(self, x: int, y: int) -> None:
        """Put the pointer on a pixel of the page."""
        pygame.mouse.set_pos(self._display.to_window(x, y))
        self._place = x, y
        self._point()

    def limit(self, *limits: int) -> None:
        """Keep the pointer within left, top, right, bottom; nothing: everywhere."""
        self._limits = limits
