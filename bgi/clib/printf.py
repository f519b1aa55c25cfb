"""printf's format language as Turbo C++ 3.0 had it.

A conversion is `%[flags][width][.precision][size]letter`: flags `- + space # 0`, `*` for a width
or a precision that is an argument, sizes `h l L F N`, letters `d i u o x X f e E g G c s p n`; and
`%%` for a percent sign. From one that is none, such as `%z`, the rest of the format is printed as
it stands: nobody knows any more which argument belongs where.
"""

import re
from collections.abc import Callable
from math import isfinite, isnan
from typing import Any, NamedTuple

from bgi.clib.bits import signed, unsigned
from bgi.clib.reals import exponential, fixed, general
from bgi.clib.strings import c_string, character
from bgi.errors import brief
from bgi.kernel.arguments import real, whole

LONGEST = 32767
"""The largest width and precision: an int of Turbo C."""

MOST_CHARACTERS = 1 << 24
"""Of all that one call makes."""

MOST_BITS = 1024
"""Of a whole number: as far as floating point goes."""

_CONVERSION = re.compile(
    r"%(?P<flags>[-+ #0]*+)(?P<width>\*|[0-9]*+)(?:\.(?P<precision>\*|[0-9]*+))?"
    r"(?P<size>[hlLFN]*+)(?P<letter>[diuoxXfeEgGcspn])|%%"
)


class Conversion(NamedTuple):
    """One conversion with its `*` filled in."""

    name: str
    """How errors call it."""
    flags: str
    width: int
    precision: int | None
    size: str
    letter: str
    behind: int
    """How many characters come before it."""

    def padded(self, sign: str, text: str, zeros: bool = False) -> str:
        """A text in the conversion's width; zeros go between the sign and the digits."""
        if "-" in self.flags:
            return f"{sign}{text}".ljust(self.width)
        if zeros and "0" in self.flags:
            return sign + text.rjust(self.width - len(sign), "0")
        return f"{sign}{text}".rjust(self.width)

    def sign(self, negative: bool) -> str:
        """The sign of a number: of a positive one as the flags ask for it."""
        if negative:
            return "-"
        return "+" if "+" in self.flags else " " if " " in self.flags else ""


def format(format_string: str | bytes, *args: Any) -> str:
    """Write numbers and texts by a format, as printf does: `format("%5d", 42)` is `'   42'`.

    Args:
        format_string: the text, with a conversion such as `%d` or `%-10s` for each argument.
        args: what the conversions show, in order; what is left over is ignored, as in C.

    `%d` and its like take any number, and drop what is behind the point, as C converts; `%c` takes
    a character or its code, `%s` a str, bytes or None, which is `(null)`; `%p` the number that an
    address is: `12AB:0004`, or `0004` as `%Np`; `%n` a list, to which it appends how many
    characters came before. Bytes are in code page 437.

    TypeError for an argument that is missing or of the wrong kind, ValueError for one that is out
    of range; both name the conversion. A width or precision may be 32767, the result 16,777,216
    characters.
    """
    text = c_string("the format", format_string)
    if "%" not in text:
        return text
    given = _Arguments(args)
    pieces: list[str] = []
    count = position = 0
    while (start := text.find("%", position)) >= 0 and (
        found := _CONVERSION.match(text, start)
    ) is not None:
        before = text[position:start]
        count += len(before)
        shown = _shown(found, given, count) if found["letter"] else "%"
        count += len(shown)
        if count > MOST_CHARACTERS:
            raise ValueError(f"the format makes more than {MOST_CHARACTERS:,} characters")
        pieces += before, shown
        position = found.end()
    return "".join(pieces) + text[position:]


class _Arguments:
    """The arguments of a call, one after the other."""

    def __init__(self, values: tuple[Any, ...]) -> None:
        self._values = values
        self._taken = 0
        self.conversions = 0

    def take(self, name: str) -> Any:
        """The next argument, for what is called `name`."""
        if self._taken == len(self._values):
            raise TypeError(f"{name} is missing: the call gives {self._taken}")
        self._taken += 1
        return self._values[self._taken - 1]


def _shown(found: re.Match[str], given: _Arguments, count: int) -> str:
    """What one conversion makes of its argument, behind `count` characters."""
    given.conversions += 1
    name = f"{found[0]:.40} (conversion {given.conversions})"
    width = _number(found["width"], f"the width of {name}", given) or 0
    precision = _number(found["precision"], f"the precision of {name}", given)
    flags = found["flags"] + "-" * (width < 0)
    if precision is not None and precision < 0:
        precision = None
    name = f"the argument of {name}"
    conversion = Conversion(
        name, flags, abs(width), precision, found["size"], found["letter"], count
    )
    return _CONVERTERS[conversion.letter](conversion, given.take(name))


def _number(written: str | None, name: str, given: _Arguments) -> int | None:
    """A width or a precision; None if there is none."""
    if written is None:
        return None
    if written == "*":
        number = whole(name, given.take(name))
    else:
        digits = written.lstrip("0") or "0"
        number = int(digits) if len(digits) < 6 else LONGEST + 1
    if abs(number) > LONGEST:
        raise ValueError(f"{name} must be at most {LONGEST:,}")
    return number


# The conversions


def _decimal(conversion: Conversion, value: object) -> str:
    """%d and %i."""
    number = _whole(conversion, value)
    if "h" in conversion.size:
        number = signed(number, 16)
    return _integer(conversion, conversion.sign(number < 0), str(abs(number)))


def _unsigned(conversion: Conversion, value: object) -> str:
    """%u, %o, %x and %X."""
    number = unsigned(_whole(conversion, value), 32 if "l" in conversion.size else 16)
    if "h" in conversion.size:
        number &= 0xFFFF
    digits = f"{number:{conversion.letter.replace('u', 'd')}}"
    prefix = ""
    if "#" in conversion.flags and number:
        prefix = {"o": "0", "x": "0x", "X": "0X"}.get(conversion.letter, "")
    if prefix == "0" and (conversion.precision or 0) > len(digits):
        prefix = ""  # the precision's own zeros do
    return _integer(conversion, prefix, digits)


def _integer(conversion: Conversion, sign: str, digits: str) -> str:
    """A whole number by its sign or prefix and its digits; zero without any has no digit."""
    precision = conversion.precision
    if precision is None:
        return conversion.padded(sign, digits, zeros=True)
    return conversion.padded(sign, ("" if digits == "0" else digits).rjust(precision, "0"))


def _real(conversion: Conversion, value: object) -> str:
    """%f, %e, %E, %g and %G."""
    try:
        number = float(real(conversion.name, value))
    except OverflowError:
        raise ValueError(f"{conversion.name} is too large: {brief(value)}") from None
    if not isfinite(number):
        return conversion.padded("", "+NAN" if isnan(number) else f"{number:+F}")
    sign = conversion.sign(str(number)[0] == "-")
    letter = conversion.letter
    precision = 6 if conversion.precision is None else conversion.precision
    point = "#" in conversion.flags
    digits = _DIGITS[letter.lower()](abs(number), precision, point)
    if sign and "0" in conversion.flags and "-" not in conversion.flags:
        conversion = conversion._replace(width=conversion.width + 1)  # Borland's zeros forget it
    return conversion.padded(sign, digits.upper() if letter in "EG" else digits, zeros=True)


def _character(conversion: Conversion, value: object) -> str:
    """%c: a character, or a code."""
    if isinstance(value, bytes) and len(value) == 1:
        value = value[0]
    if isinstance(value, str):
        if len(value) != 1:
            raise ValueError(f"{conversion.name} must be one character, not {brief(value)}")
        return conversion.padded("", value)
    return conversion.padded("", character(whole(conversion.name, value)))


def _string(conversion: Conversion, value: object) -> str:
    """%s: at most as many characters as the precision says."""
    if isinstance(value, (int, float)):
        raise TypeError(f"{conversion.name} must be a str: use %d or %f to print {brief(value)}")
    text = "(null)" if value is None else c_string(conversion.name, value)
    return conversion.padded("", text[: conversion.precision])


def _pointer(conversion: Conversion, value: object) -> str:
    """%p: far pointers, as the large memory model has them; %Np a near one."""
    address = _whole(conversion, value)
    near = f"{address & 0xFFFF:04X}"
    return conversion.padded(
        "", near if "N" in conversion.size else f"{address >> 16 & 0xFFFF:04X}:{near}"
    )


def _count(conversion: Conversion, value: object) -> str:
    """%n: what C stores through a pointer is appended to a list."""
    if not isinstance(value, list):
        kind = type(value).__name__
        raise TypeError(f"{conversion.name} must be a list, to append a number to, not {kind}")
    value.append(conversion.behind)
    return ""


def _whole(conversion: Conversion, value: object) -> int:
    """A whole number that is not too long to be written."""
    number = value if type(value) is int else whole(conversion.name, value)
    if number.bit_length() > MOST_BITS:
        raise ValueError(f"{conversion.name} is too large: {brief(number)}")
    return number


_DIGITS = {"f": fixed, "e": exponential, "g": general}

_CONVERTERS: dict[str, Callable[[Conversion, object], str]] = {
    **dict.fromkeys("di", _decimal),
    **dict.fromkeys("uoxX", _unsigned),
    **dict.fromkeys("feEgG", _real),
    "c": _character,
    "s": _string,
    "p": _pointer,
    "n": _count,
}
