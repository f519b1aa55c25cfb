"""Loops as Python: `for` over a range where one counts, `while` otherwise."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from bgi.turboc.checker.typed import (
    Act,
    Advance,
    Again,
    Comparison,
    Connective,
    Constant,
    Inverse,
    Loop,
    Routine,
    Value,
    Variable,
)
from bgi.turboc.checker.types import INT, IntType, PointerType, Symbol
from bgi.turboc.emitter.wrapping import Interval, cut
from bgi.turboc.faults import Place
from bgi.turboc.port import walking
from bgi.turboc.port.facts import OPEN, READ
from bgi.turboc.port.porteffects import PortEffects
from bgi.turboc.port.pycode import PLUS, Code, binary, call, negated
from bgi.turboc.port.ranges import Range, ranged


class Around:
    """A loop that statements stand in: what has to be done before `continue`."""

    def __init__(self, step: Value | None = None, late: Value | None = None) -> None:
        self.step, self.late = step, late


class PortLoops(PortEffects):
    """Writes loops."""

    around: list[Around]
    """The loops that the statement stands in."""
    rest: list[tuple[list[Act], Loop | None]]
    """What comes behind the statement, from the outside in, and the loop that it is in."""
    routines: list[Routine]
    """All functions of the program."""

    def act(self, act: Act) -> None:
        """A statement."""
        raise NotImplementedError

    def body(self, act: Act, loop: Loop | None = None) -> None:
        """The statements of a branch or a loop."""
        raise NotImplementedError

    def loop(self, act: Loop) -> None:
        found = ranged(act, self.facts.changed_by_calls(act.body))
        if found is not None and self._is_range(act, found):
            self._range(act, found)
            return
        if act.first is not None:
            self.act(act.first)
        self.place = act.place
        before = self.place
        self.place = None
        self.held = held = self._held(act)
        condition, lines = self._condition(act)
        self.held = None
        self.around.append(Around(act.step, act.condition if act.late else None))
        with self.block(f"while {condition if not lines else 'True'}:", before):
            if lines:
                self.lines += [(indent + 1, text, at) for indent, text, at in lines]
                with self.block(f"if {negated(condition)}:"):
                    self.line("break")
            if held is not None:
                self.effect(held)
            with self.believing(act.condition if not act.late else None, act.body):
                self.body(act.body, act)
            self._go_on(act)
        self.around.pop()

    def _held(self, act: Loop) -> Advance | None:
        """The step in `while (n-- > 0)`, if nobody asks for the variable behind the loop."""
        every = list(walking.values(act.condition)) if act.condition and not act.late else []
        steps = [one for one in every if isinstance(one, Advance)]
        if len(steps) != 1 or not steps[0].postfix or not isinstance(steps[0].target, Variable):
            return None
        symbol = steps[0].target.symbol
        same = [one for one in every if isinstance(one, Variable) and one.symbol is symbol]
        if any(isinstance(one, Connective) for one in every) or len(same) != 1:
            return None
        local = symbol.kind != "global" and not isinstance(symbol.type, PointerType)
        return steps[0] if local and not self._is_read_behind(symbol, act) else None

    def _condition(self, act: Loop) -> tuple[Code, list[tuple[int, str, Place | None]]]:
        if act.condition is None or act.late:
            return Code("True"), []
        self.walrus = True
        with self.captured() as lines:
            condition = self.test(act.condition)
        self.walrus = False
        return (Code("True") if condition == "1" else condition), lines

    def _go_on(self, act: Loop) -> None:
        """What is done at the end of a turn."""
        if walking.ends_here([act.body]):
            return
        if act.step is not None:
            self.effect(act.step)
        if act.late and act.condition is not None:
            self._leave_unless(act.condition)

    def _leave_unless(self, condition: Value) -> None:
        test = self.test(condition)
        if test == "True":
            return
        if test == "False":
            self.line("break")
            return
        with self.block(f"if {self._unless(condition, test)}:", condition.place):
            self.line("break")

    def _unless(self, condition: Value, test: Code) -> Code:
        """The opposite of a condition."""
        if "(" in test and ":=" in test:
            return negated(test)
        with self.captured() as lines:
            code = self.test(Inverse(condition.place, INT, condition))
        return code if not lines else negated(test)

    def _is_range(self, act: Loop, found: Range) -> bool:
        """Whether nobody asks for the variable of a loop behind it."""
        symbol = found.variable
        if symbol in self.cells or (symbol.kind == "parameter" and symbol in self.outs.found):
            return False
        if symbol.kind == "global" and not self._is_own(symbol, act):
            return False
        return not self._is_read_behind(symbol, act)

    def _is_own(self, symbol: Symbol, act: Loop) -> bool:
        """Whether no other function uses a global variable but to count for itself."""
        if symbol in self.facts.changed_by_calls(act.body):
            return False
        return all(
            self.facts.first(
                walking.of_routine(one),
                lambda value: isinstance(value, Variable) and value.symbol is symbol,
            )
            != READ
            for one in self.routines
        )

    def _is_read_behind(self, symbol: Symbol, act: Loop) -> bool:
        def is_it(value: Value) -> bool:
            return isinstance(value, Variable) and value.symbol is symbol

        for rest, loop in reversed(self.rest):
            found = self.facts.first(rest, is_it)
            if found != OPEN:
                return found == READ
            if loop is not None:
                again = [Loop(loop.place, None, loop.condition, loop.step, loop.body, loop.late)]
                if self.facts.first(again, is_it) == READ:
                    return True
        return False

    def _range(self, act: Loop, found: Range) -> None:
        name = self.target(Variable(act.place, found.variable.type, found.variable))
        place, self.place = self.place, None
        end = self.value(found.end)
        if found.beyond:
            end = self.sum(end, found.beyond)
        start = self.value(found.start)
        if not walking.items_of(act.body) and found.step == 1:  # a program of its day waits so
            self.names.use("time", "sleep")
            turns = end if start == "0" else binary("-", end, start)
            self.line(call(self.helpers.use("busy"), [turns]), place)
            return
        parts = [start, end]
        if abs(found.step) != 1 or found.step < 0:
            step = self.value(found.by) if found.by is not None else Code("1")
            parts.append(Code(f"-{step.inside(14)}") if found.step < 0 and step[0] != "-" else step)
        elif start == "0":
            parts = [end]
        self.around.append(Around())
        head = f"for {name} in {call('range', parts)}:"
        with self.block(head, place), self.counting(found):
            self.body(act.body, act)
        self.around.pop()

    def sum(self, code: Code, by: int) -> Code:
        """An expression and a number: 10 + 1 is 11."""
        if code.lstrip("-").isdecimal():
            return Code(str(int(code) + by), 17)
        before, _, last = code.rpartition(" + ")
        if code.level == PLUS and last.isdecimal() and int(last) + by > 0:
            return Code(f"{before} + {int(last) + by}", PLUS)
        if by == 1 and code.endswith(" - 1") and code.level == PLUS:
            return Code(code[:-4], PLUS)
        if by == -1 and code.endswith(" + 1") and code.level == PLUS:
            return Code(code[:-4], PLUS)
        return binary("+" if by > 0 else "-", code, Code(str(abs(by))))

    @contextmanager
    def counting(self, found: Range) -> Iterator[None]:
        """In a loop its variable lies between its ends."""
        ends = [cut(one, self.facts.known) for one in (found.start, found.end)]
        low = ends[0][0] if found.step > 0 else ends[1][0] + (found.beyond == 0)
        high = max(one for _, one in ends)
        with self._knowing({found.variable: (low, max(low, high))}):
            yield

    @contextmanager
    def believing(self, condition: Value | None, body: Act) -> Iterator[None]:
        """Where a condition holds: `x >= 10` says that x is not negative."""
        changed = walking.written(body) | self.facts.changed_by_calls(body)
        said: dict[Symbol, Interval] = {}
        waiting = [condition] if condition is not None else []
        while waiting:
            match waiting.pop():
                case Connective(op="&&", left=left, right=right):
                    waiting += [left, right]
                case Comparison(op=op, left=Variable(symbol=symbol), right=Constant(value=number)):
                    if op in (">", ">=", "==") and symbol not in changed and int(number) >= 0:
                        type_ = symbol.type
                        if isinstance(type_, IntType):
                            said[symbol] = int(number) + (op == ">"), type_.high
        with self._knowing(said):
            yield

    @contextmanager
    def _knowing(self, said: dict[Symbol, Interval]) -> Iterator[None]:
        before = self.facts.known
        self.facts.known = before | said
        yield
        self.facts.known = before

    def again(self, act: Again) -> None:
        around = self.around[-1]
        if around.step is not None:
            self.effect(around.step)
        if around.late is not None:
            self._leave_unless(around.late)
        self.line("continue")
