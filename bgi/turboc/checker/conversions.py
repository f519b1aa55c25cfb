"""What C converts, said or unsaid: a value as another type."""

from __future__ import annotations

from bgi.turboc.checker.folding import arithmetic, comparison, fitted
from bgi.turboc.checker.typed import (
    Address,
    Arithmetic,
    Choice,
    Comparison,
    Constant,
    Converted,
    Element,
    Field,
    MethodCall,
    Referred,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    DOUBLE,
    INT,
    VOID,
    ArrayType,
    FloatType,
    FunctionType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Type,
    common,
    described,
    is_number,
    promoted,
)
from bgi.turboc.faults import CError


def decayed(value: Value) -> Value:
    """An array as the address of its first element, a function as its own; others as they are."""
    if isinstance(value.type, ArrayType):
        return Address(value.place, PointerType(value.type.of), value)
    if isinstance(value.type, FunctionType):
        return Converted(value.place, PointerType(value.type), value)
    return value


def is_place(value: Value) -> bool:
    """Whether a value stands somewhere in memory, so that one can write there."""
    if isinstance(value, Variable):
        return value.symbol.kind not in ("function", "constant", "method")
    return isinstance(value, (Field, Element, Referred))


def addressed(value: Value) -> None:
    """Remember that the address of a variable is taken."""
    if isinstance(value, Variable):
        value.symbol.addressed = True
        value.symbol.written += 1


def passed(value: Value) -> Value:
    """A value where nobody says which type is wanted: char as int, float as double."""
    value = decayed(value)
    if isinstance(value.type, IntType):
        return converted(value, promoted(value.type))
    return converted(value, DOUBLE) if isinstance(value.type, FloatType) else value


def converted(value: Value, type_: Type, forced: bool = False) -> Value:
    """A value as another type; CError if that cannot be.

    Args:
        value: the value.
        type_: the other type.
        forced: whether the program itself says so, by a cast.
    """
    if isinstance(type_, ReferenceType):
        return _referred(value, type_)
    value = decayed(value)
    if value.type == type_:
        return value
    if type_ == VOID:
        return Converted(value.place, VOID, value)
    if is_number(type_) and is_number(value.type):
        if isinstance(value, Constant):
            return Constant(value.place, type_, fitted(value.value, type_), value.written)
        return Converted(value.place, type_, value)
    if isinstance(type_, PointerType) and _points(value, type_, forced):
        return Converted(value.place, type_, value)
    if isinstance(value.type, PointerType) and isinstance(type_, IntType):
        return Converted(value.place, type_, value)
    if isinstance(value.type, StructType) and value.type.descends(type_):
        return Converted(value.place, type_, value)
    made = as_other(value, type_) if isinstance(value.type, StructType) else None
    if made is not None:
        return converted(made, type_)
    raise CError(value.place, f"{described(value.type)} cannot become {described(type_)}")


def as_other(value: Value, type_: Type | None = None) -> Value | None:
    """An object as another type, or as any number: by the operator of its class, if it has one."""
    cls = value.type if isinstance(value.type, StructType) else None
    found: list[Value] = []
    while cls is not None:
        for name, methods in cls.methods.items():
            function = methods[0].type
            if name.startswith("operator ") and isinstance(function, FunctionType):
                exact = not methods[0].virtual
                call = MethodCall(value.place, function.result, value, methods[0], (), exact)
                found.append(call)
        cls = cls.base
    number = type_ is None or is_number(type_)
    usable = [one for one in found if one.type == type_ or (number and is_number(one.type))]
    return next((one for one in usable if one.type == type_), usable[0] if usable else None)


def _points(value: Value, type_: PointerType, forced: bool) -> bool:
    """Whether a value can become a pointer."""
    if isinstance(value.type, PointerType):
        return True
    if isinstance(value, Constant) and value.value == 0:
        return True
    return forced and isinstance(value.type, IntType)


def _referred(value: Value, type_: ReferenceType) -> Value:
    """What a reference is bound to; a value that stands nowhere gets a place of its own."""
    same = value.type == type_.to or (
        isinstance(value.type, StructType) and value.type.descends(type_.to)
    )
    if not same:
        value = converted(value, type_.to)
    if isinstance(value, Choice) and is_place(value.yes) and is_place(value.no):
        either = _referred(value.yes, type_), _referred(value.no, type_)
        return Choice(value.place, type_, value.condition, *either)
    if is_place(value):
        addressed(value)
    return Address(value.place, type_, value)


def calculated(op: str, left: Value, right: Value) -> Value:
    """An operation on two numbers, in the type where they meet."""
    if op in ("<<", ">>"):
        type_: Type = promoted(left.type) if isinstance(left.type, IntType) else left.type
        right = converted(right, promoted(right.type) if isinstance(right.type, IntType) else INT)
    else:
        type_ = common(left.type, right.type)
        right = converted(right, type_)
    left = converted(left, type_)
    whole = op in ("<<", ">>", "%", "&", "|", "^")
    if whole and not (isinstance(type_, IntType) and isinstance(right.type, IntType)):
        raise CError(left.place, f"{op} is for whole numbers only")
    if isinstance(left, Constant) and isinstance(right, Constant):
        result = arithmetic(op, left.value, right.value, type_)
        if result is not None:
            written = Arithmetic(left.place, type_, op, left, right)
            return Constant(left.place, type_, result, written)
    return Arithmetic(left.place, type_, op, left, right)


def compared(op: str, left: Value, right: Value) -> Value:
    """A comparison of two numbers, or of two pointers."""
    if is_number(left.type) and is_number(right.type):
        type_ = common(left.type, right.type)
        left, right = converted(left, type_), converted(right, type_)
        if isinstance(left, Constant) and isinstance(right, Constant):
            return Constant(left.place, INT, comparison(op, left.value, right.value))
    elif isinstance(left.type, PointerType):
        right = converted(right, left.type, forced=True)
    else:
        left = converted(left, right.type, forced=True)
    return Comparison(left.place, INT, op, left, right)
