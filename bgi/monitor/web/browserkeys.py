"""From a browser's keys to pygame's: what they type and are called then says `keycodes`.

A browser tells where a key lies (`code`, named after a US keyboard) and what it means (`key`, a
character or a name), as in https://www.w3.org/TR/uievents-code/ and its companion on `key`.
"""

from typing import NamedTuple

from bgi.monitor import sdlkeys

SHIFT, CTRL, ALT, ALTGR, NUM, CAPS = (1 << bit for bit in range(6))
"""What is held or locked while a key goes down."""

_MODS = {
    CTRL: sdlkeys.KMOD_LCTRL,
    ALT: sdlkeys.KMOD_LALT,
    NUM: sdlkeys.KMOD_NUM,
    CAPS: sdlkeys.KMOD_CAPS,
}

# By what they mean.
_NAMED: dict[str, int] = {
    "Enter": sdlkeys.K_RETURN,
    "Escape": sdlkeys.K_ESCAPE,
    "Tab": sdlkeys.K_TAB,
    "Backspace": sdlkeys.K_BACKSPACE,
    "ArrowUp": sdlkeys.K_UP,
    "ArrowDown": sdlkeys.K_DOWN,
    "ArrowLeft": sdlkeys.K_LEFT,
    "ArrowRight": sdlkeys.K_RIGHT,
    "Home": sdlkeys.K_HOME,
    "End": sdlkeys.K_END,
    "PageUp": sdlkeys.K_PAGEUP,
    "PageDown": sdlkeys.K_PAGEDOWN,
    "Insert": sdlkeys.K_INSERT,
    "Delete": sdlkeys.K_DELETE,
    "Clear": sdlkeys.K_KP5,  # the keypad's middle without NumLock
    "PrintScreen": sdlkeys.K_PRINTSCREEN,
    **{f"F{number}": sdlkeys.K_F1 + number - 1 for number in range(1, 13)},
}
# By where they lie.
_PLACED: dict[str, int] = {
    "ShiftLeft": sdlkeys.K_LSHIFT,
    "ShiftRight": sdlkeys.K_RSHIFT,
    "ControlLeft": sdlkeys.K_LCTRL,
    "ControlRight": sdlkeys.K_RCTRL,
    "AltLeft": sdlkeys.K_LALT,
    "AltRight": sdlkeys.K_RALT,
    "Space": sdlkeys.K_SPACE,
    "NumpadAdd": sdlkeys.K_KP_PLUS,
    "NumpadSubtract": sdlkeys.K_KP_MINUS,
    "NumpadMultiply": sdlkeys.K_KP_MULTIPLY,
    "NumpadDivide": sdlkeys.K_KP_DIVIDE,
    "NumpadDecimal": sdlkeys.K_KP_PERIOD,
    **{f"Numpad{digit}": getattr(sdlkeys, f"K_KP{digit}") for digit in range(10)},
}
# The keys of characters on a US keyboard.
_CHARACTERS = {
    **{f"Key{letter}": ord(letter.lower()) for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ"},
    **{f"Digit{digit}": ord(digit) for digit in "0123456789"},
    "Minus": ord("-"),
    "Equal": ord("="),
    "BracketLeft": ord("["),
    "BracketRight": ord("]"),
    "Semicolon": ord(";"),
    "Quote": ord("'"),
    "Backquote": ord("`"),
    "Backslash": ord("\\"),
    "Comma": ord(","),
    "Period": ord("."),
    "Slash": ord("/"),
}
_TEXTS = {"Enter": "\r", "Escape": "\x1b", "Tab": "\t", "Backspace": "\b", "Delete": "\x7f"}
# What Ctrl makes of characters that are no letters.
_CONTROLS = dict(zip("[\\]6^-_", "\x1b\x1c\x1d\x1e\x1e\x1f\x1f", strict=True))


class Keydown(NamedTuple):
    """A key as the attributes of pygame's KEYDOWN event have it."""

    key: int
    mod: int
    unicode: str


def translated(mods: int, code: str, key: str, right_shift: bool = False) -> Keydown:
    """A browser's key; one that pygame has no number for has number 0.

    `right_shift` says which of the Shift keys it is.
    """
    written = bool(mods & ALTGR)  # which Windows calls Ctrl and Alt, but it writes characters
    held = sdlkeys.KMOD_RALT if written else 0
    for flag, mod in _MODS.items():
        if mods & flag and not (written and flag in (CTRL, ALT)):
            held |= mod
    if mods & SHIFT:
        held |= sdlkeys.KMOD_RSHIFT if right_shift else sdlkeys.KMOD_LSHIFT
    text = _TEXTS.get(key, key if len(key) == 1 else "")
    if held & sdlkeys.KMOD_CTRL:
        text = _CONTROLS.get(text, text)
    return Keydown(_number(code, key), held, text)


def _number(code: str, key: str) -> int:
    if key in _NAMED:
        return _NAMED[key]
    if code in _PLACED:
        return _PLACED[code]
    if len(key) == 1 and key.isascii() and key.isalpha():  # wherever the layout has it
        return ord(key.lower())
    if code in _CHARACTERS:
        return _CHARACTERS[code]
    return ord(key) if len(key) == 1 else 0
