"""What is to be graded: which check applies to which function, and for how many points."""

from __future__ import annotations

import inspect
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bgi.lab import check

CHECKS: dict[str, Callable[..., Any]] = {
    name: function
    for name, function in vars(check).items()
    if inspect.isfunction(function) and not name.startswith("_") and name != "picture"
}
"""The checks of functions, by name."""

DESCRIPTION = "exercises.toml"
"""The file that is looked for in the folder."""


@dataclass(frozen=True)
class Task:
    """One function that is asked for."""

    exercise: str
    function: str
    points: float = 1
    options: dict[str, bool] = field(default_factory=dict)
    """Of the check: `exactly`, `deep`."""
    name: str = ""
    """How it is called in the marks; empty: as the check."""

    @property
    def title(self) -> str:
        """What stands above its column, and tells it from all others."""
        return self.name or self.exercise


USUAL = [Task(name, f"my_{name}") for name in CHECKS]
"""Where nothing says otherwise: my_line is checked by check.line, as far as it is there."""


def parse(word: str) -> Task:
    """The task that `line=my_line` asks for; ValueError says what is wrong."""
    exercise, equals, function = word.partition("=")
    if not equals or not function.isidentifier():
        raise ValueError(f"{word!r}: write it as in line=my_line")
    return _known(Task(exercise, function, name=word), word)


def read(file: Path) -> list[Task]:
    """The tasks that a description asks for; ValueError says what is wrong in it.

    A description has a table for each function:

        [line]
        function = "my_line"
        points = 5
        exactly = true

    Its name is that of the check, unless `check` says another one.
    """
    try:
        tables = tomllib.loads(file.read_text("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: {error}") from None
    if not tables:
        raise ValueError(f"{file}: it asks for nothing")
    return [_task(name, table, f"{file}: [{name}]") for name, table in tables.items()]


def _task(name: str, table: Any, where: str) -> Task:
    if not isinstance(table, dict):
        raise ValueError(f"{where}: write a table, [line], and below it function = 'my_line'")
    options = dict(table)
    exercise = options.pop("check", name)
    function, points = options.pop("function", f"my_{exercise}"), options.pop("points", 1)
    if type(points) not in (int, float) or not 0 <= points < 1e6:
        raise ValueError(f"{where}: points must be a number from 0 on, not {points!r}")
    if not isinstance(function, str) or not function.isidentifier():
        raise ValueError(f"{where}: function must be a name, not {function!r}")
    return _known(Task(exercise, function, points, options, name), where)


def _known(task: Task, where: str) -> Task:
    if task.exercise not in CHECKS:
        raise ValueError(f"{where}: there is no check {task.exercise!r}, only {', '.join(CHECKS)}")
    known = list(inspect.signature(CHECKS[task.exercise]).parameters)[1:]
    for name, value in task.options.items():
        if name not in known or not isinstance(value, bool):
            what = " or ".join(known) or "no option"
            raise ValueError(
                f"{where}: {name} = {value!r}: {task.exercise} takes {what}, a boolean"
            )
    return task
