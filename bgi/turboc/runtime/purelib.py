"""stdlib.h, string.h, math.h, ctype.h and alloc.h: what neither draws nor waits, nor is traced."""

from __future__ import annotations

import math
from functools import cmp_to_key
from typing import Any

from bgi import stdlib
from bgi.turboc.runtime.binding import Function, characters, string
from bgi.turboc.runtime.memory import MOST_BYTES, Allocated, Pointer, text, write_bytes, write_text

DECLARATIONS = """
int abs(int n); long labs(long n); int atoi(text s); long atol(text s); double atof(text s);
char *itoa(int n, char *to, int radix); char *ltoa(long n, char *to, int radix);
char *ultoa(unsigned long n, char *to, int radix); char *gcvt(double n, int digits, char *to);
int rand(void); void srand(unsigned seed); int random(int n); char *getenv(text name);
void *malloc(unsigned long n); void *calloc(unsigned long n, unsigned long size);
void *realloc(void *p, unsigned long n); void free(void *p); void *farmalloc(unsigned long n);
void *farcalloc(unsigned long n, unsigned long size); void farfree(void *p);
void *farrealloc(void *p, unsigned long n); unsigned coreleft(void);
unsigned long farcoreleft(void); void *_graphgetmem(unsigned n);
void _graphfreemem(void *p, unsigned n);
unsigned strlen(text s); char *strcpy(char *to, text s); char *strcat(char *to, text s);
char *strncpy(char *to, text s, unsigned n); char *strncat(char *to, text s, unsigned n);
char *stpcpy(char *to, text s); int strcmp(text a, text b);
int strncmp(text a, text b, unsigned n);
int stricmp(text a, text b); int strcmpi(text a, text b); int strnicmp(text a, text b, unsigned n);
int strncmpi(text a, text b, unsigned n);
char *strchr(char *s, int c); char *strrchr(char *s, int c);
char *strstr(char *s, text part); char *strpbrk(char *s, text any); char *strtok(char *s, text any);
unsigned strspn(text s, text any); unsigned strcspn(text s, text any); char *strdup(text s);
char *strupr(char *s); char *strlwr(char *s); char *strrev(char *s); char *strset(char *s, int c);
void *memset(void *to, int c, unsigned n); void *memcpy(void *to, void *from, unsigned n);
void *memmove(void *to, void *from, unsigned n); int memcmp(void *a, void *b, unsigned n);
double sin(double x); double cos(double x); double tan(double x); double asin(double x);
double acos(double x); double atan(double x); double atan2(double y, double x);
double sinh(double x); double cosh(double x); double tanh(double x); double exp(double x);
double log(double x); double log10(double x); double pow(double x, double y);
double sqrt(double x); double fabs(double x); double floor(double x); double ceil(double x);
double fmod(double x, double y); double hypot(double x, double y); double ldexp(double x, int n);
double modf(double x, double *whole); double pow10(int n);
int isalpha(int c); int isdigit(int c); int isalnum(int c); int isspace(int c); int isupper(int c);
int islower(int c); int ispunct(int c); int isxdigit(int c); int iscntrl(int c); int isprint(int c);
int isgraph(int c); int toupper(int c); int tolower(int c); int isascii(int c);
void qsort(void *base, unsigned n, unsigned size, void *compare);
"""


def _real(function: Function) -> Function:
    """A function of math.h, which answers where Python's raises: as the processor does."""

    def call(*given: float) -> float:
        try:
            return float(function(*given))
        except ValueError:
            return math.nan
        except OverflowError:
            return math.inf

    return call


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


def malloc(n: int) -> Pointer | None:
    """Bytes that become whatever the program takes them for."""
    return Pointer(Allocated(n + 16)) if 0 <= n < MOST_BYTES else None


def realloc(pointer: Pointer | None, n: int) -> Pointer | None:
    """More bytes, with the old ones copied."""
    if pointer is None:
        return malloc(n)
    old = pointer.memory
    if isinstance(old, bytearray):
        made = malloc(n)
        if made is not None:
            made.memory[: min(n, len(old))] = old[:n]
        return made
    old.extend([old[-1]] * max(n - len(old), 0))
    return pointer


def memset(to: Pointer, c: int, n: int) -> Pointer:
    """Fill memory with a byte."""
    if isinstance(to.memory, bytearray):
        write_bytes(to, bytes([c & 0xFF]) * n)
    else:
        for place in range(to.at, len(to.memory)):
            if isinstance(to.memory[place], (int, float)):
                to.memory[place] = 0 if c == 0 else -1
    return to


def memcpy(to: Pointer, source: Pointer, n: int) -> Pointer:
    """Copy memory of one kind."""
    if isinstance(to.memory, bytearray):
        write_bytes(to, bytes(source.memory[source.at : source.at + n]))
    else:
        part = source.memory[source.at :]
        to.memory[to.at : to.at + len(part)] = part[: len(to.memory) - to.at]
    return to


def memcmp(a: Pointer, b: Pointer, n: int) -> int:
    """Compare memory."""
    return _sign(a.memory[a.at : a.at + n], b.memory[b.at : b.at + n])


def modf(x: float, whole: Pointer) -> float:
    """The part behind the point."""
    behind, whole.memory[whole.at] = math.modf(x)
    return behind


def qsort(base: Pointer, n: int, size: int, compare: Any) -> None:
    """Sort by a function of the program."""
    memory, at = base.memory, base.at
    key = cmp_to_key(lambda a, b: compare(Pointer([a]), Pointer([b])))
    memory[at : at + n] = sorted(memory[at : at + n], key=key)


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


def _span(s: Any, any_: Any, inside: bool) -> int:
    data, ends = characters(s), characters(any_)
    return next((i for i, c in enumerate(data) if (c in ends) != inside), len(data))


def _number(convert: Function) -> Function:
    """A number written where the program says."""

    def call(n: int, to: Pointer, radix: int) -> Pointer:
        write_text(to, convert(n, radix).encode())
        return to

    return call


def _gcvt(n: float, digits: int, to: Pointer) -> Pointer:
    write_text(to, stdlib.gcvt(n, digits).encode())
    return to


_MATH = "sin cos tan asin acos atan atan2 sinh cosh tanh exp log log10 sqrt fabs fmod hypot ldexp"
_CLASSES = "isalpha isdigit isalnum isspace isupper islower"

FUNCTIONS: dict[str, Function] = {
    **{name: _real(getattr(math, name)) for name in _MATH.split()},
    **{"pow": _real(math.pow), "pow10": _real(lambda n: 10.0**n), "modf": modf},
    **{"floor": _real(math.floor), "ceil": _real(math.ceil), "abs": abs, "labs": abs},
    **{name: lambda s, f=name: getattr(stdlib, f)(characters(s)) for name in ("atoi", "atol")},
    **{"atof": lambda s: stdlib.atof(characters(s)), "getenv": lambda name: None},
    **{name: _number(getattr(stdlib, name)) for name in ("itoa", "ltoa", "ultoa")},
    **{"gcvt": _gcvt, "rand": stdlib.rand, "srand": stdlib.srand},
    "random": lambda n: stdlib.rand() * n // 32768 if n >= 0 else -(stdlib.rand() * -n // 32768),
    **dict.fromkeys(("malloc", "farmalloc", "_graphgetmem"), malloc),
    **dict.fromkeys(("calloc", "farcalloc"), lambda n, size: malloc(n * size)),
    **dict.fromkeys(("realloc", "farrealloc"), realloc),
    **dict.fromkeys(("free", "farfree", "_graphfreemem"), lambda *given: None),
    **{"coreleft": lambda: 60000, "farcoreleft": lambda: 400000},
    "strlen": lambda s: len(characters(s)),
    "strcpy": _joined(lambda to, s: s + b"\0"),
    "strcat": _joined(lambda to, s: text(to) + s + b"\0"),
    "strncpy": _joined(lambda to, s, n: s[:n].ljust(n, b"\0")),
    "strncat": _joined(lambda to, s, n: text(to) + s[:n] + b"\0"),
    "stpcpy": stpcpy,
    "strcmp": lambda a, b: _sign(characters(a), characters(b)),
    "strncmp": lambda a, b, n: _sign(characters(a)[:n], characters(b)[:n]),
    **dict.fromkeys(
        ("stricmp", "strcmpi"), lambda a, b: _sign(characters(a).lower(), characters(b).lower())
    ),
    **dict.fromkeys(
        ("strnicmp", "strncmpi"),
        lambda a, b, n: _sign(characters(a)[:n].lower(), characters(b)[:n].lower()),
    ),
    "strchr": lambda s, c: _offset(s, (text(s) + b"\0").find(c & 0xFF)),
    "strrchr": lambda s, c: _offset(s, (text(s) + b"\0").rfind(c & 0xFF)),
    "strstr": lambda s, part: _offset(s, text(s).find(characters(part))),
    "strpbrk": lambda s, e: _offset(s, (n := _span(s, e, False)) - (n == len(text(s))) * (n + 1)),
    **{"strtok": strtok, "strspn": lambda s, e: _span(s, e, True)},
    "strcspn": lambda s, e: _span(s, e, False),
    "strdup": lambda s: string(characters(s)),
    **{"strupr": _changed(bytes.upper), "strlwr": _changed(bytes.lower)},
    **{"strrev": _changed(lambda s: s[::-1]), "strset": _changed(lambda s, c: bytes([c]) * len(s))},
    **{"memset": memset, "memcpy": memcpy, "memmove": memcpy, "memcmp": memcmp, "qsort": qsort},
    **{name: _class(name) for name in _CLASSES.split()},
    **{"isprint": lambda c: int(32 <= c < 127), "isgraph": lambda c: int(32 < c < 127)},
    **{"iscntrl": lambda c: int(0 <= c < 32 or c == 127), "isascii": lambda c: int(0 <= c < 128)},
    "ispunct": lambda c: int(32 < c < 127 and not chr(c).isalnum()),
    "isxdigit": lambda c: int(0 <= c < 128 and chr(c) in "0123456789abcdefABCDEF"),
    "toupper": lambda c: c - 32 if 97 <= c <= 122 else c,
    "tolower": lambda c: c + 32 if 65 <= c <= 90 else c,
}
