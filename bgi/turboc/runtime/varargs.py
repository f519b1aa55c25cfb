"""stdarg.h: the arguments that a function has no names for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from bgi.turboc.runtime.binding import Function
from bgi.turboc.runtime.memory import Pointer

DECLARATIONS = """
void *_va_begin(va_list more); void *_va_next(va_list list); double max(double a, double b);
double min(double a, double b); int _raise(int number);
"""

NAMES = {"_more": "void *@"}
"""Inside of a function with `...`: what it was given there."""


class Arguments:
    """Arguments, one after the other."""

    def __init__(self, values: tuple[Any, ...]) -> None:
        self._rest = iter(values)

    def __iter__(self) -> Iterator[Any]:
        return self._rest

    def take(self) -> Pointer:
        """A pointer to the next one; beyond the last it is 0."""
        return Pointer([next(self._rest, 0)])


FUNCTIONS: dict[str, Function] = {
    **{"_va_begin": Arguments, "_va_next": Arguments.take, "max": max, "min": min},
}
