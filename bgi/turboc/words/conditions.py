"""What stands behind `#if`: whole numbers and operators; a name that is no macro is 0."""

from collections.abc import Callable

from bgi.turboc.faults import CError, Place
from bgi.turboc.words.lexer import Token

_LEVELS: list[dict[str, Callable[[int, int], int]]] = [
    {"||": lambda a, b: int(bool(a) or bool(b))},
    {"&&": lambda a, b: int(bool(a) and bool(b))},
    {"|": lambda a, b: a | b},
    {"^": lambda a, b: a ^ b},
    {"&": lambda a, b: a & b},
    {"==": lambda a, b: int(a == b), "!=": lambda a, b: int(a != b)},
    {
        "<": lambda a, b: int(a < b),
        ">": lambda a, b: int(a > b),
        "<=": lambda a, b: int(a <= b),
        ">=": lambda a, b: int(a >= b),
    },
    {"<<": lambda a, b: a << (b & 31), ">>": lambda a, b: a >> (b & 31)},
    {"+": lambda a, b: a + b, "-": lambda a, b: a - b},
    {
        "*": lambda a, b: a * b,
        "/": lambda a, b: a // b if b else 0,
        "%": lambda a, b: a % b if b else 0,
    },
]
_SIGNS: dict[str, Callable[[int], int]] = {
    "-": lambda a: -a,
    "+": lambda a: a,
    "!": lambda a: int(not a),
    "~": lambda a: ~a,
}
DEEPEST = 50
"""Brackets and signs within each other."""


def evaluate(words: list[Token], place: Place) -> int:
    """The value of a condition; CError if it is none."""
    reader = _Reader(words, place)
    value = reader.choice(0)
    if reader.position < len(words):
        raise CError(place, f"{words[reader.position].text!r} is not expected in a condition")
    return value


class _Reader:
    def __init__(self, words: list[Token], place: Place) -> None:
        self._words, self._place = words, place
        self.position = 0

    def _next(self) -> str:
        return self._words[self.position].text if self.position < len(self._words) else ""

    def _take(self) -> Token:
        if self.position == len(self._words):
            raise CError(self._place, "this condition is not complete")
        self.position += 1
        return self._words[self.position - 1]

    def choice(self, depth: int) -> int:
        """`a ? b : c`, or an operator's expression."""
        value = self._binary(0, depth)
        if self._next() != "?":
            return value
        self._take()
        yes = self.choice(depth + 1)
        if self._take().text != ":":
            raise CError(self._place, "a ':' is missing in this condition")
        no = self.choice(depth + 1)
        return yes if value else no

    def _binary(self, level: int, depth: int) -> int:
        if level == len(_LEVELS):
            return self._operand(depth)
        value = self._binary(level + 1, depth)
        while operator := _LEVELS[level].get(self._next()):
            self._take()
            value = operator(value, self._binary(level + 1, depth)) % (1 << 64)
            value -= (value >> 63) << 64
        return value

    def _operand(self, depth: int) -> int:
        if depth > DEEPEST:
            raise CError(self._place, "this condition is nested too deeply")
        word = self._take()
        if sign := _SIGNS.get(word.text):
            return sign(self._operand(depth + 1))
        if word.text == "(":
            value = self.choice(depth + 1)
            if self._take().text != ")":
                raise CError(self._place, "a ')' is missing in this condition")
            return value
        if word.kind == "number":
            digits = word.text.rstrip("uUlL")
            octal = digits[0] == "0" and digits.isdecimal()
            try:
                return int(digits, 8 if octal else 0)
            except ValueError:
                raise CError(word.place, f"{word.text} is no whole number") from None
        if word.kind == "character":
            return ord(word.text[1])
        if word.kind == "name":
            return 0
        raise CError(word.place, f"{word.text!r} is not expected in a condition")
