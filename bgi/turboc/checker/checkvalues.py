"""Types of expressions: from the tree as it is written to the typed one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.turboc.checker import checkliterals
from bgi.turboc.checker.conversions import (
    addressed,
    calculated,
    compared,
    converted,
    decayed,
    is_place,
    passed,
)
from bgi.turboc.checker.folding import arithmetic
from bgi.turboc.checker.meaning import Meaning
from bgi.turboc.checker.typed import (
    Address,
    Advance,
    Choice,
    Connective,
    Constant,
    Creation,
    Destruction,
    Distance,
    Element,
    Field,
    Inverse,
    Itself,
    Offset,
    Present,
    Referred,
    Sequence,
    Signed,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    INT,
    UNSIGNED,
    ArrayType,
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
    size,
)
from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar import nodes


class Values(Meaning):
    """What expressions are."""

    def value(self, node: nodes.Expr) -> Value:
        """An expression with its type: arrays are arrays still."""
        return _READERS[type(node)](self, node)

    def computed(self, node: nodes.Expr) -> Value:
        """An expression as a value: arrays are pointers."""
        return decayed(self.value(node))

    def condition(self, node: nodes.Expr) -> Value:
        """A value that is only asked whether it is 0."""
        value = self.computed(node)
        if isinstance(value.type, StructType):
            value = self.operator("!", value, [], node.place)
            return Inverse(node.place, INT, value)
        return value

    def number(self, node: nodes.Expr) -> Value:
        """A value that is a number; CError if it is none."""
        value = self.computed(node)
        if not is_number(value.type):
            raise CError(node.place, f"a number is needed here, not {described(value.type)}")
        return value

    # What calls and classes know

    def call(self, node: nodes.Call) -> Value:
        """A call."""
        raise NotImplementedError

    def operator(self, op: str, left: Value, right: list[Value], place: Place) -> Value:
        """An operator of a class; CError if it has none."""
        raise NotImplementedError

    def created(
        self, type_: Type, result: Type, given: list[Value], place: Place, count: Value | None
    ) -> Creation:
        """A new object of a type."""
        raise NotImplementedError

    # Names

    def _name(self, node: nodes.Name) -> Value:
        found = [] if node.scope else self.scope.find_inside(node.name)
        member = None if found else self.own_member(node)
        if member is not None:
            return member
        found = found or self.find(node.name, node.scope, node.place)
        if found:
            return self.named(found[0], node.place)
        raise self.unknown(node.name, node.place)

    def own_member(self, node: nodes.Name) -> Value | None:
        """A member of the class whose method it is that uses the name."""
        if self.cls is None or (node.scope and node.scope == "::"):
            return None
        static = self.cls.static(node.name)
        if static is not None:
            return self.named(static, node.place)
        if (type_ := self.cls.member(node.name)) is None:
            return None
        return self.referred(Field(node.place, type_, Itself(node.place, self.cls), node.name))

    def named(self, symbol: Any, place: Place) -> Value:
        """The value of a variable, or a constant."""
        if symbol.kind == "constant":
            variable = Variable(place, symbol.type, symbol)
            return Constant(place, symbol.type, symbol.value, variable)
        symbol.written += symbol.kind == "function"
        return self.referred(Variable(place, symbol.type, symbol))

    def referred(self, value: Value) -> Value:
        """What a reference stands for; anything else as it is."""
        if isinstance(value.type, ReferenceType):
            return Referred(value.place, value.type.to, value)
        return value

    def _this(self, node: nodes.This) -> Value:
        if self.cls is None:
            raise CError(node.place, "there is no `this` outside of a class")
        return Address(node.place, PointerType(self.cls), Itself(node.place, self.cls))

    # Operators

    def _unary(self, node: nodes.Unary) -> Value:
        if node.op == "&":
            return self._address(node)
        value = self.computed(node.operand)
        if node.op == "*":
            return self.pointee(value, Constant(node.place, INT, 0), node.place)
        if isinstance(value.type, StructType):
            return self.operator(node.op, value, [], node.place)
        if node.op == "!":
            if isinstance(value, Constant):
                return Constant(node.place, INT, int(not value.value))
            return Inverse(node.place, INT, value)
        if not is_number(value.type):
            raise CError(node.place, f"{node.op} is for numbers, not for {described(value.type)}")
        if isinstance(value.type, IntType):
            value = converted(value, promoted(value.type))
        elif node.op == "~":
            raise CError(node.place, "~ is for whole numbers only")
        if isinstance(value, Constant) and node.op in "+-":
            signed = arithmetic("*", value.value, -1 if node.op == "-" else 1, value.type)
            shown = Signed(node.place, value.type, node.op, value)
            return Constant(node.place, value.type, signed or 0, shown)
        return value if node.op == "+" else Signed(node.place, value.type, node.op, value)

    def _address(self, node: nodes.Unary) -> Value:
        if isinstance(node.operand, nodes.Name):
            found = self.find(node.operand.name, node.operand.scope, node.place)
            if found and isinstance(found[0].type, FunctionType):
                return self.computed(node.operand)
        value = self.value(node.operand)
        if isinstance(value, Element) and isinstance(value.base.type, PointerType):
            return Offset(node.place, value.base.type, value.base, value.index)
        if not (is_place(value) or isinstance(value, Itself)):
            raise CError(node.place, "& is for what stands in memory")
        addressed(value)
        return Address(node.place, PointerType(value.type), value)

    def pointee(self, base: Value, index: Value, place: Place) -> Value:
        """`base[index]`, where the base is a pointer."""
        if not isinstance(base.type, PointerType):
            raise CError(place, f"{described(base.type)} is no pointer and no array")
        if isinstance(base.type.to, FunctionType):
            return base
        if isinstance(base, Address) and isinstance(base.operand.type, ArrayType):
            base = base.operand  # the array itself
        elif isinstance(base, Address) and isinstance(index, Constant) and not index.value:
            return base.operand
        to = base.type.of if isinstance(base.type, ArrayType) else base.type.to  # type: ignore[union-attr]
        if isinstance(to, StructType) and not to.complete and not to.library:
            raise CError(place, f"nothing is known of {described(to)}")
        return Element(place, to, base, index)

    def _index(self, node: nodes.Index) -> Value:
        base, index = self.computed(node.base), self.computed(node.index)
        if isinstance(base.type, StructType):
            return self.operator("[]", base, [index], node.place)
        if isinstance(base.type, IntType) and isinstance(index.type, PointerType):
            base, index = index, base
        if not isinstance(index.type, IntType):
            raise CError(node.place, f"an index is a whole number, not {described(index.type)}")
        return self.pointee(base, index, node.place)

    def _member(self, node: nodes.Member) -> Value:
        base = self.object(node)
        assert isinstance(base.type, StructType)
        type_ = base.type.member(node.name)
        if type_ is None:
            static = base.type.static(node.name)
            if static is not None:
                return self.named(static, node.place)
            raise CError(node.place, f"{described(base.type)} has no member {node.name}")
        return self.referred(Field(node.place, type_, base, node.name))

    def object(self, node: nodes.Member) -> Value:
        """What stands before the `.` or `->` of a member: an object."""
        base = self.value(node.base)
        if node.arrow and isinstance(base.type, StructType):
            base = self.operator("->", base, [], node.place)
        if node.arrow:
            base = self.pointee(decayed(base), Constant(node.place, INT, 0), node.place)
        if not isinstance(base.type, StructType):
            hint = ": use ->" if isinstance(base.type, PointerType) else ""
            raise CError(node.place, f"{described(base.type)} has no members{hint}")
        return base

    def _binary(self, node: nodes.Binary) -> Value:
        return self.binary(node.op, self.computed(node.left), self.computed(node.right), node.place)

    def binary(self, op: str, left: Value, right: Value, place: Place) -> Value:
        """Two values with an operator between them."""
        if isinstance(left.type, StructType) or isinstance(right.type, StructType):
            return self.operator(op, left, [right], place)
        if op in ("<", ">", "<=", ">=", "==", "!="):
            result = compared(op, left, right)
        elif is_number(left.type) and is_number(right.type):
            result = calculated(op, left, right)
        else:
            result = self._pointers(op, left, right, place)
        result.place = place
        return result

    def _pointers(self, op: str, left: Value, right: Value, place: Place) -> Value:
        if isinstance(left.type, PointerType) and op in "+-":
            if isinstance(right.type, IntType):
                return self._moved(op, left, right, place)
            if op == "-" and isinstance(right.type, PointerType):
                return Distance(place, INT, left, right)
        if op == "+" and isinstance(right.type, PointerType) and isinstance(left.type, IntType):
            return self._moved(op, right, left, place)
        both = f"{described(left.type)} and {described(right.type)}"
        raise CError(place, f"{op} is not for {both}")

    def _moved(self, op: str, base: Value, count: Value, place: Place) -> Value:
        if op == "-":
            count = calculated("-", Constant(place, INT, 0), count)
        return Offset(place, base.type, base, count)

    def _logical(self, node: nodes.Logical) -> Value:
        left, right = self.condition(node.left), self.condition(node.right)
        return Connective(node.place, INT, node.op, left, right)

    def _conditional(self, node: nodes.Conditional) -> Value:
        condition = self.condition(node.condition)
        yes, no = self.computed(node.yes), self.computed(node.no)
        if yes.type == no.type:
            type_ = yes.type
        elif is_number(yes.type) and is_number(no.type):
            type_ = common(yes.type, no.type)
        else:
            null = isinstance(yes, Constant) or is_number(yes.type)
            type_ = no.type if null and isinstance(no.type, PointerType) else yes.type
        yes, no = converted(yes, type_), converted(no, type_)
        return Choice(node.place, type_, condition, yes, no)

    def _comma(self, node: nodes.Comma) -> Value:
        items = tuple(self.computed(item) for item in node.items)
        return Sequence(node.place, items[-1].type, items)

    # Assignments

    def written(self, node: nodes.Expr, place: Place) -> Value:
        """What is assigned to; CError if that cannot be."""
        target = self.value(node)
        if not is_place(target) and not isinstance(target, Itself):
            raise CError(place, "what stands on the left is no variable")
        if isinstance(target.type, (ArrayType, FunctionType)):
            raise CError(place, f"{described(target.type)} cannot be assigned to")
        if isinstance(target, Variable):
            target.symbol.written += 1
        return target

    def _assign(self, node: nodes.Assign) -> Value:
        target = self.written(node.target, node.place)
        if node.op == "=":
            value = self.computed(node.value)
            if isinstance(target.type, StructType) and (
                value.type != target.type or self._overloads(target.type, "=")
            ):
                return self.operator("=", target, [value], node.place)
            return Store(node.place, target.type, target, converted(value, target.type))
        value, op = self.computed(node.value), node.op[:-1]
        if isinstance(target.type, StructType):
            if self._overloads(target.type, node.op):
                return self.operator(node.op, target, [value], node.place)
            sum_ = self.operator(op, target, [value], node.place)
            return Store(node.place, target.type, target, sum_)
        present = Present(node.place, target.type)
        result = converted(self.binary(op, present, value, node.place), target.type)
        return Update(node.place, target.type, target, result)

    def _overloads(self, cls: StructType, op: str) -> bool:
        return bool(cls.method(f"operator{op}"))

    def _step(self, node: nodes.IncDec) -> Value:
        target = self.written(node.operand, node.place)
        if isinstance(target.type, StructType):
            return self.operator(node.op, target, [], node.place)
        return Advance(node.place, target.type, target, 1 if node.op == "++" else -1, node.postfix)

    # Types

    def _cast(self, node: nodes.Cast) -> Value:
        type_, value = self.type(node.type), self.computed(node.operand)
        if isinstance(type_, StructType) and type_ != value.type:
            return self.created(type_, type_, [value], node.place, None)
        return converted(value, type_, forced=True)

    def _construct(self, node: nodes.Construct) -> Value:
        if isinstance(base := node.type.base, nodes.Named) and not node.type.parts:
            function = self.headers.symbol(base.name)
            if function is not None and self.scope.find_type(base.name) is None:  # as time()
                name = nodes.Name(node.place, base.name)
                return self._call(nodes.Call(node.place, name, node.arguments))
        type_ = self.type(node.type)
        given = [self.value(one) for one in node.arguments]
        if isinstance(type_, StructType):
            return self.created(type_, type_, given, node.place, None)
        if len(given) != 1:
            raise CError(node.place, f"one value becomes {described(type_)}, not {len(given)}")
        return converted(given[0], type_, forced=True)

    def _size_of_value(self, node: nodes.SizeofExpr) -> Value:
        return Constant(node.place, UNSIGNED, size(self.value(node.operand).type))

    def _size_of_type(self, node: nodes.SizeofType) -> Value:
        return Constant(node.place, UNSIGNED, size(self.type(node.type)))

    def _new(self, node: nodes.New) -> Value:
        type_ = self.type(node.type)
        count = self.number(node.count) if node.count is not None else None
        given = [self.value(one) for one in node.arguments]
        return self.created(type_, PointerType(type_), given, node.place, count)

    def _delete(self, node: nodes.Delete) -> Value:
        value = self.computed(node.operand)
        if not isinstance(value.type, PointerType):
            raise CError(node.place, f"delete is for pointers, not for {described(value.type)}")
        to, found = value.type.to, []
        if isinstance(to, StructType):
            found = to.method(f"~{to.tag}")
        return Destruction(node.place, INT, passed(value), found[0] if found else None, node.array)

    def _braces(self, node: nodes.Braces) -> Value:
        raise CError(node.place, "values in braces stand only where a variable is declared")

    def _call(self, node: nodes.Call) -> Value:
        return self.referred(self.call(node))


_READERS: dict[type, Callable[[Values, Any], Value]] = {
    **checkliterals.RULES,
    nodes.Name: Values._name,
    nodes.This: Values._this,
    nodes.Unary: Values._unary,
    nodes.IncDec: Values._step,
    nodes.Binary: Values._binary,
    nodes.Logical: Values._logical,
    nodes.Assign: Values._assign,
    nodes.Conditional: Values._conditional,
    nodes.Comma: Values._comma,
    nodes.Call: Values._call,
    nodes.Construct: Values._construct,
    nodes.Index: Values._index,
    nodes.Member: Values._member,
    nodes.Cast: Values._cast,
    nodes.SizeofExpr: Values._size_of_value,
    nodes.SizeofType: Values._size_of_type,
    nodes.New: Values._new,
    nodes.Delete: Values._delete,
    nodes.Braces: Values._braces,
}
