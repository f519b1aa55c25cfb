"""Expressions as Python."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

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
    UCHAR,
    ArrayType,
    FloatType,
    IntType,
    PointerType,
    Symbol,
)
from bgi.turboc.emitter.wrapping import cut
from bgi.turboc.port import walking
from bgi.turboc.port.magnitudes import HIGHEST, magnitude
from bgi.turboc.port.pointershapes import CURSOR, TEXT
from bgi.turboc.port.porttests import PortTests
from bgi.turboc.port.pycode import (
    WALRUS,
    Code,
    binary,
    call,
    quoted,
    signed,
)


class PortValues(PortTests):
    """Writes values."""

    held: Value | None = None
    """A step in a condition that is done in the loop, at its beginning."""

    present: tuple[Code, ...] = ()
    """What the targets of the updates around hold."""

    def value(self, value: Value) -> Code:
        """A value; a whole number is cut to its 16 bits where it may have more of them."""
        code = self.raw(value)
        type_ = value.type
        if isinstance(type_, IntType) and self.is_seen(value):
            if not type_.signed:
                return binary("&", code, Code("0xFFFF"))
            return call(self.helpers.use("int16"), [code])
        return code

    def is_seen(self, value: Value) -> bool:
        """Whether a number of 16 bits may well be too large for them."""
        type_ = value.type
        if not isinstance(type_, IntType) or type_.bits != 16:
            return False
        computed = isinstance(value, (Arithmetic, Signed, Converted))
        return computed and magnitude(value, self.facts.known) > HIGHEST

    def raw(self, value: Value) -> Code:
        """A value; a whole number may have more bits than its type."""
        return self.names.named(value) or _WRITERS[type(value)](self, value)

    # Numbers

    def constant(self, value: Constant) -> Code:
        if isinstance(value.type, PointerType):
            return Code("None")
        if value.written is not None and not isinstance(value.written, Variable):
            code = self._written(value)
            if code is not None:
                return code
        return self.literal(value)

    def _written(self, value: Constant) -> Code | None:
        """A constant as it was computed, if Python comes to the same."""
        written = value.written
        assert written is not None
        code = self.value(written)
        known: dict[str, Any] = {"int": int, "ord": ord}
        for one in walking.whole(written):
            named = self.names.named(one) if isinstance(one, Constant) else None
            if named is not None:
                known[str(named)] = one.value  # type: ignore[attr-defined]
        try:
            same = eval(code, {"__builtins__": {}}, known) == value.value
        except Exception:
            same = False
        return code if same else None

    def literal(self, value: Constant) -> Code:
        """A number as it was written: characters and hexadecimal numbers stay such."""
        word, number = self.names.word(value.place), value.value
        if word[:1] == "'" and isinstance(number, int) and -128 <= number < 256:
            if number & 0xFF >= 32 and number & 0xFF != 127 and number > 0:
                return Code(f"ord({quoted(bytes([number & 0xFF]).decode('cp437'))})")
            return Code(repr(number))
        if word[:2].lower() == "0x" and int(word, 16) == number:
            return Code(word.lower().replace("0x", "0x") if len(word) < 5 else word)
        if isinstance(number, float):
            return self._real(word, number)
        return Code(repr(number), 17 if number >= 0 else 14)

    def _real(self, word: str, number: float) -> Code:
        try:
            said = float(word)
        except ValueError:
            said = number
        text = repr(said if abs(said - number) <= abs(number) * 1e-6 else number)
        if word.isdecimal() and text.endswith(".0"):
            text = text[:-2]
        elif text != "nan" and said == float(text) and word[:1].isdigit() and "e" in word.lower():
            text = word
        if text in ("inf", "nan", "-inf"):
            return Code(f'float("{text}")')
        return Code(text, 14 if text[0] == "-" else 17)

    # Places

    def _text(self, value: Quoted) -> Code:
        return quoted(value.data.partition(b"\0")[0].decode("cp437"))

    def _variable(self, value: Variable) -> Code:
        return self.variable(value.symbol)

    def _field(self, value: Field) -> Code:
        return self.place_code(value)

    def _element(self, value: Element) -> Code:
        if value.type in (CHAR, UCHAR) and self.shapes.shape(value.base) == TEXT:
            base = value.base
            text = self.place_code(base) if isinstance(base.type, ArrayType) else self.value(base)
            return call(self.helpers.use("char_at"), [text, self.value(value.index)])
        return self.place_code(value)

    def _referred(self, value: Referred) -> Code:
        return self.place_code(value)

    def _itself(self, value: Itself) -> Code:
        return Code("self")

    def _addressed(self, value: Address) -> Code:
        return self.pointer(value, self.shapes.shape(value))

    def _further(self, value: Offset) -> Code:
        return self.pointer(value, self.shapes.shape(value) or CURSOR)

    def _present(self, value: Present) -> Code:
        return self.present[-1]

    # Operations

    def _signed(self, value: Signed) -> Code:
        return signed(value.op, self.raw(value.operand))

    def _truth(self, value: Value) -> Code:
        return call("int", [self.test(value)])

    def _arithmetic(self, value: Arithmetic) -> Code:
        op, left, right = value.op, value.left, value.right
        if op in ("/", "%") and isinstance(value.type, IntType):
            return self._division(value)
        if op in ("+", "-", "*") and isinstance(value.type, IntType):
            return binary(op, self.raw(left), self.raw(right))
        return binary(op, self.value(left), self.value(right))

    def _division(self, value: Arithmetic) -> Code:
        """C divides towards zero, Python downwards."""
        left, right = self.value(value.left), self.value(value.right)
        known = self.facts.known
        if self.positive(value.left) and cut(value.right, known)[0] >= 0:
            return binary("//" if value.op == "/" else "%", left, right)
        if value.op == "/":
            return call("int", [binary("/", left, right)])
        return call("int", [call(self.names.use("math", "fmod"), [left, right])])

    def positive(self, value: Value) -> bool:
        """Whether a number is known not to be negative."""
        return cut(value, self.facts.known)[0] >= 0

    def _distance(self, value: Distance) -> Code:
        return binary("-", self.pointer(value.left, CURSOR), self.pointer(value.right, CURSOR))

    def _converted(self, value: Converted) -> Code:
        type_, operand = value.type, value.operand
        if isinstance(type_, PointerType) and isinstance(operand.type, PointerType):
            return self.value(operand)
        if isinstance(type_, IntType) and isinstance(operand.type, FloatType):
            return call("int", [self.value(operand)])
        if isinstance(type_, PointerType):
            if isinstance(operand.type, IntType):
                raise self.refuse(value.place, "a number used as an address")
            return self.value(operand)
        if isinstance(type_, IntType) and isinstance(operand.type, IntType):
            return self.raw(operand) if type_.bits <= operand.type.bits else self.value(operand)
        if isinstance(operand.type, PointerType) and isinstance(type_, IntType):
            raise self.refuse(value.place, "a pointer used as a number")
        return self.value(operand)

    # Assignments in values

    def _store(self, value: Store) -> Code:
        target = value.target
        simple = isinstance(target, Variable) and target.symbol not in self.cells
        if self.walrus and simple:
            code = self.assigned_value(value)
            return Code(f"{self.target(target)} := {code.inside(WALRUS + 1)}", WALRUS)
        self.effect(value)
        return self.value(target)

    def assigned_value(self, value: Store) -> Code:
        """What is assigned."""
        raise NotImplementedError

    def effect(self, value: Value) -> None:
        """A value that is computed for its effects."""
        raise NotImplementedError

    def _update(self, value: Update) -> Code:
        if self.walrus and isinstance(value.target, Variable):
            code = self.updated(value)
            return Code(f"{self.target(value.target)} := {code.inside(WALRUS + 1)}", WALRUS)
        self.effect(value)
        return self.value(value.target)

    def updated(self, value: Update) -> Code:
        """What an update stores."""
        self.present = (*self.present, self.place_code(value.target))
        code = (
            self.given(value.result, self.shapes.shape(value.target))
            if isinstance(value.type, PointerType)
            else self.value(value.result)
        )
        self.present = self.present[:-1]
        return code

    def _step(self, value: Advance) -> Code:
        target, sign = self.target(value.target), "+" if value.by > 0 else "-"
        inner = value.target
        if value is self.held:
            return target
        later = self.after is not None and value.postfix and isinstance(inner, Variable)
        if self.after is not None and later and self.waits(inner.symbol):  # type: ignore[attr-defined]
            self.after.append(f"{target} {sign}= 1")
            return target
        if self.walrus and isinstance(value.target, Variable):
            code = Code(f"{target} := {target} {sign} 1", WALRUS)
        else:
            self.line(f"{target} {sign}= 1")
            code = target
        if not value.postfix:
            return code
        back = "-" if sign == "+" else "+"
        return binary(back, Code(f"({code})") if code.level == WALRUS else code, Code("1"))

    def waits(self, symbol: Symbol) -> bool:
        """Whether a variable may be stepped behind the statement that it is used in."""
        raise NotImplementedError

    def _sequence(self, value: Sequence) -> Code:
        for item in value.items[:-1]:
            self.effect(item)
        return self.value(value.items[-1])

    # What others write

    def _invocation(self, value: Invocation) -> Code:
        return self.invocation(value)

    def invocation(self, value: Invocation) -> Code:
        """A call of a function of the program."""
        raise NotImplementedError

    def method(self, value: MethodCall) -> Code:
        """A call of a method."""
        raise NotImplementedError

    def library(self, value: LibraryCall) -> Code:
        """A call of a function of the library."""
        raise NotImplementedError

    def listed(self, value: Listed) -> Code:
        """Initial values."""
        raise NotImplementedError

    def destroyed(self, value: Destruction) -> Code:
        """`delete`"""
        raise NotImplementedError


_WRITERS: dict[type, Callable[[Any, Any], Code]] = {
    Constant: PortValues.constant,
    Quoted: PortValues._text,
    Variable: PortValues._variable,
    Itself: PortValues._itself,
    Field: PortValues._field,
    Element: PortValues._element,
    Referred: PortValues._referred,
    Address: PortValues._addressed,
    Present: PortValues._present,
    Converted: PortValues._converted,
    Signed: PortValues._signed,
    Inverse: PortValues._truth,
    Comparison: PortValues._truth,
    Connective: PortValues._truth,
    Arithmetic: PortValues._arithmetic,
    Offset: PortValues._further,
    Distance: PortValues._distance,
    Store: PortValues._store,
    Update: PortValues._update,
    Advance: PortValues._step,
    Choice: PortTests.chosen,
    Sequence: PortValues._sequence,
    Invocation: lambda writer, value: writer.invocation(value),
    LibraryCall: lambda writer, value: writer.library(value),
    MethodCall: lambda writer, value: writer.method(value),
    Creation: lambda writer, value: writer.created(value),
    Destruction: lambda writer, value: writer.destroyed(value),
    Listed: lambda writer, value: writer.listed(value),
}
