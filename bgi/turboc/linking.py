"""Several source files become one program, as a linker would join them."""

from __future__ import annotations

from collections.abc import Sequence

from bgi.turboc.grammar.tree import Program, Top


def linked(files: Sequence[Program]) -> Program:
    """One tree of several; what they have from the same header is there once."""
    items: dict[object, Top] = {}
    for file in files:
        for item in file.items:
            items.setdefault((type(item), item.place), item)
    headers = frozenset().union(*(file.headers for file in files))
    return Program(tuple(items.values()), headers)
