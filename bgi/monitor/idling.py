"""Finds out when a program does nothing but ask for a key, so that it need not burn a processor.

`while not kbhit(): pass` was the way to wait. Such a loop asks very often and leaves the card as it
is; one that draws or computes between two questions is never held up.
"""

import time

from bgi.memory.card import Card

REST_SECONDS = 0.010  # a key ends a rest at once
PATIENCE = 1000  # questions in vain until a look at the card
IMPATIENCE = 50  # the same for a program that was idle a moment ago
QUICK = 4e-6  # seconds from one question to the next, of a program that does nothing else


class Idling:
    """The questions of one program."""

    def __init__(self, card: Card) -> None:
        self._card = card
        self._left = self._limit = PATIENCE
        self._since = 0.0
        self._seen = 0

    def asked_in_vain(self) -> bool:
        """Count a question; whether the program may rest now."""
        self._left -= 1
        if self._left:
            return False
        now = time.perf_counter()
        quick = now - self._since < QUICK * self._limit
        seen = self._card.checksum() if quick else self._seen
        idle = quick and seen == self._seen
        self._seen = seen
        self._left = self._limit = IMPATIENCE if idle else PATIENCE
        self._since = time.perf_counter() + (REST_SECONDS if idle else 0)
        return idle
