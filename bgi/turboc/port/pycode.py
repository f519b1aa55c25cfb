"""Python expressions as text that knows how tightly it binds, and lines that are not too long."""

from __future__ import annotations

import io
import keyword
import re
import tokenize

WIDTH = 99
"""Characters in a line."""

ATOM, UNARY, TIMES, PLUS, SHIFT, BAND, BXOR, BOR = 17, 14, 13, 12, 11, 10, 9, 8
COMPARE, NOT, AND, OR, CHOICE, WALRUS = 7, 6, 5, 4, 3, 1
"""How tightly Python's operators bind, from the tightest to the loosest."""

_STRING = re.compile(r'(f?)"((?:[^"\\]|\\.)*)"')

_LEVELS = {
    **dict.fromkeys(("*", "/", "//", "%"), TIMES),
    **dict.fromkeys(("+", "-"), PLUS),
    **dict.fromkeys(("<<", ">>"), SHIFT),
    **{"&": BAND, "^": BXOR, "|": BOR},
    **dict.fromkeys(("<", ">", "<=", ">=", "==", "!=", "is", "is not", "in"), COMPARE),
    **{"and": AND, "or": OR},
}


class Code(str):
    """An expression in Python."""

    level: int

    def __new__(cls, text: str, level: int = ATOM) -> Code:
        made = super().__new__(cls, text)
        made.level = level
        return made

    def inside(self, level: int) -> str:
        """It as a part of an expression that binds so tightly."""
        return f"({self})" if self.level < level else str(self)


def binary(op: str, left: Code, right: Code) -> Code:
    """Two expressions with an operator between them; those of one level group from the left."""
    level = _LEVELS[op]
    before = level + 1 if level == COMPARE else level
    after = level if level in (AND, OR) else level + 1
    return Code(f"{left.inside(before)} {op} {right.inside(after)}", level)


def negated(code: Code) -> Code:
    """`not` before an expression."""
    return Code(f"not {code.inside(NOT)}", NOT)


def signed(op: str, code: Code) -> Code:
    """A sign before an expression."""
    return Code(f"{op}{code.inside(UNARY)}", UNARY)


def choice(yes: Code, condition: Code, no: Code) -> Code:
    """`yes if condition else no`."""
    parts = yes.inside(CHOICE + 1), condition.inside(CHOICE + 1), no.inside(CHOICE)
    return Code("{} if {} else {}".format(*parts), CHOICE)


def call(function: str, arguments: list[Code] | list[str]) -> Code:
    """A call."""
    return Code(f"{function}({', '.join(arguments)})")


def plain(name: str) -> str:
    """A name of C as Python takes it: no keyword."""
    return f"{name}_" if keyword.iskeyword(name) else name


def quoted(text: str) -> Code:
    """A string as the house writes it: in double quotes, unless there are some in it."""
    written = repr(text)
    if written[0] == "'" and '"' not in text:
        inner = written[1:-1].replace("\\'", "'")
        written = f'"{inner}"'
    return Code(written)


def wrapped(text: str, indent: int) -> list[str]:
    """A line of Python as several if it is too long: broken in its brackets.

    Args:
        text: the line, without what it is indented by.
        indent: how deep it stands, in blanks.
    """
    blank = " " * indent
    if indent + len(text) <= WIDTH or "\n" in text:
        return [blank + text]
    if text.startswith("from "):
        head, _, names = text.partition(" import ")
        lines = _filled([f"{one}," for one in names.split(", ")], 4)
        return [f"{head} import (", *lines, ")"]
    conditions = _at_operator(text, indent)
    if conditions:
        return conditions
    for start, end, commas in _brackets(text):
        head, inside, tail = text[: start + 1], text[start + 1 : end], text[end:]
        if not inside or indent + max(len(head), len(tail)) > WIDTH:
            continue
        parts = [text[a:b].strip() for a, b in _between(commas, start + 1, end)]
        lines = _filled(parts, indent + 4)
        if all(len(one) <= WIDTH for one in lines):
            return [blank + head, *lines, blank + tail]
    return _text_apart(text, indent)


def _text_apart(text: str, indent: int) -> list[str]:
    """An assignment of a long string, which becomes several beside each other."""
    name, equals, string = text.partition(" = ")
    found = _STRING.fullmatch(string)
    blank = " " * indent
    if not equals or found is None:
        return [blank + text]
    room = WIDTH - indent - 4 - len(found[1]) - 2
    lines, rest = [], found[2]
    while len(rest) > room:
        cuts = [at for at in range(room) if rest[at] == " " and _outside(rest[: at + 1])]
        if not cuts:
            return [blank + text]
        lines.append(rest[: cuts[-1] + 1])
        rest = rest[cuts[-1] + 1 :]
    inside = [f'{blank}    {found[1]}"{one}"' for one in [*lines, rest]]
    return [f"{blank}{name} = (", *inside, f"{blank})"]


def _outside(text: str) -> bool:
    """Whether the end of a part of an f-string is in no braces."""
    plain_ = text.replace("{{", "").replace("}}", "")
    return plain_.count("{") == plain_.count("}")


def _brackets(text: str) -> list[tuple[int, int, list[int]]]:
    """The outermost brackets that hold something: where, and their commas; the longest first."""
    found: list[tuple[int, int, list[int]]] = []
    stack: list[tuple[int, list[int]]] = []
    try:
        words = list(tokenize.generate_tokens(io.StringIO(text).readline))
    except (tokenize.TokenError, IndentationError):
        words = []
    for word in words:
        at = word.start[1]
        if word.type != tokenize.OP:
            continue
        if word.string in "([{":
            stack.append((at, []))
        elif word.string in ")]}" and stack:
            start, commas = stack.pop()
            found.append((start, at, commas))
        elif word.string == "," and stack:
            stack[-1][1].append(at)
    return sorted(found, key=lambda one: one[0] - one[1])


def _between(commas: list[int], start: int, end: int) -> list[tuple[int, int]]:
    """The parts between commas, each with its comma."""
    stops = [*(one + 1 for one in commas), end]
    return [(a, b) for a, b in zip([start, *stops[:-1]], stops, strict=True) if a < b]


def _filled(parts: list[str], indent: int) -> list[str]:
    """Parts in as few lines as hold them; rows of a table one to a line."""
    rows = len(parts) > 1 and all(one[0] in "([{" for one in parts if one)
    lines: list[str] = []
    for part in parts:
        if lines and not rows and len(lines[-1]) + 1 + len(part) <= WIDTH:
            lines[-1] += f" {part}"
        else:
            lines += wrapped(part, indent)
    return lines


def _at_operator(text: str, indent: int) -> list[str]:
    """A long condition in brackets, with a line for each part of it; nothing if it has no parts."""
    for word in ("if ", "elif ", "while ", "return "):
        if not text.startswith(word):
            continue
        inner = text[len(word) :].rstrip(":")
        for op in (" or ", " and "):
            parts = _apart(inner, op)
            if len(parts) > 1:
                lines = [parts[0], *(f"{op.strip()} {one}" for one in parts[1:])]
                inside = [line for one in lines for line in wrapped(one, indent + 4)]
                colon = ":" * text.endswith(":")
                blank = " " * indent
                return [f"{blank}{word}(", *inside, f"{blank}){colon}"]
    return []


def _apart(text: str, op: str) -> list[str]:
    """The parts between an operator that stands in no brackets and no string."""
    parts, depth, quote, start = [], 0, "", 0
    for at, sign in enumerate(text):
        if quote:
            quote = "" if sign == quote and text[at - 1] != "\\" else quote
        elif sign in "\"'":
            quote = sign
        else:
            depth += (sign in "([{") - (sign in ")]}")
            if depth == 0 and text.startswith(op, at):
                parts.append(text[start:at])
                start = at + len(op)
    return [*parts, text[start:]]
