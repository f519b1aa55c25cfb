"""Declarations: types as they are written, and the names that have them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar.expressions import RESERVED, Expressions
from bgi.turboc.grammar.nodes import (
    ArrayPart,
    Base,
    Expr,
    FunctionPart,
    Named,
    Parameter,
    Part,
    PointerPart,
    ReferencePart,
    Tagged,
    TypeName,
    Words,
)
from bgi.turboc.grammar.tree import Declaration, Declarator, EnumDef, StructDef

_TYPE_WORDS = frozenset(
    ["void", "char", "short", "int", "long", "float", "double", "signed", "unsigned"]
)
_STORAGE = frozenset(["static", "extern", "typedef", "friend", "virtual"])
_QUALIFIERS = frozenset(("const",))
_TAGS = frozenset(("struct", "union", "class", "enum"))


class Specifiers(NamedTuple):
    """What stands before the names of a declaration."""

    place: Place
    base: Base
    storage: str = ""
    const: bool = False
    virtual: bool = False
    defined: tuple[StructDef | EnumDef, ...] = ()
    """The struct or enum that is defined on the way."""


class Named_(NamedTuple):
    """A declarator: the name, and the parts of its type, outermost first."""

    place: Place
    name: str
    parts: tuple[Part, ...]
    scope: str = ""
    old: tuple[str, ...] = ()
    """The parameters of a function in the old style: `f(a, b) int a, b; { ... }`."""


class Declarations(Expressions):
    """What a name is declared as."""

    types: set[str]
    """Names that are types."""
    made_up: int

    @contextmanager
    def inside(self, hiding: Iterable[str] = ()) -> Iterator[None]:
        """A block: what it makes of names is over behind it.

        Args:
            hiding: names that are no types in it, since its function's parameters are called so.
        """
        before = set(self.types)
        self.types.difference_update(hiding)
        try:
            yield
        finally:
            self.types = before

    def starts_type(self, ahead: int = 0) -> bool:
        """Whether a type begins with the word so many after the next."""
        word = self.ahead(ahead)
        if word.kind != "name":
            return False
        text = word.text
        if text in _TYPE_WORDS or text in _QUALIFIERS or (self.cplusplus and text == "bool"):
            return True
        if text in _TAGS:
            return text != "class" or self.cplusplus
        return text in self.types

    def starts_declaration(self) -> bool:
        """Whether the next words declare something, and are no expression."""
        word, after = self.word, self.ahead(1)
        if word.kind != "name":
            return False
        if word.text in _STORAGE and (word.text not in ("friend", "virtual") or self.cplusplus):
            return True
        if not self.starts_type():
            return False
        if word.text in self.types or word.text in _TYPE_WORDS:
            if after.text == "(":
                return self._declares_in_brackets()
            return after.kind == "name" or after.text in ("*", "&", ";")
        return True

    def _declares_in_brackets(self) -> bool:
        """Whether `T (` goes on as in `T (*p)`: a declarator."""
        return self.ahead(2).text == "*" and self.ahead(3).kind == "name"

    # Specifiers

    def specifiers(self) -> Specifiers:
        """`static const unsigned long`, `struct point { ... }`; none at all is int."""
        place, storage, const, virtual = self.place, "", False, False
        words: list[str] = []
        base: Base | None = None
        defined: tuple[StructDef | EnumDef, ...] = ()
        while self.word.kind == "name":
            text = self.word.text
            if text in _STORAGE and (text not in ("friend", "virtual") or self.cplusplus):
                self.take()
                virtual = virtual or text == "virtual"
                storage = text if text != "virtual" else storage
                if text == "extern" and self.word.kind == "string":  # extern "C"
                    self.take()
            elif text in _QUALIFIERS:
                self.take()
                const = True
            elif base is None and text in _TYPE_WORDS:
                words.append(self.take().text)
            elif base is None and not words and text in _TAGS and self.starts_type():
                base, defined = self.tagged()
            elif base is None and not words and self._type_here(text):
                base = Words(("int",)) if text == "bool" else Named(text)
                self.take()
            else:
                break
        if base is None:
            base = Words(tuple(sorted(words)))
            _check_words(base.words, place)
        return Specifiers(place, base, storage, const, virtual, defined)

    def _type_here(self, text: str) -> bool:
        if self.cplusplus and text == "bool" and text not in self.types:
            return True
        return text in self.types and self.ahead(1).text != "::"

    def tagged(self) -> tuple[Base, tuple[StructDef | EnumDef, ...]]:
        """`struct tag`, with or without its members, or an enum."""
        word = self.take()
        tag = self.name().text if self.word.kind == "name" else ""
        if not tag:
            self.made_up += 1
            tag = f"{self.made_up} {word.text}"
        if self.cplusplus:
            self.types.add(tag)
        kind = "struct" if word.text == "class" else word.text
        base = Tagged(kind, tag)
        if word.text == "enum":
            return base, (self.enum_body(word.place, tag),) if self.at("{") else ()
        if self.at("{") or (self.cplusplus and self.at(":")):
            return base, (self.struct_body(word.place, word.text, tag),)
        return base, ()

    def enum_body(self, place: Place, tag: str) -> EnumDef:
        """`{ A, B = 3 }`"""
        self.expect("{")
        constants: list[tuple[str, Expr | None]] = []
        while not self.at("}"):
            name = self.name().text
            constants.append((name, self.conditional() if self.accept("=") else None))
            if not self.accept(","):
                break
        self.expect("}")
        return EnumDef(place, tag, tuple(constants))

    def struct_body(self, place: Place, word: str, tag: str) -> StructDef:
        """`{ members }` of a struct, union or class."""
        raise NotImplementedError

    # Declarators

    def declarator(self, abstract: bool = False, arguments: bool = False) -> Named_:
        """`*name[3]`, `(*name)(int)`.

        Args:
            abstract: whether the name may be missing.
            arguments: whether brackets behind the name may be arguments of a constructor, which are
                left alone.
        """
        with self.deeper():
            pointers: list[Part] = []
            while self.at("*", "&", "const"):
                text = self.take().text
                if text != "const":
                    pointers.append(PointerPart() if text == "*" else ReferencePart())
            inner = self._direct(abstract)
            suffixes, old = self._suffixes(arguments)
            parts = (*inner.parts, *suffixes, *reversed(pointers))
            return inner._replace(parts=parts, old=old or inner.old)

    def _direct(self, abstract: bool) -> Named_:
        """The name, or a declarator in brackets."""
        place = self.place
        if self.at("(") and (not abstract or self.ahead(1).text in ("*", "&", "(", "[")):
            self.take()
            inner = self.declarator(abstract)
            self.expect(")")
            return inner
        if self.word.kind == "name" and self.word.text not in RESERVED:
            name, scope = self._declared_name()
            return Named_(place, name, (), scope)
        if self.cplusplus and self.accept("~"):
            return Named_(place, "~" + self.name().text, ())
        if not abstract:
            raise self.error("a name expected")
        return Named_(place, "", ())

    def _declared_name(self) -> tuple[str, str]:
        """`name`, `Class::name`, `operator+`: the name, and its class."""
        name, scope = self.take().text, ""
        while self.cplusplus and self.accept("::"):
            scope = name
            name = "~" + self.name().text if self.accept("~") else self.name().text
        if self.cplusplus and name == "operator":
            type_ = self.new_type() if self.starts_type() else None
            name += f" {self.converted_to(type_)}" if type_ else self.operator_name()
        return name, scope

    def converted_to(self, type_: TypeName) -> str:
        """A type in the name of the operator that converts to it."""
        base = type_.base
        match base:
            case Words(several):
                words = " ".join(several)
            case Named(word) | Tagged(_, word):
                words = word
        return words + "*" * len(type_.parts)

    def _suffixes(self, arguments: bool) -> tuple[list[Part], tuple[str, ...]]:
        """`[3]` and `(int a)` behind a name; the names of parameters in the old style."""
        parts: list[Part] = []
        old: tuple[str, ...] = ()
        while True:
            if self.accept("["):
                parts.append(ArrayPart(None if self.at("]") else self.conditional()))
                self.expect("]")
            elif self.at("(") and not (arguments and self._holds_arguments()):
                self.take()
                part, old = self.parameters()
                parts.append(part)
                if self.cplusplus:
                    self.accept("const")
            else:
                return parts, old

    def _holds_arguments(self) -> bool:
        """Whether the brackets hold values: `Point p(1, 2)`; empty ones hold no parameters."""
        return self.cplusplus and self.ahead(1).text != ")" and not self.starts_type(1)

    def parameters(self) -> tuple[FunctionPart, tuple[str, ...]]:
        """`int a, char *b, ...)`; or names alone, of which the types come later."""
        if self.accept(")"):
            return FunctionPart((), open=not self.cplusplus), ()
        if self.word.text == "void" and self.ahead(1).text == ")":
            self.take()
            self.take()
            return FunctionPart(()), ()
        if self.word.kind == "name" and not self.starts_type():
            return self._old_parameters()
        found: list[Parameter] = []
        open_ = False
        while True:
            if self.accept("..."):
                open_ = True
                break
            found.append(self._parameter())
            if not self.accept(","):
                break
        self.expect(")")
        return FunctionPart(tuple(found), open_), ()

    def _old_parameters(self) -> tuple[FunctionPart, tuple[str, ...]]:
        names = [self.name().text]
        while self.accept(","):
            names.append(self.name().text)
        self.expect(")")
        return FunctionPart((), open=True), tuple(names)

    def _parameter(self) -> Parameter:
        if not self.starts_type() and not self.at("register"):
            raise self.error("the type of a parameter expected")
        said = self.specifiers()
        found = self.declarator(abstract=True)
        type_ = TypeName(said.place, said.base, found.parts)
        default = self.assignment() if self.accept("=") else None
        return Parameter(found.place, found.name, type_, default)

    def type_name(self) -> TypeName:
        """A type without a name in it."""
        said = self.specifiers()
        found = self.declarator(abstract=True)
        if found.name:
            raise CError(found.place, f"no name is expected here, as {found.name}")
        return TypeName(said.place, said.base, found.parts)

    def new_type(self) -> TypeName:
        """The type behind `new`, or before the bracket of a conversion: without brackets."""
        said = self.specifiers()
        pointers: list[Part] = []
        while self.accept("*"):
            pointers.append(PointerPart())
        return TypeName(said.place, said.base, tuple(pointers))

    # Declarations

    def declaration(self, said: Specifiers, first: Named_ | None = None) -> Declaration:
        """The names behind the specifiers, up to the semicolon."""
        names: list[Declarator] = []
        if not (self.at(";") and first is None):
            while True:
                found = first or self.declarator(arguments=True)
                first = None
                names.append(self._declared(said, found))
                if not self.accept(","):
                    break
        self.expect(";")
        return Declaration(said.place, tuple(names))

    def _declared(self, said: Specifiers, found: Named_) -> Declarator:
        if said.storage == "typedef":
            self.types.add(found.name)
        else:
            self.types.discard(found.name)  # a variable of that name hides the type
        type_ = TypeName(said.place, said.base, found.parts)
        initial, arguments = None, None
        if self.accept("="):
            initial = self.initializer()
        elif self.cplusplus and self.accept("("):
            arguments = self._arguments()
        name = f"{found.scope}::{found.name}" if found.scope else found.name
        return Declarator(found.place, name, type_, initial, arguments, said.storage, said.const)


def _check_words(words: tuple[str, ...], place: Place) -> None:
    """CError for words that make no type together, as `float long char`."""
    kinds = [word for word in words if word in ("void", "char", "float", "double", "int")]
    others = [word for word in kinds if word != "int"]
    signs = [word for word in words if word in ("signed", "unsigned")]
    wrong = len(others) > 1 or len(set(signs)) > 1
    wrong = wrong or bool(others and "int" in words and others != ["char"])
    if wrong:
        raise CError(place, f"{' '.join(words)} is no type")
