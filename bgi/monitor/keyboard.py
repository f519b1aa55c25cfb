"""Keys as DOS knew them: what getch() returns for a key, and the queue in which keys wait.

An ordinary key is one byte: its ASCII code or, beyond ASCII, its place in code page 437. A key
without a character, such as an arrow, is two: a 0 and the key's scan code. `encode` translates
pygame's keys into these bytes; `parse_script` does so for keys written down as words; `bios_code`
makes of them what the BIOS knew a key by.
"""

import math
import re
import sys
import threading
from collections import deque
from collections.abc import Iterable
from typing import NamedTuple

from bgi.memory.sdl import pygame

# The BIOS keeps fifteen keystrokes for a program that is busy; the sixteenth is lost.
BIOS_BUFFER = 15

# On Windows Ctrl-C cannot interrupt the wait for a lock: there it is cut into short pieces.
PIECE_SECONDS = 0.1 if sys.platform == "win32" else 3600.0

_PLAIN, _SHIFT, _CTRL, _ALT = range(4)


def _extended(keys: Iterable[int], *codes: int) -> dict[int, bytes]:
    return {key: bytes((0, code)) for key, code in zip(keys, codes, strict=True)}


def _letters(letters: str, first: int) -> dict[int, bytes]:
    return _extended(map(ord, letters), *range(first, first + len(letters)))


_FUNCTION_KEYS = [getattr(pygame, f"K_F{number}") for number in range(1, 13)]


def _function_keys(f1: int, f11: int) -> dict[int, bytes]:
    return _extended(_FUNCTION_KEYS, *range(f1, f1 + 10), f11, f11 + 1)


# Borland's table of keys. A key that is not in it and makes no text never arrives. F11 and F12 have
# the codes of the enhanced BIOS call. pygame's number of an ASCII character's key is its code.
_CODES: dict[int, dict[int, bytes]] = {
    _PLAIN: {
        pygame.K_RETURN: b"\r",
        pygame.K_KP_ENTER: b"\r",
        pygame.K_ESCAPE: b"\x1b",
        pygame.K_TAB: b"\t",
        pygame.K_BACKSPACE: b"\b",
        **_extended((pygame.K_HOME, pygame.K_UP, pygame.K_PAGEUP), 71, 72, 73),
        **_extended((pygame.K_LEFT, pygame.K_KP5, pygame.K_RIGHT), 75, 76, 77),
        **_extended((pygame.K_END, pygame.K_DOWN, pygame.K_PAGEDOWN), 79, 80, 81),
        **_extended((pygame.K_INSERT, pygame.K_DELETE), 82, 83),
        **_function_keys(59, 133),
    },
    _SHIFT: {
        **_extended((pygame.K_TAB,), 15),
        **_function_keys(84, 135),
    },
    _CTRL: {
        **{ord(letter): bytes((ord(letter) - 96,)) for letter in "abcdefghijklmnopqrstuvwxyz"},
        pygame.K_RETURN: b"\n",
        pygame.K_KP_ENTER: b"\n",
        pygame.K_ESCAPE: b"\x1b",
        pygame.K_BACKSPACE: b"\x7f",
        pygame.K_SPACE: b" ",
        **_extended((pygame.K_2, pygame.K_AT, pygame.K_PRINTSCREEN), 3, 3, 114),
        **_extended((pygame.K_LEFT, pygame.K_RIGHT), 115, 116),
        **_extended((pygame.K_END, pygame.K_PAGEDOWN), 117, 118),
        **_extended((pygame.K_HOME, pygame.K_PAGEUP), 119, 132),
        **_function_keys(94, 137),
    },
    _ALT: {
        **_letters("qwertyuiop", 16),
        **_letters("asdfghjkl", 30),
        **_letters("zxcvbnm", 44),
        **_letters("1234567890-=", 120),
        **_function_keys(104, 139),
    },
}

# What the numeric keypad means while NumLock is off.
_KEYPAD = {
    pygame.K_KP0: pygame.K_INSERT,
    pygame.K_KP1: pygame.K_END,
    pygame.K_KP2: pygame.K_DOWN,
    pygame.K_KP3: pygame.K_PAGEDOWN,
    pygame.K_KP4: pygame.K_LEFT,
    pygame.K_KP6: pygame.K_RIGHT,
    pygame.K_KP7: pygame.K_HOME,
    pygame.K_KP8: pygame.K_UP,
    pygame.K_KP9: pygame.K_PAGEUP,
    pygame.K_KP_PERIOD: pygame.K_DELETE,
}

_NAMES = {
    name.lower(): _CODES[_PLAIN][key]
    for name, key in {
        "Esc": pygame.K_ESCAPE,
        "Enter": pygame.K_RETURN,
        "Tab": pygame.K_TAB,
        "Backspace": pygame.K_BACKSPACE,
        "Up": pygame.K_UP,
        "Down": pygame.K_DOWN,
        "Left": pygame.K_LEFT,
        "Right": pygame.K_RIGHT,
        "Home": pygame.K_HOME,
        "End": pygame.K_END,
        "PgUp": pygame.K_PAGEUP,
        "PgDn": pygame.K_PAGEDOWN,
        "Ins": pygame.K_INSERT,
        "Del": pygame.K_DELETE,
        **{f"F{number}": key for number, key in enumerate(_FUNCTION_KEYS, 1)},
    }.items()
} | {"space": b" "}


def encode(key: int, mods: int, unicode: str) -> bytes:
    """The bytes that getch() returns for a key: one, two (0 and a scan code) or none at all.

    The arguments are the attributes `key`, `mod` and `unicode` of pygame's KEYDOWN event.
    """
    if mods & pygame.KMOD_META:  # Windows and Command keys speak to the desktop
        return b""
    if not unicode:
        key = _KEYPAD.get(key, key)
    modifier = _modifier(key, mods, unicode)
    code = _CODES[modifier].get(key)
    if code is None and modifier == _SHIFT:
        code = _CODES[_PLAIN].get(key)
    if code is not None:
        return code
    # Alt and Ctrl make no text, except the control characters: Ctrl-[ is Esc.
    if modifier == _ALT or (modifier == _CTRL and unicode >= " "):
        return b""
    return _text(unicode)


def _modifier(key: int, mods: int, unicode: str) -> int:
    # AltGr (on Windows it comes as Ctrl and right Alt) writes characters: then it is not Alt.
    if mods & pygame.KMOD_RALT and unicode and [*map(ord, unicode.lower())] != [key]:
        return _PLAIN
    # The order in which the BIOS asks.
    if mods & pygame.KMOD_ALT:
        return _ALT
    if mods & pygame.KMOD_CTRL:
        return _CTRL
    return _SHIFT if mods & pygame.KMOD_SHIFT else _PLAIN


def _text(characters: str) -> bytes:
    # A lone 0 would announce a scan code; the key that types it, Ctrl-@, has scan code 3.
    return characters.encode("cp437", "replace").replace(b"\0", b"\0\x03")


class Stroke(NamedTuple):
    """A keystroke of a script."""

    due: float
    """When it is there to be read, in seconds after the start."""
    keystroke: bytes


def parse_script(script: str) -> list[Stroke]:
    """Keystrokes from words, `"1 w Left Wait2s Esc"`: characters as themselves, keys by name.

    Names in any case: Esc Enter Space Tab Backspace Up Down Left Right Home End PgUp PgDn Ins Del
    F1 ... F12; Wait2s or Wait500ms puts off all that follows. ValueError names any other word.
    """
    strokes: list[Stroke] = []
    now = 0.0
    for word in script.split():
        pause = _PAUSE.fullmatch(word)
        if pause:
            now += parse_time(pause[1])
        else:
            strokes.append(Stroke(now, _keystroke(word)))
    return strokes


_PAUSE = re.compile("wait(.+)", re.IGNORECASE)


def _keystroke(word: str) -> bytes:
    if len(word) == 1:
        return _text(word)
    try:
        return _NAMES[word.lower()]
    except KeyError:
        raise ValueError(
            f"{word!r} is not a key: write a single character, Esc, Enter, Space, Tab, Backspace, "
            "Up, Down, Left, Right, Home, End, PgUp, PgDn, Ins, Del or F1 to F12, "
            "or Wait2s to put off what follows"
        ) from None


def parse_time(text: str) -> float:
    """A time such as 2s, 2.5 or 500ms, in seconds; ValueError if it is none."""
    number, unit = (text[:-2], 0.001) if text.endswith("ms") else (text.removesuffix("s"), 1)
    try:
        seconds = float(number) * unit
    except ValueError:
        seconds = -1
    if not 0 < seconds < math.inf:
        raise ValueError(f"{text!r} is not a time: write 2s, 2.5s or 500ms")
    return seconds


# The scan codes of a US keyboard, row by row; Shift and Ctrl change nothing.
_SCAN_CODES = {
    ord(character): first + place
    for first, rows in {
        0x02: ("1234567890-=", "!@#$%^&*()_+"),
        0x10: ("qwertyuiop[]", "QWERTYUIOP{}", "\x11\x17\x05\x12\x14\x19\x15\x09\x0f\x10"),
        0x1E: ("asdfghjkl;'`", 'ASDFGHJKL:"~', "\x01\x13\x04\x06\x07\x08\x0a\x0b\x0c"),
        0x2B: ("\\zxcvbnm,./", "|ZXCVBNM<>?", "\x1c\x1a\x18\x03\x16\x02\x0e\x0d"),
        # These come last and win: Esc, Backspace, Tab and Enter, not Ctrl-[, H, I, J and M.
        0x01: ("\x1b",),
        0x0E: ("\b\t", "\x7f"),
        0x1C: ("\r", "\n"),
        0x39: (" ",),
    }.items()
    for row in rows
    for place, character in enumerate(row)
}


def bios_code(keystroke: bytes) -> int:
    """What bioskey() returns for a keystroke: 256 times its scan code, plus its character.

    Characters have the scan codes of a US keyboard, and 0 beyond ASCII.
    """
    if keystroke[0] == 0:
        return keystroke[1] << 8
    return _SCAN_CODES.get(keystroke[0], 0) << 8 | keystroke[0]


# The BIOS's flags for the keys that change others: bioskey(2).
_SHIFT_FLAGS = {
    pygame.KMOD_RSHIFT: 0x01,
    pygame.KMOD_LSHIFT: 0x02,
    pygame.KMOD_CTRL: 0x04,
    pygame.KMOD_ALT: 0x08,
    pygame.KMOD_NUM: 0x20,
    pygame.KMOD_CAPS: 0x40,
}


def shift_flags(mods: int) -> int:
    """The BIOS's flags for pygame's: 1 right Shift, 2 left Shift, 4 Ctrl, 8 Alt, and the locks."""
    return sum(flag for mask, flag in _SHIFT_FLAGS.items() if mods & mask)


class KeyQueue:
    """Keystrokes on their way from the monitor's thread to the program, at most `limit` of them.

    `shifts` are the BIOS's flags of the Shift keys and their like. One byte can be put back; the
    second byte of a keystroke waits in the same place.
    """

    def __init__(self, limit: int = BIOS_BUFFER) -> None:
        self.shifts = 0
        self._limit = limit
        self._keys: deque[bytes] = deque()
        self._back: int | None = None
        self._changed = threading.Condition()
        self._error: Exception | None = None

    def put(self, keystroke: bytes) -> None:
        """Add a keystroke; when the queue is full the whole keystroke is lost."""
        if len(self._keys) < self._limit:
            self.load([keystroke])

    def load(self, keystrokes: Iterable[bytes]) -> None:
        """Add the keystrokes of a script, however many there are."""
        with self._changed:
            self._keys.extend(filter(None, keystrokes))
            self._changed.notify_all()

    def waiting(self) -> bool:
        """Whether `get` would return at once."""
        return bool(self._keys) or self._back is not None

    def half(self) -> bool:
        """Whether the next byte is the second one of a keystroke, or one that was put back."""
        return self._back is not None

    def wait(self, seconds: float) -> None:
        """Wait until there is a key, but not longer than that."""
        with self._changed:
            if not self.waiting() and self._error is None:
                self._changed.wait(seconds)

    def get(self) -> int:
        """The next byte; waits for one, or raises the error the queue was closed with."""
        with self._changed:
            code, self._back = self._back, None
            if code is None:
                code, *rest = self.take()
                self._back = rest[0] if rest else None
            return code

    def put_back(self, code: int) -> bool:
        """Make `code` the next byte; False, and no change, if one has been put back already."""
        with self._changed:
            if self._back is not None:
                return False
            self._back = code
            self._changed.notify_all()
            return True

    def peek(self) -> bytes | None:
        """The next whole keystroke, which stays, or None."""
        with self._changed:
            return self._keys[0] if self._keys else None

    def take(self) -> bytes:
        """The next whole keystroke; waits as `get` does."""
        with self._changed:
            while not self._keys:
                if self._error is not None:
                    raise self._error.with_traceback(None)
                self._changed.wait(PIECE_SECONDS)
            return self._keys.popleft()

    def close(self, error: Exception) -> None:
        """No more keys will come: once the queue is empty, `get` raises `error`."""
        with self._changed:
            self._error = error
            self._changed.notify_all()
