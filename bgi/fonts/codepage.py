"""Strings as the PC saw them: code page 437, its pictures in the control codes included."""

from functools import lru_cache

_CONTROL_PICTURES = "☺☻♥♦♣♠•◘○◙♂♀♪♫☼►◄↕‼¶§▬↨↑↓→←∟↔▲▼"
_TO_CONTROL = {ord(picture): code for code, picture in enumerate(_CONTROL_PICTURES, start=1)}
_TO_CONTROL[ord("⌂")] = 127


def encode(text: str | bytes) -> bytes:
    """The bytes of a text: a str in code page 437 with `?` for what it lacks, bytes as they are."""
    if isinstance(text, str):
        return _encode(text)
    if isinstance(text, bytes):
        return text
    raise TypeError(
        f"text must be str or bytes, not {type(text).__name__}: {text!r:.60}"
        " (use str(value) to print a number)"
    )


@lru_cache(maxsize=1024)
def _encode(text: str) -> bytes:
    return text.translate(_TO_CONTROL).encode("cp437", "replace")
