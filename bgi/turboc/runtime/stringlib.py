"""string.h and ctype.h."""

from __future__ import annotations

import re
from typing import Any

from bgi.turboc.runtime.binding import Function, characters, string
from bgi.turboc.runtime.memory import Pointer, text, write_bytes, write_text

_STRINGS = """
unsigned strlen(text s); char *strcpy(char *to, text s); char *strcat(char *to, text s);
char *strncpy(char *to, text s, unsigned n); char *strncat(char *to, text s, unsigned n);
char *stpcpy(char *to, text s); int strcmp(text a, text b); int strcoll(text a, text b);
int strncmp(text a, text b, unsigned n); unsigned strxfrm(char *to, text s, unsigned n);
int stricmp(text a, text b); int strcmpi(text a, text b); int strnicmp(text a, text b, unsigned n);
int strncmpi(text a, text b, unsigned n);
char *strchr(char *s, int c); char *strrchr(char *s, int c);
char *strstr(char *s, text part); char *strpbrk(char *s, text any); char *strtok(char *s, text any);
unsigned strspn(text s, text any); unsigned strcspn(text s, text any); char *strdup(text s);
char *strupr(char *s); char *strlwr(char *s); char *strrev(char *s); char *strset(char *s, int c);
char *strnset(char *s, int c, unsigned n);
"""

_CHARACTERS = """
int isalpha(int c); int isdigit(int c); int isalnum(int c); int isspace(int c); int isupper(int c);
int islower(int c); int ispunct(int c); int isxdigit(int c); int iscntrl(int c); int isprint(int c);
int isgraph(int c); int toupper(int c); int tolower(int c); int isascii(int c); int toascii(int c);
int _toupper(int c); int _tolower(int c); int strcasecmp(text a, text b);
"""

DECLARATIONS = _STRINGS + _CHARACTERS + re.sub(r"\b(?=(str|stp)\w+\()", "_f", _STRINGS)
"""Far strings have the same functions."""


def _class(test: str) -> Function:
    """A question of ctype.h, of ASCII."""
    return lambda c: int(0 <= c < 128 and getattr(chr(c), test)())


def _sign(a: Any, b: Any) -> int:
    return int(a > b) - int(a < b)


def _offset(s: Pointer, at: int) -> Pointer | None:
    return None if at < 0 else s + at


def _changed(change: Function) -> Function:
    """A function that changes a string in its place."""

    def call(s: Pointer, *given: Any) -> Pointer:
        write_text(s, change(text(s), *given))
        return s

    return call


def _joined(join: Function) -> Function:
    """A function that writes a string somewhere."""

    def call(to: Pointer, s: Any, *given: Any) -> Pointer:
        write_bytes(to, join(to, characters(s), *given))
        return to

    return call


_rest: list[Pointer | None] = [None]


def strtok(s: Pointer | None, any_: Any) -> Pointer | None:
    """The next word; its end becomes a zero."""
    here = s or _rest[0]
    if here is None:
        return None
    ends, data = characters(any_), text(here)
    start = next((i for i, c in enumerate(data) if c not in ends), -1)
    if start < 0:
        _rest[0] = None
        return None
    end = next((i for i in range(start, len(data)) if data[i] in ends), -1)
    _rest[0] = None if end < 0 else here + (end + 1)
    if end >= 0:
        here.memory[here.at + end] = 0
    return here + start


def stpcpy(to: Pointer, s: Any) -> Pointer:
    """Copy a string; where it ends is the answer."""
    write_text(to, characters(s))
    return to + len(characters(s))


def strxfrm(to: Pointer, s: Any, n: int) -> int:
    """Copy a string: its order is that of its characters already."""
    data = characters(s)
    write_bytes(to, (data + b"\0")[:n])
    return len(data)


def _span(s: Any, any_: Any, inside: bool) -> int:
    data, ends = characters(s), characters(any_)
    return next((i for i, c in enumerate(data) if (c in ends) != inside), len(data))


def _alike(a: Any, b: Any, n: int | None = None) -> int:
    """Compare strings, small letters like capitals."""
    return _sign(characters(a)[:n].lower(), characters(b)[:n].lower())


_CLASSES = "isalpha isdigit isalnum isspace isupper islower"
_WHITE = b" \t\n\v\f\r"

_FUNCTIONS: dict[str, Function] = {
    **dict.fromkeys(("strlen",), lambda s: len(characters(s))),
    **dict.fromkeys(("strcpy",), _joined(lambda to, s: s + b"\0")),
    **dict.fromkeys(("strcat",), _joined(lambda to, s: text(to) + s + b"\0")),
    "strncpy": _joined(lambda to, s, n: s[:n].ljust(n, b"\0")),
    "strncat": _joined(lambda to, s, n: text(to) + s[:n] + b"\0"),
    **{"stpcpy": stpcpy, "strxfrm": strxfrm},
    **dict.fromkeys(("strcmp", "strcoll"), lambda a, b: _sign(characters(a), characters(b))),
    "strncmp": lambda a, b, n: _sign(characters(a)[:n], characters(b)[:n]),
    **dict.fromkeys(("stricmp", "strcmpi", "strcasecmp", "strnicmp", "strncmpi"), _alike),
    "strchr": lambda s, c: _offset(s, (text(s) + b"\0").find(c & 0xFF)),
    "strrchr": lambda s, c: _offset(s, (text(s) + b"\0").rfind(c & 0xFF)),
    "strstr": lambda s, part: _offset(s, text(s).find(characters(part))),
    "strpbrk": lambda s, e: _offset(s, (n := _span(s, e, False)) - (n == len(text(s))) * (n + 1)),
    **{"strtok": strtok, "strspn": lambda s, e: _span(s, e, True)},
    "strcspn": lambda s, e: _span(s, e, False),
    "strdup": lambda s: string(characters(s)),
    **{"strupr": _changed(bytes.upper), "strlwr": _changed(bytes.lower)},
    "strrev": _changed(lambda s: s[::-1]),
    "strset": _changed(lambda s, c: bytes([c & 0xFF]) * len(s)),
    "strnset": _changed(lambda s, c, n: bytes([c & 0xFF]) * min(n, len(s)) + s[n:]),
    **{name: _class(name) for name in _CLASSES.split()},
    "isspace": lambda c: int(0 <= c < 128 and c in _WHITE),
    **{"isprint": lambda c: int(32 <= c < 127), "isgraph": lambda c: int(32 < c < 127)},
    **{"iscntrl": lambda c: int(0 <= c < 32 or c == 127), "isascii": lambda c: int(0 <= c < 128)},
    "ispunct": lambda c: int(32 < c < 127 and not chr(c).isalnum()),
    "isxdigit": lambda c: int(0 <= c < 128 and chr(c) in "0123456789abcdefABCDEF"),
    "toupper": lambda c: c - 32 if 97 <= c <= 122 else c,
    "tolower": lambda c: c + 32 if 65 <= c <= 90 else c,
    **{"toascii": lambda c: c & 0x7F, "_toupper": lambda c: c - 32, "_tolower": lambda c: c + 32},
}

FUNCTIONS = {
    **_FUNCTIONS,
    **{f"_f{name}": one for name, one in _FUNCTIONS.items() if name[:3] in ("str", "stp")},
}
