"""The words of a program one after the other, and what a parser asks of them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from bgi.turboc.faults import CError, Place
from bgi.turboc.words.lexer import Token

DEEPEST = 200
"""Brackets, statements and declarators within each other."""

_DROPPED = """
    far near huge cdecl pascal interrupt register auto volatile inline
    _far _near _huge _cdecl _pascal _interrupt __far __near __huge __cdecl __pascal __interrupt
    _Cdecl _Pascal _seg _export _loadds _saveregs _fastcall
"""
DROPPED = frozenset(_DROPPED.split())
"""Words that ask for what a PC's memory or a linker needed: here they say nothing."""


def _without_std(words: list[Token]) -> Iterator[Token]:
    """The words without `std::`: all that the library has stands in one place here."""
    before = ""
    for word, after in zip(words, [*words[1:], words[-1]], strict=True):
        standard = word.text == "std" and after.text == "::"
        if not standard and not (word.text == "::" and before == "std"):
            yield word
        before = word.text


class Stream:
    """Words to look at and to take."""

    def __init__(self, words: list[Token]) -> None:
        kept = [word for word in words if word.text not in DROPPED or word.kind != "name"]
        self._words = list(_without_std(kept))
        self._position = 0
        self._depth = 0

    @property
    def place(self) -> Place:
        """Where the next word stands."""
        return self._words[self._position].place

    @property
    def word(self) -> Token:
        """The next word."""
        return self._words[self._position]

    def ahead(self, count: int) -> Token:
        """The word that comes so many after the next."""
        return self._words[min(self._position + count, len(self._words) - 1)]

    def at(self, *texts: str) -> bool:
        """Whether the next word is one of these."""
        word = self.word
        return word.text in texts and word.kind in ("operator", "name")

    def take(self) -> Token:
        """Take the next word, whatever it is; the end is never passed."""
        word = self.word
        if word.kind != "end":
            self._position += 1
        return word

    def accept(self, *texts: str) -> Token | None:
        """Take the next word if it is one of these."""
        return self.take() if self.at(*texts) else None

    def expect(self, text: str) -> Token:
        """Take that word; CError if another one stands there."""
        if self.at(text):
            return self.take()
        previous = self._words[self._position - 1] if self._position else self.word
        if text in (";", ")", "]", "}", ","):  # what is missing was to stand behind that
            end = previous.place._replace(column=previous.place.column + len(previous.text))
            raise CError(end, f"a '{text}' is missing before {self.described()}")
        raise self.error(f"'{text}' expected")

    def name(self) -> Token:
        """Take a name; CError if there is none."""
        if self.word.kind != "name":
            raise self.error("a name expected")
        return self.take()

    def error(self, message: str) -> CError:
        """An error at the next word."""
        return CError(self.place, f"{message}, not {self.described()}")

    def described(self) -> str:
        """The next word as errors name it."""
        return f"'{self.word.text}'" if self.word.kind != "end" else "the end of the file"

    @contextmanager
    def deeper(self) -> Iterator[None]:
        """One level deeper; CError where there are too many."""
        if self._depth >= DEEPEST:
            raise CError(self.place, "this is nested too deeply")
        self._depth += 1
        try:
            yield
        finally:
            self._depth -= 1

    def skip_statement(self) -> None:
        """After an error: go on behind the next semicolon, or before a closing brace."""
        depth = 0
        while self.word.kind != "end":
            if depth == 0 and self.at("}"):
                return
            word = self.take()
            depth += (word.text == "{") - (word.text == "}")
            if depth == 0 and word.text in (";", "}"):
                return
