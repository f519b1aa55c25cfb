"""What stands in a format of printf() or scanf(), and when an f-string says the same."""

from __future__ import annotations

import re
from typing import NamedTuple

from bgi.turboc.checker.types import FloatType, IntType, Type, is_text
from bgi.turboc.port.pycode import CHOICE, Code, call

_PRINTED = re.compile(
    r"%(?P<flags>[-+ #0]*)(?P<width>\*|\d*)(?P<precision>\.\d*|\.\*)?[hlLFN]*(?P<letter>.)"
)
_SCANNED = re.compile(r"%(?P<skip>\*?)\d*[hlLFN]*(?P<letter>\[\^?\]?[^\]]*\]|[a-zA-Z])")


class Printed(NamedTuple):
    """A conversion of printf()."""

    flags: str
    width: str
    precision: str
    letter: str


def scanned(format_: str) -> list[str]:
    """The letters of what scanf() stores."""
    found = _SCANNED.finditer(format_.replace("%%", ""))
    return [one["letter"][0] for one in found if not one["skip"]]


def f_string(format_: str, values: list[Code], types: list[Type]) -> str | None:
    """A format with its values as an f-string, where that is exactly the same."""
    parts: list[str] = []
    at, number = 0, 0
    for found in _PRINTED.finditer(format_):
        parts.append(_plain(format_[at : found.start()]))
        at = found.end()
        if found["letter"] == "%":
            parts.append("%")
            continue
        if number >= len(values):
            return None
        one = Printed(found["flags"], found["width"], found["precision"] or "", found["letter"])
        inside = _inside(one, values[number], types[number])
        if inside is None:
            return None
        parts.append(inside)
        number += 1
    parts.append(_plain(format_[at:]))
    text = "".join(parts)
    if number != len(values) or "\\" in text.replace("\\n", ""):
        return None
    return f'{"f" if number else ""}"{text}"' if number else f'"{_plain(format_)}"'


def _inside(one: Printed, value: Code, type_: Type) -> str | None:
    """A value in braces."""
    if "'" not in value:
        value = Code(value.replace('"', "'"), value.level)
    if '"' in value or "\\" in value or "{" in value or value.level <= CHOICE or "*" in one.width:
        return None
    align = "<" if "-" in one.flags else ""
    if set(one.flags) - {"-", "0"} or (align and "0" in one.flags):
        return None
    zero = "0" if "0" in one.flags else ""
    if one.letter in "di" and isinstance(type_, IntType) and not one.precision:
        return _braces(value, f"{align}{zero}{one.width}")
    if one.letter == "u" and isinstance(type_, IntType) and not type_.signed:
        return _braces(value, f"{align}{zero}{one.width}") if not one.precision else None
    if one.letter == "f" and isinstance(type_, FloatType) and one.precision != ".*":
        return _braces(value, f"{align}{zero}{one.width}{one.precision or '.6'}f")
    if one.letter == "s" and is_text(type_) and not one.precision and not zero:
        side = align or (">" if one.width else "")
        return _braces(value, f"{side}{one.width}")
    if one.letter == "c" and not one.width:
        return _braces(call("chr", [value]), "")
    return None


def _braces(value: Code, spec: str) -> str:
    return f"{{{value}:{spec}}}" if spec else f"{{{value}}}"


def _plain(text: str) -> str:
    written = repr(text)[1:-1] if "'" not in text else repr(text + '"')[1:-2]
    return written.replace("{", "{{").replace("}", "}}").replace("\\'", "'").replace('"', '\\"')
