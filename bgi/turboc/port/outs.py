"""Parameters through which functions answer: in Python they are returned.

`void swap(int *a, int *b)` becomes `a, b = swap(a, b)`, if all that the function does with its
pointers is to read and write what they point to, and all who call it give addresses of
variables.
"""

from __future__ import annotations

from collections.abc import Iterator

from bgi.turboc.checker.typed import (
    Address,
    Constant,
    Element,
    Invocation,
    LibraryCall,
    MethodCall,
    Offset,
    Referred,
    Routine,
    TypedProgram,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    ArrayType,
    FloatType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
)
from bgi.turboc.port import walking

LIBRARY_OUTS: dict[str, tuple[int, ...]] = {
    **dict.fromkeys(("initgraph", "detectgraph", "getaspectratio"), (0, 1)),
    **{"getmoderange": (1, 2), "modf": (1,), "frexp": (1,), "time": (0,)},
    **{"scanf": tuple(range(1, 30)), "cscanf": tuple(range(1, 30))},
    **{"sscanf": tuple(range(2, 30)), "fscanf": tuple(range(2, 30))},
}
"""Where functions of the library take pointers to answer through."""


def _may_answer(type_: Type) -> bool:
    """Whether a parameter of that type can be one to answer through."""
    if not isinstance(type_, (PointerType, ReferenceType)):
        return False
    to = type_.to
    return isinstance(to, (IntType, FloatType, PointerType)) and to is not None


class Outs:
    """Which parameters answer."""

    def __init__(self, program: TypedProgram) -> None:
        self._parameters: dict[Symbol, list[Symbol]] = {
            one.symbol: one.parameters for one in program.routines
        }
        self.found = {
            parameter
            for routine in program.routines
            if not routine.symbol.virtual
            for parameter in routine.parameters
            if _may_answer(parameter.type)
        }
        self._drop_taken(program)
        before = -1
        while before != len(self.found):
            before = len(self.found)
            for routine in program.routines:
                self._look_inside(routine)
            for value in walking.of_program(program):
                self._look_at_call(value)

    def _drop_taken(self, program: TypedProgram) -> None:
        """Functions that pointers point to keep their parameters as they are."""
        called = set()
        every = list(walking.of_program(program))
        for value in every:
            if isinstance(value, Invocation):
                called.add(id(value.function))
        for value in every:
            function = isinstance(value, Variable) and value.symbol in self._parameters
            if isinstance(value, Variable) and function and id(value) not in called:
                self.found -= set(self._parameters[value.symbol])

    def _look_inside(self, routine: Routine) -> None:
        """Drop the parameters of which something else is done than to read and write there."""
        used: dict[Symbol, int] = {}
        good: dict[Symbol, int] = {}
        for value in walking.values(walking.of_routine(routine)):
            if isinstance(value, Variable) and value.symbol in self.found:
                used[value.symbol] = used.get(value.symbol, 0) + 1
            for symbol in self._good(value):
                good[symbol] = good.get(symbol, 0) + 1
        for symbol, count in used.items():
            if good.get(symbol, 0) != count:
                self.found.discard(symbol)

    def _good(self, value: Value) -> Iterator[Symbol]:
        match value:
            case Element(base=Variable(symbol=symbol), index=Constant(value=0)):
                yield symbol
            case Referred(operand=Variable(symbol=symbol)):
                yield symbol
            case LibraryCall(name=name, arguments=arguments):
                for place in LIBRARY_OUTS.get(name, ()):
                    if place < len(arguments) and isinstance(one := arguments[place], Variable):
                        yield one.symbol
            case Invocation() | MethodCall():
                for parameter, argument in self.pairs(value):
                    if parameter in self.found and isinstance(argument, Variable):
                        yield argument.symbol

    def _look_at_call(self, value: Value) -> None:
        """Drop the parameters that get anything but the address of a place."""
        if isinstance(value, (Invocation, MethodCall)):
            for parameter, argument in self.pairs(value):
                if parameter in self.found and self.place(argument) is None:
                    self.found.discard(parameter)

    def pairs(self, value: Invocation | MethodCall) -> Iterator[tuple[Symbol, Value]]:
        """The parameters of a function of the program that is called, with their arguments."""
        symbol: Symbol | None = None
        if isinstance(value, MethodCall):
            symbol = value.method
        elif isinstance(value.function, Variable):
            symbol = value.function.symbol
        if symbol in self._parameters:
            yield from zip(self._parameters[symbol], value.arguments, strict=False)

    def parameters(self, symbol: Symbol) -> list[Symbol]:
        """The parameters of a function of the program."""
        return self._parameters.get(symbol, [])

    def of(self, symbol: Symbol) -> list[Symbol]:
        """The parameters of a function that answer."""
        return [one for one in self._parameters.get(symbol, []) if one in self.found]

    def place(self, argument: Value) -> Value | None:
        """The place that an argument is the address of."""
        match argument:
            case Address(operand=operand):
                if isinstance(operand.type, (ArrayType, StructType)):
                    return None
                return operand
            case Variable(symbol=symbol) if symbol in self.found:
                type_ = symbol.type
                assert isinstance(type_, (PointerType, ReferenceType))
                if isinstance(type_, ReferenceType):
                    return Referred(argument.place, type_.to, argument)
                zero = Constant(argument.place, IntType(16), 0)
                return Element(argument.place, type_.to, argument, zero)
            case Offset(base=base, count=count) if isinstance(base, Address):
                assert isinstance(argument.type, PointerType)
                return Element(argument.place, argument.type.to, base.operand, count)
        return None
