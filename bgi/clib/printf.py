"""printf's format language as Turbo C++ 3.0 had it.

A conversion is `%[flags][width][.precision][size]letter`: flags `- + space # 0`, `*` for a width
or a precision that is an argument, sizes `h l L F N`, letters `d i u o x X f e E g G c s p n`; and
`%%` for a percent sign. From one that is none, such as `%z`, the rest of the format is printed as
it stands: nobody knows any more which argument belongs where.
"""

import re
from collections.abc import Callable
from functools import lru_cache
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

REMEMBERED = 80
"""Characters of a format whose conversions are kept: of 256 formats."""

_CONVERSION = re.compile(
    r"%(?P<flags>[-+ #0]*+)(?P<width>\*|[0-9]*+)(?:\.(?P<precision>\*|[0-9]*+))?"
    r"(?P<size>[hlLFN]*+)(?P<letter>[diuoxXfeEgGcspn])|%%"
)


class Conversion(NamedTuple):
    """One conversion of a format."""

    number: int
    """Which of the format's it is, from 1 on."""
    written: str
    flags: str
    width: int
    precision: int | None
    stars: tuple[str, ...]
    """Which of width and precision are arguments."""
    size: str
    letter: str

    def called(self, part: str) -> str:
        """How errors call its argument, its width or its precision."""
        return f"the {part} of {self.written:.40} (conversion {self.number})"

    @property
    def name(self) -> str:
        """How errors call its argument."""
        return self.called("argument")

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
    parts, rest = _remembered(text) if len(text) <= REMEMBERED else _parts(text)
    given = _Arguments(args)
    pieces: list[str] = []
    count = 0
    for before, conversion in parts:
        full = _filled(conversion, given) if conversion.stars else conversion
        value = given.take(full, "argument")
        count += len(before)
        if full.letter == "n":
            shown = _store(full, value, count)
        else:
            shown = _CONVERTERS[full.letter](full, value)
        count += len(shown)
        if count > MOST_CHARACTERS:
            raise ValueError(f"the format makes more than {MOST_CHARACTERS:,} characters")
        pieces += before, shown
    return "".join(pieces) + rest


class _Arguments:
    """The arguments of a call, one after the other."""

    def __init__(self, values: tuple[Any, ...]) -> None:
        self._values = values
        self._taken = 0

    def take(self, conversion: Conversion, part: str) -> Any:
        """The next argument, for a part of a conversion."""
        if self._taken == len(self._values):
            raise TypeError(f"{conversion.called(part)} is missing: the call gives {self._taken}")
        self._taken += 1
        return self._values[self._taken - 1]


def _parts(text: str) -> tuple[list[tuple[str, Conversion]], str]:
    """The conversions of a format, each with the text before it, and the text behind them all."""
    parts: list[tuple[str, Conversion]] = []
    before, position = "", 0
    while (start := text.find("%", position)) >= 0 and (
        found := _CONVERSION.match(text, start)
    ) is not None:
        before += text[position:start]
        position = found.end()
        if found["letter"]:
            parts.append((before, _conversion(len(parts) + 1, found)))
            before = ""
        else:
            before += "%"
    return parts, before + text[position:]


_remembered = lru_cache(maxsize=256)(_parts)


def _conversion(number: int, found: re.Match[str]) -> Conversion:
    """A conversion as it is written."""
    width, precision = found["width"], found["precision"]
    stars = tuple(part for part in ("width", "precision") if found[part] == "*")
    conversion = Conversion(
        number, found[0], found["flags"], 0, None, stars, found["size"], found["letter"]
    )
    if width and width != "*":
        conversion = conversion._replace(width=_bounded(conversion, "width", width))
    if precision is not None and precision != "*":
        conversion = conversion._replace(precision=_bounded(conversion, "precision", precision))
    return conversion


def _filled(conversion: Conversion, given: _Arguments) -> Conversion:
    """A conversion with arguments for its stars; a negative width means the flag `-`."""
    if "width" in conversion.stars:
        conversion = conversion._replace(width=_star(conversion, "width", given))
    if "precision" in conversion.stars:
        conversion = conversion._replace(precision=_star(conversion, "precision", given))
    if conversion.width < 0:
        conversion = conversion._replace(flags=conversion.flags + "-", width=-conversion.width)
    if conversion.precision is not None and conversion.precision < 0:
        conversion = conversion._replace(precision=None)
    return conversion


def _star(conversion: Conversion, part: str, given: _Arguments) -> int:
    """A width or a precision that is an argument."""
    number = whole(conversion.called(part), given.take(conversion, part))
    return _bounded(conversion, part, number)


def _bounded(conversion: Conversion, part: str, number: str | int) -> int:
    """A width or a precision within its limit."""
    if isinstance(number, str):
        digits = number.lstrip("0") or "0"
        number = int(digits) if len(digits) < 6 else LONGEST + 1
    if abs(number) > LONGEST:
        raise ValueError(f"{conversion.called(part)} must be at most {LONGEST:,}")
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


def _store(conversion: Conversion, value: object, count: int) -> str:
    """%n: what C stores through a pointer is appended to a list."""
    if not isinstance(value, list):
        kind = type(value).__name__
        raise TypeError(f"{conversion.name} must be a list, to append a number to, not {kind}")
    value.append(count)
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
}
