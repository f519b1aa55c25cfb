"""Functions with goto, without it: what jumps back is a loop, what jumps to the end returns."""

from __future__ import annotations

from bgi.turboc.checker.typed import (
    Act,
    Again,
    Branch,
    Give,
    Group,
    Jump,
    Leave,
    Loop,
    Mark,
    Routine,
    Select,
)
from bgi.turboc.port import walking
from bgi.turboc.port.walking import Out

MOST_COPIES = 12
"""Statements at the end of a function that may be written again for a goto that leads there."""


def without_jumps(routine: Routine) -> None:
    """Take away the gotos of a function that can be said otherwise; the others stay."""
    items = _flat(routine.body.items)
    labels = [one.label for one in walking.acts(items) if isinstance(one, Mark)]
    for label in labels:
        items = _structured(items, label, True)
    routine.body = Group(routine.body.place, items, routine.body.ending)
    routine.jumps = bool(walking.jumps_in(items))


def _flat(items: list[Act]) -> list[Act]:
    """Statements without the blocks that only hold a label and what stands behind it."""
    found: list[Act] = []
    for one in items:
        labelled = isinstance(one, Group) and one.items and isinstance(one.items[0], Mark)
        found += _flat(one.items) if isinstance(one, Group) and labelled else [one]
    return found


def _structured(items: list[Act], label: str, whole: bool) -> list[Act]:
    """Statements without the jumps to one label; `whole` if a function ends behind them."""
    items = _flat(items)
    places = [at for at, one in enumerate(items) if isinstance(one, Mark) and one.label == label]
    if not places:
        return [_inside(one, label) for one in items]
    at = places[0]
    before, behind = items[:at], items[at + 1 :]
    if (
        whole
        and not walking.jumps_in(behind)
        and sum(1 for _ in walking.acts(behind)) <= MOST_COPIES
    ):
        ending = [*behind, Give(items[at].place, None)]
        if walking.ends_here(behind):
            ending = behind
        changed = [_replaced(one, label, ending) for one in before]
        return changed if walking.ends_here(changed) else [*changed, *behind]
    back = [number for number, one in enumerate(behind) if _jumps_to(one, label)]
    if back and not any(_jumps_to(one, label) for one in before):
        body = behind[: back[-1] + 1]
        if not walking.leaves_switch(body) and not walking.goes_on(body):
            return [*before, _loop(items[at], body, label, Again), *behind[back[-1] + 1 :]]
    forward = [number for number, one in enumerate(before) if _jumps_to(one, label)]
    if forward and not back:
        body = before[forward[0] :]
        if not walking.leaves_switch(body) and not walking.goes_on(body):
            return [*before[: forward[0]], _loop(items[at], body, label, Leave), *behind]
    return items


def _loop(mark: Act, body: list[Act], label: str, kind: type[Again] | type[Leave]) -> Act:
    """Statements that are done again, or left, by a jump: those in loops of their own stay."""
    last, place = body[-1], mark.place
    again = walking.items_of(last.yes) if isinstance(last, Branch) and last.no is None else []
    if isinstance(last, Branch) and kind is Again and [type(one) for one in again] == [Jump]:
        inside = [_outermost(one, label, kind) for one in body[:-1]]
        if not any(_jumps_to(one, label) for one in body[:-1]):
            return Loop(place, None, last.condition, None, Group(place, inside), True)
        rest = Branch(last.place, last.condition, Group(place, []), Group(place, [Leave(place)]))
        return Loop(place, None, None, None, Group(place, [*inside, rest]))
    changed = [_outermost(one, label, kind) for one in body]
    ended = changed if walking.ends_here(changed) else [*changed, Leave(place)]
    return Loop(place, None, None, None, Group(place, ended))


def _jumps_to(act: Act, label: str) -> bool:
    return any(one.label == label for one in walking.jumps_in([act]))


def _outermost(act: Act, label: str, kind: type[Act]) -> Act:
    """A statement with its jumps to a label replaced, but those in loops of their own."""
    match act:
        case Jump(label=one) if one == label:
            return kind(act.place)
        case Group():
            return Group(act.place, [_outermost(one, label, kind) for one in act.items], act.ending)
        case Branch():
            no = _outermost(act.no, label, kind) if act.no is not None else None
            return Branch(act.place, act.condition, _outermost(act.yes, label, kind), no)
        case Select():
            kind = Out if kind is Leave else kind
            parts = [
                (known, [_outermost(one, label, kind) for one in body]) for known, body in act.parts
            ]
            return Select(act.place, act.value, parts, act.written)
    return act


def _replaced(act: Act, label: str, ending: list[Act]) -> Act:
    """A statement with all its jumps to a label replaced, however deep they are."""
    match act:
        case Jump(label=one) if one == label:
            return Group(act.place, ending)
        case Group():
            return Group(
                act.place, [_replaced(one, label, ending) for one in act.items], act.ending
            )
        case Branch():
            no = _replaced(act.no, label, ending) if act.no is not None else None
            return Branch(act.place, act.condition, _replaced(act.yes, label, ending), no)
        case Loop():
            body = _replaced(act.body, label, ending)
            return Loop(act.place, act.first, act.condition, act.step, body, act.late)
        case Select():
            parts = [
                (known, [_replaced(one, label, ending) for one in body])
                for known, body in act.parts
            ]
            return Select(act.place, act.value, parts, act.written)
    return act


def _inside(act: Act, label: str) -> Act:
    """A statement in which the label may stand."""
    match act:
        case Group():
            return Group(act.place, _structured(act.items, label, False), act.ending)
        case Branch():
            no = _inside(act.no, label) if act.no is not None else None
            return Branch(act.place, act.condition, _inside(act.yes, label), no)
        case Loop():
            body = _inside(act.body, label)
            return Loop(act.place, act.first, act.condition, act.step, body, act.late)
    return act
