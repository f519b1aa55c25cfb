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

    def find_type(self, name: str) -> Type | None:
        """The type that a name stands for."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.types:
                return scope.types[name]
            scope = scope.outer
        return None


class Namer:
    """Gives each thing a Python name of its own, C's where it can be."""

    def __init__(self, taken: Iterable[str]) -> None:
        self.taken = set(taken) | set(keyword.kwlist)

    def name(self, wanted: str, known: Iterable[str] = ()) -> str:
        """A name that is not taken, which then is."""
        chosen, number = wanted, 1
        while chosen in self.taken or chosen in known:
            number += 1
            chosen = f"{wanted}_{number}"
        self.taken.add(chosen)
        return chosen
