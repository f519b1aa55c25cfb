"""The lines of a program become its text: with comments, blank lines and imports."""

from __future__ import annotations

from collections.abc import Sequence

from bgi.turboc.faults import Place
from bgi.turboc.port.origin import Comment, Origin
from bgi.turboc.port.pycode import WIDTH, wrapped

AWAY, BACK, BLANK = "\0away", "\0back", "\0blank"
"""Where a method's body begins that stands elsewhere in the source, where it ends, a blank line."""

DEEPEST = 100_000
"""Calls within each other, in a program whose functions call themselves."""

Line = tuple[int, str, Place | None]


class Weaver:
    """Puts the comments of the sources between the lines of the program."""

    def __init__(self, origins: dict[str, Origin], files: list[str]) -> None:
        """
        Args:
            origins: the sources.
            files: their names; the first one is the program's, those behind it are included.
        """
        self._origins = origins
        self._order = {file: place for place, file in enumerate([*files[1:], *files[:1]])}
        self._waiting = {file: list(origin.comments) for file, origin in origins.items()}
        self._out: list[str] = []
        self._left: list[tuple[list[Comment], int]] = []
        """What waited where the source was left for a method's body."""
        self._last: dict[str, int] = {}
        """The line of each source that was written last."""

    def text(
        self,
        file: str,
        parts: Sequence[tuple[Place, list[Line], bool]],
        *,
        imports: list[str],
        helpers: list[str],
        notes: list[str],
        main: str,
        deep: bool,
    ) -> str:
        """The whole program."""
        ordered = sorted(parts, key=lambda one: (self._order.get(one[0].file, -1), one[0][1:]))
        first = ordered[0][0] if ordered else Place(file, 1)
        head = self._head(file, first)
        self._out = [f'"""{head[0]}' if head else f'"""{file}, in Python.', *head[1:]]
        for note in notes:
            self._out += ["", note]
        self._out[-1] += '"""' if len(self._out) == 1 else ""
        if len(self._out) > 1:
            self._out.append('"""')
        self._out += ["", *(line for one in imports for line in wrapped(one, 0))] if imports else []
        if helpers:
            self._out += ["", *helpers]
        tall = bool(helpers)
        for place, lines, high in ordered:
            self._space(2 if high or tall else 1)
            self._part(place, lines, high or tall, tall)
            tall = high
        self._rest(file)
        self._out += ["", "", 'if __name__ == "__main__":']
        if deep:  # a function may call itself as often as its stack of 64 KB let it
            self._out.append(f"    sys.setrecursionlimit({DEEPEST:_})")
        self._out.append(f"    {main}()")
        return "\n".join(_tidied(self._out)) + "\n"

    def _head(self, file: str, first: Place) -> list[str]:
        """The comment that the file begins with: the docstring."""
        waiting = self._waiting.get(file, [])
        origin = self._origins[file]
        found: list[str] = []
        at = 0
        while waiting and waiting[0].alone and (first.file != file or waiting[0].line < first.line):
            one = waiting[0]
            blank = all(not origin.line(n).strip() for n in range(at + 1, one.line))
            if not blank or (found and at + 1 != one.line):
                break
            found += one.lines
            at = one.end
            waiting.pop(0)
        self._last[file] = at
        safe = [line.replace("\\", "\\\\").replace('"""', "'''") for line in found]
        if safe and safe[0][:1] == '"':
            safe[0] = " " + safe[0]
        if safe and safe[-1][-1:] == '"':
            safe[-1] += " "
        return [one.rstrip() if i < len(safe) - 1 else one for i, one in enumerate(safe)]

    def _space(self, count: int) -> None:
        """So many blank lines; none behind what has them."""
        while self._out and not self._out[-1]:
            self._out.pop()
        self._out += [""] * count

    # Lines with their comments

    def _part(self, place: Place, lines: list[Line], high: bool, after_high: bool) -> None:
        if not high and not after_high:
            self._close_up(place)
        deepest = 0
        for indent, text, at in lines:
            if text in (AWAY, BACK, BLANK):
                self._elsewhere(text, at)
                continue
            if at is not None and at.file in self._origins:
                self._comments(at, indent, deepest, bool(text))
            if text:
                self._put(indent, text, at)
            deepest = indent

    def _elsewhere(self, text: str, at: Place | None) -> None:
        """Go to where a method's body stands in the source, with its comments, and come back."""
        if text == BLANK:
            self._out.append("")
        elif at is not None and at.file in self._origins and text == AWAY:
            origin = self._origins[at.file]
            first, last = origin.around(at.line)
            own = [one for one in self._waiting[at.file] if first <= one.line <= last]
            rest = [one for one in self._waiting[at.file] if one not in own]
            self._left.append((rest, self._last.get(at.file, 0)))
            self._waiting[at.file], self._last[at.file] = own, first - 1
        elif at is not None and at.file in self._origins:
            self._waiting[at.file], self._last[at.file] = self._left.pop()

    def _close_up(self, place: Place) -> None:
        """Constants and variables that stand together in the source do so here."""
        origin = self._origins.get(place.file)
        last = self._last.get(place.file, 0)
        between = range(last + 1, place.line)
        if origin is not None and not any(origin.is_blank(one) for one in between):
            while self._out and not self._out[-1]:
                self._out.pop()

    def _comments(self, at: Place, indent: int, before: int, counts: bool) -> None:
        """What stands in the source before a line of it."""
        origin, waiting = self._origins[at.file], self._waiting[at.file]
        last = self._last.get(at.file, 0)
        while waiting and waiting[0].line < at.line:
            comment = waiting.pop(0)
            if comment.alone or comment.line > last:
                blank = any(origin.is_blank(one) for one in range(last + 1, comment.line + 1))
                self._blank(blank and last > 0, indent)
            self._alone(comment, indent)
            last = max(last, comment.end)
        if counts:
            blank = any(origin.is_blank(one) for one in range(last + 1, at.line))
            self._blank(blank and last > 0 and last < at.line, indent)
        self._last[at.file] = max(last, at.line)

    def _blank(self, wanted: bool, indent: int) -> None:
        previous = self._out[-1] if self._out else ""
        opened = (
            previous.rstrip().endswith(":") and len(previous) - len(previous.lstrip()) < indent * 4
        )
        if wanted and previous and not opened:
            self._out.append("")

    def _alone(self, comment: Comment, indent: int) -> None:
        blank = "    " * indent
        for line in comment.lines:
            self._out.append(f"{blank}# {line}".rstrip() if line else f"{blank}#")

    def _put(self, indent: int, text: str, at: Place | None) -> None:
        lines = wrapped(text, indent * 4)
        beside = self._beside(at)
        if beside and len(lines[0]) + 2 + len(beside) <= WIDTH and len(lines) == 1:
            lines[0] += f"  {beside}"
        elif beside:
            self._out.append(" " * (indent * 4) + beside)
        self._out += lines

    def _beside(self, at: Place | None) -> str:
        """The comment behind a line of the source."""
        waiting = self._waiting.get(at.file, []) if at else []
        if at is None or not waiting or waiting[0].line != at.line or waiting[0].alone:
            return ""
        found = waiting.pop(0)
        self._last[at.file] = max(self._last.get(at.file, 0), found.end)
        return f"# {' '.join(one.strip() for one in found.lines)}".rstrip()

    def _rest(self, file: str) -> None:
        """Comments behind the last function."""
        for comment in self._waiting.get(file, []):
            if comment.alone and comment.line > self._last.get(file, 0):
                self._out.append("")
                self._alone(comment, 0)


def _tidied(lines: list[str]) -> list[str]:
    """Without a third blank line."""
    found: list[str] = []
    for line in lines:
        if line or found[-2:] != ["", ""]:
            found.append(line.rstrip())
    return found
