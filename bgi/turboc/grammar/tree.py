"""Declarations and statements: the tree of a whole program, as it is written.

Every node knows its place.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from bgi.turboc.faults import Place
from bgi.turboc.grammar.nodes import Expr, TypeName

# Declarations


@dataclass(frozen=True, slots=True)
class Declarator:
    """One name that is declared: `storage` is static, extern, typedef, friend or empty.

    `arguments` are those of a constructor, as in `Point p(1, 2)`.
    """

    place: Place
    name: str
    type: TypeName
    initial: Expr | None = None
    arguments: tuple[Expr, ...] | None = None
    storage: str = ""
    const: bool = False
    bits: Expr | None = None
    """How wide a bit field is."""


@dataclass(frozen=True, slots=True)
class Declaration:
    """The names that one declaration declares, in order."""

    place: Place
    names: tuple[Declarator, ...]


@dataclass(frozen=True, slots=True)
class FunctionDef:
    """A function with its body; `cls` is the class whose method it is.

    `initializers` are a constructor's: the name of a member or a base, and its arguments. A
    constructor has the name of its class, a destructor `~` before it, an operator `operator+`.
    """

    place: Place
    name: str
    type: TypeName
    body: Block
    storage: str = ""
    cls: str = ""
    virtual: bool = False
    initializers: tuple[tuple[str, tuple[Expr, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class StructDef:
    """A struct, union or class with its members: declarations, methods, and types in it.

    A member that is only declared is a `Declaration`; a static one has that storage, `virtuals` are
    the names of those that are virtual, `pure` of those that have no body. A tag without a name has
    one made up, which begins with a digit.
    """

    place: Place
    kind: str
    tag: str
    bases: tuple[str, ...] = ()
    members: tuple[Member_, ...] = ()
    virtuals: frozenset[str] = frozenset()
    pure: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class EnumDef:
    """An enum: its constants, each with its value if one is written."""

    place: Place
    tag: str
    constants: tuple[tuple[str, Expr | None], ...]


Member_ = Declaration | FunctionDef | StructDef | EnumDef


# Statements


@dataclass(frozen=True, slots=True)
class Block:
    """`{ ... }`"""

    place: Place
    items: tuple[Stmt, ...]


@dataclass(frozen=True, slots=True)
class ExprStmt:
    """An expression, or none: an empty statement."""

    place: Place
    value: Expr | None


@dataclass(frozen=True, slots=True)
class If:
    """`if (condition) yes else no`"""

    place: Place
    condition: Expr
    yes: Stmt
    no: Stmt | None


@dataclass(frozen=True, slots=True)
class While:
    """`while (condition) body`"""

    place: Place
    condition: Expr
    body: Stmt


@dataclass(frozen=True, slots=True)
class DoWhile:
    """`do body while (condition);`"""

    place: Place
    body: Stmt
    condition: Expr


@dataclass(frozen=True, slots=True)
class For:
    """`for (initial; condition; step) body`; the first may declare a variable, which lives on."""

    place: Place
    initial: Stmt | None
    condition: Expr | None
    step: Expr | None
    body: Stmt


@dataclass(frozen=True, slots=True)
class Switch:
    """`switch (value) body`"""

    place: Place
    value: Expr
    body: Stmt


@dataclass(frozen=True, slots=True)
class Case:
    """`case value:`, or `default:`; the statement behind it is the next in the block."""

    place: Place
    value: Expr | None


@dataclass(frozen=True, slots=True)
class Break:
    """`break;`"""

    place: Place


@dataclass(frozen=True, slots=True)
class Continue:
    """`continue;`"""

    place: Place


@dataclass(frozen=True, slots=True)
class Return:
    """`return value;`"""

    place: Place
    value: Expr | None


@dataclass(frozen=True, slots=True)
class Goto:
    """`goto label;`"""

    place: Place
    label: str


@dataclass(frozen=True, slots=True)
class Label:
    """`label:`; the statement behind it is the next in the block."""

    place: Place
    name: str


@dataclass(frozen=True, slots=True)
class Asm:
    """Inline assembler: understood by nobody here."""

    place: Place
    text: str


Stmt = (
    Block
    | ExprStmt
    | Declaration
    | StructDef
    | EnumDef
    | If
    | While
    | DoWhile
    | For
    | Switch
    | Case
    | Break
    | Continue
    | Return
    | Goto
    | Label
    | Asm
)

Top = Declaration | FunctionDef | StructDef | EnumDef | Asm


@dataclass(frozen=True, slots=True)
class Program:
    """A whole program: what stands at its top, in order, and the headers that it includes."""

    items: tuple[Top, ...]
    headers: frozenset[str] = frozenset()
    typedefs: dict[str, TypeName] = field(default_factory=dict)
    """Those of the headers; the program's own are declarations with the storage typedef."""
