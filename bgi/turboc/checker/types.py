"""C's types: their sizes and ranges, and what becomes of two of them in one expression."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from bgi.turboc.faults import NOWHERE, Place


@dataclass(frozen=True, slots=True)
class VoidType:
    """`void`"""


@dataclass(frozen=True, slots=True)
class IntType:
    """A whole number: `char` has 8 bits, `int` 16, `long` 32."""

    bits: int
    signed: bool = True

    @property
    def low(self) -> int:
        """The smallest number."""
        return -(1 << self.bits - 1) if self.signed else 0

    @property
    def high(self) -> int:
        """The largest number."""
        return (1 << self.bits - self.signed) - 1


@dataclass(frozen=True, slots=True)
class FloatType:
    """A real number: `float` has 32 bits, `double` 64, `long double` 80."""

    bits: int


@dataclass(frozen=True, slots=True)
class PointerType:
    """A pointer; `const` if what it points to is only read."""

    to: Type
    const: bool = field(default=False, compare=False)


@dataclass(frozen=True, slots=True)
class ReferenceType:
    """A reference of C++."""

    to: Type


@dataclass(frozen=True, slots=True)
class ArrayType:
    """An array; its count is 0 as long as nobody has said it."""

    of: Type
    count: int


@dataclass(frozen=True, slots=True)
class FunctionType:
    """A function; `open` if more arguments may follow."""

    result: Type
    parameters: tuple[Type, ...]
    open: bool = False


@dataclass(eq=False, slots=True)
class StructType:
    """A struct, union or class; two are the same only if they are one."""

    tag: str
    kind: str = "struct"
    complete: bool = False
    members: dict[str, Type] = field(default_factory=dict)
    """Its own data, in order; those of its base come before them."""
    base: StructType | None = None
    methods: dict[str, list[Symbol]] = field(default_factory=dict)
    """By name, all that are called so; the constructors are called as the class is."""
    statics: dict[str, Symbol] = field(default_factory=dict)
    """Static members, constants of its enums."""
    python: str = ""
    """What its Python class is called."""
    library: bool = False
    """Whether it is one of the library's."""
    pure: frozenset[str] = frozenset()
    """Its own virtual methods that have no body."""
    place: Place = NOWHERE
    """Where it is defined."""
    alias: str = ""
    """What a typedef calls it."""

    def missing(self) -> frozenset[str]:
        """The methods without a body, its own and those of its bases that nobody has given one."""
        inherited = self.base.missing() if self.base else frozenset()
        return (inherited - frozenset(self.methods)) | self.pure

    def member(self, name: str) -> Type | None:
        """The type of a member, its own or a base's."""
        found = self.members.get(name)
        return found if found is not None or self.base is None else self.base.member(name)

    def method(self, name: str) -> list[Symbol]:
        """The methods of a name; those of a class hide those of its base."""
        found = self.methods.get(name, [])
        return found if found or self.base is None else self.base.method(name)

    def static(self, name: str) -> Symbol | None:
        """A static member, its own or a base's."""
        found = self.statics.get(name)
        return found if found is not None or self.base is None else self.base.static(name)

    def descends(self, other: Type) -> bool:
        """Whether it is that class, or derived from it."""
        one: StructType | None = self
        while one is not None and one is not other:
            one = one.base
        return one is not None

    def all_members(self) -> dict[str, Type]:
        """Its data with those of its bases, in the order of memory."""
        return {**(self.base.all_members() if self.base else {}), **self.members}


Type = (
    VoidType
    | IntType
    | FloatType
    | PointerType
    | ReferenceType
    | ArrayType
    | FunctionType
    | StructType
)


@dataclass(eq=False, slots=True)
class Symbol:
    """A variable, function or constant.

    `kind` is global, local, parameter, function, method, constant or library.
    """

    name: str
    type: Type
    place: Place
    kind: str
    python: str = ""
    """What it is called in Python."""
    addressed: bool = False
    """Whether its address is taken, so that it has to live in a cell."""
    value: int | float = 0
    """Of a constant."""
    defaults: tuple[Any, ...] = ()
    """Default arguments of a function: typed values, or None."""
    owner: StructType | None = None
    """The class of a method."""
    virtual: bool = False
    static: bool = False
    defined: bool = False
    written: int = 0
    """How often it is assigned to."""


VOID = VoidType()
CHAR = IntType(8)
UCHAR = IntType(8, signed=False)
INT = IntType(16)
UNSIGNED = IntType(16, signed=False)
LONG = IntType(32)
ULONG = IntType(32, signed=False)
FLOAT = FloatType(32)
DOUBLE = FloatType(64)
LONG_DOUBLE = FloatType(80)

_WORDS: dict[tuple[str, ...], Type] = {
    (): INT,
    ("void",): VOID,
    ("char",): CHAR,
    ("int",): INT,
    ("short",): INT,
    ("long",): LONG,
    ("float",): FLOAT,
    ("double",): DOUBLE,
    ("double", "long"): LONG_DOUBLE,
}


def of_words(words: tuple[str, ...]) -> Type:
    """The type of C's own words: `unsigned long int`."""
    sizes = tuple(word for word in words if word not in ("signed", "unsigned"))
    if len(sizes) > 1:
        sizes = tuple(word for word in sizes if word != "int")
    found = _WORDS.get(sizes, INT if "short" in sizes else LONG)
    if "unsigned" in words and isinstance(found, IntType):
        return IntType(found.bits, signed=False)
    return found


def is_number(type_: Type) -> bool:
    """Whether one can compute with it."""
    return isinstance(type_, (IntType, FloatType))


def is_text(type_: Type) -> bool:
    """Whether it points to characters."""
    return isinstance(type_, PointerType) and type_.to in (CHAR, UCHAR)


def promoted(type_: IntType) -> IntType:
    """What a whole number becomes in an expression: at least an int."""
    return INT if type_.bits < INT.bits else type_


def common(left: Type, right: Type) -> Type:
    """The type in which two numbers meet: the usual arithmetic conversions."""
    if isinstance(left, FloatType) or isinstance(right, FloatType):
        real = [one for one in (left, right) if isinstance(one, FloatType)]
        return max(real, key=lambda one: one.bits)
    assert isinstance(left, IntType) and isinstance(right, IntType)
    left, right = promoted(left), promoted(right)
    if left.bits != right.bits:
        return max(left, right, key=lambda one: one.bits)
    return left if not left.signed else right


def size(type_: Type) -> int:
    """How many bytes it takes, as Turbo C packs them in its large memory model."""
    match type_:
        case IntType(bits) | FloatType(bits):
            return bits // 8
        case ArrayType(of, count):
            return count * size(of)
        case StructType():
            sizes = _sizes(type_.all_members().values())
            return (max if type_.kind == "union" else sum)(sizes) if sizes else 1
        case ReferenceType(to):
            return size(to)
        case VoidType():
            return 1
    return 4


def _sizes(members: Iterable[Type]) -> list[int]:
    """The bytes of each member; bit fields beside each other share words."""
    sizes: list[int] = []
    free = 0
    for one in members:
        if isinstance(one, IntType) and one.bits not in (8, 16, 32):
            if one.bits > free:
                sizes.append(2)
                free = 16
            free -= one.bits
        else:
            sizes.append(size(one))
            free = 0
    return sizes


def flat(type_: Type) -> int:
    """How many elements it takes in the memory of an array."""
    return type_.count * flat(type_.of) if isinstance(type_, ArrayType) else 1


def innermost(type_: Type) -> Type:
    """What an array of any depth consists of."""
    return innermost(type_.of) if isinstance(type_, ArrayType) else type_


_NAMES = {
    **{VOID: "void", CHAR: "char", UCHAR: "unsigned char", INT: "int", UNSIGNED: "unsigned"},
    **{LONG: "long", ULONG: "unsigned long", FLOAT: "float", DOUBLE: "double"},
    LONG_DOUBLE: "long double",
}


def described(type_: Type) -> str:
    """A type as messages name it."""
    match type_:
        case PointerType(to):
            return f"{described(to)} *"
        case ReferenceType(to):
            return f"{described(to)} &"
        case ArrayType(of, count):
            return f"{described(of)}[{count or ''}]"
        case FunctionType(result, parameters):
            return f"{described(result)}({', '.join(map(described, parameters))})"
        case StructType():
            return type_.tag if not type_.tag[0].isdigit() else type_.kind
    return _NAMES.get(type_, "int")
