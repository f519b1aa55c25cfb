"""Names in the Python program: what is imported, constants and macros by their own names."""

from __future__ import annotations

import builtins
import re
from collections.abc import Iterable

import bgi
from bgi import conio
from bgi.turboc.checker.scopes import Namer
from bgi.turboc.checker.typed import Constant, LibraryCall, Quoted, Value, Variable
from bgi.turboc.checker.types import Symbol
from bgi.turboc.faults import Place
from bgi.turboc.port import walking
from bgi.turboc.port.origin import Origin
from bgi.turboc.port.pycode import Code, plain, quoted
from bgi.turboc.understanding import Understood
from bgi.turboc.words.preprocess import Definition

_NUMBER = re.compile(r"[\d.][\w.]*|'(?:\\.|[^'])+'")
_SUMS = re.compile(r"(?:[A-Za-z_]\w*|\d+|[-+*()])+")
_MATH = {"M_PI": "pi", "M_E": "e"}

_OURS = {
    "BytesIO",
    "StringIO",
    "sys",
    "copy",
    "deepcopy",
    "fmod",
    "time",
    "sprintf",
    "pow",
    "sleep",
}
"""Names that a port may need where the program does not name them."""

MOST_NAMES = 12
"""Names that one line imports; of more, all are."""

ORDER = ("bgi", "bgi.conio", "bgi.dos", "bgi.mouse", "bgi.stdio", "bgi.stdlib")


class Names:
    """All names of one program."""

    def __init__(self, program: Understood) -> None:
        self.origins = {file: Origin(lines) for file, lines in program.sources.items()}
        self._library = program.headers
        self.imported: dict[str, set[str]] = {}
        self.modules: set[str] = set()
        """Those that are imported whole."""
        self.constants: dict[str, tuple[Place, str]] = {}
        """Constants of the module: where they were defined, and their values."""
        self._macros = _macros(program.defined)
        self._values: dict[str, object] = {}
        self.library = self.library_names([*walking.of_program(program.typed)])
        """The names of the library that the program uses."""
        self.library -= _OURS
        self.namer = Namer([*dir(builtins), *self.library, *_OURS])
        for name in self._macros:
            self.namer.taken.add(name)

    def library_names(self, thing: object) -> set[str]:
        """The names of the library that something uses."""
        found: set[str] = set()
        for value in walking.values(thing):
            if isinstance(value, LibraryCall):
                found.add(value.name)
            elif isinstance(value, Constant) and isinstance(value.written, Variable):
                found.add(value.written.symbol.name)
        return found

    def use(self, module: str, name: str) -> Code:
        """A name of a module, which then is imported."""
        self.imported.setdefault(module, set()).add(name)
        return Code(name)

    def word(self, place: Place) -> str:
        """The word of the source at a place."""
        origin = self.origins.get(place.file)
        return origin.word(place) if origin else ""

    def imports(self) -> list[str]:
        """The lines that import."""
        lines = [f"import {one}" for one in sorted(self.modules)]
        own = [one for one in self.imported if not one.startswith("bgi")]
        for module in sorted(own):
            lines.append(f"from {module} import {', '.join(sorted(self.imported[module]))}")
        if lines:
            lines.append("")
        for module in sorted(set(self.imported) - set(own), key=ORDER.index):
            names = sorted(self.imported[module], key=lambda one: (one.islower(), one))
            every = module == "bgi" and len(names) > MOST_NAMES
            lines.append(f"from {module} import {'*' if every else ', '.join(names)}")
        return lines

    def known_count(self, word: str, count: int) -> Code | None:
        """A constant with a name that says how long an array is."""
        macro = self._macros.get(word)
        if macro is not None and self._values.get(word) == count:
            return Code(plain(word))
        if (
            macro is not None
            and word not in self._values
            and macro.macro.body[0].text == str(count)
        ):
            self._values[word] = count
            return self._defined(plain(word), macro.place, str(count))
        return Code(word) if self.constants.get(word, (None, ""))[1] == str(count) else None

    # Constants by name

    def named(self, value: Value) -> Code | None:
        """The name of a constant or macro, if that is what stands in the source."""
        if isinstance(value, (Constant, Quoted)):
            macro = self._macro(value)
            if macro is not None:
                return macro
        if isinstance(value, Constant) and isinstance(value.written, Variable):
            return self._constant(value, value.written.symbol)
        return None

    def _constant(self, value: Constant, symbol: Symbol) -> Code | None:
        if value.value != symbol.value:
            return None
        if self._library.symbol(symbol.name) is symbol:
            if symbol.name in bgi.__all__:
                return self.use("bgi", symbol.name)
            if symbol.name in conio.__all__:
                return self.use("bgi.conio", symbol.name)
            return self.use("math", _MATH[symbol.name]) if symbol.name in _MATH else None
        return self._defined(plain(symbol.name), symbol.place, repr(symbol.value))

    def _defined(self, name: str, place: Place, text: str) -> Code | None:
        """A constant of the module; None if there is another one of that name."""
        if self.constants.setdefault(name, (place, text)) != (place, text):
            return None
        self.namer.taken.add(name)
        return Code(name)

    def _macro(self, value: Constant | Quoted) -> Code | None:
        name = self.word(value.place)
        macro = self._macros.get(name)
        if macro is None or any(one.place != value.place for one in walking.whole(value)):
            return None
        known = value.value if isinstance(value, Constant) else value.data
        if self._values.setdefault(name, known) != known:
            return None
        python = plain(name)
        text = self.constants[python][1] if python in self.constants else self._body(macro, value)
        return self._defined(python, macro.place, text)

    def _body(self, macro: Definition, value: Constant | Quoted) -> str:
        """What a macro stands for, in Python."""
        if isinstance(value, Quoted):
            return quoted(value.data.decode("cp437"))
        words = macro.macro.body
        text = "".join(
            f" {one.text} " if one.text in "+-*" and i else one.text for i, one in enumerate(words)
        )
        while text.startswith("(") and text.endswith(")") and text.count("(") == 1:
            text = text[1:-1].strip()
        if len(words) == 1 and words[0].kind == "character":
            return f"ord({quoted(chr(int(value.value) & 0xFF))})"
        number = value.value
        if isinstance(number, float) and number.is_integer() and "." not in text:
            number = int(number)
        if not isinstance(number, int) or not _SUMS.fullmatch(text.replace(" ", "")):
            return text if text.lower().startswith("0x") else repr(number)
        found: dict[str, int] = {}
        for word in words:
            if word.kind == "name" and self._known_name(word.text, found) is None:
                return repr(number)
        try:
            same = eval(text, {"__builtins__": {}}, found) == number
        except (SyntaxError, TypeError):
            same = False
        return text if same else repr(number)

    def _known_name(self, name: str, found: dict[str, int]) -> int | None:
        """The value of a name in a macro: a library's constant, or another macro that is used."""
        symbol = self._library.symbol(name)
        if symbol is not None and symbol.kind == "constant" and name in bgi.__all__:
            self.use("bgi", name)
            found[name] = int(symbol.value)
        elif name in self._macros:
            number = self._number(name)
            if number is not None:
                found[name] = number
        return found.get(name)

    def _number(self, name: str) -> int | None:
        """The value of another macro, which then is defined, too."""
        macro = self._macros[name]
        if name not in self._values:
            word = macro.macro.body[0]
            if len(macro.macro.body) != 1 or word.kind != "number" or not word.text.isdecimal():
                return None
            self._values[name] = int(word.text)
            self._defined(plain(name), macro.place, word.text)
        known = self._values[name]
        return known if isinstance(known, int) and plain(name) in self.constants else None


def _macros(defined: Iterable[Definition]) -> dict[str, Definition]:
    """The macros without parameters that are defined once."""
    found: dict[str, Definition] = {}
    twice: set[str] = set()
    for one in defined:
        if one.name in found and found[one.name].macro.body != one.macro.body:
            twice.add(one.name)
        found.setdefault(one.name, one)
    return {
        name: one
        for name, one in found.items()
        if one.macro.parameters is None and one.macro.body and name not in twice
    }
