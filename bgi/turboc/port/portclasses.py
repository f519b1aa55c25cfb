"""Objects of C++ as Python: methods, operators, constructors and destructors."""

from __future__ import annotations

from bgi.turboc.checker.typed import (
    Address,
    Converted,
    Creation,
    Destruction,
    Invocation,
    Itself,
    MethodCall,
    Value,
)
from bgi.turboc.checker.types import ArrayType, PointerType, StructType, Symbol, flat
from bgi.turboc.port.pointershapes import CURSOR, OBJECT
from bgi.turboc.port.portstreams import PortStreams
from bgi.turboc.port.pycode import Code, binary, call, plain, signed

_BINARY = {
    **{"+": "add", "-": "sub", "*": "mul", "/": "truediv", "%": "mod", "==": "eq", "!=": "ne"},
    **{"<": "lt", ">": "gt", "<=": "le", ">=": "ge", "&": "and", "|": "or", "^": "xor"},
    **{"<<": "lshift", ">>": "rshift"},
}
"""Operators whose methods Python calls alike."""

_IN_PLACE = {"+=": "iadd", "-=": "isub", "*=": "imul", "/=": "itruediv"}


def method_name(symbol: Symbol) -> str:
    """What a method is called in Python."""
    assert symbol.owner is not None
    name, number = symbol.name, _number(symbol)
    if name == symbol.owner.tag:
        return "__init__" if is_only(symbol) else f"construct{number}"
    if name.startswith("~"):
        return "destroy"
    if not name.startswith("operator"):
        return f"{plain(name)}{number}"
    sign = name.removeprefix("operator").strip()
    if sign in ("[]", "()") and not number:
        return "__getitem__" if sign == "[]" else "__call__"
    known = _known(symbol, sign)
    if known and not number:
        return f"__{known}__"
    return symbol.python.strip("_") + number


def _known(symbol: Symbol, sign: str) -> str:
    count = len(symbol.type.parameters)  # type: ignore[union-attr]
    if count == 1:
        return _BINARY.get(sign, "")
    return {"-": "neg", "+": "pos"}.get(sign, "") if count == 0 else ""


def _number(symbol: Symbol) -> str:
    """Nothing for the first of several methods of a name, `_2` for the second."""
    assert symbol.owner is not None
    same = symbol.owner.methods.get(symbol.name, [symbol])
    place = same.index(symbol) if symbol in same else 0
    return f"_{place + 1}" if place else ""


def is_only(symbol: Symbol) -> bool:
    """Whether a constructor is the only one of its class."""
    assert symbol.owner is not None
    return len(symbol.owner.methods.get(symbol.name, [])) == 1


class PortClasses(PortStreams):
    """Writes what is done with objects."""

    def called(self, value: Invocation | MethodCall, quiet: bool) -> Code:
        """A call; methods of streams, and operators, have their own ways."""
        if isinstance(value, MethodCall) and value.method.owner is not None:
            if value.method.owner.library:
                return self.stream(value)
            operation = self._operation(value)
            if operation is not None:
                return operation
        return super().called(value, quiet)

    def _operation(self, value: MethodCall) -> Code | None:
        """An operator between objects."""
        name = value.method.python
        sign = value.method.name.removeprefix("operator").strip()
        if not (value.method.name.startswith("operator") and name.startswith("__")):
            return None
        given = [self.argument(one, None) for one in value.arguments]
        base = self.value(value.base)
        if sign == "[]":
            return Code(f"{base.inside(17)}[{given[0]}]")
        if sign == "()":
            return call(base.inside(17), given)
        if sign in _BINARY and given:
            return binary(sign, base, given[0])
        return signed(sign, base)

    def function(self, value: Invocation | MethodCall) -> str:
        """What is called."""
        if not isinstance(value, MethodCall):
            return super().function(value)
        method, base = value.method, value.base
        owner = method.owner
        assert owner is not None
        name = method.python
        if method.static:
            return f"{owner.python}.{name}"
        cls = base.type
        inherited = value.exact and isinstance(base, Itself) and isinstance(cls, StructType)
        if inherited and owner is not self.inside and self._hides(self.inside, method):
            return f"super().{name}"
        return f"{self.object(base)}.{name}"

    inside: StructType | None = None
    """The class whose method is written."""

    def _hides(self, cls: StructType | None, method: Symbol) -> bool:
        """Whether a class has a method of the same name as one of its base."""
        if cls is None or cls is method.owner:
            return False
        return any(one.python == method.python for same in cls.methods.values() for one in same)

    # Constructors and destructors

    def created(self, value: Creation) -> Code:
        """A new object, by its constructor if it has one."""
        if value.constructor is None:
            if isinstance(value.what, StructType) and value.arguments and value.count is None:
                return self.copied(value.arguments[0])
            return super().created(value)
        one = self._constructed(value.constructor, value)
        if isinstance(value.type, ArrayType):
            return Code(f"[{one} for _ in range({flat(value.type)})]")
        if not isinstance(value.type, PointerType):
            return one
        shape = self.shapes.shape(value)
        if value.count is not None:
            made = Code(f"[{one} for _ in range({self.value(value.count)})]")
            return self._cursor(made) if shape == CURSOR else made
        if shape == OBJECT:
            return one
        return self._cursor(Code(f"[{one}]")) if shape == CURSOR else Code(f"[{one}]")

    def _constructed(self, constructor: Symbol, value: Creation) -> Code:
        parameters = self.outs.parameters(constructor)

        def write(place: int, one: Value) -> Code:
            return self.argument(one, parameters[place] if place < len(parameters) else None)

        given = self.ordered(value.arguments, write)
        assert constructor.owner is not None
        cls = constructor.owner.python
        if is_only(constructor):
            return call(cls, given)
        return call(f"{cls}().{constructor.python}", given)

    def destroyed(self, value: Destruction) -> Code:
        """`delete`: Python forgets by itself, but a destructor may have something to do."""
        if value.destructor is None:
            return Code("")
        operand = self.pointer(value.operand, self.shapes.shape(value.operand))
        if value.array:
            with self.block(f"for one in {operand}:"):
                self.line(f"one.{value.destructor.python}()")
            return Code("")
        if self.shapes.shape(value.operand) != OBJECT:
            operand = Code(f"{operand.inside(17)}[0]")
        return Code(f"{operand.inside(17)}.{value.destructor.python}()")

    def argument(self, value: Value, parameter: Symbol | None) -> Code:
        """An argument of a function of the program."""
        inner = value.operand if isinstance(value, Converted) else value
        place = inner.operand if isinstance(inner, Address) else None
        if parameter is None and place is not None and isinstance(place.type, StructType):
            return self.value(place)
        return super().argument(value, parameter)
