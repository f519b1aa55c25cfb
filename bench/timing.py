"""How a row is measured: every library in turn, in rounds, and the median of the ratios.

One unit is what an empty call of three arguments takes in a loop inside a function:

    def empty(a, b, c): pass

    def loop(function, many):
        for a, b, c in many:
            function(a, b, c)

All calls run in such a loop. What counts is the processor time of the thread: what other programs
do meanwhile disturbs it least. Within a round every library has its turn, in the next one in
reverse order; a ratio is formed within a round, so a moment in which the machine is slow slows
both of its sides.
"""

import functools
import random
import statistics
import time
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

OURS, UNIT = "bgi", "unit"
UNIT_CALLS = [(1, 2, 3)] * 2000

Arguments = list[tuple[Any, ...]]
Task = Callable[[int], float]
"""Seconds that a thing takes, given the number of the round."""


class Row(NamedTuple):
    """One line of a table: the same work by us and by the peers that can do it."""

    group: str
    name: str
    tasks: Mapping[str, Task]
    """By library, ours first."""


class Result(NamedTuple):
    """What was measured of a row."""

    group: str
    name: str
    seconds: float
    """Ours, the median of the rounds."""
    units: float
    ratios: dict[str, float]
    """By peer: its time through ours. Above 1, we are faster."""


def empty(a: object, b: object, c: object) -> None:
    """The unit."""


@functools.cache
def loop(count: int) -> Callable[[Callable[..., object], Arguments], None]:
    """A function that calls another with each of many tuples of so many arguments."""
    names = ", ".join("abcdefgh"[:count])
    source = f"""
def loop(function, many):
    for {names + "," if names else "_"} in many:
        function({names})
"""
    space: dict[str, Any] = {}
    exec(source, space)
    made: Callable[[Callable[..., object], Arguments], None] = space["loop"]
    return made


def seconds_per_call(function: Callable[..., object], many: Arguments) -> float:
    """The thread's processor time for one call."""
    calls = loop(len(many[0]))
    start = time.thread_time()
    calls(function, many)
    return (time.thread_time() - start) / len(many)


def unit(_: int) -> float:
    """Seconds that an empty call takes just now."""
    return seconds_per_call(empty, UNIT_CALLS)


def dice(number: int) -> random.Random:
    """Chance that is the same in every run and for every library."""
    return random.Random(number)


def measure(row: Row, rounds: int) -> Result:
    """Time a row: `rounds` rounds after one that warms up."""
    tasks = {**row.tasks, UNIT: unit}
    order = list(tasks)
    times: dict[str, list[float]] = {name: [] for name in tasks}
    for number in range(rounds + 1):
        for name in order:
            times[name].append(tasks[name](number))
        order.reverse()
    first = min(rounds, 1)
    ours = times[OURS][first:]

    def over_ours(name: str) -> float:
        pairs = zip(times[name][first:], ours, strict=True)
        return statistics.median(other / max(own, 1e-12) for other, own in pairs)

    return Result(
        row.group,
        row.name,
        statistics.median(ours),
        1 / max(over_ours(UNIT), 1e-12),
        {name: over_ours(name) for name in row.tasks if name != OURS},
    )
