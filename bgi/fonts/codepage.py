"""Strings as the PC saw them: code page 437, its pictures in the control codes included."""

from functools import lru_cache

from bgi.errors import brief

REMEMBERED = 80
"""Characters of a text of which anything is kept: longer ones rarely come again."""

_CONTROL_PICTURES = "☺☻♥♦♣♠•◘○◙♂♀♪♫☼►◄↕‼¶§▬↨↑↓→←∟↔▲▼"
_TO_CONTROL = {ord(picture): code for code, picture in enumerate(_CONTROL_PICTURES, start=1)}
_TO_CONTROL[ord("⌂")] = 127
_TO_PICTURE = {0: " ", **{code: chr(picture) for picture, code in _TO_CONTROL.items()}}


def encode(text: str | bytes) -> bytes:
    """The bytes of a text: a str in code page 437 with `?` for what it lacks, bytes as they are."""
    if isinstance(text, str):
        return _remembered(text) if len(text) <= REMEMBERED else _encode(text)
    if isinstance(text, bytes):
        return text
    raise TypeError(
        f"text must be str or bytes, not {type(text).__name__}: {brief(text)}"
        " (use str(value) to print a number)"
    )


def _encode(text: str) -> bytes:
    if text.isascii():
        return text.encode("ascii")
    return text.translate(_TO_CONTROL).encode("cp437", "replace")


def decode(codes: bytes) -> str:
    """The text of bytes in code page 437, its pictures for the control codes; 0 is a space."""
    return codes.decode("cp437").translate(_TO_PICTURE)


_remembered = lru_cache(maxsize=1024)(_encode)
