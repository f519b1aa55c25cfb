"""A table of functions as learners write them, each with a part of the hint that it must get."""

from collections.abc import Callable
from typing import Any

Function = Callable[..., Any]


class Mistakes:
    """Collects functions: `@mistakes("the last pixel")` above each."""

    def __init__(self) -> None:
        self.table: list[tuple[Function, str]] = []

    def __call__(self, hint: str) -> Callable[[Function], Function]:
        def collect(function: Function) -> Function:
            self.table.append((function, hint))
            return function

        return collect

    @property
    def names(self) -> list[str]:
        """What the functions are called: `ids` for pytest."""
        return [function.__name__ for function, _ in self.table]
