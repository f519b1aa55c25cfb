"""Rows of single calls and of whole programs, for all libraries alike."""

import random
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from bench.libraries import Library, libraries
from bench.timing import OURS, Arguments, Row, Task, dice, seconds_per_call

Settings = tuple[tuple[Any, ...], ...]
"""Calls that choose a style beforehand: names with arguments."""


class Call(NamedTuple):
    """One function, called with many arguments."""

    name: str
    function: str
    arguments: Callable[[random.Random], Arguments]
    before: Settings = ()
    cold: bool = False
    """Whether every round has other arguments, so that nothing is met a second time."""
    plain: bool = True
    """Whether it needs nothing that only graphics.h has, such as an operator."""


class ArrayCall(NamedTuple):
    """One call of ours with arrays; the others need a loop. The time is that of an element."""

    name: str
    function: str
    arrays: Callable[[Arguments], tuple[Any, ...]]
    """What our call takes, of the arguments that the loop takes."""
    arguments: Callable[[random.Random], Arguments]
    before: Settings = ()


class Program(NamedTuple):
    """A function that draws a whole picture, given an object with the functions of graphics.h."""

    name: str
    draw: Callable[[Any], object]
    prepare: Callable[[Any], object] = lambda g: None
    times: int = 1
    """How often it does what the row is named after."""


def rows(group: str, table: Iterable[Call | ArrayCall | Program]) -> list[Row]:
    """Rows of a table, with the libraries that are installed and can do it."""
    made = []
    for entry in table:
        tasks = {}
        for name, library in libraries().items():
            task = task_of(entry, library) if library else None
            if task:
                tasks[name] = task
        made.append(Row(group, entry.name, tasks))
    return made


def task_of(entry: Call | ArrayCall | Program, library: Library) -> Task | None:
    """How a library does what an entry says; None: it cannot."""
    if isinstance(entry, Program):
        return _program(entry, library) if library.functions else None
    function = library.function(entry.function)
    styled = bool(entry.before) or (isinstance(entry, Call) and not entry.plain)
    if function is None or (styled and not library.functions):
        return None
    if isinstance(entry, ArrayCall) and library.name == OURS:
        return _array_task(entry, library, function)
    return _call_task(entry, library, function)


def _call_task(entry: Call | ArrayCall, library: Library, function: Callable[..., object]) -> Task:
    cold = isinstance(entry, Call) and entry.cold
    kept: list[Arguments] = []

    def task(number: int) -> float:
        if cold or not kept:
            many = entry.arguments(dice(number if cold else 0))
            kept[:] = [library.arguments(entry.function, many)]
        _ready(library, entry.before)
        return seconds_per_call(function, kept[0])

    return task


def _array_task(entry: ArrayCall, library: Library, function: Callable[..., object]) -> Task:
    many = entry.arguments(dice(0))
    arrays = entry.arrays(many)

    def task(_: int) -> float:
        _ready(library, entry.before)
        return seconds_per_call(function, [arrays]) / len(many)

    return task


def _program(entry: Program, library: Library) -> Task:
    def task(_: int) -> float:
        library.reset()
        entry.prepare(library.functions)
        return seconds_per_call(entry.draw, [(library.functions,)]) / entry.times

    return task


def _ready(library: Library, before: Settings) -> None:
    library.reset()
    for name, *values in before:
        getattr(library.functions, name)(*values)
