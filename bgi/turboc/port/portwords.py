"""Functions of the library that Python has other words for: strings, pictures, structures."""

from __future__ import annotations

from collections.abc import Callable

import bgi
from bgi.turboc.checker.typed import (
    Address,
    Constant,
    Converted,
    LibraryCall,
    Value,
    Variable,
)
from bgi.turboc.checker.types import StructType
from bgi.turboc.port import walking
from bgi.turboc.port.portfiles import PortFiles
from bgi.turboc.port.portlibrary import MODULES
from bgi.turboc.port.pycode import Code, binary, call, quoted

_SETTINGS = """
    getviewsettings getlinesettings getfillsettings gettextsettings getarccoords getpalette
    gettime getdate gettextinfo
"""


class PortWords(PortFiles):
    """Writes them."""

    def special(self, value: LibraryCall) -> Code | None:
        """A call in other words; None if there are none."""
        write = _SPECIAL.get(value.name)
        return write(self, value) if write is not None else self.file_call(value)


_Writer = Callable[[PortWords, LibraryCall], Code]


def _fill(make: _Writer) -> _Writer:
    """A function that writes a string where its first argument says."""
    return lambda writer, value: writer.fill(value.arguments[0], make(writer, value))


def _strcat(writer: PortWords, value: LibraryCall) -> Code:
    target, source = value.arguments[:2]
    return binary("+", writer.string(target), writer.string(source))


def _itoa(writer: PortWords, value: LibraryCall) -> Code:
    number, target, radix = value.arguments
    ten = isinstance(radix, Constant) and radix.value == 10
    code = writer.value(number)
    if ten:
        return writer.fill(target, call("str", [code]))
    function = writer.names.use("bgi.stdlib", value.name)
    return writer.fill(target, call(function, [code, writer.value(radix)]))


def _gcvt(writer: PortWords, value: LibraryCall) -> Code:
    number, digits, target = value.arguments
    function = writer.names.use("bgi.stdlib", "gcvt")
    return writer.fill(target, call(function, [writer.value(number), writer.value(digits)]))


def _cut(writer: PortWords, value: Value, count: Value) -> Code:
    return Code(f"{writer.string(value).inside(17)}[:{writer.value(count)}]")


def _changed(method: str) -> _Writer:
    return _fill(lambda writer, value: Code(f"{writer.string(value.arguments[0])}{method}"))


def _compared(lower: str, count: bool) -> _Writer:
    def write(writer: PortWords, value: LibraryCall) -> Code:
        both = [
            _cut(writer, one, value.arguments[2]) if count else writer.string(one)
            for one in value.arguments[:2]
        ]
        texts = [Code(f"{one.inside(17)}{lower}") for one in both]
        return call(writer.helpers.use("compare"), texts)

    return write


def _getimage(writer: PortWords, value: LibraryCall) -> Code:
    """The picture is what getimage() returns."""
    corners = [writer.value(one) for one in value.arguments[:4]]
    code = call(writer.names.use("bgi", "getimage"), corners)
    writer.line(f"{writer.image(value.arguments[4], True)} = {code}")
    return Code("")


def _putimage(writer: PortWords, value: LibraryCall) -> Code:
    x, y, image, op = value.arguments
    codes = [writer.value(x), writer.value(y), writer.image(image), writer.value(op)]
    return call(writer.names.use("bgi", "putimage"), codes)


def _settings(writer: PortWords, value: LibraryCall) -> Code:
    """A structure that is asked for."""
    target = value.arguments[0]
    if not (isinstance(target, Address) and isinstance(target.operand.type, StructType)):
        raise writer.refuse(value.place, f"where {value.name}() answers")
    function = writer.names.use(MODULES[value.name], value.name)
    writer.line(f"{writer.target(target.operand)} = {function}()")
    return Code("")


def _exit(writer: PortWords, value: LibraryCall) -> Code:
    writer.names.modules.add("sys")
    status = writer.value(value.arguments[0]) if value.arguments else "0"
    return call("sys.exit", [] if status == "0" else [str(status)])


def _pow(writer: PortWords, value: LibraryCall) -> Code:
    base, exponent = value.arguments
    inner = exponent.operand if isinstance(exponent, Converted) else exponent
    if isinstance(inner, Constant) and float(inner.value).is_integer() and 0 < inner.value < 20:
        return Code(f"{writer.value(base).inside(16)} ** {int(inner.value)}", 15)
    return call(writer.names.use("math", "pow"), [writer.value(base), writer.value(exponent)])


def _printf(writer: PortWords, value: LibraryCall) -> Code:
    module = "bgi.conio" if value.name == "cprintf" else "bgi.stdio"
    format_, *rest = value.arguments

    def one(place: int, argument: Value) -> Code:
        return writer.printed(argument)

    codes = writer.ordered((format_, *rest), one)
    return call(writer.names.use(module, value.name), codes)


def _abs(writer: PortWords, value: LibraryCall) -> Code:
    return call("abs", [writer.value(value.arguments[0])])


def _length(writer: PortWords, value: LibraryCall) -> Code:
    return call("len", [writer.string(value.arguments[0])])


def _letter(text: str) -> _Writer:
    """A function of ctype.h, with `@` for the letter."""
    return lambda writer, value: Code(text.replace("@", f"chr({writer.value(value.arguments[0])})"))


def _system(writer: PortWords, value: LibraryCall) -> Code:
    """What a program asked the shell for that has a function of its own."""
    word = (walking.literal(value.arguments[0]) or b"").strip().lower()
    if word == b"cls":
        return call(writer.names.use("bgi.conio", "clrscr"), [])
    if word == b"pause":
        message = quoted("Press any key to continue . . . ")
        writer.line(call(writer.names.use("bgi.stdio", "printf"), [message]))
        return call(writer.names.use("bgi", "getch"), [])
    raise writer.refuse(value.place, "system(): it would start another program")


def _register(writer: PortWords, value: LibraryCall) -> Code:
    """A driver or a font that was linked into the program."""
    linked = value.arguments[0]
    while isinstance(linked, Converted):
        linked = linked.operand
    if not isinstance(linked, Variable) or linked.symbol.name not in bgi.__all__:
        raise writer.refuse(value.place, f"what {value.name}() is given")
    name = writer.names.use("bgi", linked.symbol.name)
    return call(writer.names.use("bgi", value.name), [name])


def _round(writer: PortWords, value: LibraryCall) -> Code:
    return call(writer.helpers.use("rounded"), [writer.value(value.arguments[0])])


_SPECIAL: dict[str, _Writer] = {
    "strcpy": _fill(lambda writer, value: writer.string(value.arguments[1])),
    "strncpy": _fill(lambda writer, value: _cut(writer, *value.arguments[1:3])),
    "strcat": _fill(_strcat),
    "sprintf": _fill(lambda writer, value: writer.formatted(value.arguments[1:])),
    "gets": _fill(lambda writer, value: Code(f"{writer.names.use('bgi.stdio', 'gets')}()")),
    "strupr": _changed(".upper()"),
    "strlwr": _changed(".lower()"),
    "strrev": _changed("[::-1]"),
    **dict.fromkeys(("itoa", "ltoa"), _itoa),
    **dict.fromkeys(("strcmp", "_fstrcmp"), _compared("", False)),
    **dict.fromkeys(("stricmp", "strcmpi"), _compared(".lower()", False)),
    "strncmp": _compared("", True),
    "strnicmp": _compared(".lower()", True),
    **dict.fromkeys(_SETTINGS.split(), _settings),
    **{"gcvt": _gcvt, "getimage": _getimage, "putimage": _putimage, "exit": _exit, "pow": _pow},
    **{"_exit": _exit, "strlen": _length, "system": _system},
    **dict.fromkeys(("abs", "labs", "fabs"), _abs),
    **dict.fromkeys(("printf", "cprintf"), _printf),
    **dict.fromkeys(("registerbgidriver", "registerfarbgidriver"), _register),
    **{"registerbgifont": _register, "registerfarbgifont": _register, "round": _round},
    "toupper": _letter("ord(@.upper())"),
    "tolower": _letter("ord(@.lower())"),
    **{f"is{one}": _letter(f"@.is{one}()") for one in ("digit", "alpha", "alnum", "space")},
    **{"isupper": _letter("@.isupper()"), "islower": _letter("@.islower()")},
}
