"""The text of a C source, as a PC of 1990 stored it."""

END_OF_FILE = b"\x1a"
"""Ctrl-Z: editors for DOS ended files with it."""


def decode(data: bytes) -> str:
    """The text: code page 437 up to Ctrl-Z, lines ended by a line feed, the last one too."""
    text = data.partition(END_OF_FILE)[0].decode("cp437")
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", " ")
    return text if text.endswith("\n") else text + "\n"
