"""math.h, and the numbers and the chance of stdlib.h."""

from __future__ import annotations

import math
from typing import Any

from bgi import stdlib
from bgi.clib.bits import signed, unsigned
from bgi.turboc.runtime.binding import Function, characters, string
from bgi.turboc.runtime.memory import Pointer, write_text

_ONE = (
    "sin cos tan asin acos atan sinh cosh tanh exp log log10 sqrt fabs floor ceil round trunc "
    "cbrt exp2 log2 asinh acosh atanh"
)
_TWO = "atan2 pow fmod hypot fmax fmin"

_REALS = "".join(
    f"double {name}(double x{', double y' * (name in _TWO.split())}); "
    f"double {name}f(double x{', double y' * (name in _TWO.split())}); "
    f"long double {name}l(double x{', double y' * (name in _TWO.split())}); "
    for name in f"{_ONE} {_TWO}".split()
)

DECLARATIONS = (
    _REALS
    + """
int abs(int n); long labs(long n); int atoi(text s); long atol(text s); double atof(text s);
long double _atold(text s); double strtod(char *s, char **end);
long strtol(char *s, char **end, int radix); unsigned long strtoul(char *s, char **end, int radix);
char *itoa(int n, char *to, int radix); char *ltoa(long n, char *to, int radix);
char *ultoa(unsigned long n, char *to, int radix); char *gcvt(double n, int digits, char *to);
char *ecvt(double n, int digits, int *point, int *sign);
char *fcvt(double n, int digits, int *point, int *sign); int rand(void); void srand(unsigned seed);
int random(int n); char *getenv(text name); int putenv(text setting); div_t div(int a, int b);
ldiv_t ldiv(long a, long b); double ldexp(double x, int n); double modf(double x, double *whole);
double frexp(double x, int *exponent); long double ldexpl(long double x, int n);
long double modfl(long double x, long double *whole); long double frexpl(long double x, int *e);
long double pow10l(int n); long double polyl(long double x, int n, long double *c);
long double _strtold(char *s, char **end); unsigned char _crotl(unsigned char n, int by);
unsigned char _crotr(unsigned char n, int by); long _lrand(void);
 double pow10(int n); double poly(double x, int n, double *c);
unsigned _rotl(unsigned n, int by); unsigned _rotr(unsigned n, int by);
unsigned long _lrotl(unsigned long n, int by); unsigned long _lrotr(unsigned long n, int by);
unsigned _clear87(void); unsigned _status87(void); unsigned _control87(unsigned a, unsigned b);
void _fpreset(void);
"""
)

TYPES = {
    "div_t": "struct @ { int quot, rem; };",
    "ldiv_t": "struct @ { long quot, rem; };",
}

CONSTANTS: dict[str, int | float] = {
    **{"M_PI": 3.14159265358979323846, "M_PI_2": 1.57079632679489661923},
    **{"M_PI_4": 0.785398163397448309616, "M_1_PI": 0.318309886183790671538},
    **{"M_2_PI": 0.636619772367581343076, "M_1_SQRTPI": 0.564189583547756286948},
    **{"M_2_SQRTPI": 1.12837916709551257390, "M_SQRT2": 1.41421356237309504880},
    **{"M_SQRT_2": 0.707106781186547524401, "M_SQRT1_2": 0.707106781186547524401},
    **{"M_E": 2.71828182845904523536, "M_LOG2E": 1.44269504088896340736},
    **{"M_LOG10E": 0.434294481903251827651, "M_LN2": 0.693147180559945309417},
    **{"M_LN10": 2.30258509299404568402, "HUGE_VAL": math.inf},
}


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


def _rounded(x: float) -> float:
    """The nearest whole number; of two the one farther from 0."""
    return math.copysign(math.floor(abs(x) + 0.5), x)


_PYTHONS: dict[str, Function] = {
    **{"floor": math.floor, "ceil": math.ceil, "round": _rounded, "trunc": math.trunc},
    **{"pow": math.pow, "fmax": max, "fmin": min, "exp2": lambda x: 2.0**x, "cbrt": math.cbrt},
}


def modf(x: float, whole: Pointer) -> float:
    """The part behind the point."""
    behind, whole.memory[whole.at] = math.modf(x)
    return behind


def frexp(x: float, exponent: Pointer) -> float:
    """The part of a number between 1/2 and 1; its power of two is stored."""
    part, exponent.memory[exponent.at] = math.frexp(x)
    return part


def poly(x: float, n: int, coefficients: Pointer) -> float:
    """A polynomial."""
    result = 0.0
    for place in range(n, -1, -1):
        result = result * x + coefficients.memory[coefficients.at + place]
    return result


def random(n: int) -> int:
    """A random number below another."""
    return stdlib.rand() * n // 32768 if n >= 0 else -(stdlib.rand() * -n // 32768)


def _number(convert: Function) -> Function:
    """A number written where the program says."""

    def call(n: int, to: Pointer, radix: int) -> Pointer:
        write_text(to, convert(n, radix).encode() if 2 <= radix <= 36 else b"")
        return to

    return call


def _gcvt(n: float, digits: int, to: Pointer) -> Pointer:
    write_text(to, stdlib.gcvt(n, digits).encode())
    return to


def _digits(convert: Function) -> Function:
    """The digits of a number; where its point and what its sign is are stored."""

    def call(n: float, digits: int, point: Pointer, sign: Pointer) -> Pointer:
        shown, point.memory[point.at], sign.memory[sign.at] = convert(n, digits)
        return string(shown)

    return call


def _parsed(convert: Function) -> Function:
    """A number that a string begins with; where it ends is stored."""

    def call(s: Pointer, end: Pointer | None, *radix: int) -> Any:
        data = characters(s)
        value, rest = convert(data, *radix)
        if end is not None:
            end.memory[end.at] = s + (len(data) - len(rest))
        return value

    return call


def _rotated(bits: int) -> Function:
    """Turn a number's bits round, to the left."""

    def call(n: int, by: int) -> int:
        by %= bits
        n = unsigned(n, bits)
        return (n << by | n >> (bits - by)) & (1 << bits) - 1

    return call


def _reals() -> dict[str, Function]:
    found: dict[str, Function] = {}
    for name in f"{_ONE} {_TWO}".split():
        function = _real(_PYTHONS.get(name) or getattr(math, name))
        found |= dict.fromkeys((name, f"{name}f", f"{name}l"), function)
    return found


_FUNCTIONS: dict[str, Function] = {
    **_reals(),
    **{"ldexp": _real(math.ldexp), "pow10": _real(lambda n: 10.0**n), "modf": modf},
    **{"frexp": frexp, "poly": poly, "labs": abs, "abs": lambda n: signed(abs(n), 16)},
    **{name: lambda s, f=name: getattr(stdlib, f)(characters(s)) for name in ("atoi", "atol")},
    **dict.fromkeys(("atof", "_atold"), lambda s: stdlib.atof(characters(s))),
    **{name: _parsed(getattr(stdlib, name)) for name in ("strtod", "strtol", "strtoul")},
    **{name: _number(getattr(stdlib, name)) for name in ("itoa", "ltoa", "ultoa")},
    **{"gcvt": _gcvt, "ecvt": _digits(stdlib.ecvt), "fcvt": _digits(stdlib.fcvt)},
    **{"rand": stdlib.rand, "srand": stdlib.srand, "random": random},
    **{"getenv": lambda name: None, "putenv": lambda setting: 0},
    **{"_rotl": _rotated(16), "_rotr": lambda n, by: _rotated(16)(n, -by)},
    **{"_lrotl": _rotated(32), "_lrotr": lambda n, by: _rotated(32)(n, -by)},
    **{"_crotl": _rotated(8), "_crotr": lambda n, by: _rotated(8)(n, -by)},
    **{"_clear87": lambda: 0, "_status87": lambda: 0, "_control87": lambda a, b: 0x133F},
    "_fpreset": lambda: None,
}

_LONG = "ldexp modf frexp pow10 poly"
FUNCTIONS = {
    **_FUNCTIONS,
    **{f"{name}l": _FUNCTIONS[name] for name in _LONG.split()},
    **{"_strtold": _FUNCTIONS["strtod"], "_lrand": lambda: stdlib.rand() << 15 | stdlib.rand()},
}
"""All but those that answer with structures."""
