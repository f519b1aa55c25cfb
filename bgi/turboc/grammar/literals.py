"""Numbers, characters and strings as they are written, and what they are."""

import re

from bgi.turboc.faults import CError, Place
from bgi.turboc.grammar.nodes import FloatLit, IntLit

_ESCAPES = {
    **{"n": 10, "t": 9, "r": 13, "a": 7, "b": 8, "f": 12, "v": 11, "0": 0},
    **{"\\": 92, "'": 39, '"': 34, "?": 63},
}
_PIECE = re.compile(r"\\x([0-9a-fA-F]{1,2})|\\([0-7]{1,3})|\\(.)|(.)", re.DOTALL)
_LARGEST = 0xFFFFFFFF


def number(text: str, place: Place) -> IntLit | FloatLit:
    """A number; CError for one that is too large."""
    digits = text.rstrip("uUlL")
    suffix = text[len(digits) :].lower()
    whole = digits[:2] in ("0x", "0X") or digits.isdecimal()
    if not whole:
        digits = text.rstrip("fFlL")
        return FloatLit(place, float(digits), text[len(digits) :].lower())
    octal = digits[0] == "0" and digits.isdecimal() and digits != "0"
    if octal and set(digits) & set("89"):  # Turbo C took them
        value = sum(int(digit) * 8**place for place, digit in enumerate(reversed(digits)))
    elif len(digits) > 40:
        value = _LARGEST + 1
    else:
        value = int(digits, 8 if octal else 0) if digits != "0" else 0
    if value > _LARGEST:
        raise CError(place, f"{text[:40]} does not fit into a long")
    return IntLit(place, value, suffix, digits[:1] != "0")


def string(text: str) -> bytes:
    """The bytes of a string or character in its quotes."""
    made = bytearray()
    for hexadecimal, octal, escape, plain in _PIECE.findall(text[1:-1]):
        if hexadecimal:
            made.append(int(hexadecimal, 16))
        elif octal:
            made.append(int(octal, 8) & 0xFF)
        elif escape:
            made += (
                bytes([_ESCAPES[escape]])
                if escape in _ESCAPES
                else escape.encode("cp437", "replace")
            )
        else:
            made += plain.encode("cp437", "replace")
    return bytes(made)


def character(text: str) -> int:
    """The value of a character in its quotes: a signed char, or two in an int."""
    codes = string(text)
    if not codes:
        return 0
    if len(codes) == 1:
        return codes[0] - (codes[0] >> 7 << 8)
    value = codes[0] | codes[1] << 8
    return value - (value >> 15 << 16)
