"""Notices when a program does nothing but ask, so that it need not keep a processor busy.

`while not kbhit(): pass` was the way to wait, for a key, the mouse or a time. Such a loop asks very
often and leaves the card as it is; a loop that draws or computes between two questions is never
held up.
"""

import time

from bgi.memory.card import Card

REST_SECONDS = 0.010  # of a program that is idle; a key ends a rest at once
PATIENCE = 1000  # questions, until the card is looked at
IMPATIENCE = 50  # the same for a program that was idle a moment ago
QUICK_SECONDS = 4e-6  # from one question to the next, at most, if nothing is done between them


class Idling:
    """The questions of one program."""

    def __init__(self, card: Card) -> None:
        self._card = card
        self._left = self._limit = PATIENCE
        self._since = 0.0
        self._seen = 0

    def count_question(self) -> bool:
        """Count a question that does not end a wait; return whether the program may rest now."""
        self._left -= 1
        if self._left:
            return False
        now = time.perf_counter()
        quick = now - self._since < QUICK_SECONDS * self._limit
        seen = self._card.checksum() if quick else self._seen
        idle = quick and seen == self._seen
        self._seen = seen
        self._left = self._limit = IMPATIENCE if idle else PATIENCE
        self._since = time.perf_counter() + (REST_SECONDS if idle else 0)
        return idle

    def begin_anew(self) -> None:
        """The program does more than ask."""
        self._left = self._limit = PATIENCE
