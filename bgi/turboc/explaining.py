"""What went wrong in a running program, in C's words: exceptions and warnings explained."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Any

from bgi.turboc.faults import NOWHERE, CError, Place, shown

PROGRAM = "<C program>"
"""What Python calls the file of the emitted program."""

_MESSAGES: dict[type[Exception], str] = {
    ZeroDivisionError: "division by zero",
    IndexError: "outside of an array",
    RecursionError: "the stack overflowed: does a function call itself without end?",
    MemoryError: "there is not that much memory",
    OverflowError: "this number is too large",
    NameError: "this variable has not come to life: a goto jumped over it",
    AttributeError: "this pointer points to something of another type",
    TypeError: "this pointer points to something of another type",
    StopIteration: "an argument is missing",
}

_TEXTS = {
    "float infinity to integer": "this real number is too large for a whole number",
    "float NaN to integer": "this real number is not defined, as the root of -1 is not",
    "math domain error": "this function is not defined for this number",
    "math range error": "the result of this function is too large",
    "NoneType": "a null pointer was used",
    "attribute 'memory'": "this is no pointer",
    "attribute 'at'": "this is no pointer",
}
"""By what Python's own message holds."""


_PLAIN = (IndexError, KeyError, OverflowError, NameError, RecursionError, MemoryError)
"""Of these Python's own message says nothing that helps."""


def explained(error: Exception, places: list[Place]) -> CError:
    """A fault of the C program.

    Args:
        error: what Python raised.
        places: where each line of the emitted program comes from.
    """
    place, told = NOWHERE, False
    step: TracebackType | None = error.__traceback__
    while step is not None:
        ours = step.tb_frame.f_code.co_filename == PROGRAM
        if ours:
            place = places[step.tb_lineno - 1]
        told = not ours
        step = step.tb_next
    return CError(place, _message(error, told))


def _message(error: Any, told: bool) -> str:
    """What is wrong; `told` by the library, which says it better than Python would."""
    text = str(error)
    known = next((message for part, message in _TEXTS.items() if part in text), None)
    if known is not None:
        return known
    if told and text and not isinstance(error, _PLAIN):
        return text
    kinds = (message for kind, message in _MESSAGES.items() if isinstance(error, kind))
    return next(kinds, f"this cannot be done here: {text}")


@contextmanager
def warnings_explained(places: list[Place], line: Callable[[Place], str]) -> Iterator[None]:
    """While a C program runs: a warning shows its line of C, not ours of Python.

    Args:
        places: where each line of the emitted program comes from.
        line: looks up the line that a place is in.
    """

    def show(message: Warning | str, *_: Any, **__: Any) -> None:
        step: FrameType | None = sys._getframe()
        while step and step.f_code.co_filename != PROGRAM:
            step = step.f_back
        warning = CError(places[step.f_lineno - 1] if step else NOWHERE, f"warning: {message}")
        warning.source = line(warning.place)
        print(shown(warning), file=sys.stderr)

    with warnings.catch_warnings():
        warnings.showwarning = show
        yield
