"""Time that is counted instead of waited for, and the keys of a script that come in it."""

import math
from collections import deque
from collections.abc import Iterable

from bgi.monitor.keyqueue import KeyQueue
from bgi.monitor.script import Press


class Timeline:
    """What the screens of a program that nobody sees have in common: the time, and the keyboard."""

    def __init__(self, presses: Iterable[Press]) -> None:
        self.keys = KeyQueue()
        self._coming = deque(presses)
        self.move_to(0.0)

    def move_to(self, now: float) -> None:
        """Make it so late, in milliseconds since the start; the keys that are due are typed."""
        self.now = now
        while self._coming and 1000 * self._coming[0].at <= now:
            self._coming.popleft().type(self.keys)

    def next_key(self) -> float:
        """When the script types a key that does not wait yet; infinity if it is at its end."""
        for press in self._coming:
            if press.keystroke:
                return 1000 * press.at
        return math.inf
