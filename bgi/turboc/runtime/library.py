"""The whole library of Turbo C: what its headers declare, and the functions for one program."""

from __future__ import annotations

from typing import Any

import bgi
from bgi import conio
from bgi.turboc.runtime import (
    alloclib,
    filelib,
    filestreams,
    folderlib,
    graphicslib,
    interruptlib,
    manipulators,
    mathlib,
    pclib,
    stdiolib,
    streams,
    stringlib,
    timelib,
    varargs,
    winlib,
)
from bgi.turboc.runtime.binding import bound, declarations
from bgi.turboc.runtime.headertexts import TEXTS
from bgi.turboc.runtime.limits import LIMITS
from bgi.turboc.runtime.session import Session
from bgi.turboc.runtime.structures import structures

_NAMES = (
    "alloc assert bios complex conio constrea ctype dir direct dos errno fcntl float fstream "
    "generic graphics io iomanip iostream limits locale malloc math mem memory new process share "
    "setjmp signal stat stdarg stdbool stddef stdint stdio stdiostr stdlib stream string strstrea "
    "time timeb types unistd utime values varargs winbgim windows"
)
_MODERN = (
    "iostream iomanip fstream sstream cassert cctype cerrno cfloat climits cmath csetjmp csignal "
    "cstdarg cstddef cstdio cstdlib cstring ctime complex new stdc++.h graphics conio"
)
_ALIASES = {"cstdarg": "stdarg.h", "cassert": "assert.h", "cstdlib": "stdlib.h"}
_ALIASES |= {"csignal": "signal.h", "complex": "complex.h", "varargs.h": "stdarg.h"}

HEADERS: dict[str, str] = {
    name: TEXTS.get(_ALIASES.get(name, name), "")
    for name in (*(f"{one}.h" for one in _NAMES.split()), *_MODERN.split())
}
"""The names of the headers, and what stands in them besides the library."""

MACROS = interruptlib.MACROS
"""Macros that are there without a header."""

_DIRECT = {
    **declarations(graphicslib.DIRECT),
    **declarations(pclib.DIRECT),
    **declarations(winlib.DIRECT),
}
_TRACED = {
    **declarations(pclib.TRACED),
    **declarations(timelib.TRACED),
    **declarations(interruptlib.TRACED),
}
_PLAIN = declarations(winlib.PLAIN)
_DRIVERS = "CGA EGAVGA Herc ATT PC3270 IBM8514"
_FONTS = "triplex small sansserif gothic script simplex bold euro complex triplex_scr"
_LINKED = {
    f"{name}_{what}{far}": "void @(void)"
    for what, every in (("driver", _DRIVERS), ("font", _FONTS))
    for name in every.split()
    for far in ("", "_far")
}

_PURE = (alloclib, mathlib, stringlib, varargs)
_PARTS = (
    *(graphicslib, winlib, pclib, timelib, interruptlib),
    *(filelib, folderlib, stdiolib, manipulators, varargs),
)

FUNCTIONS: dict[str, str] = {
    **_DIRECT,
    **_TRACED,
    **_PLAIN,
    **_LINKED,
    **{
        name: one
        for part in (*_PURE, *_PARTS)
        for block in ("DECLARATIONS", "OTHERS")
        for name, one in declarations(getattr(part, block, "")).items()
    },
    **{
        name: one for part in (*_PARTS, streams) for name, one in getattr(part, "NAMES", {}).items()
    },
}
"""How each function, and each variable, is declared: `@` stands for its name."""

_STRUCTURES: dict[str, str] = {
    name: one
    for part in (graphicslib, pclib, timelib, interruptlib, folderlib, stdiolib, mathlib)
    for name, one in part.TYPES.items()
}

TYPES = {**_STRUCTURES, **manipulators.TYPES, **streams.TYPES, **filestreams.TYPES}
"""The structures and classes, as C++ writes them."""

CONSTANTS: dict[str, int | float] = {
    **{
        name: value
        for module in (bgi, conio)
        for name in module.__all__
        if isinstance(value := getattr(module, name), int)
    },
    **{"NULL": 0, "EOF": -1, "EXIT_SUCCESS": 0, "EXIT_FAILURE": 1, **LIMITS},
    **mathlib.CONSTANTS,
    **{
        name: value
        for part in (filelib, manipulators, pclib, timelib, winlib)
        for name, value in part.CONSTANTS.items()
    },
}


def names(program: Session) -> dict[str, Any]:
    """What a program's Python calls: functions, classes and streams by name."""
    made = structures(_STRUCTURES)
    registers, segments = made["REGS"](), made["SREGS"]()
    stdio = stdiolib.StdioLibrary(program)
    files = filelib.FileLibrary(program, stdio)
    interrupts = interruptlib.InterruptLibrary(program, registers, segments)
    parts = (
        graphicslib.GraphicsLibrary(program, made["palettetype"]),
        *(winlib.WindowLibrary(program), pclib.PCLibrary(program), interrupts),
        *(timelib.TimeLibrary(program, made["tm"]), stdio, files),
        folderlib.FolderLibrary(program),
    )
    found: dict[str, Any] = {**manipulators.MANIPULATORS, **dict.fromkeys(_LINKED, _linked)}
    for pure in _PURE:
        found |= pure.FUNCTIONS
    for name in FUNCTIONS:
        for part in parts:
            if hasattr(part, name):
                found[name] = getattr(part, name)
    for name, declaration in _DIRECT.items():
        function = getattr(bgi, name, None) or pclib.direct(name)
        found[name] = bound(name, declaration, function, program.trace)
    for name, declaration in _TRACED.items():
        found[name] = bound(name, declaration, found[name], program.trace)
    found |= {name: _whole(getattr(bgi, name)) for name in _PLAIN}
    found |= {f"struct_{name}": cls for name, cls in made.items()}
    found |= {"div": _quotient(made["div_t"]), "ldiv": _quotient(made["ldiv_t"])}
    found |= {
        "busy": program.pc.busy,
        "far_pointer": interrupts.far_pointer,
        "_raise": parts[2].raise_,
    }
    return found | _variables(stdio, registers, segments) | filestreams.classes(stdio, files)


def _variables(stdio: stdiolib.StdioLibrary, registers: Any, segments: Any) -> dict[str, Any]:
    """The variables of the headers, and the streams."""
    outputs = ("stdout", "stderr", "stdaux", "stdprn")
    return {
        **dict.fromkeys(stdiolib.NAMES, 0),
        **pclib.VALUES,
        **{"stdin": stdio.keyboard, **dict.fromkeys(outputs, stdio.screen)},
        **{name: streams.ostream(stdio, stdio.screen) for name in ("cout", "cerr", "clog")},
        **{"cin": streams.istream(stdio, stdio.keyboard)},
        **{"struct_manipulator": manipulators.manipulator, "_more": ()},
        **{"_registers": registers, "_segments": segments},
    }


def _linked() -> None:
    """What a driver or a font that was linked into a program is."""


def _whole(function: Any) -> Any:
    """A function whose answer is a number, not a truth."""
    return lambda *given: None if (answer := function(*given)) is None else int(answer)


def _quotient(cls: Any) -> Any:
    """div() and ldiv()."""
    from bgi import stdlib

    def call(a: int, b: int) -> Any:
        found = stdlib.div(a, b)
        return cls().filled(quot=found.quot, rem=found.rem)

    return call
