"""The keyboard of a program: the keys that wait for it, and those that are down.

However many windows a program has, its keyboard is one: getch() hears what is typed into any of
them, whichever is drawn in.
"""

import sys
import threading
from collections import deque
from collections.abc import Callable, Iterable

# The BIOS keeps fifteen keystrokes for a program that is busy; the sixteenth is lost.
BIOS_BUFFER = 15

# On Windows Ctrl-C cannot interrupt the wait for a lock: there it is cut into short pieces.
PIECE_SECONDS = 0.1 if sys.platform == "win32" else 3600.0

Check = Callable[[], None]
"""Called while no key waits: raises if none will come."""


class KeyQueue:
    """Keystrokes on their way to the program, and what is held down.

    At most fifteen wait. One byte can be put back; the second byte of a keystroke waits in the same
    place.
    """

    def __init__(self) -> None:
        self._keys: deque[bytes] = deque()
        self._back: int | None = None
        self._changed = threading.Condition()
        self._down: dict[object, tuple[int, frozenset[str]]] = {}

    # What is down

    def hold(self, source: object, shifts: int, held: frozenset[str]) -> None:
        """Take note of what is down at one window, or in a script: BIOS's flags, names of keys."""
        self._down[source] = shifts, held

    @property
    def shifts(self) -> int:
        """The BIOS's flags of the Shift keys and their like."""
        found = 0
        for shifts, _ in [*self._down.values()]:
            found |= shifts
        return found

    @property
    def held(self) -> frozenset[str]:
        """The names (`bgi.monitor.keycodes.key_named`) of the keys that are down."""
        return frozenset().union(*(held for _, held in [*self._down.values()]))

    # What waits

    def put(self, keystroke: bytes) -> None:
        """Add a keystroke; when the queue is full the whole keystroke is lost."""
        if len(self._keys) < BIOS_BUFFER:
            self.load([keystroke])

    def load(self, keystrokes: Iterable[bytes]) -> None:
        """Add the keystrokes of a script, however many there are."""
        with self._changed:
            self._keys.extend(filter(None, keystrokes))
            self._changed.notify_all()

    def waiting(self) -> bool:
        """Whether `get` would return at once."""
        return bool(self._keys) or self._back is not None

    def half(self) -> bool:
        """Whether the next byte is the second one of a keystroke, or one that was put back."""
        return self._back is not None

    def wait(self, seconds: float) -> None:
        """Wait until there is a key, or `wake` is called, but not longer than that."""
        with self._changed:
            if not self.waiting():
                self._changed.wait(seconds)

    def wake(self) -> None:
        """Have whoever waits check whether a key will come."""
        with self._changed:
            self._changed.notify_all()

    def get(self, check: Check) -> int:
        """The next byte; waits for one as long as `check` raises nothing."""
        with self._changed:
            code, self._back = self._back, None
            if code is None:
                code, *rest = self.take(check)
                self._back = rest[0] if rest else None
            return code

    def put_back(self, code: int) -> bool:
        """Make `code` the next byte; False, and no change, if one has been put back already."""
        with self._changed:
            if self._back is not None:
                return False
            self._back = code
            self._changed.notify_all()
            return True

    def peek(self) -> bytes | None:
        """The next whole keystroke, which stays, or None."""
        with self._changed:
            return self._keys[0] if self._keys else None

    def take(self, check: Check) -> bytes:
        """The next whole keystroke; waits as `get` does."""
        with self._changed:
            while not self._keys:
                check()
                self._changed.wait(PIECE_SECONDS)
            return self._keys.popleft()
