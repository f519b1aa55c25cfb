"""Types and expressions of a program as they are written: nothing is resolved yet.

Every node knows its place. `TypeName` is a type; what it means is found out later.
"""

from __future__ import annotations

from dataclasses import dataclass

from bgi.turboc.faults import Place

# Types


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
