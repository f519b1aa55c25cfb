"""Running a C program: from its file to its last statement."""

from __future__ import annotations

import linecache
import math
import sys
from collections.abc import Callable, Sequence
from typing import Any

from bgi.errors import BGIError
from bgi.turboc.checker.folding import single
from bgi.turboc.emitter.emit import emit
from bgi.turboc.explaining import PROGRAM, explained, warnings_explained
from bgi.turboc.faults import CError, CErrors
from bgi.turboc.runtime import library, memory
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.plaindata import Plain
from bgi.turboc.runtime.session import Session
from bgi.turboc.understanding import DEEPEST, Understood, deep

MOST_CALLS = 330_000
"""Calls of its functions within each other: a flood fill by recursion has one for each pixel."""

STACK = 256 << 20
"""Bytes that the variables of these calls may take."""


def remainder(left: int, right: int) -> int:
    """C's remainder, which has the sign of the left side."""
    if not right:
        raise ZeroDivisionError
    return int(math.fmod(left, right))


def number(pointer: Any) -> int:
    """A pointer as a number: only whether it is null counts."""
    return 0 if pointer is None else pointer.at + 1


def destroy(pointer: Any, array: bool, destructor: Callable[[Any], Any]) -> None:
    """Call the destructors of what is deleted."""
    if pointer is not None:
        for one in pointer.memory if array else [pointer.memory[pointer.at]]:
            destructor(one)


_HELPERS: dict[str, Any] = {
    **{name: getattr(memory, name) for name in ("Pointer", "MemberPlace", "CharMember", "Record")},
    **{name: getattr(memory, name) for name in ("typed", "room", "put", "put_member", "index")},
    **{"single": single, "remainder": remainder, "number": number, "destroy": destroy},
    **{"int": int, "float": float, "range": range, "bytearray": bytearray},
    **{"Union": memory.Union, "shared": memory.shared},
    "Plain": Plain,
    "__builtins__": {
        "__build_class__": __build_class__,
        "super": super,
        "staticmethod": staticmethod,
    },
}


class Runnable(Understood):
    """A program in Python, which can be run."""

    def __init__(
        self,
        path: str,
        defined: dict[str, str],
        folders: Sequence[str] = (),
        others: Sequence[str] = (),
    ) -> None:
        """Read a program; CErrors holds all that is wrong with it.

        Args:
            path: its file.
            defined: macros.
            folders: where else files lie that it includes.
            others: the other files of the same program.
        """
        super().__init__(path, defined, folders, others)
        with deep():
            self.emitted = emit(self.typed, self.headers)
            try:
                self.code = compile(self.emitted.text, PROGRAM, "exec", dont_inherit=True)
            except SyntaxError as error:
                place = self.emitted.places[(error.lineno or 1) - 1]
                what = f"this is too much for Python: {error.msg}"
                raise self.with_lines(CErrors([CError(place, what)])) from None

    def load(self, session: Session) -> dict[str, Any]:
        """The program in Python: its names, with its global variables as they are at first."""
        said = [
            f"{place.file}:{place.line}: {self.line(place).strip()}\n"
            for place in self.emitted.places
        ]
        linecache.cache[PROGRAM] = (0, None, said, PROGRAM)  # for whoever asks what a line is
        found = library.names(session)
        names = {**_HELPERS, "__name__": "program"}
        names |= {name: found[name] for name in self.emitted.used}
        exec(self.code, names)
        return names

    def run(self, session: Session, arguments: Sequence[str] = ()) -> int:
        """Run it; returns its exit status. CError for a fault of the program."""

        def main() -> int:
            names = self.load(session)
            return int(names[self.emitted.main](*_given(self.file, arguments)) or 0) & 0xFF

        before = sys.getrecursionlimit()
        sys.setrecursionlimit(min(MOST_CALLS, DEEPEST // 10 + STACK // (self.emitted.frame + 1)))
        try:
            with warnings_explained(self.emitted.places, self.line):
                return session.run(main)
        except (BGIError, KeyboardInterrupt):
            raise
        except Exception as error:
            fault = explained(error, self.emitted.places)
            fault.source = self.line(fault.place)
            raise fault from error
        finally:
            sys.setrecursionlimit(before)


def _given(file: str, arguments: Sequence[str]) -> tuple[Any, ...]:
    """What main() gets: how many words the command had, and these."""
    words = [
        Pointer(bytearray(f"{word}\0".encode("cp437", "replace"))) for word in (file, *arguments)
    ]
    return len(words), Pointer([*words, None]), Pointer([None])
