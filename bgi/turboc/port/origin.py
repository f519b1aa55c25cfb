"""The C source beside its Python: words at their places, comments, blank lines, closing braces."""

from __future__ import annotations

import re
from typing import NamedTuple

from bgi.turboc.faults import Place

_WORD = re.compile(
    r"""0[xX][0-9a-fA-F]+ | (?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?
      | [A-Za-z_]\w* | '(?:\\.|[^'])+'""",
    re.VERBOSE,
)
_PART = re.compile(
    r"""/\*.*?\*/ | //[^\n]* | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+' | [{}] | \n""",
    re.VERBOSE | re.DOTALL,
)


class Comment(NamedTuple):
    """A comment: its lines without their signs; `alone` if no code stands before it."""

    line: int
    end: int
    lines: list[str]
    alone: bool


class Origin:
    """One file of the program."""

    def __init__(self, lines: list[str]) -> None:
        self.lines = lines
        self.comments: list[Comment] = []
        self.closing: dict[tuple[int, int], int] = {}
        """The line of the brace that closes the one at a line and a column."""
        self._read("\n".join(lines))

    def _read(self, text: str) -> None:
        line, start = 1, 0
        open_: list[tuple[int, int]] = []
        for found in _PART.finditer(text):
            word = found[0]
            if word == "\n":
                line, start = line + 1, found.end()
            elif word == "{":
                open_.append((line, found.start() - start + 1))
            elif word == "}" and open_:
                self.closing[open_.pop()] = line
            elif word.startswith(("/*", "//")):
                alone = not text[start : found.start()].strip(" \t}")
                end = line + word.count("\n")
                column = found.start() - start
                self.comments.append(Comment(line, end, _plain(word, column), alone))
                if end > line:
                    line, start = end, found.start() + word.rfind("\n") + 1

    def word(self, place: Place) -> str:
        """The number, name or character at a place."""
        line = self.line(place.line)
        found = _WORD.match(line, place.column - 1)
        return found[0] if found else ""

    def line(self, number: int) -> str:
        """One line."""
        return self.lines[number - 1] if 0 < number <= len(self.lines) else ""

    def around(self, number: int) -> tuple[int, int]:
        """The lines of a function that begins in a line, with the comments right above it."""
        first = number
        comments = {
            line for one in self.comments if one.alone for line in range(one.line, one.end + 1)
        }
        while first - 1 in comments:
            first -= 1
        starts = [one for one in self.closing if one[0] >= number]
        return first, self.closing[min(starts)] if starts else number

    def is_blank(self, number: int) -> bool:
        """Whether there is nothing in a line of the file."""
        return 0 < number < len(self.lines) and not self.line(number).strip()


def _plain(word: str, column: int) -> list[str]:
    """The lines of a comment, without the signs around it and the stars before its lines."""
    if word.startswith("//"):
        return [_text(word[2:])]
    lines = word[2:-2].expandtabs(8).split("\n")
    rest = [one[min(column, len(one) - len(one.lstrip())) :] for one in lines[1:]]
    starred = all(one.lstrip().startswith("*") for one in rest if one.strip())
    if starred:
        rest = [one.lstrip().removeprefix("*") for one in rest]
    cut = min((len(one) - len(one.lstrip()) for one in rest if one.strip()), default=0)
    found = [lines[0].strip(), *(one[cut:].rstrip() for one in rest)]
    while found and not found[0].strip("*-= "):
        found.pop(0)
    while found and not found[-1].strip("*-= "):
        found.pop()
    return found


def _text(line: str) -> str:
    return line.rstrip().removeprefix(" ")
