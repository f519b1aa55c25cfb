"""The grammar of C, and of the C++ of 1992: from the words of a program to its tree."""

from __future__ import annotations

import sys
from collections.abc import Iterable

from bgi.turboc.faults import MOST_ERRORS, CError, CErrors
from bgi.turboc.grammar.classes import Classes
from bgi.turboc.grammar.declarations import Named_, Specifiers
from bgi.turboc.grammar.nodes import FunctionPart, Words
from bgi.turboc.grammar.stream import DEEPEST
from bgi.turboc.grammar.tree import Asm, Program, Top
from bgi.turboc.words.lexer import Token

FRAMES = 40
"""Of Python, for each level of a program's nesting."""


class Parser(Classes):
    """A whole program."""

    def __init__(self, words: list[Token], types: Iterable[str], cplusplus: bool) -> None:
        super().__init__(words)
        self.types = set(types)
        self.cplusplus = cplusplus
        self.errors = []
        self.made_up = 0

    def program(self) -> tuple[Top, ...]:
        """Everything up to the end; what is wrong is in `errors`."""
        items: list[Top] = []
        while self.word.kind != "end" and len(self.errors) < MOST_ERRORS:
            before = self.word
            try:
                items += self.top()
            except CError as error:
                if error not in self.errors:
                    self.errors.append(error)
                if self.word is before:
                    self.take()
                self.skip_statement()
                self.accept("}")
        return tuple(items)

    def top(self) -> list[Top]:
        """What may stand at the top: declarations and functions."""
        if self.accept(";"):
            return []
        if self.at("asm", "_asm", "__asm"):
            asm = self._asm()
            return [asm] if isinstance(asm, Asm) else []
        if self.at("extern") and self.ahead(1).kind == "string" and self.ahead(2).text == "{":
            return self._linkage()
        if self.at("using") and self.cplusplus:
            self.skip_statement()
            return []
        said = self._specifiers_at_top()
        made: list[Top] = list(said.defined)
        if self.accept(";"):
            return made
        found = self.declarator(arguments=True)
        if self._begins_body(found):
            return [*made, self.function(said, found)]
        return [*made, self.declaration(said, found)]

    def _linkage(self) -> list[Top]:
        """`extern "C" { ... }`"""
        for _ in range(3):
            self.take()
        items: list[Top] = []
        while not self.at("}") and self.word.kind != "end":
            items += self.top()
        self.expect("}")
        return items

    def _specifiers_at_top(self) -> Specifiers:
        """Those of a function or a variable; `Class::Class(` has none."""
        if self.word.kind == "name" and self.ahead(1).text == "::" and self.word.text in self.types:
            name = self.ahead(2).text
            if name in (self.word.text, "~", "operator"):
                return Specifiers(self.place, Words(("void",)))
        if self.word.kind != "name":
            raise self.error("a declaration expected")
        return self.specifiers()

    def _begins_body(self, found: Named_) -> bool:
        """Whether a function's body follows, or the types of its parameters in the old style."""
        if not (found.parts and isinstance(found.parts[0], FunctionPart)):
            return False
        return self.at("{", ":") or (not self.at(";", ",", "=") and bool(found.old))


def parse(
    words: list[Token], types: Iterable[str], cplusplus: bool, headers: frozenset[str] = frozenset()
) -> Program:
    """The tree of a program.

    Args:
        words: what the preprocessor left.
        types: names that headers make types.
        cplusplus: whether it is C++.
        headers: those that it includes.

    CErrors holds all that is wrong, 20 errors at most.
    """
    parser = Parser(words, types, cplusplus)
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, 1000 + FRAMES * DEEPEST))
    try:
        items = parser.program()
    finally:
        sys.setrecursionlimit(before)
    if parser.errors:
        raise CErrors(parser.errors)
    return Program(items, headers)
