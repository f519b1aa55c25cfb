"""Notices when a program waits for what never comes: a key or the mouse, where there is no window.

getch() says so at once. But `while not kbhit():` may be the loop of a program that draws, computes,
or will end by itself: so it counts as waiting in vain only if it has drawn nothing for more than a
minute (a clock draws then), nor done anything but ask and let time pass, and if no other thread of
the program is at work. What draws, and what sleeps by itself as in time.sleep(), is never ended.
"""

import threading
import time

from bgi.memory.card import Card

LOOKS = 20  # at the card, all of which find it the same
LOOK_SECONDS = 3.1  # from one look to the next at least, in real time
RESTS = 200  # as many rests of an idle program (`bgi.monitor.idling`) from look to look, or
DELAYS = 180_000  # so many milliseconds let pass by delay() and its like: an hour in all


class Waiting:
    """The waits in vain of one program."""

    def __init__(self, card: Card) -> None:
        self._card = card
        self._rests, self._delayed = 0, 0.0
        self._looks, self._seen = 0, 0
        self._next_look = 0.0

    def rest(self) -> None:
        """The program has rested, since it did nothing but ask."""
        self._rests += 1

    def delay(self, milliseconds: float) -> None:
        """The program has let time pass."""
        self._delayed += milliseconds

    def is_endless(self) -> bool:
        """Whether the program, which asks in vain once more, would do so for ever."""
        if self._rests < RESTS and self._delayed < DELAYS:
            return False
        now = time.monotonic()
        if now < self._next_look:
            return False
        seen = self._card.fingerprint()
        self._looks = self._looks + 1 if seen == self._seen and not _others_work() else 0
        self._seen, self._next_look = seen, now + LOOK_SECONDS
        self._rests, self._delayed = 0, 0.0
        endless = self._looks == LOOKS
        if endless:
            self._looks = 0
        return endless


def _others_work() -> bool:
    """Whether the program has another thread than this one; ours do not count."""
    here = threading.current_thread()
    return any(one is not here and not one.name.startswith("bgi ") for one in threading.enumerate())
