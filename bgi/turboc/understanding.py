"""Reading a C program: from its files to the typed tree."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from bgi.turboc.checker.checking import check
from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.typed import TypedProgram
from bgi.turboc.faults import NOWHERE, CError, CErrors, Place
from bgi.turboc.grammar.parser import parse
from bgi.turboc.grammar.tree import Program
from bgi.turboc.linking import linked
from bgi.turboc.runtime import library
from bgi.turboc.runtime.headertexts import REFUSED
from bgi.turboc.words.preprocess import Definition, preprocess
from bgi.turboc.words.source import decode

DEEPEST = 20_000
"""Calls within each other while a program is read."""

PREDEFINED = {"__TURBOC__": "0x401", "__MSDOS__": "1", "__LARGE__": "1"}


class Understood:
    """A program of which everything is known."""

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
        """The lines of each file, in the order in which they were read."""
        own = dict.fromkeys(os.path.dirname(os.path.abspath(one)) for one in paths)
        self.folders = [*own, *folders]
        self.headers = Headers(library.FUNCTIONS, library.CONSTANTS, library.TYPES, REFUSED)
        self.defined: list[Definition] = []
        """Its macros."""
        texts = {}
        for one in paths:
            with open(one, "rb") as file:
                name = os.path.basename(one)
                texts[name] = self._keep(name, decode(file.read()))
        cplusplus = any(one.lower().endswith((".cpp", ".cc", ".cxx")) for one in paths)
        try:
            self.typed = self._understood(texts, cplusplus, defined)
        except CErrors as found:
            try:  # many a .C was compiled as C++
                self.typed = self._understood(texts, not cplusplus, defined)
                return
            except CErrors:
                pass
            raise self.with_lines(found) from None

    def _understood(
        self, texts: dict[str, str], cplusplus: bool, defined: dict[str, str]
    ) -> TypedProgram:
        """The typed tree; CErrors holds all that is wrong with the program."""
        macros = {
            **PREDEFINED,
            **library.MACROS,
            **({"__cplusplus": "1"} if cplusplus else {}),
            **defined,
        }
        self.defined = []
        with deep():
            trees = [self._parsed(*one, cplusplus, macros) for one in texts.items()]
            return check(linked(trees), self.headers, cplusplus)

    def _parsed(self, name: str, text: str, cplusplus: bool, macros: dict[str, str]) -> Program:
        """The tree of one file."""
        read = preprocess(text, name, library.HEADERS, self._load, macros)
        if read.errors:
            raise CErrors(read.errors)
        self.defined += read.defined
        return parse(read.tokens, self.headers.types, cplusplus, read.headers)

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

    def with_lines(self, found: CErrors) -> CErrors:
        """Errors with the lines of the source that they are in."""
        for error in found.errors:
            error.source = self.line(error.place)
        return found

    def line(self, place: Place) -> str:
        """The source line of a place."""
        lines = self.sources.get(place.file, [])
        return lines[place.line - 1] if 0 < place.line <= len(lines) else ""


@contextmanager
def deep() -> Iterator[None]:
    """Read an expression however deep it is; CErrors for one that is too deep."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(DEEPEST)
    try:
        yield
    except (RecursionError, MemoryError):
        raise CErrors([CError(NOWHERE, "an expression is nested too deeply")]) from None
    finally:
        sys.setrecursionlimit(before)
