"""The whole library of Turbo C: what its headers declare, and the functions for one program."""

from __future__ import annotations

from typing import Any

import bgi
from bgi import conio
from bgi.turboc.runtime import graphicslib, pclib, purelib, stdiolib, streams
from bgi.turboc.runtime.binding import bound, declarations
from bgi.turboc.runtime.session import Session
from bgi.turboc.runtime.structures import structures

_NAMES = (
    "graphics conio dos bios stdio stdlib string math ctype time alloc malloc mem memory process "
    "iostream iomanip fstream stdarg limits values float dir io errno assert new winbgim complex "
    "fcntl stddef windows"
)
HEADERS = {f"{name}.h" for name in _NAMES.split()} | {
    *("iostream", "iomanip", "fstream", "cmath", "cstdlib", "cstdio", "cstring", "ctime")
}
"""The names of the headers."""

_DIRECT = {**declarations(graphicslib.DIRECT), **declarations(pclib.DIRECT)}
_TRACED = declarations(pclib.TRACED)
_DRIVERS = "CGA_driver EGAVGA_driver Herc_driver ATT_driver PC3270_driver IBM8514_driver"
_FONTS = "triplex_font small_font sansserif_font gothic_font"
_LINKED = dict.fromkeys(f"{_DRIVERS} {_FONTS}".split(), "void @(void)")

FUNCTIONS: dict[str, str] = {
    **_DIRECT,
    **_TRACED,
    **declarations(graphicslib.OTHERS),
    **declarations(pclib.OTHERS),
    **declarations(purelib.DECLARATIONS),
    **declarations(stdiolib.DECLARATIONS),
    **declarations(streams.DECLARATIONS),
    **_LINKED,
    **stdiolib.NAMES,
    **streams.NAMES,
}
"""How each function, and each variable, is declared: `@` stands for its name."""

TYPES = {**graphicslib.TYPES, **pclib.TYPES, **stdiolib.TYPES, **streams.TYPES}
"""The structures and classes, as C++ writes them."""

_MATH = {
    **{"M_PI": 3.14159265358979323846, "M_PI_2": 1.57079632679489661923, "M_E": 2.718281828459045},
    **{"M_PI_4": 0.785398163397448309616, "M_SQRT2": 1.4142135623730951, "CLK_TCK": 18.2},
}

CONSTANTS: dict[str, int | float] = {
    **{
        name: value
        for module in (bgi, conio)
        for name in module.__all__
        if isinstance(value := getattr(module, name), int)
    },
    **{"NULL": 0, "EOF": -1, "RAND_MAX": 0x7FFF, "INT_MAX": 32767, "INT_MIN": -32768},
    **{"MAXINT": 32767, "MAXCOLORS": 15, "SEEK_SET": 0, "SEEK_CUR": 1, "SEEK_END": 2},
    **{"EXIT_SUCCESS": 0, "EXIT_FAILURE": 1, "LONG_MAX": 0x7FFFFFFF, "UINT_MAX": 0xFFFF},
    **_MATH,
    **streams.CONSTANTS,
}


def names(program: Session) -> dict[str, Any]:
    """What a program's Python calls: functions, classes and streams by name."""
    trace = program.trace
    stdio = stdiolib.StdioLibrary(program)
    parts = (graphicslib.GraphicsLibrary(program), pclib.PCLibrary(program), stdio)
    found: dict[str, Any] = {**purelib.FUNCTIONS, **streams.MANIPULATORS}
    for name in FUNCTIONS:
        for part in parts:
            if hasattr(part, name):
                found[name] = getattr(part, name)
    for name, declaration in _DIRECT.items():
        function = getattr(bgi, name, None) or pclib.direct(name)
        found[name] = bound(name, declaration, function, trace)
    for name, declaration in _TRACED.items():
        found[name] = bound(name, declaration, found[name], trace)
    made = structures({**graphicslib.TYPES, **pclib.TYPES, **stdiolib.TYPES})
    found |= {f"struct_{name}": cls for name, cls in made.items()}
    found |= {name: lambda: None for name in _LINKED}
    found |= dict.fromkeys(stdiolib.NAMES, stdio)
    found |= {name: streams.ostream(stdio) for name in ("cout", "cerr", "clog")}
    return found | {"cin": streams.istream(stdio), "struct_manipulator": streams.manipulator}
