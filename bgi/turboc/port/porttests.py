"""Conditions as Python: comparisons, `and`, `or` and `not`."""

from __future__ import annotations

from bgi.turboc.checker.typed import (
    Arithmetic,
    Choice,
    Comparison,
    Connective,
    Constant,
    Converted,
    Element,
    Inverse,
    LibraryCall,
    Value,
    Variable,
)
from bgi.turboc.checker.types import CHAR, UCHAR, ArrayType, FloatType, PointerType, is_number
from bgi.turboc.emitter.effects import has_effects
from bgi.turboc.port.pointershapes import BYTES, CURSOR, TEXT
from bgi.turboc.port.portplaces import PortPlaces
from bgi.turboc.port.pycode import COMPARE, Code, binary, call, choice, negated, quoted

_MIRRORED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "==", "!=": "!="}
_BOOLEAN = (Comparison, Connective, Inverse)


_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}


def _de_morgan(value: Connective) -> Connective:
    """What is true where both sides together are not."""
    op = "||" if value.op == "&&" else "&&"
    sides = [Inverse(one.place, value.type, one) for one in (value.left, value.right)]
    return Connective(value.place, value.type, op, _simple(sides[0]), _simple(sides[1]))


def _simple(value: Inverse) -> Value:
    """The opposite of a comparison is another one."""
    inner = value.operand
    whole = isinstance(inner, Comparison) and not isinstance(
        inner.left.type, (FloatType, PointerType)
    )
    if isinstance(inner, Comparison) and whole:
        return Comparison(inner.place, inner.type, _OPPOSITE[inner.op], inner.left, inner.right)
    return value


class PortTests(PortPlaces):
    """Writes conditions."""

    walrus = False
    """Whether an assignment in a value stays there: in the conditions of loops."""

    def character(self, value: Value) -> Code:
        """A character that is known, as a string of one."""
        assert isinstance(value, Constant)
        return quoted(bytes([int(value.value) & 0xFF]).decode("cp437"))

    def test(self, value: Value) -> Code:
        """A value that is only asked whether it is 0."""
        match value:
            case Comparison():
                return self.comparison(value)
            case Connective():
                return self.connective(value)
            case Inverse(operand=operand):
                return self._inverse(operand)
            case Converted(operand=operand) if not isinstance(operand.type, PointerType):
                if not isinstance(operand.type, FloatType):
                    return self.test(operand)
            case Constant(value=number) if not isinstance(value.type, PointerType):
                if number in (0, 1):
                    return Code(str(bool(number)))
            case Element() if self.is_character(value):
                return self._behind(value)
            case Arithmetic(op="%"):
                return self._remainder(value)
        code = self.value(value)
        if isinstance(value.type, PointerType):
            return binary("is not", code, Code("None"))
        if code.startswith("int(") and code.endswith(")") and isinstance(value, _BOOLEAN):
            return Code(code[4:-1])
        return code

    def _remainder(self, value: Arithmetic) -> Code:
        """What is left by a division, for whoever only asks whether it is 0: its sign is free."""
        return binary("%", self.value(value.left), self.value(value.right))

    def is_character(self, value: Value) -> bool:
        """Whether it is a letter of a Python string."""
        return (
            isinstance(value, Element)
            and value.type in (CHAR, UCHAR)
            and self.shapes.shape(value.base) == TEXT
        )

    def _behind(self, value: Element) -> Code:
        """Whether a string has a letter at a place: C asks whether it is no zero."""
        base = value.base
        text = self.place_code(base) if isinstance(base.type, ArrayType) else self.value(base)
        index = self.value(value.index)
        if index == "0":
            return text
        return binary("<", index, call("len", [text]))

    def _inverse(self, operand: Value) -> Code:
        match operand:
            case Comparison(op=op) if op in ("==", "!="):
                other = "!=" if op == "==" else "=="
                return self.comparison(
                    Comparison(operand.place, operand.type, other, operand.left, operand.right)
                )
            case Comparison(op=op) if not isinstance(operand.left.type, FloatType):
                if not isinstance(operand.left.type, PointerType):
                    return self.comparison(
                        Comparison(
                            operand.place, operand.type, _OPPOSITE[op], operand.left, operand.right
                        )
                    )
            case Connective(op=op) if not has_effects(operand):
                return self.connective(_de_morgan(operand))
        if isinstance(operand.type, PointerType):
            return binary("is", self.value(operand), Code("None"))
        return negated(self.test(operand))

    def comparison(self, value: Comparison) -> Code:
        """A comparison, which is True or False."""
        op, left, right = value.op, value.left, value.right
        if isinstance(left.type, PointerType):
            return self._pointers(value)
        for one, other in ((left, right), (right, left)):
            letter = one.operand if isinstance(one, Converted) else one
            if op in ("==", "!=") and isinstance(other, Constant) and self.is_character(letter):
                return self._letters(op, letter, other)
            zero = isinstance(other, Constant) and other.value == 0
            if zero and isinstance(letter, Arithmetic) and letter.op == "%" and op in ("==", "!="):
                return binary(op, self._remainder(letter), Code("0"))
            if zero and isinstance(letter, LibraryCall):
                texts = self.compared(letter, op if one is left else _MIRRORED[op])
                if texts is not None:
                    return texts
        return binary(op, self.value(left), self.value(right))

    def compared(self, value: LibraryCall, op: str) -> Code | None:
        """strcmp() against 0 as a comparison of two strings."""
        if value.name not in ("strcmp", "_fstrcmp"):
            return None
        return binary(op, *(self.string(one) for one in value.arguments))

    def _letters(self, op: str, letter: Value, other: Constant) -> Code:
        """A letter of a string that is compared with one that is known."""
        assert isinstance(letter, Element)
        if other.value == 0:
            found = self._behind(letter)
            return negated(found) if op == "==" else found
        base, index = letter.base, self.value(letter.index)
        text = self.place_code(base) if isinstance(base.type, ArrayType) else self.value(base)
        if index == "0":
            one = Code(f"{text.inside(17)}[:1]")
        else:
            end = binary("+", index, Code("1")) if not index.isdecimal() else str(int(index) + 1)
            one = Code(f"{text.inside(17)}[{index}:{end}]")
        return binary(op, one, self.character(other))

    def _pointers(self, value: Comparison) -> Code:
        left, right = value.left, value.right
        null = isinstance(right, Constant) or (
            isinstance(right, Converted) and isinstance(right.operand, Constant)
        )
        if null:
            return binary("is" if value.op == "==" else "is not", self.value(left), Code("None"))
        shape = self.shapes.shape(left)
        if value.op in ("==", "!=") and shape not in (CURSOR, BYTES):
            op = "is" if value.op == "==" else "is not"
            return binary(op, self.pointer(left, shape), self.pointer(right, shape))
        return binary(value.op, self.pointer(left, CURSOR), self.pointer(right, CURSOR))

    def connective(self, value: Connective) -> Code:
        """`and` or `or`; what has to be done before the right side is done only if it counts."""
        shorter = self._between(value) if value.op == "&&" else self._among(value)
        if shorter is not None:
            return shorter
        left = self.test(value.left)
        word = "and" if value.op == "&&" else "or"
        before, self.walrus = self.walrus, True
        with self.captured() as lines:
            right = self.test(value.right)
        self.walrus = before
        if not lines:
            return binary(word, left, right)
        name = self.temporary("holds")
        self.line(f"{name} = {left}")
        with self.block(f"if {name if word == 'and' else f'not {name}'}:"):
            self.lines += [(indent + 1, text, place) for indent, text, place in lines]
            self.line(f"{name} = {right}")
        return Code(name)

    def _among(self, value: Connective) -> Code | None:
        """`c == 1 || c == 3` as `c in (1, 3)`."""
        parts: list[Value] = [value]
        while isinstance(parts[0], Connective) and parts[0].op == "||":
            parts[:1] = [parts[0].left, parts[0].right]
        names, numbers = set(), []
        for one in parts:
            if not (isinstance(one, Comparison) and one.op == "==" and is_number(one.left.type)):
                return None
            letter = one.left.operand if isinstance(one.left, Converted) else one.left
            if not isinstance(letter, Variable) or not isinstance(one.right, Constant):
                return None
            names.add(str(self.value(one.left)))
            numbers.append(str(self.value(one.right)))
        if len(names) != 1:
            return None
        return Code(f"{names.pop()} in ({', '.join(numbers)})", COMPARE)

    def _between(self, value: Connective) -> Code | None:
        """`x >= 1 && x <= 9` as `1 <= x <= 9`."""
        one, other = value.left, value.right
        if not (isinstance(one, Comparison) and isinstance(other, Comparison)):
            return None
        if isinstance(one.left.type, PointerType) or isinstance(other.left.type, PointerType):
            return None
        if (one.op[0], other.op[0]) == ("<", ">"):
            one, other = other, one
        if (one.op[0], other.op[0]) != (">", "<") or has_effects(value):
            return None
        middle = self.value(one.left)
        if middle != self.value(other.left) or not middle.replace(".", "").isidentifier():
            return None
        low, high = self.value(one.right).inside(8), self.value(other.right).inside(8)
        return Code(f"{low} {_MIRRORED[one.op]} {middle} {other.op} {high}", COMPARE)

    def chosen(self, value: Choice) -> Code:
        condition = self.test(value.condition)
        before, self.walrus = self.walrus, True
        with self.captured() as lines:
            if isinstance(value.type, PointerType):
                shape = self.shapes.shape(value)
                yes, no = self.pointer(value.yes, shape), self.pointer(value.no, shape)
            else:
                yes, no = self.value(value.yes), self.value(value.no)
        self.walrus = before
        if lines:
            raise self.refuse(value.place, "an assignment in a choice by ? and :")
        return choice(yes, condition, no)
