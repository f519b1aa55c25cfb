"""cout and cin as printf() and scanf()."""

from __future__ import annotations

from typing import NamedTuple

from bgi.turboc.checker.typed import (
    Address,
    Constant,
    Converted,
    LibraryCall,
    MethodCall,
    Quoted,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    LONG,
    UCHAR,
    ULONG,
    UNSIGNED,
    FloatType,
    IntType,
    PointerType,
    StructType,
    Type,
    is_text,
)
from bgi.turboc.emitter.effects import has_effects
from bgi.turboc.port.pointershapes import TEXT
from bgi.turboc.port.portobjects import PortObjects
from bgi.turboc.port.pycode import Code, call, quoted

_OUTPUTS = ("cout", "cerr", "clog")
_COMPARED = ("operator<", "operator>")
"""What `cout < "text"` does, a slip that was let pass: nothing."""

_LETTERS: dict[Type, str] = {UNSIGNED: "u", LONG: "ld", ULONG: "lu"}
_LINES = {"endl": "\n", "flush": "", "ends": "\0"}


class _Item(NamedTuple):
    """What is written: its conversion, and the value, if it is no text that is known."""

    format: str
    value: Value | None


class PortStreams(PortObjects):
    """Writes what is written to streams, and read."""

    def stream(self, value: MethodCall) -> Code:
        """A call of a method of a stream; what is written as a chain is one printf()."""
        chain = [one for one in _chain(value) if one.method.name not in _COMPARED]
        if not chain:
            return Code("")
        base = chain[0].base
        while isinstance(base, Converted):
            base = base.operand
        name = base.symbol.name if isinstance(base, Variable) else ""
        if name in _OUTPUTS and all(one.method.name in ("operator<<", "flush") for one in chain):
            self._write(chain)
        elif name == "cin" and all(one.method.name == "operator>>" for one in chain):
            self._read(chain)
        elif name == "cin" and len(chain) == 1:
            return self._keyboard(value)
        else:
            raise self.refuse(value.place, _why(value, base, name))
        return Code("")

    # Writing

    def _write(self, chain: list[MethodCall]) -> None:
        items: list[_Item] = []
        width = ""
        for one in chain:
            if not one.arguments:
                continue
            argument = one.arguments[0]
            if isinstance(argument, LibraryCall) and argument.name == "setw":
                count = argument.arguments[0]
                if not isinstance(count, Constant):
                    raise self.refuse(one.place, "a width that is computed")
                width = str(int(count.value))
                continue
            if items and has_effects(argument):  # what stands before it is written before it
                self._print(items)
                items = []
            items.append(self._item(argument, width))
            width = ""
        self._print(items)

    def _item(self, argument: Value, width: str) -> _Item:
        inner = argument.operand if isinstance(argument, Address) else argument
        if isinstance(inner, Variable) and inner.symbol.name in _LINES:
            return _Item(_LINES[inner.symbol.name], None)
        if isinstance(inner, Quoted) and not width and self.names.named(inner) is None:
            text = inner.data.partition(b"\0")[0].decode("cp437")
            return _Item(text.replace("%", "%%"), None)
        type_ = argument.type
        if is_text(type_):
            return _Item(f"%{width}s", argument)
        if type_ in (CHAR, UCHAR):
            known = argument.value if isinstance(argument, Constant) and not width else None
            if known is not None:
                return _Item(chr(int(known)).replace("%", "%%"), None)
            return _Item(f"%{width}c", argument)
        if isinstance(type_, IntType):
            return _Item(f"%{width}{_LETTERS.get(type_, 'd')}", argument)
        if isinstance(type_, FloatType):
            return _Item(f"%{width}g", argument)
        raise self.refuse(argument.place, "what is written here")

    def _print(self, items: list[_Item]) -> None:
        format_ = "".join(one.format for one in items)
        values = [self.printed(one.value) for one in items if one.value is not None]
        if format_:
            function = self.names.use("bgi.stdio", "printf")
            self.line(call(function, [quoted(format_), *values]))

    # Reading

    def _read(self, chain: list[MethodCall]) -> None:
        format_ = ""
        codes: list[Code] = []
        behind: list[str] = []
        for one in chain:
            argument = one.arguments[0]
            if isinstance(argument.type, PointerType):
                format_ += "%s"
                lines = self.filled(argument, Code("word"))
                direct = self.shapes.shape(argument) == TEXT
                codes.append(Code(lines[0].partition(" = ")[0] if direct else "word"))
                behind += [] if direct else lines
                continue
            place = self.outs.place(argument)
            if place is None:
                raise self.refuse(one.place, "what is read here")
            code = self.target(place)
            codes.append(code)
            format_ += _scanned_as(place.type)
            if place.type in (CHAR, UCHAR):
                behind.append(f"{code} = ord({code})")
        function = self.names.use("bgi.stdio", "scanf")
        self.line(f"{', '.join(codes)} = {call(function, [quoted(format_)])}")
        for line in behind:
            self.line(line)

    def _keyboard(self, value: MethodCall) -> Code:
        if value.method.name == "get" and not value.arguments:
            return Code(f"{self.names.use('bgi.stdio', 'getchar')}()")
        if value.method.name in ("get", "getline") and len(value.arguments) == 2:
            line = Code(f"{self.names.use('bgi.stdio', 'gets')}()")
            return self.fill(value.arguments[0], line)
        raise self.refuse(value.place, f"cin.{value.method.name}()")


def _why(value: MethodCall, base: Value, name: str) -> str:
    """Why a call of a method of a stream cannot be carried over."""
    method = value.method.name
    called = name or "a stream" if method.startswith("operator") else f"{name}.{method}()"
    if name in _OUTPUTS or name == "cin" or not isinstance(base.type, StructType):
        return called
    return f"{called} of an {base.type.tag}: only cout and cin are known"


def _chain(value: MethodCall) -> list[MethodCall]:
    """The calls of a chain, in their order."""
    found = [value]
    while True:
        base = found[0].base
        while isinstance(base, Converted) or hasattr(base, "operand"):
            base = base.operand
        if not isinstance(base, MethodCall):
            return found
        found.insert(0, base)


def _scanned_as(type_: Type) -> str:
    """The conversion that reads a number."""
    if type_ in (CHAR, UCHAR):
        return " %c"
    if isinstance(type_, IntType):
        return f"%{_LETTERS.get(type_, 'd')}"
    return "%f" if type_ == FloatType(32) else "%lf"
