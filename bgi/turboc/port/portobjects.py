"""Calls of the program's functions, copies of objects, new objects and first values."""

from __future__ import annotations

from bgi.turboc.checker.conversions import is_place
from bgi.turboc.checker.typed import (
    Converted,
    Creation,
    Destruction,
    Element,
    Invocation,
    Listed,
    MethodCall,
    Quoted,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    VOID,
    ArrayType,
    FloatType,
    FunctionType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    innermost,
)
from bgi.turboc.emitter.wrapping import fits, interval
from bgi.turboc.port.pointershapes import BYTES, CURSOR, LIST, OBJECT, TEXT, Key, owner
from bgi.turboc.port.portwords import PortWords
from bgi.turboc.port.pycode import Code, binary, call
from bgi.turboc.port.singles import loses, place_key


class PortObjects(PortWords):
    """Writes calls and objects."""

    changed: set[Symbol]
    """Parameters that are objects, and that their functions change."""

    answer: Code | None = None
    """Where the answer of the call goes that is written."""

    def fitted(self, value: Value, type_: Type, code: Code, target: Value | None = None) -> Code:
        """A number for a place of 8 bits, cut off if it may be larger."""
        if target is not None and place_key(target) in self.facts.singles and loses(value):
            return call(self.helpers.use("float32"), [code])
        if isinstance(type_, FloatType) and code.isdecimal():
            return Code(f"{code}.0")
        text = isinstance(target, Element) and self.shapes.shape(target.base) == BYTES
        if not isinstance(type_, IntType) or type_ not in (CHAR, UCHAR):
            return code
        if not isinstance(value.type, IntType):
            return code
        inside = fits(interval(value, self.facts.known), type_)
        if type_ == UCHAR and not inside:
            return binary("&", code, Code("0xFF"))
        if text and not inside:
            inner = value.operand if isinstance(value, Converted) else value
            if not (isinstance(inner.type, IntType) and inner.type == CHAR):
                return binary("&", code, Code("0xFF"))
        return code

    def copied(self, value: Value) -> Code:
        """An object that is given away: a copy, if it stands somewhere."""
        code = self.value(value)
        inner = value.operand if isinstance(value, Converted) else value
        if not (is_place(inner) or code == "self"):
            return code
        assert isinstance(value.type, StructType)
        deep = any(
            isinstance(innermost(one), StructType) or isinstance(one, ArrayType)
            for one in value.type.all_members().values()
        )
        return call(self.names.use("copy", "deepcopy" if deep else "copy"), [code])

    def invocation(self, value: Invocation) -> Code:
        """A call of a function of the program, whose answer counts."""
        return self.called(value, False)

    def method(self, value: MethodCall) -> Code:
        """A call of a method, whose answer counts."""
        return self.called(value, False)

    def called(self, value: Invocation | MethodCall, quiet: bool) -> Code:
        """A call; what it answers through pointers is assigned."""
        pairs = dict(enumerate(self.outs.pairs(value)))
        places = [
            (parameter, self.outs.place(argument))
            for parameter, argument in pairs.values()
            if parameter in self.outs.found
        ]

        def one(number: int, argument: Value) -> Code:
            parameter = pairs[number][0] if number in pairs else None
            return self.argument(argument, parameter)

        kept = [
            (number, one)
            for number, one in enumerate(value.arguments)
            if number not in pairs or pairs[number][0] not in self.facts.pure
        ]
        numbers = [number for number, _ in kept]
        codes = self.ordered(
            tuple(given for _, given in kept), lambda at, given: one(numbers[at], given)
        )
        code = call(self.function(value), codes)
        if not places:
            return code
        targets = [self.target(place) for _, place in places if place is not None]
        answers = self.answers(value)
        if answers:
            free = self.answer or Code(self.temporary("answer"))
            targets.insert(0, Code("_") if quiet else free)
        self.line(f"{', '.join(targets)} = {code}")
        return Code("") if quiet or not answers else targets[0]

    def answers(self, value: Invocation | MethodCall) -> bool:
        """Whether a function gives a value back besides."""
        return value.type != VOID and not isinstance(value.type, FunctionType)

    def argument(self, value: Value, parameter: Symbol | None) -> Code:
        """An argument of a function of the program."""
        if parameter is not None and parameter in self.outs.found:
            place = self.outs.place(value)
            assert place is not None
            return self.value(place)
        if isinstance(value.type, StructType):
            changes = parameter is None or parameter in self.changed
            return self.copied(value) if changes else self.value(value)
        if not isinstance(value.type, (PointerType, ReferenceType)):
            return self.value(value)
        if parameter is None:
            return self.given(value, self.shapes.shape(value), value.type)
        wanted = self.shapes.of_key((parameter, 0), parameter.type)
        if isinstance(parameter.type, ReferenceType):
            return self.reference(value, parameter.type, wanted)
        return self.given(value, wanted, parameter.type)

    def reference(self, value: Value, type_: ReferenceType, wanted: str) -> Code:
        if isinstance(type_.to, StructType):
            inner = value
            while isinstance(inner, Converted):
                inner = inner.operand
            return self.value(getattr(inner, "operand", inner))
        return self.pointer(value, wanted or LIST)

    def function(self, value: Invocation | MethodCall) -> str:
        """What is called."""
        assert isinstance(value, Invocation)
        function = value.function
        while isinstance(function, Converted):
            function = function.operand
        if isinstance(function, Variable):
            return self.name_of(function.symbol)
        return self.value(function).inside(17)

    def created(self, value: Creation) -> Code:
        """`new`: an object, an array or a number."""
        shape = self.shapes.shape(value) if isinstance(value.type, PointerType) else ""
        return self.memory_of(value, shape)

    def memory_of(self, value: Creation, shape: str) -> Code:
        """Memory that `new` gives."""
        key = self.shapes.deeper(self.shapes.key(value))
        if value.count is not None:
            count = self.value(value.count)
            if value.what in (CHAR, UCHAR) and shape in (BYTES, CURSOR, TEXT):
                made = Code(f"bytearray({count})") if shape != TEXT else Code('""')
            else:
                made = self.many(value.what, key, count)
            return self._cursor(made) if shape == CURSOR else made
        one = self.nothing(value.what, key)
        if value.arguments and not isinstance(value.what, StructType):
            one = self.value(value.arguments[0])
        if not isinstance(value.type, PointerType) or shape == OBJECT:
            return one
        made = Code(f"[{one}]")
        return self._cursor(made) if shape == CURSOR else made

    def destroyed(self, value: Destruction) -> Code:
        """`delete`: Python forgets by itself."""
        return Code("")

    def listed(self, value: Listed) -> Code:
        """Initial values, of whatever they are."""
        return self.initial(value, value.type, (id(value), 0))

    def initial(self, value: Value, type_: Type, key: Key) -> Code:
        """What a variable holds at first."""
        if isinstance(value, Quoted):
            shape = self.shapes.of_key(key, type_)
            if shape == TEXT:
                return self.value(value)
            assert isinstance(type_, ArrayType)
            return Code(f"bytearray({value.data.ljust(type_.count, bytes(1))!r})")
        if isinstance(value, Listed) and isinstance(type_, StructType):
            return self._members(value, type_)
        if isinstance(value, Listed):
            assert isinstance(type_, ArrayType)
            inner = self.shapes.deeper(key)
            items = [self.initial(one, type_.of, inner) for one in value.items if one is not None]
            made = Code(f"[{', '.join(items)}]")
            missing = type_.count - len(items)
            if self.shapes.of_key(key, type_) == BYTES:
                return Code(f"bytearray({made})")
            if not items:
                return self.many(type_.of, inner, Code(str(type_.count)))
            if missing > 0:
                return binary("+", made, self.many(type_.of, inner, Code(str(missing))))
            return made
        if isinstance(type_, PointerType):
            return self.given(value, self.shapes.of_key(key, type_), type_)
        if isinstance(type_, StructType):
            return self.copied(value)
        return self.fitted(value, type_, self.value(value))

    def _members(self, value: Listed, type_: StructType) -> Code:
        given: list[Code] = []
        for (name, member), item in zip(type_.all_members().items(), value.items, strict=True):
            if item is None:
                break
            code = self.initial(item, member, ((owner(type_, name), name), 0))
            given.append(code)
        return call(type_.python, given)
