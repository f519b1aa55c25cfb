"""Calls a learner's function, and comes back from it whatever that does.

An endless loop is ended after so many lines of Python: so the answer is the same on every machine.
They are counted as a debugger counts them, by a trace function; where a real debugger is at work,
its tracing stays, and only calls that reach the screen are counted. What gives nothing to count is
ended after a time (`bgi.lab.alarm`).
"""

from __future__ import annotations

import inspect
import io
import linecache
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import dataclass
from types import FrameType, TracebackType
from typing import Any

from bgi.errors import brief
from bgi.graphics import Graphics
from bgi.graphics.slow import ORDERS
from bgi.lab.alarm import Alarm

LINES = 400_000
"""Lines of Python that one call may run."""
SECONDS = 6
"""For one call that runs no lines to be counted."""
SCREEN_CALLS = 100_000
"""Pixels that one call may set and ask for."""
DEEPEST = 20_000
"""Calls inside each other: more of them may end Python itself."""
PRINTED = 2000
"""Characters that are kept of what it prints."""


HOPELESS = {"endless", "deep", "forbidden"}
ENOUGH = 2
"""So many such troubles are enough: no more is tried."""

USUAL = {
    "NobodyThere": "the function gets all that it needs as arguments: leave keys to the program",
    "EOFError": "the function gets all that it needs as arguments: leave input() to the program",
    "SystemExit": "return ends a function; exit() ends all of the program",
    "NameError": "is the name written as where it was set? What another function sets is not known",
    "UnboundLocalError": "what a function sets is its own: set it first, or use the arguments",
    "exception": "Python says what it could not do, and in which line",
    "endless": "look at the condition of the loop: does something change that it asks for?",
    "deep": "a function that calls itself must stop somewhere",
}
"""The hints for troubles and errors, unless an exercise knows better."""


class Stopped(BaseException):
    """Ends a function from outside; no `except Exception` holds it up."""


_ALARM = Alarm(Stopped)


class NotAllowed(Exception):
    """A call that would do the exercise's work."""


@dataclass(frozen=True)
class Trouble:
    """Why a function has given no answer."""

    kind: str
    """`exception`, `endless`, `deep`, `forbidden` or `arguments`."""
    words: str
    error: BaseException | None = None


@dataclass(frozen=True)
class Outcome:
    """What a call came to."""

    value: Any = None
    trouble: Trouble | None = None
    depth: int = 0
    """How many calls were inside each other, its own included; 0 under a debugger."""
    printed: str = ""


class PixelsOnly:
    """Everything that a screen is, but of what draws only `putpixel`, and what else is allowed."""

    def __init__(self, screen: Graphics, allowed: tuple[str, ...] = ()) -> None:
        self._screen = screen
        self._refused = ORDERS.keys() - {*allowed}
        self.calls = 0

    def putpixel(self, x: Any, y: Any, color: Any) -> None:
        """Set pixels."""
        self._count()
        self._screen.putpixel(x, y, color)

    def getpixel(self, x: Any, y: Any) -> Any:
        """Read pixels."""
        self._count()
        return self._screen.getpixel(x, y)

    def _count(self) -> None:
        self.calls += 1
        if self.calls > SCREEN_CALLS:
            raise Stopped

    def __getattr__(self, name: str) -> Any:
        if name in self._refused:
            raise NotAllowed(name)
        return getattr(self._screen, name)


class _Watch:
    """A trace function: counts lines and depth, and ends what goes beyond."""

    def __init__(self) -> None:
        self.lines = self.depth = self.deepest = 0
        self.why = ""
        self.where = ""

    def __call__(self, frame: FrameType, event: str, argument: object) -> Any:
        if _is_ours(frame):
            return None
        self.depth += 1
        self.deepest = max(self.deepest, self.depth)
        if self.depth > DEEPEST:
            self._stop("deep", frame)
        return self._inside

    def _inside(self, frame: FrameType, event: str, argument: object) -> Any:
        if event == "line":
            self.lines += 1
            if self.lines > LINES:
                self._stop("endless", frame)
        elif event == "return":
            self.depth -= 1
        return self._inside

    def _stop(self, why: str, frame: FrameType) -> None:
        self.why, self.where = why, _place(frame.f_code.co_filename, frame.f_lineno)
        raise Stopped


class _Printed(io.StringIO):
    """What is printed: the beginning of it."""

    def write(self, text: str) -> int:
        room = PRINTED - self.tell()
        if room > 0:
            super().write(text[:room])
        return len(text)

    def close(self) -> None:
        """Stays open: what was printed is asked for at the end."""


def call(function: Callable[..., Any], arguments: tuple[Any, ...]) -> Outcome:
    """Call a function. Ctrl-C comes through, and nothing else that it raises."""
    watch, value, trouble = _Watch(), None, None
    with _alone() as printed:
        tracing, before = sys.gettrace() is None, sys.gettrace()
        try:
            with _ALARM.after(SECONDS):
                if tracing:
                    sys.settrace(watch)
                value = function(*arguments)
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            sys.settrace(before)
            trouble = _explained(error, watch)
        finally:
            sys.settrace(before)
    if (watch.why or _ALARM.rang) and (
        trouble is None or trouble.kind == "exception"
    ):  # it held the end up
        trouble = _explained(Stopped(), watch)
    return Outcome(value, trouble, watch.deepest, printed.getvalue())


@contextmanager
def _alone() -> Iterator[io.StringIO]:
    """Keep what is printed, and have nobody answer `input()`."""
    printed, stdin = _Printed(), sys.stdin
    sys.stdin = io.StringIO()
    try:
        with redirect_stdout(printed):
            yield printed
    finally:
        sys.stdin = stdin


def _explained(error: BaseException, watch: _Watch) -> Trouble:
    where = _last_place(error.__traceback__)
    if isinstance(error, Stopped):
        if watch.why == "deep":
            return Trouble("deep", f"it was stopped {DEEPEST:,} calls deep, at {watch.where}")
        after = f"{LINES:,} lines of Python" if watch.why else "very many pixels"
        after = f"{SECONDS} seconds" if _ALARM.rang else after
        place = watch.where or where
        return Trouble("endless", f"it does not end: stopped after {after}, at {place}")
    if isinstance(error, RecursionError):
        return Trouble("deep", f"Python ended it {max(watch.deepest, 1):,} calls deep, at {where}")
    if isinstance(error, NotAllowed):
        return Trouble("forbidden", f"it calls {error}() at {where}", error)
    if isinstance(error, SystemExit):
        return Trouble("exception", f"it ends the program at {where}", error)
    if isinstance(error, EOFError):
        return Trouble("exception", f"it asks for input at {where}", error)
    text = f"{type(error).__name__}: {_text(error)}"
    return Trouble("exception", f"{text} ({where})" if where else text, error)


def _text(error: BaseException) -> str:
    """What an error says; it may be of the learner's making, and fail at that."""
    try:
        return str(error)[:300]
    except Exception:
        return "an error that cannot be printed"


def _last_place(traceback: TracebackType | None) -> str:
    """The last line of the learner's that an error came through."""
    place = ""
    while traceback is not None:
        frame = traceback.tb_frame
        if not _is_ours(frame):
            place = _place(frame.f_code.co_filename, traceback.tb_lineno)
        traceback = traceback.tb_next
    return place


def _place(file: str, line: int) -> str:
    """A line as it is told: its number, and what stands there."""
    source = linecache.getline(file, line).strip()
    name = "" if file.startswith("<") else f"{os.path.basename(file)}, "
    return f"{name}line {line}: {source}" if source else f"{name}line {line}"


def _is_ours(frame: FrameType) -> bool:
    """Whether it is our own code, be it imported or run by `python -m`."""
    known = frame.f_globals
    name = str(getattr(known.get("__spec__"), "name", "") or known.get("__name__", ""))
    return name.startswith("bgi.") and not name.startswith("bgi.demos")


def usual(trouble: Trouble) -> str:
    """The hint that fits in every exercise."""
    return USUAL.get(type(trouble.error).__name__) or USUAL.get(trouble.kind, "")


def misfit(function: Callable[..., Any], names: tuple[str, ...]) -> str:
    """Why a function cannot be called with arguments of these names; nothing where it can."""
    if not callable(function):
        raise TypeError(
            f"a check takes the function itself, as in check.line(my_line) without more brackets,"
            f" not {brief(function)}"
        )
    try:
        inspect.signature(function).bind(*names)
    except TypeError as error:
        return f"it must take {len(names)} arguments, {', '.join(names)}: {error}"
    except ValueError:  # it does not tell
        return ""
    return ""


def name_of(function: Callable[..., Any]) -> str:
    """What a function is called."""
    return str(getattr(function, "__name__", "the function"))


def copied(arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The same arguments, for a function that may change a list that it is given."""
    return tuple(list(one) if isinstance(one, list) else one for one in arguments)


def quoted(outcome: Outcome) -> str:
    """What was printed, to be told at the end of a reason."""
    printed = outcome.printed.strip()
    return f"; it printed: {brief(printed)}" if printed else ""
