"""The tree of a C or C++ program, as it is written: nothing is resolved yet.

Every node knows its place. `TypeName` is a type as it is written; what it means, `types` says.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from bgi.turboc.errors import Place

# Types as they are written


@dataclass(frozen=True, slots=True)
class TypeName:
    """A type: what it is built from, outermost first in `parts`.

    `int (*p)[3]` has the base int and the parts pointer, array of 3.
    """

    place: Place
    base: Base
    parts: tuple[Part, ...] = ()


@dataclass(frozen=True, slots=True)
class Words:
    """A base of keywords, sorted: `unsigned`, `long`, `int` ...; none at all means int."""

    words: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Named:
    """A typedef's name, or that of a class."""

    name: str


@dataclass(frozen=True, slots=True)
class Tagged:
    """`struct name`, `union name`, `class name` or `enum name`; defined by a node of its own."""

    kind: str
    tag: str


Base = Words | Named | Tagged


@dataclass(frozen=True, slots=True)
class PointerPart:
    """`*`"""


@dataclass(frozen=True, slots=True)
class ReferencePart:
    """`&`"""


@dataclass(frozen=True, slots=True)
class ArrayPart:
    """`[size]`; None without a size."""

    size: Expr | None


@dataclass(frozen=True, slots=True)
class FunctionPart:
    """`(parameters)`; `open` if `...` ends them, or nothing was said of them as in `f()` of C."""

    parameters: tuple[Parameter, ...]
    open: bool = False


Part = PointerPart | ReferencePart | ArrayPart | FunctionPart


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter; its name may be missing."""

    place: Place
    name: str
    type: TypeName
    default: Expr | None = None


# Expressions


@dataclass(frozen=True, slots=True)
class IntLit:
    """A whole number; `suffix` holds u and l as written, in lower case."""

    place: Place
    value: int
    suffix: str = ""
    decimal: bool = True


@dataclass(frozen=True, slots=True)
class FloatLit:
    """A real number; `suffix` is f, l or empty."""

    place: Place
    value: float
    suffix: str = ""


@dataclass(frozen=True, slots=True)
class CharLit:
    """A character: its code, as a signed char."""

    place: Place
    value: int


@dataclass(frozen=True, slots=True)
class StrLit:
    """A string, without the zero that ends it."""

    place: Place
    value: bytes


@dataclass(frozen=True, slots=True)
class Name:
    """A variable, function, constant; `scope` is the class in `Class::name`, or `::` alone."""

    place: Place
    name: str
    scope: str = ""


@dataclass(frozen=True, slots=True)
class This:
    """`this`"""

    place: Place


@dataclass(frozen=True, slots=True)
class Unary:
    """`- + ! ~ * &` before an operand."""

    place: Place
    op: str
    operand: Expr


@dataclass(frozen=True, slots=True)
class IncDec:
    """`++` or `--`, before its operand or after it."""

    place: Place
    op: str
    operand: Expr
    postfix: bool


@dataclass(frozen=True, slots=True)
class Binary:
    """`* / % + - << >> < > <= >= == != & ^ |`"""

    place: Place
    op: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True)
class Logical:
    """`&&` or `||`"""

    place: Place
    op: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True)
class Assign:
    """`=`, or with another operator before it: `op` is `=`, `+=` ..."""

    place: Place
    op: str
    target: Expr
    value: Expr


@dataclass(frozen=True, slots=True)
class Conditional:
    """`condition ? yes : no`"""

    place: Place
    condition: Expr
    yes: Expr
    no: Expr


@dataclass(frozen=True, slots=True)
class Comma:
    """Expressions in order; the last one's value counts."""

    place: Place
    items: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Call:
    """A call; the function is any expression."""

    place: Place
    function: Expr
    arguments: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Construct:
    """A type called like a function: `int(x)`, `Point(1, 2)`."""

    place: Place
    type: TypeName
    arguments: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Index:
    """`base[index]`"""

    place: Place
    base: Expr
    index: Expr


@dataclass(frozen=True, slots=True)
class Member:
    """`base.name`, or `base->name`; `scope` is the class in `base.Class::name`."""

    place: Place
    base: Expr
    name: str
    arrow: bool
    scope: str = ""


@dataclass(frozen=True, slots=True)
class Cast:
    """`(type) operand`"""

    place: Place
    type: TypeName
    operand: Expr


@dataclass(frozen=True, slots=True)
class SizeofExpr:
    """`sizeof operand`"""

    place: Place
    operand: Expr


@dataclass(frozen=True, slots=True)
class SizeofType:
    """`sizeof(type)`"""

    place: Place
    type: TypeName


@dataclass(frozen=True, slots=True)
class New:
    """`new type`, `new type(arguments)`, `new type[count]`"""

    place: Place
    type: TypeName
    arguments: tuple[Expr, ...] = ()
    count: Expr | None = None


@dataclass(frozen=True, slots=True)
class Delete:
    """`delete operand`, `delete[] operand`"""

    place: Place
    operand: Expr
    array: bool


@dataclass(frozen=True, slots=True)
class Braces:
    """`{ ... }` after a `=`: initial values."""

    place: Place
    items: tuple[Expr, ...]


Expr = (
    IntLit
    | FloatLit
    | CharLit
    | StrLit
    | Name
    | This
    | Unary
    | IncDec
    | Binary
    | Logical
    | Assign
    | Conditional
    | Comma
    | Call
    | Construct
    | Index
    | Member
    | Cast
    | SizeofExpr
    | SizeofType
    | New
    | Delete
    | Braces
)


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
