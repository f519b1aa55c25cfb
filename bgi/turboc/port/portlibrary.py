"""Calls of the library as Python's own words, or as calls of `bgi`."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Sequence

import bgi
from bgi import conio, dos, stdio, stdlib
from bgi.turboc.checker.typed import (
    Address,
    Constant,
    Converted,
    LibraryCall,
    Value,
)
from bgi.turboc.checker.types import (
    ArrayType,
    FunctionType,
    PointerType,
    Type,
    is_text,
)
from bgi.turboc.emitter.effects import has_effects, order_matters
from bgi.turboc.port import walking
from bgi.turboc.port.formats import f_string, scanned
from bgi.turboc.port.outs import LIBRARY_OUTS
from bgi.turboc.port.pointershapes import TEXT
from bgi.turboc.port.portvalues import PortValues
from bgi.turboc.port.pycode import Code, call
from bgi.turboc.port.shaping import is_const_text

_MATH = """
    sin cos tan asin acos atan atan2 sqrt exp log log10 fabs floor ceil hypot sinh cosh tanh fmod
    ldexp
"""
_NAMELESS = "free farfree _graphfreemem hfree fflush fcloseall"


def _modules() -> dict[str, str]:
    """The module that each function is imported from."""
    found = {"random": "bgi.stdlib", "clock": "bgi.dos", "bioskey": "bgi.bios"}
    found |= dict.fromkeys(_MATH.split(), "math")
    for name, module in (("stdlib", stdlib), ("stdio", stdio), ("dos", dos), ("conio", conio)):
        found |= dict.fromkeys(module.__all__, f"bgi.{name}")
    return found | dict.fromkeys(bgi.__all__, "bgi")


MODULES = _modules()


class PortLibrary(PortValues):
    """Writes calls of the library."""

    def library(self, value: LibraryCall) -> Code:
        """A call whose answer counts."""
        special = self.special(value)
        if special is not None:
            return special
        if value.name in LIBRARY_OUTS:
            return self.answered(value, True)
        return self._direct(value)

    def special(self, value: LibraryCall) -> Code | None:
        """A call in other words; None if there are none."""
        raise NotImplementedError

    def library_effect(self, value: LibraryCall) -> None:
        """A call as a statement."""
        if value.name in LIBRARY_OUTS:
            self.answered(value, False)
            return
        if value.name in _NAMELESS.split():
            return
        code = self.library(value)
        if "(" in code:
            self.line(code)

    def _direct(self, value: LibraryCall) -> Code:
        module = MODULES.get(value.name)
        if module is None:
            raise self.refuse(value.place, f"{value.name}()")
        return call(self.names.use(module, value.name), self.arguments(value))

    def parameters(self, value: LibraryCall) -> tuple[Type, ...]:
        """The types of a function's parameters."""
        symbol = self.headers.symbol(value.name)
        assert symbol is not None and isinstance(symbol.type, FunctionType)
        return symbol.type.parameters

    def arguments(self, value: LibraryCall) -> list[Code]:
        """The arguments of a call of the library."""
        types = self.parameters(value)

        def one(place: int, argument: Value) -> Code:
            if place < len(types) and is_const_text(types[place]):
                return self.string(argument)
            if isinstance(argument.type, PointerType) and is_text(argument.type):
                return self.string(argument)
            if isinstance(argument.type, PointerType):
                return self.pointer(argument, self.shapes.shape(argument))
            return self.value(argument)

        return self.ordered(value.arguments, one, _parameter_names(value.name))

    def ordered(
        self,
        values: tuple[Value, ...],
        write: Callable[[int, Value], Code],
        called: Sequence[str] = (),
    ) -> list[Code]:
        """Arguments; where it is to be seen, they are computed from right to left, as C did.

        Args:
            values: the arguments.
            write: writes one, by its place.
            called: the names of the parameters.
        """
        if not order_matters(values):
            return [write(place, one) for place, one in enumerate(values)]
        acting = [place for place, one in enumerate(values) if has_effects(one)]
        codes: dict[int, Code] = {}
        for place in range(len(values) - 1, -1, -1):
            one = values[place]
            code = write(place, one)
            later = place > acting[0] and (
                place in acting or order_matters((values[acting[0]], one))
            )
            if later and not isinstance(one, Constant):
                wanted = called[place] if place < len(called) else "value"
                name = self.temporary(wanted)
                self.line(f"{name} = {code}")
                code = Code(name)
            codes[place] = code
        return [codes[place] for place in range(len(values))]

    # Functions that answer through pointers

    def answered(self, value: LibraryCall, counts: bool) -> Code:
        """A call that answers through pointers: what it answers is assigned."""
        name, given = value.name, value.arguments
        places = [place for place in LIBRARY_OUTS[name] if place < len(given)]
        if name.endswith("scanf"):
            return self._scanned(value, places[0] if places else len(given))
        if name == "time":
            return self._time(value)
        targets = [self.outs.place(given[place]) for place in places]
        if any(one is None for one in targets):
            raise self.refuse(value.place, f"where {name}() answers")
        codes = [self.target(one) for one in targets if one is not None]
        kept = [one for place, one in enumerate(given) if place not in places]
        texts = [self.string(one) if is_text(one.type) else self.value(one) for one in kept]
        if name == "initgraph":
            texts = [self.value(one) for one in targets if one is not None] + texts
        function = self.names.use("math" if name in ("modf", "frexp") else "bgi", name)
        answer = ["value"] if name in ("modf", "frexp") else []
        self.line(f"{', '.join([*answer, *codes])} = {call(function, texts)}")
        return Code(answer[0] if answer else "None")

    def _time(self, value: LibraryCall) -> Code:
        now = call("int", [call(self.names.use("time", "time"), [])])
        target = self.outs.place(value.arguments[0]) if value.arguments else None
        if target is None:
            return now
        self.line(f"{self.target(target)} = {now}")
        return self.place_code(target)

    def _scanned(self, value: LibraryCall, first: int) -> Code:
        text = walking.literal(value.arguments[first - 1])
        if text is None:
            raise self.refuse(value.place, "a format that is not written in the call")
        letters = scanned(text.decode("cp437"))
        before = [self.string(one) for one in value.arguments[:first]]
        module = "bgi.conio" if value.name == "cscanf" else "bgi.stdio"
        code = call(self.names.use(module, value.name), before)
        targets = value.arguments[first:]
        if len(targets) < len(letters):
            letters = letters[: len(targets)]
        codes, behind = self._scan_targets(letters, targets)
        self.line(f"{', '.join(codes)} = {code}" if codes else code)
        for line in behind:
            self.line(line)
        return Code(str(len(letters)))

    def _scan_targets(
        self, letters: list[str], targets: tuple[Value, ...]
    ) -> tuple[list[Code], list[str]]:
        """What scanf() assigns to, and what has to be done behind it."""
        codes: list[Code] = []
        behind: list[str] = []
        for letter, target in zip(letters, targets, strict=False):
            place = self.outs.place(target)
            if letter in "s[":
                if place is None:
                    codes.append(Code("word"))
                    behind += self.filled(target, Code("word"))
                else:
                    raise self.refuse(target.place, "a word that goes into one character")
                shape = self.shapes.shape(target)
                if shape == TEXT:
                    codes[-1] = Code(behind.pop().partition(" = ")[0])
                continue
            if place is None:
                shape = self.shapes.shape(target)
                if not isinstance(target.type, PointerType) or not shape:
                    raise self.refuse(target.place, "what is no address")
                code = Code(f"{self.pointer(target, shape).inside(17)}[0]")
            else:
                code = self.target(place)
            codes.append(code)
            if letter == "c":
                behind.append(f"{code} = ord({code})")
        return codes, behind

    def image(self, value: Value, stored: bool = False) -> Code:
        """Where a piece of the screen is kept."""
        while isinstance(value, Converted):
            value = value.operand
        if isinstance(value, Address):
            value = value.operand
        return self.target(value) if stored else self.place_code(value)

    # Strings

    def filled(self, target: Value, code: Code) -> list[str]:
        """The statements that write a string somewhere."""
        shape = self.shapes.shape(target)
        if shape == TEXT:
            inner = target
            while isinstance(inner, Converted):
                inner = inner.operand
            if isinstance(inner, Address) and isinstance(inner.operand.type, ArrayType):
                return [f"{self.target(inner.operand)} = {code}"]
            return [f"{self.target(inner)} = {code}"]
        return [str(call(self.helpers.use("store_text"), [self.pointer(target, shape), code]))]

    def fill(self, target: Value, code: Code) -> Code:
        """Write a string somewhere; where it stands is the answer."""
        for line in self.filled(target, code):
            self.line(line)
        return self.pointer(target, self.shapes.shape(target)) if not self.quiet else Code("")

    quiet = False
    """Whether nobody asks for the answer."""

    def formatted(self, values: tuple[Value, ...]) -> Code:
        """What sprintf() writes: an f-string where that is exactly the same."""
        format_, *rest = values
        codes = self.ordered(tuple(rest), lambda place, one: self.printed(one))
        text = walking.literal(format_)
        if text is not None:
            types = [one.type for one in rest]
            said = f_string(text.partition(b"\0")[0].decode("cp437"), codes, types)
            if said is not None:
                return Code(said)
        return call(self.names.use("bgi.stdio", "sprintf"), [self.string(format_), *codes])

    def printed(self, value: Value) -> Code:
        """What printf() is given."""
        return self.string(value) if isinstance(value.type, PointerType) else self.value(value)


@functools.cache
def _parameter_names(name: str) -> tuple[str, ...]:
    """What the parameters of a function of `bgi` are called."""
    function = getattr(bgi, name, None)
    return tuple(inspect.signature(function).parameters) if inspect.isfunction(function) else ()
