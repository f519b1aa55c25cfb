"""What types and names mean: from `TypeName` to types, from names to their symbols."""

from __future__ import annotations

from difflib import get_close_matches

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.scopes import Scope
from bgi.turboc.checker.typed import Constant, Value
from bgi.turboc.checker.types import (
    INT,
    ArrayType,
    FunctionType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    flat,
    of_words,
)
from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar import nodes

MOST_ELEMENTS = 1 << 22
"""Of one array."""


class Meaning:
    """The scopes of a program, and what stands in them."""

    def __init__(self, headers: Headers, cplusplus: bool) -> None:
        self.headers = headers
        self.cplusplus = cplusplus
        self.errors: list[CError] = []
        self.top = self.scope = Scope()
        self.structs: list[StructType] = []
        self.cls: StructType | None = None
        """The class whose method is looked at."""

    def value(self, node: nodes.Expr) -> Value:
        """An expression with its type."""
        raise NotImplementedError

    # Types

    def type(self, written: nodes.TypeName) -> Type:
        """The type that is written."""
        type_ = self._base(written.base, written.place)
        for part in reversed(written.parts):
            type_ = self._part(part, type_, written.place)
        return type_

    def _base(self, base: nodes.Base, place: Place) -> Type:
        match base:
            case nodes.Words(words):
                return of_words(words)
            case nodes.Named(name):
                if self.cplusplus and self._only_declared(name):
                    self.top.types[name] = self.top.types[f"struct {name}"] = StructType(name)
                return self.named_type(name, place)
            case nodes.Tagged("enum", _):
                return INT
            case nodes.Tagged(kind, tag):
                return self.tagged(kind, tag)

    def _only_declared(self, name: str) -> bool:
        """Whether nothing but `class name;` has been said of a class."""
        known = self.scope.find_type(name) or self.scope.find_type(f"struct {name}")
        return known is None and self.headers.type(name) is None

    def named_type(self, name: str, place: Place) -> Type:
        """The type of a name."""
        found = self.scope.find_type(name) or self.scope.find_type(f"struct {name}")
        found = found or self.headers.type(name)
        if found is None:
            raise CError(place, f"there is no type {name}{self._guess(name, [])}")
        return found

    def tagged(self, kind: str, tag: str) -> StructType:
        """The struct of a tag, which may not have been defined yet."""
        found = self.scope.find_type(f"struct {tag}") or self.headers.type(tag)
        if isinstance(found, StructType):
            return found
        made = StructType(tag, kind)
        self.declare_type(f"struct {tag}", made)
        if self.cplusplus:
            self.declare_type(tag, made)
        return made

    def declare_type(self, name: str, type_: Type) -> None:
        """Let a name stand for a type."""
        self.scope.types[name] = type_
        if isinstance(type_, StructType) and name != type_.tag and " " not in name:
            type_.alias = type_.alias or name

    def _part(self, part: nodes.Part, type_: Type, place: Place) -> Type:
        match part:
            case nodes.PointerPart():
                return PointerType(type_)
            case nodes.ReferencePart():
                return ReferenceType(type_)
            case nodes.ArrayPart(size):
                made = ArrayType(type_, self.count(size) if size is not None else 0)
                if flat(made) > MOST_ELEMENTS:
                    raise CError(place, f"an array of {flat(made)} elements is too large")
                return made
            case nodes.FunctionPart(parameters, open_):
                return FunctionType(type_, tuple(map(self.parameter_type, parameters)), open_)

    def parameter_type(self, parameter: nodes.Parameter) -> Type:
        """The type of a parameter: arrays and functions are pointers there."""
        type_ = self.type(parameter.type)
        if isinstance(type_, ArrayType):
            return PointerType(type_.of)
        return PointerType(type_) if isinstance(type_, FunctionType) else type_

    def count(self, node: nodes.Expr) -> int:
        """The number of an array's elements."""
        count = self.constant(node)
        if not 0 < count <= MOST_ELEMENTS:
            raise CError(node.place, f"an array cannot have {count} elements")
        return count

    def constant(self, node: nodes.Expr) -> int:
        """A whole number that has to be known before the program runs."""
        value = self.value(node)
        if isinstance(value, Constant) and isinstance(value.type, IntType):
            return int(value.value)
        raise CError(node.place, "a constant whole number is needed here")

    # Names

    def declare(self, symbol: Symbol) -> None:
        """Let a name stand for a symbol in this scope."""
        self.scope.names[symbol.name] = [symbol]

    def find(self, name: str, scope: str, place: Place) -> list[Symbol]:
        """What a name stands for; CError if that is nothing."""
        if scope and scope != "::":
            constant = self.headers.symbol(f"{scope}::{name}")
            if constant is not None:
                return [constant]
            cls = self.named_type(scope, place)
            static = cls.static(name) if isinstance(cls, StructType) else None
            return [static] if static else []
        found = self.top.names.get(name, []) if scope else self.scope.find(name)
        if not found and (symbol := self.headers.symbol(name)):
            found = [symbol]
        return found

    def unknown(self, name: str, place: Place, type_: Type = INT) -> CError:
        """An error for a name that nothing is known of; it is told once."""
        names = set(self.headers.names())
        scope: Scope | None = self.scope
        while scope is not None:
            names |= set(scope.names)
            scope = scope.outer
        self.top.names[name] = [Symbol(name, type_, place, "global", name)]
        if name in self.headers.refused:
            return CError(place, f"{name} {self.headers.refused[name]}")
        return CError(place, f"there is no {name}{self._guess(name, names)}")

    def _guess(self, name: str, names: set[str] | list[str]) -> str:
        near = [one for one in names if one.lower() == name.lower()]
        near = near or get_close_matches(name, sorted(names), 1, 0.8)
        return f": did you mean {near[0]}?" if near else ""
