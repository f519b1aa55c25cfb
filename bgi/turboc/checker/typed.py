"""The typed tree: expressions and statements of which everything is known.

Every value knows its type; what C converts unsaid is a node of its own here. Names are gone: a
`Variable` holds its symbol.
"""

from __future__ import annotations

from dataclasses import dataclass

from bgi.turboc.checker.types import StructType, Symbol, Type
from bgi.turboc.faults import Place

# Values


@dataclass(eq=False, slots=True)
class Value:
    """Something that has a type."""

    place: Place
    type: Type


@dataclass(eq=False, slots=True)
class Constant(Value):
    """A number that is known; 0 as a pointer is null.

    `written` is what it was computed from, a name or an operation, for whoever shows it.
    """

    value: int | float
    written: Value | None = None


@dataclass(eq=False, slots=True)
class Quoted(Value):
    """A string, without the zero that ends it."""

    data: bytes


@dataclass(eq=False, slots=True)
class Variable(Value):
    """A variable, or a function."""

    symbol: Symbol


@dataclass(eq=False, slots=True)
class Itself(Value):
    """The object that `this` points to."""


@dataclass(eq=False, slots=True)
class Field(Value):
    """A member of an object."""

    base: Value
    name: str


@dataclass(eq=False, slots=True)
class Element(Value):
    """`base[index]`, where the base is a pointer or an array; `*base` has the index 0."""

    base: Value
    index: Value


@dataclass(eq=False, slots=True)
class Address(Value):
    """`&operand`; of an array, its first element's."""

    operand: Value


@dataclass(eq=False, slots=True)
class Referred(Value):
    """What a reference stands for."""

    operand: Value


@dataclass(eq=False, slots=True)
class Converted(Value):
    """A value as another type."""

    operand: Value


@dataclass(eq=False, slots=True)
class Signed(Value):
    """`-` or `~` before a number."""

    op: str
    operand: Value


@dataclass(eq=False, slots=True)
class Inverse(Value):
    """`!`"""

    operand: Value


@dataclass(eq=False, slots=True)
class Arithmetic(Value):
    """`* / % + - << >> & ^ |` on numbers of the type of the result."""

    op: str
    left: Value
    right: Value


@dataclass(eq=False, slots=True)
class Offset(Value):
    """A pointer that is so many elements further."""

    base: Value
    count: Value


@dataclass(eq=False, slots=True)
class Distance(Value):
    """How many elements lie between two pointers."""

    left: Value
    right: Value


@dataclass(eq=False, slots=True)
class Comparison(Value):
    """`< > <= >= == !=` on two numbers of one type, or two pointers."""

    op: str
    left: Value
    right: Value


@dataclass(eq=False, slots=True)
class Connective(Value):
    """`&&` or `||`"""

    op: str
    left: Value
    right: Value


@dataclass(eq=False, slots=True)
class Store(Value):
    """`target = value`"""

    target: Value
    value: Value


@dataclass(eq=False, slots=True)
class Update(Value):
    """`target op= value`: `result` is an operation whose left side stands for the target."""

    target: Value
    result: Value


@dataclass(eq=False, slots=True)
class Present(Value):
    """What the target of an update holds before it."""


@dataclass(eq=False, slots=True)
class Advance(Value):
    """`++` and `--`: `by` is 1 or -1."""

    target: Value
    by: int
    postfix: bool


@dataclass(eq=False, slots=True)
class Choice(Value):
    """`condition ? yes : no`"""

    condition: Value
    yes: Value
    no: Value


@dataclass(eq=False, slots=True)
class Sequence(Value):
    """Values in order, the last of which counts."""

    items: tuple[Value, ...]


@dataclass(eq=False, slots=True)
class Invocation(Value):
    """A call of a function of the program, or through a pointer."""

    function: Value
    arguments: tuple[Value, ...]


@dataclass(eq=False, slots=True)
class LibraryCall(Value):
    """A call of a function of the library."""

    name: str
    arguments: tuple[Value, ...]


@dataclass(eq=False, slots=True)
class MethodCall(Value):
    """A call of a method; `exact` if the class is known, and no other's method is meant."""

    base: Value
    method: Symbol
    arguments: tuple[Value, ...]
    exact: bool


@dataclass(eq=False, slots=True)
class Creation(Value):
    """A new object, array or number, in memory of its own if the type is a pointer."""

    what: Type
    count: Value | None
    constructor: Symbol | None
    arguments: tuple[Value, ...]


@dataclass(eq=False, slots=True)
class Destruction(Value):
    """`delete`"""

    operand: Value
    destructor: Symbol | None
    array: bool


@dataclass(eq=False, slots=True)
class Listed(Value):
    """Initial values of an array or a struct: those that are missing are None."""

    items: tuple[Value | None, ...]


# Statements


@dataclass(eq=False, slots=True)
class Act:
    """A statement."""

    place: Place


@dataclass(eq=False, slots=True)
class Compute(Act):
    """A value that is computed for its effects."""

    value: Value


@dataclass(eq=False, slots=True)
class Define(Act):
    """A variable comes to life; without a value where it holds anything."""

    symbol: Symbol
    value: Value | None


@dataclass(eq=False, slots=True)
class Group(Act):
    """A block; `ending` are the objects that end with it."""

    items: list[Act]
    ending: tuple[Symbol, ...] = ()


@dataclass(eq=False, slots=True)
class Branch(Act):
    """`if`"""

    condition: Value
    yes: Act
    no: Act | None


@dataclass(eq=False, slots=True)
class Loop(Act):
    """`while`, `for`, and `do` if it is tested `late`; without a condition it is endless."""

    first: Act | None
    condition: Value | None
    step: Value | None
    body: Act
    late: bool = False


@dataclass(eq=False, slots=True)
class Select(Act):
    """`switch`: parts from one case to the next, each with its values; None is the default.

    `written` are the cases as the program writes them.
    """

    value: Value
    parts: list[tuple[list[int | None], list[Act]]]
    written: dict[int, Value]


@dataclass(eq=False, slots=True)
class Leave(Act):
    """`break`"""


@dataclass(eq=False, slots=True)
class Again(Act):
    """`continue`"""


@dataclass(eq=False, slots=True)
class Give(Act):
    """`return`"""

    value: Value | None


@dataclass(eq=False, slots=True)
class Jump(Act):
    """`goto`"""

    label: str


@dataclass(eq=False, slots=True)
class Mark(Act):
    """A label."""

    label: str


# Programs


@dataclass(eq=False, slots=True)
class Routine:
    """A function with its body."""

    symbol: Symbol
    parameters: list[Symbol]
    body: Group
    variables: list[Symbol]
    """Its local variables."""
    before: list[Act]
    """Of a constructor: what constructs the base and the members."""
    after: list[Act]
    """Of a destructor: what destroys them."""
    jumps: bool
    """Whether there is a goto in it."""


@dataclass(eq=False, slots=True)
class TypedProgram:
    """A whole program."""

    structs: list[StructType]
    globals: list[Define]
    routines: list[Routine]
    main: Symbol
