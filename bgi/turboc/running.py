"""Running a C program: from its file to its last statement."""

from __future__ import annotations

import linecache
import math
import os
import sys
from collections.abc import Callable, Sequence
from typing import Any

from bgi.errors import BGIError
from bgi.turboc.checker.checking import check
from bgi.turboc.checker.folding import single
from bgi.turboc.checker.headers import Headers
from bgi.turboc.emitter.emit import Emitted, emit
from bgi.turboc.explaining import PROGRAM, explained
from bgi.turboc.faults import NOWHERE, CError, CErrors, Place
from bgi.turboc.grammar.parser import parse
from bgi.turboc.grammar.tree import Program
from bgi.turboc.linking import linked
from bgi.turboc.runtime import library, memory
from bgi.turboc.runtime.headertexts import REFUSED
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.plaindata import Plain
from bgi.turboc.runtime.session import Session
from bgi.turboc.words.preprocess import preprocess
from bgi.turboc.words.source import decode

DEEPEST = 20_000
"""Calls within each other while a program is read."""

MOST_CALLS = 330_000
"""Calls of its functions within each other: a flood fill by recursion has one for each pixel."""

STACK = 256 << 20
"""Bytes that the variables of these calls may take."""

PREDEFINED = {"__TURBOC__": "0x401", "__MSDOS__": "1", "__LARGE__": "1"}


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


class Runnable:
    """A program that has been understood."""

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
        paths = [path, *others]
        self.file = os.path.basename(path)
        self.sources: dict[str, list[str]] = {}
        own = dict.fromkeys(os.path.dirname(os.path.abspath(one)) for one in paths)
        self.folders = [*own, *folders]
        self._headers = Headers(library.FUNCTIONS, library.CONSTANTS, library.TYPES, REFUSED)
        texts = {}
        for one in paths:
            with open(one, "rb") as file:
                name = os.path.basename(one)
                texts[name] = self._keep(name, decode(file.read()))
        cplusplus = any(one.lower().endswith((".cpp", ".cc", ".cxx")) for one in paths)
        try:
            self.emitted = self._understood(texts, cplusplus, defined)
        except CErrors as found:
            try:  # many a .C was compiled as C++
                self.emitted = self._understood(texts, not cplusplus, defined)
                return
            except CErrors:
                pass
            for error in found.errors:
                error.source = self.line(error.place)
            raise

    def _understood(
        self, texts: dict[str, str], cplusplus: bool, defined: dict[str, str]
    ) -> Emitted:
        """The program in Python; CErrors holds all that is wrong with it."""
        macros = {
            **PREDEFINED,
            **library.MACROS,
            **({"__cplusplus": "1"} if cplusplus else {}),
            **defined,
        }
        before = sys.getrecursionlimit()
        sys.setrecursionlimit(DEEPEST)
        try:
            trees = [self._parsed(*one, cplusplus, macros) for one in texts.items()]
            emitted = emit(check(linked(trees), self._headers, cplusplus), self._headers)
            self.code = compile(emitted.text, PROGRAM, "exec", dont_inherit=True)
        except SyntaxError as error:
            place = emitted.places[(error.lineno or 1) - 1]
            raise CErrors([CError(place, f"this is too much for Python: {error.msg}")]) from None
        except (RecursionError, MemoryError):
            raise CErrors([CError(NOWHERE, "an expression is nested too deeply")]) from None
        finally:
            sys.setrecursionlimit(before)
        return emitted

    def _parsed(self, name: str, text: str, cplusplus: bool, macros: dict[str, str]) -> Program:
        """The tree of one file."""
        read = preprocess(text, name, library.HEADERS, self._load, macros)
        if read.errors:
            raise CErrors(read.errors)
        return parse(read.tokens, self._headers.types, cplusplus, read.headers)

    def _keep(self, name: str, text: str) -> str:
        self.sources[name] = text.split("\n")
        return text

    def _load(self, name: str) -> str | None:
        """The text of a file beside the program."""
        for folder in self.folders:
            wanted = os.path.basename(name.replace("\\", "/")).lower()
            for one in os.listdir(folder) if os.path.isdir(folder) else ():
                if one.lower() == wanted:
                    with open(os.path.join(folder, one), "rb") as file:
                        return self._keep(name, decode(file.read()))
        return None

    def line(self, place: Place) -> str:
        """The source line of a place."""
        lines = self.sources.get(place.file, [])
        return lines[place.line - 1] if 0 < place.line <= len(lines) else ""

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
