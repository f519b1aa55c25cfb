"""Functions with goto: their statements in parts, from one label to the next.

What holds a label or a goto is taken apart into jumps, as a compiler does; everything else stays as
it is. The parts are run by a loop that knows which is next: a state machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from bgi.turboc.checker.typed import (
    Act,
    Again,
    Branch,
    Comparison,
    Compute,
    Constant,
    Group,
    Inverse,
    Jump,
    Leave,
    Loop,
    Mark,
    Select,
    Store,
    Value,
    Variable,
)
from bgi.turboc.checker.types import INT, Symbol
from bgi.turboc.faults import Place


@dataclass
class Machine:
    """The parts of a function, and the part that each label begins."""

    parts: list[list[Act]] = field(default_factory=lambda: [[]])
    labels: dict[str, int] = field(default_factory=dict)
    variables: list[Symbol] = field(default_factory=list)
    """Those that hold the values of switches."""
    made: int = 0
    """Labels that no program has."""

    def add(self, act: Act) -> None:
        """A statement of the last part."""
        self.parts[-1].append(act)

    def mark(self, label: str) -> None:
        """A label: a part begins."""
        self.parts.append([])
        self.labels[label] = len(self.parts) - 1

    def new(self, why: str) -> str:
        """A label that no program has, and nothing else here."""
        self.made += 1
        return f"{why} {self.made}"


def taken_apart(body: Group) -> Machine:
    """The parts of a function's body."""
    machine = Machine()
    _lower(body, machine, "", "")
    return machine


def _inner(act: Act) -> list[Act]:
    """The statements in a statement."""
    match act:
        case Group(items=items):
            return items
        case Branch(yes=yes, no=no):
            return [yes, no] if no is not None else [yes]
        case Loop(first=first, body=body):
            return [first, body] if first is not None else [body]
        case Select(parts=parts):
            return [one for _, acts in parts for one in acts]
    return []


def _holds(act: Act, kinds: type | tuple[type, ...]) -> bool:
    return isinstance(act, kinds) or any(_holds(one, kinds) for one in _inner(act))


def _apart(act: Act, inside: bool) -> bool:
    """Whether a statement has to be taken apart; `inside` a loop that has been."""
    match act:
        case Loop():
            return _holds(act, (Mark, Jump))
        case Select():
            return _holds(act, (Mark, Jump)) or (inside and _holds(act, Again))
        case Group():
            return True
    return _holds(act, Mark) or any(_apart(one, inside) for one in _inner(act) if not _plain(one))


def _plain(act: Act) -> bool:
    """Whether it is a block without anything to take apart."""
    return isinstance(act, Group) and not any(
        _apart(one, True) for one in act.items if not _plain(one)
    )


def _lower(act: Act, machine: Machine, out: str, on: str) -> None:
    """Add a statement: break jumps to `out`, continue to `on`, where a loop was taken apart."""
    match act:
        case Mark(label=label):
            machine.mark(label)
        case Leave(place=place) if out:
            machine.add(Jump(place, out))
        case Again(place=place) if on:
            machine.add(Jump(place, on))
        case Group(items=items):
            for item in items:
                _lower(item, machine, out, on)
        case Branch() if _apart(act, bool(out)):
            _lower_branch(act, machine, out, on)
        case Loop() if _apart(act, bool(out)):
            _lower_loop(act, machine)
        case Select() if _apart(act, bool(out)):
            _lower_select(act, machine, on)
        case _:
            machine.add(_with_jumps(act, out, on))


def _with_jumps(act: Act, out: str, on: str) -> Act:
    """A statement that stays, with jumps for the break and continue of a loop that does not."""
    match act:
        case Leave(place=place) if out:
            return Jump(place, out)
        case Again(place=place) if on:
            return Jump(place, on)
        case Group(items=items):
            return Group(act.place, [_with_jumps(one, out, on) for one in items], act.ending)
        case Branch(condition=condition, yes=yes, no=no):
            other = None if no is None else _with_jumps(no, out, on)
            return Branch(act.place, condition, _with_jumps(yes, out, on), other)
    return act


def _unless(condition: Value, label: str) -> Act:
    place = condition.place
    return Branch(place, Inverse(place, INT, condition), Jump(place, label), None)


def _lower_branch(act: Branch, machine: Machine, out: str, on: str) -> None:
    other, end = machine.new("else"), machine.new("endif")
    machine.add(_unless(act.condition, other))
    _lower(act.yes, machine, out, on)
    if act.no is not None:
        machine.add(Jump(act.place, end))
    machine.mark(other)
    if act.no is not None:
        _lower(act.no, machine, out, on)
        machine.mark(end)


def _lower_loop(act: Loop, machine: Machine) -> None:
    top, on, end = machine.new("top"), machine.new("on"), machine.new("end")
    if act.first is not None:
        _lower(act.first, machine, "", "")
    machine.mark(top)
    if act.condition is not None and not act.late:
        machine.add(_unless(act.condition, end))
    _lower(act.body, machine, end, on)
    machine.mark(on)
    if act.step is not None:
        machine.add(Compute(act.step.place, act.step))
    if act.condition is not None and act.late:
        machine.add(_unless(act.condition, end))
    machine.add(Jump(act.place, top))
    machine.mark(end)


def _lower_select(act: Select, machine: Machine, on: str) -> None:
    end, place = machine.new("end"), act.place
    symbol = Symbol("selected", act.value.type, place, "local")
    machine.variables.append(symbol)
    variable = Variable(place, symbol.type, symbol)
    machine.add(Compute(place, Store(place, symbol.type, variable, act.value)))
    labels = [machine.new(f"case {number}") for number in range(len(act.parts))]
    other = end
    for label, (values, _) in zip(labels, act.parts, strict=True):
        for value in values:
            if value is None:
                other = label
            else:
                machine.add(_case(place, variable, value, label))
    machine.add(Jump(place, other))
    for label, (_, acts) in zip(labels, act.parts, strict=True):
        machine.mark(label)
        for one in acts:
            _lower(one, machine, end, on)
    machine.mark(end)


def _case(place: Place, variable: Variable, value: int, label: str) -> Act:
    same = Comparison(place, INT, "==", variable, Constant(place, variable.type, value))
    return Branch(place, same, Jump(place, label), None)
