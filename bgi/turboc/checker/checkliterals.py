"""Types of what is written as it is: numbers, characters, strings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.turboc.checker.folding import fitted
from bgi.turboc.checker.meaning import Meaning
from bgi.turboc.checker.typed import Constant, Quoted, Value
from bgi.turboc.checker.types import (
    CHAR,
    DOUBLE,
    FLOAT,
    INT,
    LONG,
    LONG_DOUBLE,
    ULONG,
    UNSIGNED,
    ArrayType,
)
from bgi.turboc.grammar import nodes

_REALS = {"": DOUBLE, "f": FLOAT, "l": LONG_DOUBLE}


def whole_number(meaning: Meaning, node: nodes.IntLit) -> Value:
    """A whole number: an int, or what is large enough for it."""
    sizes = [INT, UNSIGNED, LONG, ULONG]
    if node.decimal and "u" not in node.suffix:
        sizes = [INT, LONG, ULONG]
    if "u" in node.suffix:
        sizes = [one for one in sizes if not one.signed]
    if "l" in node.suffix:
        sizes = [one for one in sizes if one.bits == 32]
    type_ = next(one for one in sizes if node.value <= one.high)
    return Constant(node.place, type_, node.value)


def real_number(meaning: Meaning, node: nodes.FloatLit) -> Value:
    """A real number."""
    type_ = _REALS[node.suffix]
    return Constant(node.place, type_, fitted(node.value, type_))


def character(meaning: Meaning, node: nodes.CharLit) -> Value:
    """A character: an int in C, a char in C++."""
    small = meaning.cplusplus and -0x80 <= node.value < 0x80
    return Constant(node.place, CHAR if small else INT, node.value)


def string(meaning: Meaning, node: nodes.StrLit) -> Value:
    """A string."""
    return Quoted(node.place, ArrayType(CHAR, len(node.value) + 1), node.value)


RULES: dict[type, Callable[[Meaning, Any], Value]] = {
    nodes.IntLit: whole_number,
    nodes.FloatLit: real_number,
    nodes.CharLit: character,
    nodes.StrLit: string,
}
"""Which function types which node."""
