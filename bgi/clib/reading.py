"""Numbers and words read from characters that come one by one.

At most one character is looked at that does not belong to what is read: it is given back. So the
characters may come from a keyboard.
"""

import sys
from collections.abc import Callable
from typing import Protocol

WHITE = " \t\n\v\f\r"
"""What C calls white space."""

MOST_CHARACTERS = 1 << 24
"""That one call reads: an endless source comes to an end."""

MOST_DIGITS = 300
"""Of a whole number."""

_DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"


class Source(Protocol):
    """Where characters come from."""

    def getc(self) -> str:
        """The next character, or an empty str at the end."""

    def ungetc(self, character: str) -> None:
        """Take the last character back, which comes again."""


class StringSource:
    """The characters of a str."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.position = 0

    def getc(self) -> str:
        character = self.text[self.position : self.position + 1]
        self.position += len(character)
        return character

    def ungetc(self, character: str) -> None:
        self.position -= len(character)


class Reader:
    """What reads from a source: field after field, each of so many characters at most."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self._width = 0
        self.taken = 0
        """Characters of the field so far."""
        self.count = 0
        """Characters read so far, white space too."""
        self.ended = False
        """Whether there are no more."""

    def begin(self, width: int) -> None:
        """A new field, of at most `width` characters."""
        self._width = width
        self.taken = 0

    def take(self, wanted: Callable[[str], bool]) -> str:
        """The next character if it is wanted and within the field, otherwise an empty str."""
        if self.taken == self._width:
            return ""
        character = self._source.getc()
        if not character:
            self.ended = True
        elif wanted(character):
            self.taken += 1
            self.count += 1
            if self.count > MOST_CHARACTERS:
                raise ValueError(f"the input has more than {MOST_CHARACTERS:,} characters")
            return character
        else:
            self._source.ungetc(character)
        return ""

    def take_all(self, wanted: Callable[[str], bool]) -> str:
        """The next characters as long as they are wanted and within the field."""
        return "".join(iter(lambda: self.take(wanted), ""))

    def skip_white(self) -> None:
        """Pass over white space, which is part of no field."""
        self.begin(sys.maxsize)
        self.take_all(WHITE.__contains__)


def read_whole(reader: Reader, base: int) -> int | None:
    """A whole number of the field, in a base of 2 to 36; None if it has no digit.

    Base 0 goes by how the number begins: `0x1f` is hexadecimal, `017` octal, all others decimal.
    """
    sign = reader.take("+-".__contains__)
    digits = ""
    if base in (0, 16) and reader.take("0".__contains__):
        digits = "0"
        if reader.take("xX".__contains__):
            base = 16
        base = base or 8
    base = base or 10
    allowed = _DIGITS[:base] + _DIGITS[:base].upper()
    digits += reader.take_all(allowed.__contains__)
    if not digits:
        return None
    digits = digits.lstrip("0") or "0"
    if len(digits) > MOST_DIGITS:
        raise ValueError(f"the input has a number of more than {MOST_DIGITS} digits")
    return int(f"{sign}{digits}", base)


def read_real(reader: Reader) -> float | None:
    """A number of the field with a point and an exponent, neither of which must be there.

    None if there is no digit. An exponent without digits counts as none: `1e` is 1.
    """
    digit = _DIGITS[:10].__contains__
    sign = reader.take("+-".__contains__)
    before = reader.take_all(digit)
    behind = reader.take_all(digit) if reader.take(".".__contains__) else ""
    if not before and not behind:
        return None
    exponent = ""
    if reader.take("eE".__contains__):
        exponent = reader.take("+-".__contains__) + reader.take_all(digit)
    return float(f"{sign}{before}.{behind}e{exponent if exponent.strip('+-') else '0'}")
