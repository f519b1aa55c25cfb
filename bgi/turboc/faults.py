"""What is wrong with a C program, and where: with the line, and a caret under the place."""

from typing import NamedTuple


class Place(NamedTuple):
    """A place in a source: file, line and column, both from 1 on."""

    file: str
    line: int
    column: int = 1


NOWHERE = Place("", 0, 0)

MOST_ERRORS = 20
"""As many are told of one program."""


class CError(Exception):
    """A fault of a C program; as text: `PROGRAM.C:12:5: what is wrong`."""

    def __init__(self, place: Place, message: str) -> None:
        super().__init__(message)
        self.place = place
        self.message = message
        self.source = ""
        """The line that the place is in, where somebody has looked it up."""

    def __str__(self) -> str:
        file, line, column = self.place
        return f"{file}:{line}:{column}: {self.message}" if line else self.message


class CErrors(Exception):
    """All that is wrong with a program that cannot be run."""

    def __init__(self, errors: list[CError]) -> None:
        super().__init__("\n".join(map(str, errors)))
        self.errors = errors


def shown(error: CError) -> str:
    """An error with the line that it is in, and a caret under the place."""
    text = error.source.expandtabs(8).rstrip()
    before = error.source[: max(error.place.column - 1, 0)].expandtabs(8)
    return f"{error}\n    {text}\n    {' ' * len(before)}^" if text else str(error)
