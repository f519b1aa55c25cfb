"""A line typed at the keyboard and shown on the screen, up to Enter, as DOS reads it."""

from collections.abc import Callable

LONGEST = 126
"""Characters of a line that DOS takes; it is deaf to more."""

ENTER, BACKSPACE, ESCAPE, TAB, CTRL_C = b"\r", b"\b", b"\x1b", b"\t", b"\x03"


def read_line(
    next_key: Callable[[], bytes],
    show: Callable[[bytes], object],
    erase: Callable[[], object],
    longest: int = LONGEST,
) -> bytes:
    """Read a line; Enter ends it and is not part of it.

    Backspace takes back the last character and Esc all of them. Control characters are shown as
    `^Z`, a tab as a blank; arrows and their like are not heard.

    Args:
        next_key: waits for a keystroke, and returns its bytes.
        show: writes what is typed.
        erase: takes the last character back from the screen.
        longest: how many characters there is room for.

    Raises KeyboardInterrupt at Ctrl-C.
    """
    typed = bytearray()
    while (key := next_key()) != ENTER:
        if key == CTRL_C:
            raise KeyboardInterrupt
        if key in (BACKSPACE, ESCAPE):
            for _ in range(len(typed) if key == ESCAPE else min(len(typed), 1)):
                for _ in _shown(typed[-1:]):
                    erase()
                del typed[-1]
        elif len(key) == 1 and len(typed) < longest:
            typed += key
            show(_shown(key))
    return bytes(typed)


def _shown(key: bytes | bytearray) -> bytes:
    """What is seen of a character that is typed."""
    if key == TAB:
        return b" "
    return bytes(key) if key[0] >= 32 else b"^" + bytes([key[0] + 64])
