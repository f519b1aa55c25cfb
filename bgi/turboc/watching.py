"""Programs in Python under a script and with a trace: the same lines as a C program would write.

The program imports from `bgi`, and gets modules in which the functions that a script answers, or a
trace tells of, are those that C programs call.
"""

from __future__ import annotations

import io
import re
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

import bgi
from bgi import bios, conio, dos, stdio, stdlib
from bgi.interrupts.registers import REGS
from bgi.memory.image import Image
from bgi.turboc.runtime import graphicslib, library, pclib, timelib
from bgi.turboc.runtime.binding import declarations
from bgi.turboc.runtime.memory import Pointer, text
from bgi.turboc.runtime.session import Session

Function = Callable[..., Any]

_MODULES = {
    "bgi": bgi,
    "bgi.conio": conio,
    "bgi.dos": dos,
    "bgi.stdio": stdio,
    "bgi.stdlib": stdlib,
    "bgi.bios": bios,
}

_ALIKE = {
    *(["registerbgidriver", "registerbgifont", "registerfarbgidriver", "registerfarbgifont"]),
    *declarations(graphicslib.DIRECT),
    *declarations(pclib.DIRECT),
    *declarations(pclib.TRACED),
    *declarations(timelib.TRACED),
    *(["installuserdriver", "installuserfont", "randomize", "getche", "ungetch", "Sleep"]),
    *(["printf", "cprintf", "puts", "cputs", "putchar", "putch", "perror", "getchar", "movetext"]),
}
"""Functions that C and Python call with the same arguments."""

_OUTS = {"detectgraph": (0, 1), "getaspectratio": (0, 1), "getmoderange": (1, 2)}
"""Where C's functions take pointers for what Python's return."""

_TEXTS = ("getmodename", "getdrivername", "grapherrormsg")
_SETTINGS = ("getviewsettings", "getlinesettings", "getfillsettings", "gettextsettings")
_CONVERSION = re.compile(r"%(\*?)(\d*)[hlLFN]*(\[\^?\]?[^\]]*\]|[a-zA-Z])")
_LINE = 1000


@contextmanager
def watched(session: Session) -> Iterator[dict[str, Any]]:
    """In the block, programs that import `bgi` are under the script, and in the trace.

    What the block gets are names that the program finds instead of Python's own.
    """
    before = {name: sys.modules[name] for name in (*_MODULES, "time")}
    functions = _functions(session)
    made = {name: _copy(name, module, functions) for name, module in _MODULES.items()}
    for name, module in made.items():
        if name != "bgi":
            setattr(made["bgi"], name.partition(".")[2], module)
    if session.scripted:
        made["time"] = _copy("time", time, {"time": functions["time"], "sleep": _no_sleep})
    sys.modules.update(made)
    try:
        yield {"open": _open(session)}
    finally:
        sys.modules.update(before)


def _no_sleep(seconds: float) -> None:
    """time.sleep() where a script has its own time."""


def _open(session: Session) -> Function:
    """open(): in the trace it is fopen(); a script's program finds an empty folder."""

    def call(file: Any, mode: str = "r", *given: Any, **named: Any) -> Any:
        found = None
        try:
            if session.scripted:
                found = _from_memory(session, str(file), mode, named)
            else:
                found = open(file, mode, *given, **named)  # noqa: SIM115
        finally:
            if session.trace:
                words = str(file).encode("cp437", "replace"), mode.encode()
                session.trace.call("fopen", words, int(found is not None))
        return found

    return call


def _from_memory(session: Session, name: str, mode: str, named: dict[str, Any]) -> Any:
    """A file that is gone with the program."""
    reads, writes = "r" in mode, "r" not in mode or "+" in mode
    data = session.folder.open(name, reads, writes, "w" in mode)
    if data is None:
        raise FileNotFoundError(2, "under a script the folder is empty at first", name)
    data.seek(0, 2 if "a" in mode else 0)
    if "b" in mode:
        return data
    return io.TextIOWrapper(data, named.get("encoding"), named.get("errors"), named.get("newline"))


def _copy(name: str, module: ModuleType, functions: dict[str, Function]) -> ModuleType:
    """A module with other functions in it."""
    made = ModuleType(name, module.__doc__)
    made.__dict__.update(module.__dict__)
    for one, function in functions.items():
        if hasattr(module, one):
            setattr(made, one, function)
    return made


def _functions(session: Session) -> dict[str, Function]:
    """All that is watched, by name."""
    c = library.names(session)
    found: dict[str, Function] = {name: _encoded(c[name]) for name in _ALIKE if name in c}
    found |= {name: _returning(c[name], places) for name, places in _OUTS.items()}
    found["initgraph"] = _initgraph(c["initgraph"])
    found |= {name: _decoded(c[name]) for name in _TEXTS}
    found |= {name: _asked(name, session) for name in (*_SETTINGS, "getarccoords")}
    found |= {name: _quiet(name, session) for name in ("getpalette", "getdefaultpalette")}
    found |= {name: _poly(c[name]) for name in ("drawpoly", "fillpoly")}
    found |= {name: _scanf(c[name]) for name in ("scanf", "cscanf")}
    found |= {"getimage": _getimage(c["getimage"]), "putimage": _putimage(c["putimage"])}
    found |= {"gets": _gets(c["gets"]), "setfillpattern": _setfillpattern(c["setfillpattern"])}
    found |= {"gettime": _time_of_day(c, "time"), "getdate": _time_of_day(c, "date")}
    found |= {"int86": _int86(c), "time": lambda: float(c["time"](None))}
    found["restorecrtmode"] = c["restorecrtmode"]
    return found


def _plain(value: Any) -> Any:
    """An argument as C's functions take it: texts are bytes."""
    return value.encode("cp437", "replace") if isinstance(value, str) else value


def _encoded(function: Function) -> Function:
    return lambda *given: function(*map(_plain, given))


def _decoded(function: Function) -> Function:
    return lambda *given: text(function(*given)).decode("cp437")


def _returning(function: Function, places: tuple[int, ...]) -> Function:
    def call(*given: Any) -> Any:
        answers = [Pointer([0]) for _ in places]
        rest = iter(given)
        everything = [
            answers[places.index(place)] if place in places else _plain(next(rest))
            for place in range(len(given) + len(places))
        ]
        function(*everything)
        return tuple(one.memory[0] for one in answers)

    return call


def _initgraph(function: Function) -> Function:
    def call(gd: int = 0, gm: int = 0, path: Any = "") -> tuple[int, int]:
        driver, mode = Pointer([gd]), Pointer([gm])
        function(driver, mode, _plain(path))
        return driver.memory[0], mode.memory[0]

    return call


def _asked(name: str, session: Session) -> Function:
    """A function that returns a structure."""

    def call() -> Any:
        found = getattr(bgi, name)()
        if session.trace:
            values = tuple(getattr(found, one) for one in found.__dataclass_fields__)
            session.trace.call(name, (), values)
        return found

    return call


def _quiet(name: str, session: Session) -> Function:
    """A function of whose answer the trace does not tell."""

    def call(*given: Any) -> Any:
        if session.trace:
            session.trace.call(name)
        return getattr(bgi, name)(*given)

    return call


def _poly(function: Function) -> Function:
    def call(points: Any, flat: Any = None, **more: Any) -> None:
        numbers = points if flat is None else flat
        pairs = [
            one for point in numbers for one in (point if hasattr(point, "__len__") else [point])
        ]
        count = len(pairs) // 2 if flat is None else points
        function(count, Pointer(pairs))

    return call


def _scanf(function: Function) -> Function:
    def call(format: Any) -> Any:
        written = format if isinstance(format, str) else format.decode("cp437")
        kinds = [
            (letter, int(width or 1))
            for skip, width, letter in _CONVERSION.findall(written.replace("%%", ""))
            if not skip
        ]
        boxes = [
            Pointer(bytearray(_LINE) if letter[0] in "s[" else [None] * width)
            for letter, width in kinds
        ]
        count = function(_plain(format), *boxes)
        answers = [
            None if number >= count else _read(letter, box)
            for number, ((letter, _), box) in enumerate(zip(kinds, boxes, strict=True))
        ]
        return answers[0] if len(answers) == 1 else tuple(answers)

    return call


def _read(letter: str, box: Pointer) -> Any:
    """What scanf() stored."""
    if letter[0] in "s[":
        return text(box).decode("cp437")
    if letter == "c":
        return bytes(box.memory).decode("cp437")
    return box.memory[0]


def _gets(function: Function) -> Function:
    def call() -> str | None:
        box = Pointer(bytearray(_LINE))
        return None if function(box) is None else text(box).decode("cp437")

    return call


def _getimage(function: Function) -> Function:
    def call(left: int, top: int, right: int, bottom: int, buffer: Any = None) -> Any:
        box = Pointer([None])
        function(left, top, right, bottom, box)
        if buffer is not None:
            buffer[: len(bytes(box.memory[0]))] = bytes(box.memory[0])
        return box.memory[0]

    return call


def _putimage(function: Function) -> Function:
    def call(left: int, top: int, image: Any, op: int) -> None:
        memory = [image] if isinstance(image, Image) else bytearray(image)
        function(left, top, Pointer(memory), op)

    return call


def _setfillpattern(function: Function) -> Function:
    return lambda pattern, color: function(Pointer([int(row) for row in pattern]), color)


def _time_of_day(c: dict[str, Any], name: str) -> Function:
    """gettime() and getdate()."""
    kind = getattr(dos, name)

    def call() -> Any:
        box = Pointer([c[f"struct_{name}"]()])
        c[f"get{name}"](box)
        return kind(*(getattr(box.memory[0], field) for field in kind.__dataclass_fields__))

    return call


_WORDS = ("ax", "bx", "cx", "dx", "si", "di", "cflag", "flags")


def _int86(c: dict[str, Any]) -> Function:
    def call(intno: int, inregs: REGS, outregs: REGS | None = None) -> int:
        given = c["struct_REGS"]()
        for name in _WORDS:
            setattr(given.x, name, getattr(inregs.x, name))
        answer: int = c["int86"](intno, Pointer([given]), Pointer([given]))
        target = inregs if outregs is None else outregs
        for name in _WORDS:
            setattr(target.x, name, getattr(given.x, name))
        return answer

    return call
