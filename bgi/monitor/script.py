"""Keys that press themselves: a script such as "1 Wait2s +Left Wait500ms -Left Esc".

A word is a key: a single character, or a name, such as Esc. `Wait2s` lets two seconds pass before
the next one; `+Left` presses a key and holds it, `-Left` lets it go.
"""

import threading
import time
from typing import NamedTuple

from bgi.monitor.keycodes import KEYSTROKES, key_named, typed
from bgi.monitor.keyqueue import KeyQueue

LONGEST = (1 << 31) - 1  # milliseconds to wait at most: C's largest int, 24 days

_SHIFTS = {"shift": 2, "ctrl": 4, "alt": 8}  # by the BIOS's flags


class Press(NamedTuple):
    """A moment of a script, in seconds from its start: what is typed, and all that is held then."""

    at: float
    keystroke: bytes
    held: frozenset[str]

    def type(self, keys: KeyQueue) -> None:
        """Do it, on a program's keyboard."""
        shifts = sum(flag for name, flag in _SHIFTS.items() if name in self.held)
        keys.hold("script", shifts, self.held)
        keys.load([self.keystroke])


def parse_script(script: str) -> list[Press]:
    """The moments of a script; ValueError names a word that makes no sense."""
    at = 0.0
    held: frozenset[str] = frozenset()
    presses = []
    for word in script.split():
        if word[:4].lower() == "wait" and len(word) > 4:
            at += parse_time(word[4:].lower())
            continue
        sign, key = (word[0], word[1:]) if len(word) > 1 and word[0] in "+-" else ("", word)
        name = key_named(key)
        held = {"": held, "+": held | {name}, "-": held - {name}}[sign]
        keystroke = typed(key) if len(key) == 1 else KEYSTROKES[name]
        presses.append(Press(at, b"" if sign == "-" else keystroke, held))
    return presses


def parse_time(text: str) -> float:
    """A time such as 2s, 2.5 or 500ms, in seconds; ValueError for anything else."""
    number, unit = (text[:-2], 0.001) if text.endswith("ms") else (text.removesuffix("s"), 1)
    try:
        seconds = float(number) * unit
    except ValueError:
        seconds = -1
    if not 0 < seconds <= LONGEST / 1000:
        raise ValueError(f"{text!r} is not a time: write 2s, 2.5s or 500ms; at most 24 days")
    return seconds


def play(presses: list[Press], keys: KeyQueue) -> None:
    """Type a script on a program's keyboard: what is due now at once, the rest in a thread."""
    began = time.monotonic()

    def type_rest() -> None:
        for press in presses[now:]:
            time.sleep(max(0.0, began + press.at - time.monotonic()))
            press.type(keys)

    now = sum(press.at == 0 for press in presses)
    for press in presses[:now]:
        press.type(keys)
    if presses[now:]:
        threading.Thread(target=type_rest, name="bgi script", daemon=True).start()
