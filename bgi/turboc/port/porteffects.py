"""Values that are computed for their effects: assignments and calls as statements."""

from __future__ import annotations

from bgi.turboc.checker.conversions import is_place
from bgi.turboc.checker.typed import (
    Advance,
    Arithmetic,
    Choice,
    Connective,
    Converted,
    Element,
    Invocation,
    LibraryCall,
    MethodCall,
    Offset,
    Present,
    Referred,
    Sequence,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    FloatType,
    IntType,
    PointerType,
    StructType,
    Symbol,
)
from bgi.turboc.emitter.effects import has_effects
from bgi.turboc.port import walking
from bgi.turboc.port.pointershapes import CURSOR, OBJECT, TEXT
from bgi.turboc.port.portclasses import PortClasses
from bgi.turboc.port.pycode import Code, negated
from bgi.turboc.port.singles import loses, place_key

_IN_PLACE = ("+", "-", "*", "/", "//", "%", "<<", ">>", "&", "|", "^")


class PortEffects(PortClasses):
    """Writes assignments and statements that are values."""

    def effect(self, value: Value) -> None:
        """A value that is computed for its effects."""
        outer, self.after = self.after, []
        before, self.walrus = self.walrus, False
        self.statement = value
        self._effect(value)
        for line in self.after:
            self.line(line)
        self.after, self.walrus = outer, before

    statement: Value | None = None
    """The one that is written."""

    def _effect(self, value: Value) -> None:
        match value:
            case Store():
                self._assign(value)
            case Update():
                self._change(value)
            case Advance():
                self._advance(value)
            case Sequence(items=items):
                for item in items:
                    self.effect(item)
            case Converted(operand=operand):
                self._effect(operand)
            case Invocation() | MethodCall():
                code = self.called(value, True)
                if code:
                    self.line(code)
            case LibraryCall():
                self.quiet = True
                self.library_effect(value)
                self.quiet = False
            case Choice(condition=condition, yes=yes, no=no):
                self._either(self.test(condition), yes, no)
            case Connective(op=op, left=left, right=right):
                test = self.test(left)
                self._either(test if op == "&&" else negated(test), right, None)
            case _:
                if has_effects(value):
                    code = self.value(value)
                    if "(" in code:
                        self.line(code)

    def _either(self, condition: Code, yes: Value, no: Value | None) -> None:
        with self.block(f"if {condition}:"):
            self.effect(yes)
        if no is not None:
            with self.block("else:"):
                self.effect(no)

    # Assignments

    def _assign(self, value: Store) -> None:
        targets = [value.target]
        given = value.value
        while True:
            inner = given.operand if isinstance(given, Converted) else given
            numbers = not isinstance(given.type, (PointerType, StructType))
            narrowed = isinstance(given.type, IntType) and isinstance(inner.type, FloatType)
            if not (isinstance(inner, Store) and numbers and not narrowed):
                break
            targets.append(inner.target)
            given = inner.value
        last = Store(value.place, targets[-1].type, targets[-1], given)
        if isinstance(value.type, StructType) and self._is_reached(value.target):
            copied = self.copied(value.value)
            if copied.startswith("copy("):
                copied = self.value(value.value)
            self.line(f"vars({self.value(value.target)}).update(vars({copied}))")
            return
        if len(targets) == 1 and self._in_place(last):
            return
        codes = [self.target(one) for one in targets]
        self.answer = codes[0] if len(codes) == 1 else None
        code = self.assigned_value(last)
        self.answer = None
        if codes != [code]:
            self.line(" = ".join([*codes, code]))

    def _is_reached(self, target: Value) -> bool:
        """Whether an object is only reached through a pointer, and so has to stay itself."""
        if isinstance(target, Element) and isinstance(target.base.type, PointerType):
            return self.shapes.shape(target.base) == OBJECT
        return isinstance(target, Referred) or not is_place(target)

    def target(self, value: Value) -> Code:
        """What is assigned to."""
        if self.is_character(value):
            raise self.refuse(value.place, "a letter of a string that is changed")
        return super().target(value)

    def _in_place(self, value: Store) -> bool:
        """`x = x + 1` as `x += 1`."""
        given = value.value
        while isinstance(given, Converted) and type(given.type) is type(given.operand.type):
            given = given.operand
        if not (isinstance(given, Arithmetic) and given.op in ("+", "-", "*")):
            return False
        left = given.left
        while isinstance(left, Converted):
            left = left.operand
        if not (isinstance(value.target, Variable) and isinstance(left, Variable)):
            return False
        if left.symbol is not value.target.symbol or value.type in (CHAR, UCHAR):
            return False
        if isinstance(given.type, FloatType) and isinstance(value.type, IntType):
            return False
        if place_key(value.target) in self.facts.singles and loses(given):
            return False
        if self.is_seen(given):  # it must be cut to its 16 bits
            return False
        right = self.value(given.right)
        self.line(f"{self.target(value.target)} {given.op}= {right}")
        return True

    def assigned_value(self, value: Store) -> Code:
        """What is assigned: a copy of an object, a pointer in its shape, a number."""
        target, given = value.target, value.value
        if isinstance(value.type, StructType):
            return self.copied(given)
        if isinstance(value.type, PointerType):
            return self.given(given, self.destination(target), value.type)
        return self.fitted(given, value.type, self.value(given), target)

    def _change(self, value: Update) -> None:
        """`x += 1` and its like."""
        target = self.target(value.target)
        result: Value = value.result
        while isinstance(result, Converted) and type(result.type) is type(result.operand.type):
            result = result.operand
        if isinstance(result, Offset) and isinstance(result.base, Present):
            self._move(value, target, result)
            return
        if isinstance(result, Arithmetic) and self._is_present(result.left):
            op = result.op
            whole = isinstance(result.type, IntType)
            if op == "/" and whole:
                positive = self.positive(value.target) and self.positive(result.right)
                op = "//" if positive else ""
            if op == "%" and not (self.positive(value.target) and self.positive(result.right)):
                op = ""
            single = place_key(value.target) in self.facts.singles and loses(result)
            if (
                op in _IN_PLACE
                and value.type not in (CHAR, UCHAR)
                and not (single or self._grows(value, result))
            ):
                self.line(f"{target} {op}= {self.value(result.right)}")
                return
        code = self.fitted(value.result, value.type, self.updated(value), value.target)
        self.line(f"{target} = {code}")

    def _grows(self, value: Update, result: Arithmetic) -> bool:
        """Whether `x *= y` may well be too large for 16 bits."""
        made = Arithmetic(value.place, result.type, result.op, value.target, result.right)
        return self.is_seen(made)

    def _move(self, value: Update, target: Code, result: Offset) -> None:
        shape = self.destination(value.target)
        count = self.value(result.count)
        if shape == TEXT:
            self.line(f"{target} = {target}[{count}:]")
        elif shape == CURSOR:
            self.line(f"{target} += {count}")
        else:
            raise self.refuse(value.place, "a pointer that walks here")

    def _is_present(self, value: Value) -> bool:
        while isinstance(value, Converted):
            value = value.operand
        return isinstance(value, Present)

    def _advance(self, value: Advance) -> None:
        target, sign = self.target(value.target), "+" if value.by > 0 else "-"
        if isinstance(value.type, PointerType):
            shape = self.destination(value.target)
            if shape == TEXT and sign == "+":
                self.line(f"{target} = {target}[1:]")
                return
            if shape != CURSOR:
                raise self.refuse(value.place, "a pointer that walks here")
        if value.type == UCHAR:
            self.line(f"{target} = ({target} {sign} 1) & 0xFF")
            return
        self.line(f"{target} {sign}= 1")

    def waits(self, symbol: Symbol) -> bool:
        """Whether a variable may be stepped behind the statement that it is used in."""
        if self.statement is None or (
            symbol.kind == "global" and walking.calls_own(self.statement)
        ):
            return False
        count = sum(
            isinstance(one, Variable) and one.symbol is symbol
            for one in walking.values(self.statement)
        )
        return count == 1
