"""Statements as Python."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bgi.turboc.checker.typed import (
    Act,
    Again,
    Branch,
    Compute,
    Constant,
    Define,
    Give,
    Group,
    Jump,
    Leave,
    Loop,
    Mark,
    Routine,
    Select,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    VOID,
    ArrayType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    innermost,
    is_number,
)
from bgi.turboc.faults import Place
from bgi.turboc.port import walking
from bgi.turboc.port.facts import READ, SET
from bgi.turboc.port.pointershapes import TEXT
from bgi.turboc.port.portloops import PortLoops
from bgi.turboc.port.portplaces import REGISTERS
from bgi.turboc.port.pycode import Code, call, negated
from bgi.turboc.port.singles import loses
from bgi.turboc.port.switches import TooMuch, parts_of


class PortActions(PortLoops):
    """Writes statements."""

    routine: Routine
    """The function that is written."""

    def begin(self, routine: Routine) -> None:
        """A function begins."""
        self.routine = routine
        self.around, self.rest = [], []

    def act(self, act: Act) -> None:
        """A statement."""
        self.place = act.place
        _WRITERS[type(act)](self, act)
        self.place = None

    def acts(self, items: list[Act], loop: Loop | None = None) -> None:
        """Statements one after the other."""
        for number, one in enumerate(items):
            self.rest.append((items[number + 1 :], loop))
            self.act(one)
            self.rest.pop()

    def body(self, act: Act, loop: Loop | None = None) -> None:
        """The statements of a branch or a loop."""
        items = act.items if isinstance(act, Group) and not act.ending else [act]
        self.acts(items, loop)
        self._mark_end(act)

    def _mark_end(self, act: Act) -> None:
        """Where a block ends, for the comments before its brace."""
        origin = self.names.origins.get(act.place.file)
        if isinstance(act, Group) and origin is not None:
            end = origin.closing.get((act.place.line, act.place.column))
            if end is not None:
                self.lines.append((self.indent, "", Place(act.place.file, end)))

    # Statements

    def _compute(self, act: Compute) -> None:
        self.effect(act.value)

    def _define(self, act: Define) -> None:
        symbol = act.symbol
        if self._is_replaced(act) if act.value else not self.has_to_begin(symbol):
            self.place = None
            return
        self.statement, self.after = act.value, []
        self.answer = None if symbol in self.cells else Code(symbol.python)
        text = self.first(act)
        self.answer = None
        if text != symbol.python:
            self.line(f"{symbol.python} = {text}")
        for line in self.after:
            self.line(line)
        self.after = None

    def _is_replaced(self, act: Define) -> bool:
        """Whether a number is stored first in a variable that nobody reads before the next one."""
        symbol = act.symbol
        local = symbol.kind == "local" and symbol not in self.cells and not self.routine.jumps
        if not (local and isinstance(act.value, Constant) and is_number(symbol.type)):
            return False

        def is_it(one: Value) -> bool:
            own = isinstance(one, Variable) and one.symbol is symbol
            return own and one.place != act.place

        return self.facts.first(walking.of_routine(self.routine), is_it) == SET

    def first(self, act: Define) -> Code:
        """What a variable holds at first."""
        symbol, key = act.symbol, (act.symbol, 0)
        if act.value is None:
            code = self._sized(symbol, self.nothing(symbol.type, key))
        elif isinstance(symbol.type, ReferenceType):
            code = self.reference(act.value, symbol.type, "")
        else:
            code = self.initial(act.value, symbol.type, key)
            if symbol in self.facts.singles and loses(act.value):
                code = call(self.helpers.use("float32"), [code])
        return Code(f"[{code}]") if symbol in self.cells else code

    def _sized(self, symbol: Symbol, code: Code) -> Code:
        """An empty array, whose length is a constant with a name."""
        type_, place = symbol.type, symbol.place
        origin = self.names.origins.get(place.file)
        if not isinstance(type_, ArrayType) or origin is None:
            return code
        behind = origin.line(place.line)[place.column - 1 + len(symbol.name) :].lstrip()
        counts: list[Code | None] = []
        inner: Any = type_
        while isinstance(inner, ArrayType) and behind.startswith("["):
            word = behind[1:].partition("]")[0].strip()
            counts.append(self.names.known_count(word, inner.count))
            inner, behind = inner.of, behind.partition("]")[2].lstrip()
        for count in counts:
            if count is not None:
                size = self._count_at(type_, counts.index(count))
                for before, after in (
                    (f"] * {size}", f"] * {count}"),
                    (f"range({size})", f"range({count})"),
                ):
                    if code.count(before) == 1:
                        code = Code(code.replace(before, after), code.level)
        return code

    def _count_at(self, type_: Any, depth: int) -> int:
        for _ in range(depth):
            type_ = type_.of
        return int(type_.count)

    def has_to_begin(self, symbol: Symbol) -> bool:
        """Whether a variable without a value needs one."""
        type_ = symbol.type
        library = isinstance(type_, StructType) and type_.library and type_.tag not in REGISTERS
        text = isinstance(type_, ArrayType) and self.shapes.of_key((symbol, 0), type_) == TEXT
        whole = isinstance(type_, (ArrayType, StructType)) and not library and not text
        if symbol in self.cells or whole:
            return self._is_used(symbol)
        acts = walking.of_routine(self.routine)
        if self.routine.jumps:
            return self._is_used(symbol)
        found = self.facts.first(
            acts, lambda one: isinstance(one, Variable) and one.symbol is symbol
        )
        return found == READ

    def _is_used(self, symbol: Symbol) -> bool:
        return any(
            isinstance(one, Variable) and one.symbol is symbol
            for one in walking.values(walking.of_routine(self.routine))
        )

    def _group(self, act: Group) -> None:
        if len(act.items) > 1 and all(isinstance(one, Define) for one in act.items):
            self._defines(act)
            return
        self.acts(act.items)
        self.ended(act.ending)

    def _defines(self, act: Group) -> None:
        """Variables that are declared together; those that begin alike, in one line."""
        before = len(self.lines)
        for one in act.items:
            self.act(one)
        made = self.lines[before:]
        texts = [text.partition(" = ") for _, text, _ in made]
        alike = len({value for _, _, value in texts}) == 1 and len(texts) > 1
        if alike and (texts[0][2].replace(".", "").isdecimal() or texts[0][2] == '""'):
            names = " = ".join(name for name, _, _ in texts)
            self.lines[before:] = [(made[0][0], f"{names} = {texts[0][2]}", made[0][2])]

    def ended(self, symbols: tuple[Symbol, ...]) -> None:
        """Objects that end with a block."""
        for symbol in reversed(symbols):
            cls = innermost(symbol.type)
            assert isinstance(cls, StructType)
            name = cls.method(f"~{cls.tag}")[0].python
            if isinstance(symbol.type, StructType):
                self.line(f"{symbol.python}.{name}()")
            else:
                with self.block(f"for one in reversed({symbol.python}):"):
                    self.line(f"one.{name}()")

    def _branch(self, act: Branch) -> None:
        place, self.place = self.place, None
        with self.captured() as lines:
            condition = self.test(act.condition)
        self.lines += lines
        self._if(act, condition, "if", place)

    def _if(self, act: Branch, condition: Code, word: str, place: Place | None) -> None:
        yes, no = act.yes, act.no
        if not walking.items_of(yes) and no is not None:
            yes, no, condition = no, None, negated(condition)
        with self.block(f"{word} {condition}:", place), self.believing(act.condition, yes):
            self.body(yes)
        rest = walking.items_of(no)
        if len(rest) == 1 and isinstance(rest[0], Branch):
            with self.captured() as lines:
                condition = self.test(rest[0].condition)
            if not lines:
                self._if(rest[0], condition, "elif", rest[0].place)
                return
        if rest and no is not None:
            with self.block("else:", no.place if isinstance(no, Group) else None):
                self.body(no)

    def _give(self, act: Give) -> None:
        outs = [str(self.variable(one)) for one in self.outs.of(self.routine.symbol)]
        result = self.routine.symbol.type.result  # type: ignore[union-attr]
        if act.value is not None and act.value.type != VOID:
            if self.routine.symbol.name == "main":
                self._end_main(act.value)
                return
            outs.insert(0, self.returned(act.value, result))
        elif act.value is not None:
            self.effect(act.value)
        self.line(f"return {', '.join(outs)}" if outs else "return")

    def returned(self, value: Value, result: Any) -> str:
        """What a function gives back."""
        if isinstance(result, PointerType):
            wanted = self.shapes.of_key((("result", self.routine.symbol), 0), result)
            return str(self.given(value, wanted, result))
        if isinstance(result, StructType):
            own = isinstance(value, Variable) and value.symbol.kind == "local"
            return str(self.value(value) if own else self.copied(value))
        if isinstance(result, ReferenceType):
            return str(self.reference(value, result, ""))
        return str(self.value(value))

    def _end_main(self, value: Value) -> None:
        if isinstance(value, Constant) and not value.value:
            self.line("return")
            return
        self.names.modules.add("sys")
        self.line(f"sys.exit({self.value(value)})")

    def _leave(self, act: Leave | walking.Out) -> None:
        self.line("break")

    # Switch

    def _select(self, act: Select) -> None:
        place, self.place = self.place, None
        try:
            parts = parts_of(act)
        except TooMuch:
            raise self.refuse(act.place, "a switch whose cases fall into each other") from None
        value = self._selected(act, parts)
        word = "if"
        for numbers, items in parts:
            first = items[0].place if items else None
            if not numbers:
                if not items:
                    continue
                head = "else:" if word == "elif" else "if True:"
            elif len(numbers) == 1:
                head = f"{word} {value} == {self._case(act, numbers[0])}:"
            else:
                head = f"{word} {value} in ({', '.join(self._case(act, one) for one in numbers)}):"
            with self.block(head, place if word == "if" else self._before(act, first)):
                self.acts(items)
            word = "elif"

    def _before(self, act: Select, first: Place | None) -> Place | None:
        """A case stands in the line of what is done in it, or in the one before."""
        if first is None:
            return None
        origin = self.names.origins.get(first.file)
        same = origin is not None and origin.line(first.line).lstrip()[:4] in ("case", "defa")
        return first if same else first._replace(line=first.line - 1)

    def _selected(self, act: Select, parts: list[tuple[list[int], list[Act]]]) -> Code:
        value = self.value(act.value)
        if value.replace("_", "").replace(".", "").isalnum() or len(parts) < 2:
            return Code(value.inside(8))
        name = self.temporary("choice")
        self.line(f"{name} = {value}", act.place)
        return Code(name)

    def _case(self, act: Select, number: int) -> str:
        """A case as it is written: a character, a constant with a name."""
        return str(self.value(act.written[number]) if number in act.written else number)

    # Goto

    def _jump(self, act: Jump) -> None:
        raise self.refuse(act.place, f"goto {act.label}: write it as a loop first")

    def _mark(self, act: Mark) -> None:
        """A label that nothing jumps to."""


_WRITERS: dict[type, Callable[[PortActions, Any], None]] = {
    Compute: PortActions._compute,
    Define: PortActions._define,
    Group: PortActions._group,
    Branch: PortActions._branch,
    Loop: PortLoops.loop,
    Select: PortActions._select,
    Leave: PortActions._leave,
    walking.Out: PortActions._leave,
    Again: PortLoops.again,
    Give: PortActions._give,
    Jump: PortActions._jump,
    Mark: PortActions._mark,
}
