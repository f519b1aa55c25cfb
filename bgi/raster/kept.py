"""Tables that fill themselves, and never grow beyond so many bytes."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import numpy as np

Made = TypeVar("Made", bound=Iterable[object])
_OF_AN_ENTRY = 500
"""Bytes that an entry takes besides its arrays' numbers, roughly."""
_OF_A_ROW = 300
"""Bytes that each element of a list takes, which is a tuple of slices."""
MET = 1000
"""Keys that are remembered until they are met again."""


class Kept(dict[Any, Made]):
    """What a function made of its arguments, to be looked up by them: `table[a, b]` is `f(a, b)`.

    What it makes is a tuple of arrays, lists and numbers, or of such tuples. Where all of them
    together take too many bytes, the oldest are forgotten. (functools.lru_cache counts entries,
    whatever their size, and takes longer to find one.)
    """

    def __init__(self, make: Callable[..., Made], most_bytes: int) -> None:
        """An empty table."""
        super().__init__()
        self._make = make
        self._most = most_bytes
        self.bytes = 0
        self._met: set[tuple[Any, ...]] = set()

    def again(self, *key: Any) -> Made | None:
        """What is made of arguments that were met before; None for new ones."""
        found = self.get(key)
        if found is None:
            if key in self._met:
                self._met.remove(key)
                return self[key]
            if len(self._met) >= MET:
                self._met.clear()
            self._met.add(key)
        return found

    def __missing__(self, key: tuple[Any, ...]) -> Made:
        made = self._make(*key)
        self.bytes += _bytes(made)
        self[key] = made
        while self.bytes > self._most:
            self.bytes -= _bytes(self.pop(next(iter(self))))
        return made


def _bytes(made: Iterable[object]) -> int:
    total = _OF_AN_ENTRY
    for part in made:
        if isinstance(part, np.ndarray):
            total += part.nbytes
        elif isinstance(part, list):
            total += _OF_A_ROW * len(part)
        elif isinstance(part, tuple):
            total += _bytes(part)
    return total
