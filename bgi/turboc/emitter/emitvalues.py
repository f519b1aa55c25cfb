"""Expressions as Python."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.turboc.checker.conversions import is_place
from bgi.turboc.checker.typed import (
    Address,
    Advance,
    Arithmetic,
    Choice,
    Comparison,
    Connective,
    Constant,
    Converted,
    Creation,
    Destruction,
    Distance,
    Element,
    Field,
    Inverse,
    Invocation,
    Itself,
    LibraryCall,
    Listed,
    MethodCall,
    Offset,
    Present,
    Quoted,
    Referred,
    Sequence,
    Signed,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    FLOAT,
    UCHAR,
    VOID,
    FloatType,
    FunctionType,
    IntType,
    PointerType,
    StructType,
    Type,
    flat,
    innermost,
    size,
)
from bgi.turboc.emitter.effects import order_matters
from bgi.turboc.emitter.emitobjects import Objects
from bgi.turboc.emitter.emitplaces import SIMPLE, Spot, is_cell
from bgi.turboc.emitter.layouts import layout, pointed
from bgi.turboc.emitter.wrapping import cut, fits, interval, wrapped


class ValueWriter(Objects):
    """Writes values."""

    def value(self, value: Value) -> str:
        """A value of its type: whole numbers are cut to their bits where that is to be seen."""
        text = self.raw(value)
        type_ = value.type
        if isinstance(type_, IntType) and not fits(interval(value, self.known), type_):
            return wrapped(text, type_)
        return text

    def raw(self, value: Value) -> str:
        """A value; a whole number may have more bits than its type: the lower ones count."""
        return _WRITERS[type(value)](self, value)

    def test(self, value: Value) -> str:
        """A value that is only asked whether it is 0."""
        match value:
            case Comparison():
                return self.comparison(value)
            case Connective(op=op, left=left, right=right):
                word = "and" if op == "&&" else "or"
                return f"({self.test(left)} {word} {self.test(right)})"
            case Inverse(operand=operand):
                return f"(not {self.test(operand)})"
            case Converted(operand=operand) if isinstance(value.type, (IntType, FloatType)):
                if isinstance(operand.type, IntType) and size(operand.type) <= size(value.type):
                    return self.test(operand)
        if isinstance(value.type, PointerType):
            return f"({self.value(value)} is not None)"
        return self.value(value)

    def comparison(self, value: Comparison) -> str:
        """A comparison, which is True or False."""
        left, right = value.left, value.right
        if value.op in ("==", "!=") and isinstance(right, (Constant, Converted)):
            inner = right.operand if isinstance(right, Converted) else right
            if isinstance(right.type, PointerType) and isinstance(inner, Constant):
                return f"({self.value(left)} is {'not ' * (value.op == '!=')}None)"
        return f"({self.value(left)} {value.op} {self.value(right)})"

    # Literals and variables

    def _constant(self, value: Constant) -> str:
        if isinstance(value.type, PointerType):
            return "None"
        text = repr(value.value)
        if text in ("inf", "nan"):
            return f"float('{text}')"
        return f"({text})" if text.startswith("-") else text

    def _text(self, value: Quoted) -> str:
        return self.string(value)

    def _variable(self, value: Variable) -> str:
        if not is_cell(value.symbol):
            return self.name_of(value.symbol)
        return self.spot(value).read

    def _read(self, value: Value) -> str:
        spot = self.spot(value)
        return self.sequence(spot, [spot.read]) if spot.before else spot.read

    def _itself(self, value: Itself) -> str:
        return "self"

    def _address(self, value: Address) -> str:
        return self.address(value.operand, value.type)

    def _present(self, value: Present) -> str:
        return self.present[-1]

    # Operations

    def _signed(self, value: Signed) -> str:
        return f"({value.op}{self.raw(value.operand)})"

    def _truth(self, value: Value) -> str:
        return f"(1 if {self.test(value)} else 0)"

    def _arithmetic(self, value: Arithmetic) -> str:
        op, left, right = value.op, value.left, value.right
        if isinstance(value.type, FloatType):
            text = f"{self.value(left)} {op} {self.value(right)}"
            return f"single({text})" if value.type == FLOAT else f"({text})"
        if op in ("+", "-", "*"):
            return f"({self.raw(left)} {op} {self.raw(right)})"
        if op in ("/", "%"):
            return self._division(value)
        if op in ("<<", ">>"):
            low, high = cut(right, self.known)
            count = self.value(right)
            if low < 0 or high > 31:
                count = f"({count} & 31)"
            return f"({self.raw(left) if op == '<<' else self.value(left)} {op} {count})"
        return f"({self.value(left)} {op} {self.value(right)})"

    def _division(self, value: Arithmetic) -> str:
        left, right = self.value(value.left), self.value(value.right)
        positive = cut(value.left, self.known)[0] >= 0 and cut(value.right, self.known)[0] >= 0
        if positive:
            return f"({left} {value.op * (1 + (value.op == '/'))} {right})"
        if isinstance(value.right, Constant) and value.right.value > 0:
            name, op = self.temporary(), value.op * (1 + (value.op == "/"))
            return f"({name} {op} {right} if ({name} := {left}) >= 0 else -(-{name} {op} {right}))"
        if value.op == "/":
            return f"int({left} / {right})"
        return f"remainder({left}, {right})"

    def _offset(self, value: Offset) -> str:
        assert isinstance(value.type, PointerType)
        if isinstance(value.base, (Address, Offset)):
            memory, at = self.pointed(value)
            return f"Pointer({memory}, {at})"
        count = self.scaled(self.value(value.count), flat(value.type.to))
        return f"({self.value(value.base)} + {count})"

    def _distance(self, value: Distance) -> str:
        assert isinstance(value.left.type, PointerType)
        text = f"({self.value(value.left)} - {self.value(value.right)})"
        stride = flat(value.left.type.to)
        return text if stride == 1 else f"({text} // {stride})"

    def _converted(self, value: Converted) -> str:
        type_, operand = value.type, value.operand
        if isinstance(type_, IntType) and isinstance(operand.type, IntType):
            narrower = type_.bits <= operand.type.bits  # the bits above are cut once
            return self.raw(operand) if narrower else self.value(operand)
        if isinstance(type_, IntType) and isinstance(operand.type, FloatType):
            return f"int({self.value(operand)})"
        if isinstance(type_, FloatType):
            return self._real(type_, operand)
        if isinstance(type_, IntType):
            return f"number({self.value(operand)})"
        if isinstance(type_, PointerType):
            return self._pointer(type_, operand)
        return self.value(operand)

    def _real(self, type_: FloatType, operand: Value) -> str:
        text = self.value(operand)
        if isinstance(operand.type, IntType):
            if type_ == FLOAT and operand.type.bits > 16:
                return f"single({text})"
            return f"({text} * 1.0)"
        return f"single({text})" if type_ == FLOAT and operand.type != FLOAT else text

    def _pointer(self, type_: PointerType, operand: Value) -> str:
        zero = isinstance(operand, Constant) and not operand.value
        number = isinstance(operand.type, IntType)
        if zero or (number and isinstance(type_.to, FunctionType)):
            return "None"
        text = self.value(operand)
        if number:  # segment and offset, as in (char far *)0xB8000000
            self.used.add("far_pointer")
            text = f"far_pointer({text})"
        bytes_ = (CHAR, UCHAR, VOID)
        from_ = operand.type.to if isinstance(operand.type, PointerType) else VOID
        if (
            (from_ in bytes_ or number)
            and type_.to not in bytes_
            and not isinstance(type_.to, FunctionType)
        ):
            one = innermost(type_.to)
            if one not in bytes_:
                return f"typed({text}, {size(one)}, lambda _n: {self.many(one, '_n')})"
        return text

    # Assignments

    def _store(self, value: Store) -> str:
        spot = self.spot(value.target)
        if isinstance(value.type, StructType):
            return f"{spot.read}.assign({self.value(value.value)})"
        return self.sequence(spot, [spot.store(self.value(value.value))])

    def _update(self, value: Update) -> str:
        spot = self.settled(self.spot(value.target))
        return self.sequence(spot, [spot.store(self.updated(value, spot))])

    def updated(self, value: Update, spot: Spot) -> str:
        """What an update stores."""
        self.present.append(spot.read)
        text = self.value(value.result)
        self.present.pop()
        return text

    def _step(self, value: Advance) -> str:
        spot = self.settled(self.spot(value.target))
        stored = spot.store(self.stepped(value, spot))
        return (
            self.sequence(spot, [spot.read, stored], 0)
            if value.postfix
            else self.sequence(spot, [stored])
        )

    def stepped(self, value: Advance, spot: Spot) -> str:
        """What a step stores."""
        sign = "+" if value.by > 0 else "-"
        type_ = value.type
        if isinstance(type_, PointerType):
            return f"{spot.read} {sign} {flat(type_.to)}"
        text = f"{spot.read} {sign} 1"
        if not isinstance(type_, IntType):
            return text
        low, high = type_.low, type_.high
        if isinstance(value.target, Variable):
            low, high = self.known.get(value.target.symbol, (low, high))
        if fits((low + value.by, high + value.by), type_):
            return text
        if not SIMPLE.fullmatch(spot.read):
            return wrapped(text, type_)
        last, first = (type_.high, type_.low)[:: value.by]
        return f"{text} if {spot.read} != {last} else {first}"

    def sequence(self, spot: Spot, items: list[str], which: int = -1) -> str:
        """Values in order, one of which counts, after what a place needs first."""
        before = [f"{name} := {text}" for name, text in spot.before]
        if not before and len(items) == 1:
            return items[0] if items[0][0] == "(" else f"({items[0]})"
        place = len(before) + (which if which >= 0 else len(items) + which)
        return f"({', '.join(before + items)})[{place}]"

    def _choice(self, value: Choice) -> str:
        condition = self.test(value.condition)
        return f"({self.value(value.yes)} if {condition} else {self.value(value.no)})"

    def _sequence(self, value: Sequence) -> str:
        return f"({', '.join(self.value(item) for item in value.items)})[-1]"

    # Calls

    def arguments(self, values: tuple[Value, ...], types: tuple[Type, ...]) -> tuple[str, str]:
        """The arguments of a call, and what is computed before it: from right to left."""
        texts = [
            self.argument(value, types[place] if place < len(types) else None)
            for place, value in enumerate(values)
        ]
        if not order_matters(values):
            return ", ".join(texts), ""
        before: list[str] = []
        for place in range(len(values) - 1, -1, -1):
            if not isinstance(values[place], Constant):
                name = self.temporary()
                before.append(f"{name} := {texts[place]}")
                texts[place] = name
        return ", ".join(texts), ", ".join(before)

    def argument(self, value: Value, type_: Type | None) -> str:
        """An argument: a string that is only read as its bytes, an object as a copy."""
        read = isinstance(type_, PointerType) and type_.const
        plain = read and isinstance(type_, PointerType) and type_.to == VOID
        if plain and isinstance(value.type, PointerType):
            what = pointed(value)
            if isinstance(what, StructType) and what.library:
                self.used.add(what.python)
            return f"Plain({self.value(value)}, {layout(what)})"
        if read and isinstance(value, Address) and isinstance(value.operand, Quoted):
            return repr(value.operand.data.partition(b"\0")[0])
        return self.given(value)

    def given(self, value: Value) -> str:
        """A value that is given away: an object as a copy, if it stands somewhere."""
        text = self.value(value)
        if isinstance(value.type, StructType) and (is_place(value) or isinstance(value, Itself)):
            return f"{text}.copy()"
        return text

    def called(self, function: str, values: tuple[Value, ...], types: tuple[Type, ...]) -> str:
        """A call of a Python function."""
        texts, before = self.arguments(values, types)
        call = f"{function}({texts})"
        return f"({before}, {call})[-1]" if before else call

    def _invocation(self, value: Invocation) -> str:
        type_ = value.function.type
        if isinstance(type_, PointerType):
            type_ = type_.to
        assert isinstance(type_, FunctionType)
        return self.called(self.value(value.function), value.arguments, ())

    def _library(self, value: LibraryCall) -> str:
        symbol = self.headers.symbol(value.name)
        assert symbol is not None and isinstance(symbol.type, FunctionType)
        self.used.add(value.name)
        return self.called(value.name, value.arguments, symbol.type.parameters)

    def _method(self, value: MethodCall) -> str:
        method, base = value.method, self.value(value.base)
        assert isinstance(method.type, FunctionType) and method.owner is not None
        types = method.type.parameters if method.owner.library else ()
        if method.static:
            return self.called(f"{method.owner.python}.{method.python}", value.arguments, types)
        inherited = method.owner is not value.base.type or method in self.hidden
        if value.exact and (inherited if base == "self" else not method.owner.library):
            texts, before = self.arguments(value.arguments, types)
            call = f"{method.owner.python}.{method.python}({base}{', ' * bool(texts)}{texts})"
            return f"({before}, {call})[-1]" if before else call
        return self.called(f"{base}.{method.python}", value.arguments, types)


_WRITERS: dict[type, Callable[[ValueWriter, Any], str]] = {
    Constant: ValueWriter._constant,
    Quoted: ValueWriter._text,
    Variable: ValueWriter._variable,
    Itself: ValueWriter._itself,
    Field: ValueWriter._read,
    Element: ValueWriter._read,
    Referred: ValueWriter._read,
    Address: ValueWriter._address,
    Present: ValueWriter._present,
    Converted: ValueWriter._converted,
    Signed: ValueWriter._signed,
    Inverse: ValueWriter._truth,
    Comparison: ValueWriter._truth,
    Connective: ValueWriter._truth,
    Arithmetic: ValueWriter._arithmetic,
    Offset: ValueWriter._offset,
    Distance: ValueWriter._distance,
    Store: ValueWriter._store,
    Update: ValueWriter._update,
    Advance: ValueWriter._step,
    Choice: ValueWriter._choice,
    Sequence: ValueWriter._sequence,
    Invocation: ValueWriter._invocation,
    LibraryCall: ValueWriter._library,
    MethodCall: ValueWriter._method,
    Creation: ValueWriter.creation,
    Destruction: ValueWriter.destruction,
    Listed: ValueWriter.listed,
}
