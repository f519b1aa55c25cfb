"""C's strings: characters of code page 437, up to a zero byte."""

from bgi.errors import brief


def c_string(name: str, value: object) -> str:
    """The characters of a str or bytes up to the first zero, where C's strings end.

    Args:
        name: how an error calls the value.
        value: a str, or bytes in code page 437.
    """
    if isinstance(value, (bytes, bytearray)):
        value = value.decode("cp437")
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}: {brief(value)}")
    return value.partition("\0")[0] if "\0" in value else value


def character(code: int) -> str:
    """The character of a code, of which C's char keeps eight bits."""
    return _CHARACTERS[code & 0xFF]


_CHARACTERS = bytes(range(256)).decode("cp437")
