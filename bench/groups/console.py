"""The text screen, which none of the peers has: so these rows show our own times only."""

from collections.abc import Callable

from bench.timing import OURS, Arguments, Row, Task, seconds_per_call
from bgi import conio, stdio

LETTERS: Arguments = [(65,)] * 75
FULL: Arguments = [("x" * 79,)] * 25
NUMBERS: Arguments = [("line %d\n", number) for number in range(200)]


def task(write: Callable[..., object], many: Arguments, times: int = 1) -> Task:
    """Write on a fresh text screen; the time is that of a call, or of so many together."""

    def measured(_: int) -> float:
        conio.textmode(conio.C80)
        return seconds_per_call(write, many) * times

    return measured


def rows() -> list[Row]:
    """The rows of this group."""
    return [
        Row("console", "putch", {OURS: task(conio.putch, LETTERS)}),
        Row("console", "cprintf, a full screen", {OURS: task(conio.cprintf, FULL, 25)}),
        Row("console", "printf, 2,000 lines", {OURS: task(stdio.printf, NUMBERS, 2000)}),
    ]
