"""The preprocessor: `#include`, `#define`, `#if` and their like; what is left has no directives."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import NamedTuple

from bgi.turboc.faults import MOST_ERRORS, CError, Place
from bgi.turboc.words.conditions import evaluate
from bgi.turboc.words.lexer import Token, objection, tokens

MOST_TOKENS = 500_000
"""Words of a program, and of its macros as they are expanded."""

DEEPEST = 20
"""Files that include each other."""

DEEPEST_IF = 100
"""Parts under `#if` inside each other."""


@dataclass(frozen=True)
class Macro:
    """What `#define` says: `parameters` is None for a macro that is not called."""

    body: tuple[Token, ...]
    parameters: tuple[str, ...] | None = None


class Definition(NamedTuple):
    """One `#define`: where the name stands in it."""

    name: str
    macro: Macro
    place: Place


class Preprocessed(NamedTuple):
    """A program without directives, and the headers of ours that it includes."""

    tokens: list[Token]
    headers: frozenset[str]
    errors: list[CError]
    defined: list[Definition]


Loader = Callable[[str], str | None]
"""The text of a file beside the program, None if there is none."""


def preprocess(
    text: str, file: str, headers: Mapping[str, str], load: Loader, defined: Mapping[str, str]
) -> Preprocessed:
    """Follow the directives of a program.

    Args:
        text: the program.
        file: what it is called.
        headers: the headers that there are, in lower case, and the text in each.
        load: finds files that are included.
        defined: macros that are defined from the beginning.
    """
    found = _Preprocessor(headers, load)
    for name, value in defined.items():
        words = tuple(word for word in tokens(value, "") if word.kind != "end")
        found.macros[name] = Macro(words)
    found.read(text, file, 0)
    end = Token("end", "", Place(file, text.count("\n") + 1), first=True)
    included = frozenset(found.included)
    return Preprocessed([*found.output, end], included, found.errors, found.defined)


class _Preprocessor:
    def __init__(self, headers: Mapping[str, str], load: Loader) -> None:
        self._headers, self._load = headers, load
        self.macros: dict[str, Macro] = {}
        self.included: set[str] = set()
        self.defined: list[Definition] = []
        self.output: list[Token] = []
        self.errors: list[CError] = []
        self._depth = self._steps = 0

    def read(self, text: str, file: str, depth: int) -> None:
        """Follow the directives of one file; its words go to the output."""
        self._depth = depth
        words = list(islice(tokens(text, file), MOST_TOKENS))[:-1]
        if len(words) == MOST_TOKENS - 1:
            self.errors.append(CError(words[-1].place, "this file is too long"))
            return
        # For each #if that is open: whether its part is read, and whether one of its parts was.
        self._parts: list[list[bool]] = []
        position = 0
        while position < len(words) and self._goes_on():
            end = position + 1
            if words[position].text == "#" and words[position].first:
                while end < len(words) and not words[end].first:
                    end += 1
                self._follow(words[position], words[position + 1 : end])
            else:
                while end < len(words) and not (words[end].text == "#" and words[end].first):
                    end += 1
                if self._reading():
                    self._emit(words[position:end])
            position = end

    def _goes_on(self) -> bool:
        return self._steps <= MOST_TOKENS and len(self.errors) < MOST_ERRORS

    def _reading(self) -> bool:
        return all(read for read, _ in self._parts)

    def _emit(self, words: list[Token]) -> None:
        try:
            expanded = list(self.expand(words))
            for word in expanded:
                if word.kind == "wrong":
                    raise objection(word)
            self.output += expanded
        except CError as error:
            self.errors.append(error)

    # Directives

    def _follow(self, sign: Token, words: list[Token]) -> None:
        if not words:
            return
        name, rest = words[0].text, words[1:]
        try:
            if name in ("if", "ifdef", "ifndef", "elif", "else", "endif"):
                self._condition(name, words[0].place, rest)
            elif self._reading():
                if name not in _DIRECTIVES:
                    raise CError(words[0].place, f"there is no directive #{name}")
                _DIRECTIVES[name](self, words[0].place, rest)
        except CError as error:
            self.errors.append(error)

    def _condition(self, name: str, place: Place, rest: list[Token]) -> None:
        if name in ("if", "ifdef", "ifndef"):
            if len(self._parts) >= DEEPEST_IF:
                raise CError(place, f"more than {DEEPEST_IF} #if are open here")
            holds = self._reading() and self._holds(name, place, rest)
            self._parts.append([holds, holds or not self._reading()])
        elif not self._parts:
            raise CError(place, f"#{name} without an #if")
        elif name == "endif":
            self._parts.pop()
        else:
            part = self._parts[-1]
            part[0] = not part[1] and (name == "else" or self._holds("if", place, rest))
            part[1] = part[1] or part[0]

    def _holds(self, name: str, place: Place, rest: list[Token]) -> bool:
        if not rest:
            raise CError(place, f"#{name} of what?")
        if name != "if":
            return (rest[0].text in self.macros) == (name == "ifdef")
        return bool(evaluate(list(self.expand(_defined(rest, self.macros))), place))

    def _include(self, place: Place, rest: list[Token]) -> None:
        words = rest if rest and rest[0].kind == "string" else list(self.expand(rest))
        text = "".join(word.text for word in words)
        local = text[:1] == '"'
        name = text[1:-1].replace("\\", "/").rpartition("/")[2]
        header = name.lower()
        beside = self._load(name) if local or header not in self._headers else None
        if beside is not None:
            if self._depth >= DEEPEST:
                raise CError(place, f"{name} is included too deeply: does it include itself?")
            self._read_inside(beside, name)
        elif header in self._headers:
            if header not in self.included and self._headers[header]:
                self._read_inside(self._headers[header], header)
            self.included.add(header)
        else:
            raise CError(place, f"there is no file {name or text}")

    def _read_inside(self, text: str, name: str) -> None:
        """Read another file in the middle of this one."""
        parts, depth = self._parts, self._depth
        self.read(text, name, depth + 1)
        self._parts, self._depth = parts, depth

    def _define(self, place: Place, rest: list[Token]) -> None:
        if not rest or rest[0].kind != "name":
            raise CError(place, "#define needs a name")
        name, body = rest[0].text, rest[1:]
        parameters = None
        if body and body[0].text == "(" and not body[0].spaced:
            close = next((i for i, word in enumerate(body) if word.text == ")"), 0)
            if not close:
                raise CError(place, f"the parameters of {name} do not end")
            parameters = tuple(word.text for word in body[1:close] if word.text != ",")
            body = body[close + 1 :]
        self.macros[name] = Macro(tuple(body), parameters)
        self.defined.append(Definition(name, self.macros[name], rest[0].place))

    def _undefine(self, place: Place, rest: list[Token]) -> None:
        if rest:
            self.macros.pop(rest[0].text, None)

    def _stop(self, place: Place, rest: list[Token]) -> None:
        raise CError(place, "#error " + " ".join(word.text for word in rest))

    def _ignore(self, place: Place, rest: list[Token]) -> None:
        """#pragma and #line say nothing to us."""

    # Macros

    def expand(self, words: Iterable[Token], busy: frozenset[str] = frozenset()) -> Iterator[Token]:
        """The words with their macros replaced; those in `busy` are being replaced already."""
        rest = list(words)
        position = 0
        while position < len(rest):
            word = rest[position]
            position += 1
            self._steps += 1
            if self._steps > MOST_TOKENS:
                raise CError(word.place, "the macros make too much of this program")
            macro = self.macros.get(word.text) if word.kind == "name" else None
            if word.text in ("__LINE__", "__FILE__") and word.kind == "name":
                yield _known(word)
            elif macro is None or word.text in busy:
                yield word
            elif macro.parameters is None:
                yield from self.expand(_placed(macro.body, word), busy | {word.text})
            elif position < len(rest) and rest[position].text == "(":
                given, position = _arguments(rest, position, word)
                body = self._filled(macro, given, word, busy)
                yield from self.expand(_placed(body, word), busy | {word.text})
            else:
                yield word

    def _filled(
        self, macro: Macro, given: list[list[Token]], word: Token, busy: frozenset[str]
    ) -> list[Token]:
        """The body of a macro with its arguments in place of its parameters."""
        parameters = macro.parameters or ()
        if len(given) != len(parameters) and not (len(given) == 1 and not given[0]):
            count = f"{len(parameters)} arguments, not {len(given)}"
            raise CError(word.place, f"the macro {word.text} takes {count}")
        by_name = dict(zip(parameters, given, strict=False))
        filled: list[Token] = []
        body = list(macro.body)
        for place, part in enumerate(body):
            before = body[place - 1].text if place else ""
            after = body[place + 1].text if place + 1 < len(body) else ""
            if part.text == "#" and after in by_name:
                continue
            argument = by_name.get(part.text) if part.kind == "name" else None
            if argument is None:
                filled.append(part)
            elif before == "#":
                filled.append(_as_string(argument, part))
            elif "##" in (before, after):
                filled += argument
            else:
                filled += self.expand(argument, busy)
        return _pasted(filled)


_DIRECTIVES: dict[str, Callable[[_Preprocessor, Place, list[Token]], None]] = {
    "include": _Preprocessor._include,
    "define": _Preprocessor._define,
    "undef": _Preprocessor._undefine,
    "error": _Preprocessor._stop,
    "pragma": _Preprocessor._ignore,
    "line": _Preprocessor._ignore,
}


def _defined(words: list[Token], macros: Mapping[str, Macro]) -> list[Token]:
    """A condition with `defined X` answered."""
    answered: list[Token] = []
    rest = iter(words)
    for word in rest:
        if word.text != "defined":
            answered.append(word)
            continue
        name = next(rest, word)
        if name.text == "(":
            name = next(rest, word)
            next(rest, word)
        answered.append(word._replace(kind="number", text=str(int(name.text in macros))))
    return answered


def _arguments(words: list[Token], position: int, macro: Token) -> tuple[list[list[Token]], int]:
    """The arguments of a macro, whose bracket opens at a position, and where they end."""
    given: list[list[Token]] = [[]]
    depth = 0
    for place in range(position, len(words)):
        word = words[place]
        depth += (word.text == "(") - (word.text == ")")
        if depth == 0:
            return given, place + 1
        if word.text == "," and depth == 1:
            given.append([])
        elif place > position:
            given[-1].append(word)
    raise CError(macro.place, f"the arguments of the macro {macro.text} do not end")


def _placed(words: Iterable[Token], where: Token) -> list[Token]:
    """Words that stand where a macro was called."""
    return [word._replace(place=where.place, first=False) for word in words]


def _known(word: Token) -> Token:
    if word.text == "__LINE__":
        return word._replace(kind="number", text=str(word.place.line))
    return word._replace(kind="string", text=f'"{word.place.file}"')


def _as_string(words: list[Token], where: Token) -> Token:
    text = "".join(" " * (word.spaced and i > 0) + word.text for i, word in enumerate(words))
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return where._replace(kind="string", text=f'"{escaped}"')


def _pasted(words: list[Token]) -> list[Token]:
    """The words with those around a `##` made one."""
    if all(word.text != "##" for word in words):
        return words
    made: list[Token] = []
    rest = iter(words)
    for word in rest:
        if word.text == "##" and made:
            after = next(rest, word)
            joined = made.pop().text + after.text
            made.append(next(tokens(joined, word.place.file))._replace(place=word.place))
        else:
            made.append(word)
    return made
