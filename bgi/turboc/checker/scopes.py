"""Names and what they stand for, in the scopes that they are known in."""

from __future__ import annotations

import keyword
from collections.abc import Iterable
from dataclasses import dataclass, field

from bgi.turboc.checker.types import Symbol, Type


@dataclass(slots=True)
class Scope:
    """The names of a block, in that of the block around it."""

    outer: Scope | None = None
    names: dict[str, list[Symbol]] = field(default_factory=dict)
    types: dict[str, Type] = field(default_factory=dict)
    """Typedefs, and tags."""

    def find(self, name: str) -> list[Symbol]:
        """What a name stands for: several if functions are overloaded, none if it is unknown."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.names:
                return scope.names[name]
            scope = scope.outer
        return []

    def find_inside(self, name: str) -> list[Symbol]:
        """What a name stands for in the function: it hides a member, which hides a global."""
        scope = self
        while scope.outer is not None:
            if name in scope.names:
                return scope.names[name]
            scope = scope.outer
        return []

    def find_type(self, name: str) -> Type | None:
        """The type that a name stands for."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.types:
                return scope.types[name]
            scope = scope.outer
        return None


RESERVED = frozenset(["SIZE", "MEMBERS", "assign", "copy", "filled", "shared_bytes", "self"])
"""What every object has in Python."""


def safe(name: str) -> str:
    """A name of C that means nothing in Python: no keyword, nothing that begins with `_`."""
    if name[0] == "_":
        return f"c{name}"
    return f"{name}_" if keyword.iskeyword(name) or name in RESERVED else name


class Namer:
    """Gives each thing a Python name of its own, C's where it can be."""

    def __init__(self, taken: Iterable[str]) -> None:
        self.taken = set(taken)

    def name(self, wanted: str, known: Iterable[str] = ()) -> str:
        """A name that is not taken, which then is."""
        wanted = safe(wanted)
        chosen, number = wanted, 1
        while chosen in self.taken or chosen in known:
            number += 1
            chosen = f"{wanted}_{number}"
        self.taken.add(chosen)
        return chosen


_OPERATORS = {
    **{"+": "add", "-": "subtract", "*": "multiply", "/": "divide", "%": "remainder"},
    **{"==": "equal", "!=": "differs", "<": "less", ">": "greater", "<=": "less_equal"},
    **{">=": "greater_equal", "[]": "item", "()": "call", "=": "assigned", "++": "increment"},
    **{"--": "decrement", "!": "inverse", "<<": "shift_left", ">>": "shift_right", "->": "arrow"},
    **{"&&": "both", "||": "either", "&": "bit_and", "|": "bit_or", "^": "bit_xor", "~": "invert"},
}


def python_name(symbol: Symbol, number: int = 1) -> str:
    """What a function is called in Python; several methods of one name are numbered."""
    name = safe(symbol.name)
    if symbol.owner is not None and symbol.name == symbol.owner.tag:
        name = "construct_"
    elif name.startswith("~"):
        name = "destroy_"
    elif name.startswith("operator"):
        sign = name.removeprefix("operator").strip()
        if sign[0].isalpha():
            known = "to_" + sign.replace(" ", "_").replace("*", "_pointer")
        else:
            known = _OPERATORS.get(sign) or f"{_OPERATORS.get(sign[:-1], 'other')}_in_place"
        name = f"{known}_"
    return name if number == 1 else f"{name}_{number}"
