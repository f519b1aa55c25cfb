"""iomanip.h: the flags of a stream, and what is told to it by `<<` and `>>`."""

from __future__ import annotations

from typing import Any

from bgi.turboc.runtime.memory import Record

SKIP, LEFT, RIGHT, INTERNAL, DEC, OCT, HEX, BASE_SHOWN = 1, 2, 4, 8, 16, 32, 64, 128
POINT, UPPER, PLUS, SCIENTIFIC, FIXED = 256, 512, 1024, 2048, 4096
ADJUST, BASE, REAL = 14, 112, 6144
END, FAILED, BAD = 1, 2, 4
"""What has happened to a stream."""

IN, OUT, AT_END, APPEND, EMPTY, NO_CREATE, NO_REPLACE = 1, 2, 4, 8, 16, 32, 64

CONSTANTS: dict[str, int | float] = {
    f"ios::{name}": value
    for name, value in {
        **{"skipws": SKIP, "left": LEFT, "right": RIGHT, "internal": INTERNAL, "dec": DEC},
        **{"oct": OCT, "hex": HEX, "showbase": BASE_SHOWN, "showpoint": POINT, "uppercase": UPPER},
        **{"showpos": PLUS, "scientific": SCIENTIFIC, "fixed": FIXED, "unitbuf": 8192},
        **{"stdio": 16384, "adjustfield": ADJUST, "basefield": BASE, "floatfield": REAL},
        **{"goodbit": 0, "eofbit": END, "failbit": FAILED, "badbit": BAD, "hardfail": 128},
        **{"in": IN, "out": OUT, "ate": AT_END, "app": APPEND, "trunc": EMPTY},
        **{"nocreate": NO_CREATE, "noreplace": NO_REPLACE, "binary": 128},
        **{"beg": 0, "cur": 1, "end": 2},
    }.items()
}

DECLARATIONS = """
manipulator setw(int n); manipulator setprecision(int n); manipulator setfill(int c);
manipulator setiosflags(long flags); manipulator resetiosflags(long flags);
manipulator setbase(int n); manipulator setclr(int color); manipulator setbk(int color);
manipulator setattr(int attribute); manipulator setxy(int x, int y);
manipulator setcrsrtype(int kind);
"""

NAMES = dict.fromkeys(["endl", "ends", "flush", "hex", "dec", "oct", "ws"], "manipulator @")

TYPES = {"manipulator": "struct @ { int kind, value; };"}


class manipulator(Record):
    """What is told to a stream: a kind and a value."""

    __slots__ = ("kind", "value")
    MEMBERS = ("kind", "value")

    def __init__(self, kind: str = "", value: Any = 0) -> None:
        self.kind = kind
        self.value = value


def _maker(kind: str) -> Any:
    return lambda value: manipulator(kind, value)


MANIPULATORS: dict[str, Any] = {
    **{"endl": manipulator("write", 10), "ends": manipulator("write", 0)},
    **{"flush": manipulator(), "ws": manipulator("ws")},
    **{"dec": manipulator("base", DEC), "oct": manipulator("base", OCT)},
    **{"hex": manipulator("base", HEX), "setw": _maker("width")},
    **{"setprecision": _maker("precision"), "setfill": _maker("fill")},
    **{"setiosflags": _maker("set"), "resetiosflags": _maker("reset")},
    "setbase": lambda n: manipulator("base", {8: OCT, 16: HEX}.get(n, DEC)),
    **{"setclr": _maker("textcolor"), "setbk": _maker("textbackground")},
    **{"setattr": _maker("textattr"), "setcrsrtype": _maker("_setcursortype")},
    "setxy": lambda x, y: manipulator("gotoxy", (x, y)),
}
