"""Numbers as texts, texts as numbers, and division: the parts of stdlib.h that only compute.

An int has 16 bits here, a long 32: what is larger loses the bits in front, as in Turbo C.
"""

from __future__ import annotations

import sys
from math import isfinite
from typing import NamedTuple

from bgi.clib.bits import signed, unsigned
from bgi.clib.reading import Reader, StringSource, read_real, read_whole
from bgi.clib.reals import exponential, fixed, general
from bgi.clib.strings import c_string
from bgi.errors import brief
from bgi.kernel.arguments import Number, real, whole

MOST_PLACES = 1000
"""That ecvt() and its like make."""

_DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"


class div_t(NamedTuple):
    """A quotient and what remains, as div() and ldiv() return them."""

    quot: int
    rem: int


# Numbers become texts


def itoa(value: Number, radix: Number = 10) -> str:
    """Write an int of 16 bits in a number system, as `itoa(255, 16)`, which is `'ff'`.

    Args:
        value: the number; 40000 is -25536, as in an int of Turbo C. `ltoa` has room for more.
        radix: 2 to 36; the digits beyond 9 are small letters.

    Only radix 10 knows a minus sign: in others a negative number is shown as its 16 bits. C's
    second argument, where the text goes, is what this returns. Source: stdlib.h.
    """
    return _written(signed(whole("value", value), 16), 16, radix)


def ltoa(value: Number, radix: Number = 10) -> str:
    """Write a long of 32 bits in a number system, as itoa() does an int. Source: stdlib.h."""
    return _written(signed(whole("value", value), 32), 32, radix)


def ultoa(value: Number, radix: Number = 10) -> str:
    """Write an unsigned long of 32 bits in a number system: of -1 all bits. Source: stdlib.h."""
    return _written(whole("value", value) & 0xFFFFFFFF, 32, radix)


def _written(number: int, bits: int, radix: Number) -> str:
    base = whole("radix", radix)
    if not 2 <= base <= 36:
        raise ValueError(f"radix must be 2 to 36, not {brief(radix)}")
    if base == 10:
        return str(number)
    number = unsigned(number, bits)
    digits = ""
    while number or not digits:
        number, digit = divmod(number, base)
        digits = _DIGITS[digit] + digits
    return digits


def gcvt(value: Number, ndec: Number) -> str:
    """Write a number with so many digits that count, as `%g` does. Source: stdlib.h.

    Args:
        value: the number.
        ndec: how many digits, 1 or more; at most 15 are the number's own.
    """
    number = _finite(value)
    return "-" * (number < 0) + general(abs(number), max(_places("ndec", ndec), 1), False)


def ecvt(value: Number, ndig: Number) -> tuple[str, int, int]:
    """Return a number's digits, how many of them are before the point, and 1 if it is negative.

    Args:
        value: the number: -12.5 with 4 digits is `('1250', 2, 1)`.
        ndig: how many digits, 1 or more; at most 15 are the number's own.

    Source: stdlib.h.
    """
    number = _finite(value)
    written = exponential(abs(number), max(_places("ndig", ndig), 1) - 1, False)
    mantissa, _, exponent = written.partition("e")
    return mantissa.replace(".", ""), int(exponent) + 1, int(number < 0)


def fcvt(value: Number, ndig: Number) -> tuple[str, int, int]:
    """Return what ecvt() returns, of a number with so many digits behind the point.

    Args:
        value: the number: 12.345 with 2 digits is `('1234', 2, 0)`.
        ndig: how many digits behind the point, 0 or more.

    Source: stdlib.h.
    """
    number = _finite(value)
    before, _, behind = fixed(abs(number), _places("ndig", ndig), False).partition(".")
    digits = (before + behind).lstrip("0")
    return digits, len(digits) - len(behind), int(number < 0)


def _finite(value: Number) -> float:
    number = real("value", value)
    if abs(number) > sys.float_info.max or not isfinite(number):
        raise ValueError(f"value must be a finite number, not {brief(value)}")
    return float(number)


def _places(name: str, value: Number) -> int:
    places = whole(name, value)
    if not 0 <= places <= MOST_PLACES:
        raise ValueError(f"{name} must be 0 to {MOST_PLACES}, not {brief(value)}")
    return places


# Texts become numbers


def atoi(s: str | bytes) -> int:
    """Return the whole number, an int of 16 bits, with which a text begins; 0 if with none.

    Args:
        s: the text: white space, a sign, digits, and anything else. `'70000'` is 4464, as in an int
            of Turbo C; `atol` has room for more, and Python's own int() for all.

    Source: stdlib.h.
    """
    return signed(_whole(s), 16)


def atol(s: str | bytes) -> int:
    """Return the whole number, a long of 32 bits, with which a text begins. Source: stdlib.h."""
    return signed(_whole(s), 32)


def atof(s: str | bytes) -> float:
    """Return the number with which a text begins, as `'1.5e3 m'`; 0.0 if with none.

    Source: math.h, stdlib.h.
    """
    return strtod(s)[0]


def _whole(s: str | bytes) -> int:
    reader, _ = _begin(s)
    return read_whole(reader, 10) or 0


def strtol(s: str | bytes, radix: Number = 10) -> tuple[int, str]:
    """Return the whole number, a long, with which a text begins, and the text behind it.

    Args:
        s: the text: white space, a sign, digits, and anything else.
        radix: 2 to 36; or 0, which goes by the number: `0x1f` is hexadecimal, `017` octal.

    A number out of range is the nearest that a long of 32 bits holds; of none comes 0 and the whole
    text. What C stores through its second argument is the text returned. Source: stdlib.h.
    """
    number, rest = _number(s, radix)
    return min(max(number, -(1 << 31)), (1 << 31) - 1), rest


def strtoul(s: str | bytes, radix: Number = 10) -> tuple[int, str]:
    """Return what strtol() returns, of an unsigned long: `'-1'` is 4294967295. Source: stdlib.h."""
    number, rest = _number(s, radix)
    return min(unsigned(max(number, -(1 << 31)), 32), (1 << 32) - 1), rest


def strtod(s: str | bytes) -> tuple[float, str]:
    """Return the number with which a text begins, and the text behind it. Source: stdlib.h."""
    reader, source = _begin(s)
    number = read_real(reader)
    return (0.0, source.text) if number is None else (number, source.text[source.position :])


def _number(s: str | bytes, radix: Number) -> tuple[int, str]:
    base = whole("radix", radix)
    if base != 0 and not 2 <= base <= 36:
        raise ValueError(f"radix must be 0 or 2 to 36, not {brief(radix)}")
    reader, source = _begin(s)
    number = read_whole(reader, base)
    return (0, source.text) if number is None else (number, source.text[source.position :])


def _begin(s: str | bytes) -> tuple[Reader, StringSource]:
    """What reads a text from behind the white space it begins with."""
    source = StringSource(c_string("s", s))
    reader = Reader(source)
    reader.skip_white()
    reader.begin(sys.maxsize)
    return reader, source


# Arithmetic


def div(numer: Number, denom: Number) -> div_t:
    """Divide whole numbers as C does, toward zero: -7 by 2 is -3, and -1 remains.

    Args:
        numer: what is divided.
        denom: by what; ZeroDivisionError for 0.

    Python's own // and % round down: -4, and 1 remains. Source: stdlib.h.
    """
    above, below = whole("numer", numer), whole("denom", denom)
    quotient = abs(above) // abs(below)
    if (above < 0) != (below < 0):
        quotient = -quotient
    return div_t(quotient, above - quotient * below)


def ldiv(numer: Number, denom: Number) -> div_t:
    """Divide whole numbers as div() does. Source: stdlib.h."""
    return div(numer, denom)


def labs(x: Number) -> int:
    """Return a whole number without its sign. Source: stdlib.h."""
    return abs(whole("x", x))
