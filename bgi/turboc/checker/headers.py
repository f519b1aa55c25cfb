"""What the headers declare: the library's functions, constants and types, each understood as it is
asked for."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from bgi.turboc.checker.types import (
    CHAR,
    DOUBLE,
    INT,
    LONG,
    UNSIGNED,
    VOID,
    ArrayType,
    FunctionType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    described,
    of_words,
)
from bgi.turboc.faults import NOWHERE
from bgi.turboc.grammar import nodes, tree
from bgi.turboc.grammar.parser import parse
from bgi.turboc.words.lexer import tokens

TEXT = PointerType(CHAR, const=True)
"""A string that a function only reads: it gets the bytes of it."""

DATA = PointerType(VOID, const=True)
"""Memory that a function takes for bytes: it gets them as `Plain`."""

_ENUMS = """
    graphics_errors graphics_drivers graphics_modes COLORS CGA_COLORS EGA_COLORS line_styles
    line_widths font_names text_just putimage_ops fill_patterns text_modes
"""

_KNOWN: dict[str, Type] = {
    **{
        "text": TEXT,
        "data": DATA,
        "size_t": UNSIGNED,
        "time_t": LONG,
        "clock_t": LONG,
        "ptrdiff_t": INT,
    },
    **dict.fromkeys(("streampos", "streamoff", "fpos_t"), LONG),
    **{"va_list": PointerType(VOID), "streamsize": INT, "jmp_buf": ArrayType(INT, 10)},
    **dict.fromkeys(_ENUMS.split(), INT),
}


class Headers:
    """The library as a program sees it."""

    def __init__(
        self,
        functions: Mapping[str, str],
        constants: Mapping[str, int | float],
        types: Mapping[str, str],
        refused: Mapping[str, str],
    ) -> None:
        """
        Args:
            functions: the declaration of each: `int @(int x)`, with `@` for the name.
            constants: their values.
            types: structs and classes, as C++ writes them.
            refused: names of the headers that are not here, and why.
        """
        self._functions, self._constants, self._structs = functions, constants, types
        self.refused = refused
        self._symbols: dict[str, Symbol] = {}
        self._types = dict(_KNOWN)

    @property
    def types(self) -> Iterable[str]:
        """The names of all types that a program sees."""
        return [name for name in (*_KNOWN, *self._structs) if name not in ("text", "data")]

    def names(self) -> Iterable[str]:
        """All names of functions and constants."""
        return [*self._functions, *self._constants]

    def symbol(self, name: str) -> Symbol | None:
        """The function, variable or constant of a name."""
        if name in self._symbols:
            return self._symbols[name]
        if name in self._constants:
            value = self._constants[name]
            made = Symbol(name, _type_of(value), NOWHERE, "constant", name, value=value)
        elif name in self._functions:
            made = self._declared(name, self._functions[name])
        else:
            return None
        self._symbols[name] = made
        return made

    def _declared(self, name: str, declaration: str) -> Symbol:
        items = self._parsed(f"{declaration.replace('@', name)};")
        declaration_ = items[0]
        assert isinstance(declaration_, tree.Declaration)
        type_ = self._meaning(declaration_.names[0].type)
        kind = "library" if isinstance(type_, FunctionType) else "global"
        return Symbol(name, type_, NOWHERE, kind, name)

    def _parsed(self, text: str) -> tuple[tree.Top, ...]:
        return parse(list(tokens(text, "")), [*_KNOWN, *self._structs], True).items

    def type(self, name: str) -> Type | None:
        """The type of a name."""
        if name not in self._types and name in self._structs:
            made = StructType(name, complete=True, library=True, python=f"struct_{name}")
            self._types[name] = made
            self._fill(made, self._structs[name])
        return self._types.get(name)

    def _fill(self, made: StructType, text: str) -> None:
        """Give a class its members and methods."""
        definition = self._parsed(text.replace("@", made.tag))[0]
        assert isinstance(definition, tree.StructDef)
        for base in definition.bases:
            found = self.type(base)
            assert isinstance(found, StructType)
            made.base = found
        for member in definition.members:
            assert isinstance(member, tree.Declaration)
            for one in member.names:
                type_ = self._meaning(one.type)
                if isinstance(type_, FunctionType):
                    python = _method_name(one.name, type_)
                    symbol = Symbol(one.name, type_, NOWHERE, "method", python, owner=made)
                    made.methods.setdefault(one.name, []).append(symbol)
                else:
                    made.members[one.name] = type_

    def _meaning(self, written: nodes.TypeName) -> Type:
        match written.base:
            case nodes.Words(words):
                type_: Type = of_words(words)
            case nodes.Named(name) | nodes.Tagged(_, name):
                found = self.type(name)
                assert found is not None, name
                type_ = found
        for part in reversed(written.parts):
            match part:
                case nodes.PointerPart():
                    type_ = PointerType(type_)
                case nodes.ReferencePart():
                    type_ = ReferenceType(type_)
                case nodes.ArrayPart(size):
                    assert isinstance(size, nodes.IntLit)
                    type_ = ArrayType(type_, size.value)
                case nodes.FunctionPart(parameters, open_):
                    given = tuple(self._meaning(one.type) for one in parameters)
                    type_ = FunctionType(type_, given, open_)
        return type_


def _type_of(value: int | float) -> Type:
    if isinstance(value, float):
        return DOUBLE
    return INT if -0x8000 <= value <= 0x7FFF else UNSIGNED if 0 <= value <= 0xFFFF else LONG


_OPERATORS = {
    **{"<<": "shift_left", ">>": "shift_right", "!": "fails", "=": "assign"},
    **{"==": "equals", "!=": "differs", "<": "less", ">": "greater"},
}


def _method_name(name: str, type_: FunctionType) -> str:
    """What a method of the library is called in Python: operators after what they take."""
    if name.startswith("~"):
        return "destroy_"
    if not name.startswith("operator"):
        return name
    return _OPERATORS[name.removeprefix("operator")] + "".join(
        "_" + _kind(one) for one in type_.parameters
    )


def _kind(type_: Type) -> str:
    return described(type_).replace(" ", "_").replace("*", "pointer").replace("&", "reference")
