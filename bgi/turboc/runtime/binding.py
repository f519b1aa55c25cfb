"""From C's declarations to Python functions that convert, and leave their line in the trace."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from bgi.turboc.runtime.memory import Pointer, text
from bgi.turboc.runtime.trace import Trace

Function = Callable[..., Any]

_DECLARATION = re.compile(r"(?P<result>.*?[ *])(?P<name>\w+)\((?P<parameters>.*)\)$")


def declarations(block: str) -> dict[str, str]:
    """Functions by name: how each is declared, with `@` for its name."""
    found: dict[str, str] = {}
    for line in block.replace("\n", " ").split(";"):
        if match := _DECLARATION.match(line.strip()):
            found[match["name"]] = f"{match['result']}@({match['parameters']})"
    return found


def characters(value: Any) -> bytes:
    """The bytes of a string, however it comes."""
    if isinstance(value, Pointer):
        return text(value)
    return b"(null)" if value is None else bytes(value)


def string(data: bytes | str) -> Pointer:
    """A string as a program of C has it."""
    codes = data.encode("cp437", "replace") if isinstance(data, str) else data
    return Pointer(bytearray(codes + b"\0"))


def bound(name: str, declaration: str, function: Function, trace: Trace | None) -> Function:
    """A function that takes what C gives it, and leaves a line in the trace if there is one."""
    result, _, parameters = declaration.partition("@")
    texts = [i for i, one in enumerate(parameters.split(",")) if one.strip("( )")[:4] == "text"]
    answers = result.strip() != "void"

    def plain(*given: Any) -> Any:
        values = list(given)
        for place in texts:
            values[place] = characters(values[place])
        return function(*values)

    def traced(*given: Any) -> Any:
        assert trace is not None
        values = list(given)
        for place in texts:
            values[place] = characters(values[place])
        answer = function(*values)
        trace.call(name, tuple(values), *((answer,) if answers else ()))
        return answer

    if trace is not None:
        return traced
    return plain if texts else function
