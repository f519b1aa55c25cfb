"""From text to words: names, numbers, characters, strings and operators, each with its place."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from bgi.turboc.faults import CError, Place


class Token(NamedTuple):
    """A word; `first` if it begins a line, `spaced` if there is white space before it."""

    kind: str
    """`name number character string operator`, `wrong` for what is none of them, `end` at last."""
    text: str
    place: Place
    first: bool = False
    spaced: bool = False


SPLICE = "\x00"
"""Stands for a backslash at the end of a line, which joins it to the next."""

_TOKEN = re.compile(
    r"""
      (?P<newline>\n) | (?P<splice>\x00) | (?P<white>[ \t\v\f]+)
    | (?P<comment>/\*.*?\*/ | //[^\n]*)
    | (?P<string>"(?:\\.|[^"\\\n])*") | (?P<character>'(?:\\.|[^'\\\n])+')
    | (?P<number>0[xX][0-9a-fA-F]+[uUlL]* | (?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUlLfF]*)
    | (?P<name>[A-Za-z_][A-Za-z_0-9]*)
    | (?P<operator>(?!/\*)(?:\.\.\.|<<=|>>=|->\*|->|::|\+\+|--|&&|\|\||[-+*/%&|^<>=!]=|<<|>>|\#\#
        |[-+*/%&|^~!<>=?:;,.()\[\]{}\#]))
    | (?P<wrong>/\*.*|.)
    """,
    re.VERBOSE | re.DOTALL,
)


def tokens(text: str, file: str) -> Iterator[Token]:
    """The words of a text, without comments."""
    text = text.replace("\\\n", SPLICE)
    line, start, position = 1, 0, 0
    first, spaced = True, False
    while position < len(text):
        found = _TOKEN.match(text, position)
        place = Place(file, line, position - start + 1)
        assert found is not None
        kind, word, position = found.lastgroup or "", found[0], found.end()
        if kind in ("newline", "splice", "comment", "white"):
            lines = word.count("\n") + word.count(SPLICE)
            if lines:
                line += lines
                start = found.start() + max(word.rfind("\n"), word.rfind(SPLICE)) + 1
            first = first or kind == "newline"
            spaced = True
            continue
        yield Token(kind, word.replace(SPLICE, ""), place, first, spaced)
        line += word.count(SPLICE) + word.count("\n")
        first = spaced = False
    yield Token("end", "", Place(file, line, 1), first=True)


def objection(word: Token) -> CError:
    """What there is to say of a word that is wrong."""
    if word.text[:2] == "/*":
        return CError(word.place, "this comment never ends")
    if word.text in "\"'":
        return CError(word.place, f"there is no second {word.text} in this line")
    return CError(word.place, f"nothing in C begins with {word.text!r}")
