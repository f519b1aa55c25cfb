"""Files of stdio.h as Python's own: open(), write(), seek() and close()."""

from __future__ import annotations

from collections.abc import Callable

from bgi.turboc.checker.typed import (
    Comparison,
    Constant,
    Converted,
    Inverse,
    LibraryCall,
    Routine,
    Value,
    Variable,
)
from bgi.turboc.checker.types import PointerType, StructType
from bgi.turboc.port import walking
from bgi.turboc.port.portlibrary import PortLibrary
from bgi.turboc.port.pycode import Code, call, quoted

_SCREEN = ("stdin", "stdout", "stderr", "stdprn", "stdaux")

_UNSAID = {
    **dict.fromkeys(("fread", "fwrite"), "the bytes of a variable in a file"),
    "fscanf": "read a line of the file, and split it",
    "feof": "in Python, what is read at the end of a file is empty",
    "fgets": "read a line by readline()",
}
"""What Python does otherwise."""


class PortFiles(PortLibrary):
    """Writes calls that use files."""

    routines: list[Routine]
    """All functions of the program."""

    def file_call(self, value: LibraryCall) -> Code | None:
        """A call of a function of files; None if it is another one, or one of the screen's."""
        if value.name in _UNSAID:
            raise self.refuse(value.place, f"{value.name}(): {_UNSAID[value.name]}")
        write = _WRITERS.get(value.name)
        if write is None:
            return None
        streams = [one for one in value.arguments if _is_file(one)]
        screen = [
            one for one in streams if isinstance(one, Variable) and one.symbol.name in _SCREEN
        ]
        return None if screen else write(self, value)

    def answered(self, value: LibraryCall, counts: bool) -> Code:
        """A call that answers through pointers; the one that reads a file is told to be another."""
        self.file_call(value)
        return super().answered(value, counts)

    def _fopen(self, value: LibraryCall) -> Code:
        name, mode = value.arguments
        written = walking.literal(mode)
        if written is None:
            raise self.refuse(value.place, "fopen() with a mode that is not written there")
        helper = "open_file" if self._asks() else "open_or_empty"
        if helper == "open_or_empty":
            self.names.use("io", "BytesIO")
            self.names.use("io", "StringIO")
        how = quoted(written.decode("cp437"))
        return call(self.helpers.use(helper), [self.string(name), how])

    def _asks(self) -> bool:
        """Whether the program ever asks if a file is open."""
        for routine in self.routines:
            for one in walking.values(walking.of_routine(routine)):
                asked = one.left if isinstance(one, Comparison) else None
                asked = one.operand if isinstance(one, Inverse) else asked
                if asked is not None and _is_file(asked):
                    return True
        return False

    def _method(self, value: LibraryCall, name: str, given: list[Code]) -> Code:
        """A call of a method of the file that is the last argument, or the first."""
        file = next(one for one in value.arguments if _is_file(one))
        return call(f"{self.value(file).inside(17)}.{name}", given)

    def _is_binary(self, value: LibraryCall) -> bool:
        """Whether the program's files are opened as bytes."""
        found = set()
        for routine in self.routines:
            for one in walking.values(walking.of_routine(routine)):
                if isinstance(one, LibraryCall) and one.name == "fopen":
                    found.add(b"b" in (walking.literal(one.arguments[1]) or b""))
        if len(found) > 1:
            raise self.refuse(value.place, "some files as text, and others as bytes")
        return found == {True}

    def _only(self, value: LibraryCall, binary: bool) -> None:
        """Refuse a call that does not go with how the files are opened."""
        if self._is_binary(value) != binary:
            kind = "text" if binary else "bytes"
            raise self.refuse(value.place, f"{value.name}() in a file that is opened as {kind}")

    def _putting(self, value: LibraryCall, code: Code) -> Code:
        self._only(value, False)
        return self._method(value, "write", [code])

    def _fprintf(self, value: LibraryCall) -> Code:
        return self._putting(value, self.formatted(value.arguments[1:]))

    def _fputs(self, value: LibraryCall) -> Code:
        return self._putting(value, self.string(value.arguments[0]))

    def _fputc(self, value: LibraryCall) -> Code:
        one = value.arguments[0]
        known = isinstance(one, Constant)
        return self._putting(
            value, self.character(one) if known else call("chr", [self.value(one)])
        )

    def _getc(self, value: LibraryCall) -> Code:
        self._only(value, False)
        return call(self.helpers.use("next_code"), [self.value(value.arguments[0])])

    def _putw(self, value: LibraryCall) -> Code:
        self._only(value, True)
        self.names.modules.add("struct")
        code = call("struct.pack", [quoted("<h"), self.value(value.arguments[0])])
        return self._method(value, "write", [code])

    def _getw(self, value: LibraryCall) -> Code:
        self._only(value, True)
        return call(self.helpers.use("next_int"), [self.value(value.arguments[0])])

    def _close(self, value: LibraryCall) -> Code:
        return self._method(value, "close", [])

    def _rewind(self, value: LibraryCall) -> Code:
        return self._method(value, "seek", [Code("0")])


def _is_file(value: Value) -> bool:
    """Whether a value is a `FILE *`."""
    while isinstance(value, Converted) and isinstance(value.operand.type, PointerType):
        value = value.operand
    type_ = value.type
    return (
        isinstance(type_, PointerType)
        and isinstance(type_.to, StructType)
        and type_.to.tag == "FILE"
    )


_WRITERS: dict[str, Callable[[PortFiles, LibraryCall], Code]] = {
    "fopen": PortFiles._fopen,
    "fclose": PortFiles._close,
    "rewind": PortFiles._rewind,
    "fprintf": PortFiles._fprintf,
    "fputs": PortFiles._fputs,
    **dict.fromkeys(("fputc", "putc"), PortFiles._fputc),
    **dict.fromkeys(("fgetc", "getc"), PortFiles._getc),
    **{"putw": PortFiles._putw, "getw": PortFiles._getw},
}
