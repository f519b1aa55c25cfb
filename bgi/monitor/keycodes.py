"""The codes and the names of keys: what getch() returns for a key, and what a user calls it.

An ordinary key is one byte: its ASCII code or, beyond ASCII, its place in code page 437. A key
without a character, such as an arrow, is two: a 0 and the key's scan code. `encode` translates
pygame's keys into these bytes; `bios_code` makes of them what the BIOS knew a key by.
"""

import sys
from collections.abc import Iterable

from bgi.errors import brief
from bgi.monitor import sdlkeys

_PLAIN, _SHIFT, _CTRL, _ALT = range(4)


def _extended(keys: Iterable[int], *codes: int) -> dict[int, bytes]:
    return {key: bytes((0, code)) for key, code in zip(keys, codes, strict=True)}


def _letters(letters: str, first: int) -> dict[int, bytes]:
    return _extended(map(ord, letters), *range(first, first + len(letters)))


_FUNCTION_KEYS = range(sdlkeys.K_F1, sdlkeys.K_F1 + 12)


def _function_keys(f1: int, f11: int) -> dict[int, bytes]:
    return _extended(_FUNCTION_KEYS, *range(f1, f1 + 10), f11, f11 + 1)


# Borland's table of keys. A key that is not in it and makes no text never arrives. F11 and F12 have
# the codes of the enhanced BIOS call. pygame's number of an ASCII character's key is its code.
_CODES: dict[int, dict[int, bytes]] = {
    _PLAIN: {
        sdlkeys.K_RETURN: b"\r",
        sdlkeys.K_KP_ENTER: b"\r",
        sdlkeys.K_ESCAPE: b"\x1b",
        sdlkeys.K_TAB: b"\t",
        sdlkeys.K_BACKSPACE: b"\b",
        **_extended((sdlkeys.K_HOME, sdlkeys.K_UP, sdlkeys.K_PAGEUP), 71, 72, 73),
        **_extended((sdlkeys.K_LEFT, sdlkeys.K_KP5, sdlkeys.K_RIGHT), 75, 76, 77),
        **_extended((sdlkeys.K_END, sdlkeys.K_DOWN, sdlkeys.K_PAGEDOWN), 79, 80, 81),
        **_extended((sdlkeys.K_INSERT, sdlkeys.K_DELETE), 82, 83),
        **_function_keys(59, 133),
    },
    _SHIFT: {
        **_extended((sdlkeys.K_TAB,), 15),
        **_function_keys(84, 135),
    },
    _CTRL: {
        **{ord(letter): bytes((ord(letter) - 96,)) for letter in "abcdefghijklmnopqrstuvwxyz"},
        sdlkeys.K_RETURN: b"\n",
        sdlkeys.K_KP_ENTER: b"\n",
        sdlkeys.K_ESCAPE: b"\x1b",
        sdlkeys.K_BACKSPACE: b"\x7f",
        sdlkeys.K_SPACE: b" ",
        **_extended((sdlkeys.K_2, sdlkeys.K_AT, sdlkeys.K_PRINTSCREEN), 3, 3, 114),
        **_extended((sdlkeys.K_LEFT, sdlkeys.K_RIGHT), 115, 116),
        **_extended((sdlkeys.K_END, sdlkeys.K_PAGEDOWN), 117, 118),
        **_extended((sdlkeys.K_HOME, sdlkeys.K_PAGEUP), 119, 132),
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
    sdlkeys.K_KP0: sdlkeys.K_INSERT,
    sdlkeys.K_KP1: sdlkeys.K_END,
    sdlkeys.K_KP2: sdlkeys.K_DOWN,
    sdlkeys.K_KP3: sdlkeys.K_PAGEDOWN,
    sdlkeys.K_KP4: sdlkeys.K_LEFT,
    sdlkeys.K_KP6: sdlkeys.K_RIGHT,
    sdlkeys.K_KP7: sdlkeys.K_HOME,
    sdlkeys.K_KP8: sdlkeys.K_UP,
    sdlkeys.K_KP9: sdlkeys.K_PAGEUP,
    sdlkeys.K_KP_PERIOD: sdlkeys.K_DELETE,
}

_NAMED = {
    "esc": sdlkeys.K_ESCAPE,
    "enter": sdlkeys.K_RETURN,
    "space": sdlkeys.K_SPACE,
    "tab": sdlkeys.K_TAB,
    "backspace": sdlkeys.K_BACKSPACE,
    "up": sdlkeys.K_UP,
    "down": sdlkeys.K_DOWN,
    "left": sdlkeys.K_LEFT,
    "right": sdlkeys.K_RIGHT,
    "home": sdlkeys.K_HOME,
    "end": sdlkeys.K_END,
    "pgup": sdlkeys.K_PAGEUP,
    "pgdn": sdlkeys.K_PAGEDOWN,
    "ins": sdlkeys.K_INSERT,
    "del": sdlkeys.K_DELETE,
    **{f"f{number}": key for number, key in enumerate(_FUNCTION_KEYS, 1)},
}
# Keys that change others.
_CHANGING = {
    sdlkeys.K_LSHIFT: "shift",
    sdlkeys.K_RSHIFT: "shift",
    sdlkeys.K_LCTRL: "ctrl",
    sdlkeys.K_RCTRL: "ctrl",
    sdlkeys.K_LALT: "alt",
    sdlkeys.K_RALT: "alt",
}
_NAMES = {key: name for name, key in _NAMED.items()} | {sdlkeys.K_KP_ENTER: "enter"} | _CHANGING

KEYSTROKES = {name: _CODES[_PLAIN].get(key, b" ") for name, key in _NAMED.items()} | {
    "shift": b"",
    "ctrl": b"",
    "alt": b"",
}
"""The names of keys that are not one character, and what each types alone."""


def encode(key: int, mods: int, unicode: str) -> bytes:
    """The bytes that getch() returns for a key: one, two (0 and a scan code) or none at all.

    The arguments are the attributes `key`, `mod` and `unicode` of pygame's KEYDOWN event.
    """
    if mods & sdlkeys.KMOD_META:  # Windows and Command keys speak to the desktop
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
    return typed(unicode)


def _modifier(key: int, mods: int, unicode: str) -> int:
    # AltGr (on Windows it comes as Ctrl and right Alt) writes characters: then it is not Alt.
    if mods & sdlkeys.KMOD_RALT and unicode and [*map(ord, unicode.lower())] != [key]:
        return _PLAIN
    # The order in which the BIOS asks.
    if mods & sdlkeys.KMOD_ALT:
        return _ALT
    if mods & sdlkeys.KMOD_CTRL:
        return _CTRL
    return _SHIFT if mods & sdlkeys.KMOD_SHIFT else _PLAIN


def typed(characters: str) -> bytes:
    """What characters are in code page 437."""
    # A lone 0 would announce a scan code; the key that types it, Ctrl-@, has scan code 3.
    return characters.encode("cp437", "replace").replace(b"\0", b"\0\x03")


def key_named(word: str) -> str:
    """The one name of a key that a user has written; ValueError if it is none.

    A single character is itself, in small letters; names, in any case, are those of `KEYSTROKES`.
    """
    name = word.lower()
    if len(word) == 1:
        return _NAMES.get(ord(word), name)
    if name in KEYSTROKES:
        return name
    raise ValueError(
        f"{brief(word)} is not a key: write a single character, Esc, Enter, Space, Tab, Backspace, "
        "Up, Down, Left, Right, Home, End, PgUp, PgDn, Ins, Del, F1 to F12, Shift, Ctrl or Alt"
    )


def name_of(key: int, unicode: str) -> str:
    """The name that `key_named` has for pygame's key; "" for one that has none."""
    if not unicode:
        key = _KEYPAD.get(key, key)
    if name := _NAMES.get(key):
        return name
    # Keys of characters have their codes, in small letters; those of the keypad only their text.
    return chr(key) if ord(" ") < key <= sys.maxunicode else unicode


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
    sdlkeys.KMOD_RSHIFT: 0x01,
    sdlkeys.KMOD_LSHIFT: 0x02,
    sdlkeys.KMOD_CTRL: 0x04,
    sdlkeys.KMOD_ALT: 0x08,
    sdlkeys.KMOD_NUM: 0x20,
    sdlkeys.KMOD_CAPS: 0x40,
}


def shift_flags(mods: int) -> int:
    """The BIOS's flags for pygame's: 1 right Shift, 2 left Shift, 4 Ctrl, 8 Alt, and the locks."""
    return sum(flag for mask, flag in _SHIFT_FLAGS.items() if mods & mask)
