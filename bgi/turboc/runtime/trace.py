"""What a program does, call by call, as text: one line for each call of the library."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

MOST_LINES = 20_000
MOST_BYTES = 1_000_000

FULL = 256
"""Bytes of output that make a line of their own."""

_ESCAPES = {ord('"'): '\\"', ord("\\"): "\\\\", 10: "\\n", 13: "\\r", 9: "\\t"}
_QUOTED = [_ESCAPES.get(c, chr(c) if 32 <= c <= 126 else f"\\x{c:02x}") for c in range(256)]


def quoted(data: bytes) -> str:
    """A string as C writes it."""
    return f'"{"".join([_QUOTED[code] for code in data])}"'


def low(number: int) -> int:
    """The low 16 bits of a number, with their sign."""
    return (int(number) & 0xFFFF ^ 0x8000) - 0x8000


def shown(value: Any) -> str:
    """An argument or an answer."""
    if isinstance(value, (bytes, bytearray)):
        return quoted(bytes(value))
    return "null" if value is None else str(low(value))


class Trace:
    """Lines that are kept until the program ends.

    `stop` is called with the reason once there are too many: it must not return.
    """

    def __init__(self, stop: Callable[[str], None]) -> None:
        self.lines: list[str] = []
        self._bytes = 0
        self._printed = bytearray()
        self._stop = stop
        self._ended = False

    def call(self, name: str, given: tuple[object, ...] = (), answer: object = ...) -> None:
        """A call with its arguments; the answer is a value, or a tuple of several."""
        parts = [name, *map(shown, given)]
        if answer is not ...:
            answers = answer if isinstance(answer, tuple) else (answer,)
            parts += ["->", *map(shown, answers)]
        self._flush()
        self._add(" ".join(parts))

    def read(self, data: bytes) -> None:
        """Input that was taken."""
        self._flush()
        self._add(f"read {quoted(data)}")

    def print(self, data: bytes) -> None:
        """Output; it runs together until something else happens."""
        self._printed += data
        while len(self._printed) >= FULL:
            first = bytes(self._printed[:FULL])
            del self._printed[:FULL]
            self._add(f"print {quoted(first)}")

    def _flush(self) -> None:
        if self._printed:
            text = quoted(bytes(self._printed))
            self._printed.clear()
            self._add(f"print {text}")

    def _add(self, line: str) -> None:
        if len(self.lines) >= MOST_LINES:
            self._stop("lines")
        if self._bytes + len(line) + 1 > MOST_BYTES:
            self._stop("bytes")
        self.lines.append(line)
        self._bytes += len(line) + 1

    def end(self, reason: str) -> str:
        """The whole text, once the program has ended."""
        if not self._ended:
            self._ended = True
            if self._printed:
                self.lines.append(f"print {quoted(bytes(self._printed))}")
            self.lines.append(f"end {reason}")
        return "\n".join(self.lines) + "\n"
