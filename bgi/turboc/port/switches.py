"""A switch as if and elif: each part ends where it is left, and has what it falls through into."""

from __future__ import annotations

from bgi.turboc.checker.typed import Act, Branch, Group, Leave, Select
from bgi.turboc.port import walking

MOST_COPIES = 150
"""Statements that may be written a second time for a part that falls through."""


class TooMuch(Exception):
    """A switch that falls through too much."""


def parts_of(act: Select) -> list[tuple[list[int], list[Act]]]:
    """The cases with what is done in each; the default, without numbers, comes last."""
    found: list[tuple[list[int], list[Act]]] = []
    other: tuple[list[int], list[Act]] | None = None
    copies = 0
    for place, (known, own) in enumerate(act.parts):
        body = list(own)
        following = place + 1
        while not walking.ends_here(body) and following < len(act.parts):
            more = act.parts[following][1]
            copies += sum(1 for _ in walking.acts(more))
            body += more
            following += 1
        if copies > MOST_COPIES:
            raise TooMuch
        part = without_leave(body)
        numbers = [one for one in known if one is not None]
        if None in known:
            other = [], part
        else:
            found.append((numbers, part))
    return [*found, other] if other is not None else found


def without_leave(items: list[Act]) -> list[Act]:
    """Statements without the breaks that end them: what stands behind becomes an else."""
    for place, act in enumerate(items):
        if isinstance(act, Leave):
            return items[:place]
        if isinstance(act, Group) and not act.ending and walking.leaves_switch([act]):
            return items[:place] + without_leave([*act.items, *items[place + 1 :]])
        if isinstance(act, Branch) and walking.leaves_switch([act]):
            rest = items[place + 1 :]
            yes, no = [act.yes], [act.no] if act.no is not None else []
            changed = Branch(
                act.place,
                act.condition,
                Group(act.place, without_leave(yes + ([] if walking.ends_here(yes) else rest))),
                Group(act.place, without_leave(no + ([] if walking.ends_here(no) else rest))),
            )
            return [*items[:place], changed]
    return items
