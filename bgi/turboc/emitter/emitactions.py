"""Statements as Python."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.scopes import Namer
from bgi.turboc.checker.typed import (
    Act,
    Advance,
    Again,
    Branch,
    Compute,
    Converted,
    Define,
    Give,
    Group,
    Jump,
    Leave,
    Loop,
    Mark,
    Select,
    Sequence,
    Store,
    Update,
    Value,
)
from bgi.turboc.checker.types import VOID, StructType, Symbol, innermost
from bgi.turboc.emitter.emitvalues import ValueWriter
from bgi.turboc.emitter.gotos import Machine
from bgi.turboc.emitter.loops import Counted, counted, is_empty
from bgi.turboc.faults import NOWHERE, Place


class Inside(NamedTuple):
    """What a break or continue belongs to."""

    step: Value | None = None
    late: Value | None = None
    select: str = ""
    """In a switch: the name that says that the loop around it goes on."""


class ActionWriter(ValueWriter):
    """Writes statements, each on lines of its own whose places are kept."""

    def __init__(self, headers: Headers, namer: Namer) -> None:
        super().__init__(headers, namer)
        self.lines: list[str] = []
        self.places: list[Place] = []
        self.indent = 0
        self.place = NOWHERE
        self.around: list[Inside] = []
        self.labels: dict[str, int] = {}
        """Which part of the function each label begins."""
        self.state = ""
        """The name that holds which part is next."""
        self.ending: list[tuple[Symbol, ...]] = []
        """Objects to destroy, by block."""

    def line(self, text: str) -> None:
        """A line of Python."""
        self.lines.append("    " * self.indent + text)
        self.places.append(self.place)

    @contextmanager
    def block(self, head: str) -> Iterator[None]:
        """Lines further in; there is at least one."""
        self.line(head)
        self.indent += 1
        before = len(self.lines)
        yield
        if len(self.lines) == before:
            self.line("pass")
        self.indent -= 1

    def act(self, act: Act) -> None:
        """A statement."""
        self.place = act.place
        _WRITERS[type(act)](self, act)

    def effect(self, value: Value) -> None:
        """A value that is computed for its effects."""
        self.place = value.place
        match value:
            case Store() if not isinstance(value.type, StructType):
                spot = self.spot(value.target)
                self.line(spot.write.replace("@", self.value(value.value)))
            case Update():
                spot = self.settled(self.spot(value.target))
                self._before(spot.before)
                self.line(spot.write.replace("@", self.updated(value, spot)))
            case Advance():
                spot = self.settled(self.spot(value.target))
                self._before(spot.before)
                self.line(spot.write.replace("@", self.stepped(value, spot)))
            case Sequence(items=items):
                for item in items:
                    self.effect(item)
            case Converted(operand=operand) if value.type == VOID:
                self.effect(operand)
            case _:
                self.line(self.raw(value))

    def _before(self, names: tuple[tuple[str, str], ...]) -> None:
        for name, text in names:
            self.line(f"{name} = {text}")

    # Statements

    def _compute(self, act: Compute) -> None:
        self.effect(act.value)

    def _define(self, act: Define) -> None:
        symbol = act.symbol
        if act.value is not None:
            self.line(f"{symbol.python} = {self.made_variable(symbol, act.value)}")

    def _group(self, act: Group) -> None:
        self.ending.append(act.ending)
        for item in act.items:
            self.act(item)
        self._destroy(act.ending)
        self.ending.pop()

    def _destroy(self, symbols: tuple[Symbol, ...]) -> None:
        for symbol in reversed(symbols):
            cls = innermost(symbol.type)
            assert isinstance(cls, StructType)
            found = cls.method(f"~{cls.tag}")[0]
            if isinstance(symbol.type, StructType):
                self.line(f"{symbol.python}.{found.python}()")
            else:
                with self.block(f"for _one in {symbol.python}[::-1]:"):
                    self.line(f"_one.{found.python}()")

    def _branch(self, act: Branch) -> None:
        one: Act | None = act
        word = "if"
        while isinstance(one, Branch):
            self.place = one.place
            with self.block(f"{word} {self.test(one.condition)}:"):
                self.act(one.yes)
            one, word = one.no, "elif"
        if one is not None:
            with self.block("else:"):
                self.act(one)

    def _loop(self, act: Loop) -> None:
        if act.first is not None:
            self.act(act.first)
        self.place = act.place
        range_ = counted(act, self.known)
        if range_ is not None:
            self._counted(act, range_)
            return
        condition = "True" if act.condition is None or act.late else self.test(act.condition)
        self.around.append(Inside(act.step, act.condition if act.late else None))
        with self.block(f"while {condition}:"):
            self.act(act.body)
            if act.step is not None:
                self.effect(act.step)
            if act.late and act.condition is not None:
                self.place = act.condition.place
                with self.block(f"if not {self.test(act.condition)}:"):
                    self.line("break")
        self.around.pop()

    def _counted(self, act: Loop, range_: Counted) -> None:
        """A loop that counts up or down to what stays the same: a range."""
        variable, step = range_.variable, self.value(range_.step)
        name, end = self.name_of(variable), self.value(range_.end)
        limit = f"{end} {'+' if range_.up else '-'} 1" if range_.inclusive else end
        left = f"{name} {'<' if range_.up else '>'} {limit}"
        if is_empty(act.body) and step == "1":  # a program of its day waits so
            self.used.add("busy")
            with self.block(f"if {left}:"):
                self.line(f"busy({limit} - {name})" if range_.up else f"busy({name} - ({limit}))")
                self.line(f"{name} = {limit}")
            return
        before = self.known.get(variable)
        self.known[variable] = range_.inside
        self.around.append(Inside())
        steps = f", {'-' * (not range_.up)}{step}" if step != "1" or not range_.up else ""
        with self.block(f"for {name} in range({name}, {limit}{steps}):"):
            self.act(act.body)
        self.around.pop()
        del self.known[variable]
        if before is not None:
            self.known[variable] = before
        with self.block("else:"):
            self.line(f"if {left}: {name} {'+' if range_.up else '-'}= {step}")

    def _leave(self, act: Leave) -> None:
        self.line("break")

    def _again(self, act: Again) -> None:
        inside = self.around[-1] if self.around else Inside()
        if inside.select:
            self.line(f"{inside.select} = True")
            self.line("break")
            return
        if inside.step is not None:
            self.effect(inside.step)
        if inside.late is not None:
            with self.block(f"if not {self.test(inside.late)}:"):
                self.line("break")
        self.line("continue")

    def _give(self, act: Give) -> None:
        text = "return"
        if act.value is not None and act.value.type != VOID:
            text = f"return {self.given(act.value)}"
        elif act.value is not None:
            self.effect(act.value)
        ending = [symbols for symbols in self.ending if symbols]
        if ending and act.value is not None and text != "return":
            self.line(f"_result = {text.removeprefix('return ')}")
            text = "return _result"
        for symbols in reversed(ending):
            self._destroy(symbols)
        self.line(text)

    # Switch

    def _select(self, act: Select) -> None:
        """A switch: parts in order, from the one whose case it is; a break leaves the loop."""
        case, again = self.temporary(), self.temporary()
        numbers: dict[int, int] = {}
        other = len(act.parts)
        for place, (values, _) in enumerate(act.parts):
            for value in values:
                if value is None:
                    other = place
                else:
                    numbers.setdefault(value, place)
        self.line(f"{case} = {numbers}.get({self.value(act.value)}, {other})")
        continues = any(map(_continues, (one for _, acts in act.parts for one in acts)))
        if continues:
            self.line(f"{again} = False")
        self.around.append(Inside(select=again))
        with self.block("while True:"):
            for place, (_, acts) in enumerate(act.parts):
                sign = "<=" if place == 0 or _falls(act.parts[place - 1][1]) else "=="
                with self.block(f"if {case} {sign} {place}:"):
                    for one in acts:
                        self.act(one)
            self.line("break")
        self.around.pop()
        if continues:
            with self.block(f"if {again}:"):
                self._again(Again(act.place))

    # Goto

    def machine(self, machine: Machine) -> None:
        """Parts in order, from the one that a goto leads to."""
        self.labels = machine.labels
        self.state = self.temporary()
        self.line(f"{self.state} = 0")
        self.around.append(Inside())
        with self.block("while True:"):
            for place, acts in enumerate(machine.parts):
                with self.block(f"if {self.state} <= {place}:"):
                    for one in acts:
                        self.act(one)
            self.line("break")
        self.around.pop()

    def _jump(self, act: Jump) -> None:
        self.line(f"{self.state} = {self.labels[act.label]}")
        self.line("continue")

    def _mark(self, act: Mark) -> None:
        """A label that nothing jumps to."""


def _continues(act: Act) -> bool:
    """Whether there is a continue in it that belongs to a loop around it."""
    match act:
        case Again():
            return True
        case Group(items=items):
            return any(map(_continues, items))
        case Branch(yes=yes, no=no):
            return _continues(yes) or (no is not None and _continues(no))
        case Select(parts=parts):
            return any(_continues(one) for _, acts in parts for one in acts)
    return False


def _falls(acts: list[Act]) -> bool:
    """Whether the end of statements may be reached."""
    last: Act | None = acts[-1] if acts else None
    while isinstance(last, Group) and last.items:
        last = last.items[-1]
    return not isinstance(last, (Leave, Give, Again, Jump))


_WRITERS: dict[type, Callable[[ActionWriter, Any], None]] = {
    Compute: ActionWriter._compute,
    Define: ActionWriter._define,
    Group: ActionWriter._group,
    Branch: ActionWriter._branch,
    Loop: ActionWriter._loop,
    Select: ActionWriter._select,
    Leave: ActionWriter._leave,
    Again: ActionWriter._again,
    Give: ActionWriter._give,
    Jump: ActionWriter._jump,
    Mark: ActionWriter._mark,
}
