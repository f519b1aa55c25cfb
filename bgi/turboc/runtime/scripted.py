"""A PC whose keyboard, clock, mouse and ports follow a script: the same in every run."""

from __future__ import annotations

from dataclasses import dataclass, field

from bgi.monitor.script import parse_script

NOON = 708_609_600
"""When it begins, in seconds since 1970: 15 June 1992, 12:00."""

QUESTION = 55
"""Milliseconds that pass with each question for the time."""

POLLS = 60
"""Questions for a key that are answered by no until one is there."""

TYPED = {
    "A": "100 100 200 150 50 3 2 1 45 120 80 250 200 4 60 5 10 300 220 0",
    "B": "3 100 120 260 140 180 240 4 2 1 5 90 30 320 20 7 6 160 40 0",
}
"""What is typed for scanf() and its like, a line each, for ever."""

KEYS = "Enter 1 Space Right 2 Down a Enter Left 3 d Up w y s Enter F1 + - 4"
"""Keys that are pressed one after the other."""

ENDLESS = "Esc q Enter n x 0 5 6 7 8 9 4 y Q X e"
"""Those that are pressed once the others are through, again and again."""

PLACES = [(100, 100), (200, 150), (320, 240), (50, 400), (600, 20)]
PLACES += [(320, 10), (10, 10), (635, 470), (400, 300), (150, 450)]
"""Where the mouse is, for eight questions each."""

_LOOKS = 8
"""Of a program at each place."""


def _looks() -> list[tuple[int, int, int]]:
    """What a program sees of the mouse, look for look: the buttons that are down, and the place."""
    seen = []
    for number, (x, y) in enumerate(PLACES):
        for step in range(_LOOKS):
            right = step == 6 and number % 5 == 4
            seen.append((1 if step in (4, 5) else 2 if right else 0, x, y))
    return seen


def codes(words: str) -> list[int]:
    """The codes of keys by their names; ValueError for a word that is none."""
    found = []
    for press in parse_script(words):
        keystroke = press.keystroke
        extended = len(keystroke) == 2
        found.append(0x100 | keystroke[1] if extended else keystroke[0])
    return found


@dataclass
class Script:
    """What a scripted PC does."""

    typed: str
    keys: list[int] = field(default_factory=lambda: codes(KEYS))
    endless: list[int] = field(default_factory=lambda: codes(ENDLESS))
    looks: list[tuple[int, int, int]] = field(default_factory=_looks)
    start: int = NOON


_ROWS = "\x1b1234567890-=\b\tqwertyuiop[]\r\0asdfghjkl;'`\0\\zxcvbnm,./"


def _scan(code: int) -> int:
    """The scan code of a character's key."""
    if code in (27, 32, 43):
        return {27: 1, 32: 0x39, 43: 0x0D}[code]
    place = _ROWS.find(chr(code).lower())
    return place + 1 if place > 0 else 0


class Scripted:
    """Answers what a program asks of the PC."""

    def __init__(self, script: Script) -> None:
        self._script = script
        self._typed = script.typed
        self._at = 0
        self._taken = self._polls = 0
        self._waiting: list[int] = []
        self._milliseconds = 0
        self._looks = 0
        self._port_60 = self._port_3da = 0

    # The typed text

    def getc(self) -> str:
        """The next typed character."""
        character = self._typed[self._at % len(self._typed)]
        self._at += 1
        return character

    def ungetc(self, character: str) -> None:
        """Take it back."""
        self._at -= 1

    # The keyboard

    def _key(self) -> int:
        keys, endless = self._script.keys, self._script.endless
        if self._taken < len(keys):
            return keys[self._taken]
        return endless[(self._taken - len(keys)) % len(endless)]

    def _take(self) -> int:
        key = self._key()
        self._taken += 1
        self._polls = 0
        return key

    def getch(self) -> int:
        """The next code of the keyboard."""
        if self._waiting:
            return self._waiting.pop()
        key = self._take()
        if key >= 0x100:
            self._waiting.append(key & 0xFF)
            return 0
        return key

    def ungetch(self, code: int) -> None:
        """Let a code come again."""
        self._waiting.append(code & 0xFF)

    def kbhit(self) -> int:
        """Whether there is a key."""
        if self._waiting or self._polls >= POLLS:
            return 1
        self._polls += 1
        return 0

    def _word(self, key: int) -> int:
        return (key & 0xFF) << 8 if key >= 0x100 else _scan(key) << 8 | key

    def bioskey(self, command: int) -> int:
        """What the BIOS says of the keyboard."""
        if command & 0xF == 0:
            self._waiting.clear()
            return self._word(self._take())
        if command & 0xF == 1:
            return self._word(self._key()) if self.kbhit() else 0
        return 0

    # The clock

    def pass_time(self, milliseconds: int) -> None:
        """Wait."""
        self._milliseconds += milliseconds

    def busy(self, turns: int) -> None:
        """An empty loop takes no time."""

    def milliseconds(self) -> int:
        """Those that have passed; the question takes time, too."""
        now = self._milliseconds
        self._milliseconds += QUESTION
        return now

    def now(self) -> float:
        """Seconds since 1970."""
        return self._script.start + self.milliseconds() / 1000

    def seed(self) -> int:
        """What randomize() begins with."""
        return self._script.start + self._milliseconds // 1000

    # The mouse, and ports

    def mouse(self, look: bool = True) -> tuple[int, int, int]:
        """Buttons and place."""
        looks = self._script.looks
        seen = looks[self._looks % len(looks)]
        self._looks += look
        return seen

    def port(self, number: int) -> int:
        """What a port gives."""
        if number == 0x3DA:
            self._port_3da ^= 8
            return self._port_3da
        if number == 0x60:
            self._port_60 += 1
            return 0x80 if self._port_60 <= 60 else 1
        return 0


def script(name: str) -> Scripted:
    """The scripts A and B."""
    return Scripted(Script(typed_lines(TYPED[name])))


def typed_lines(words: str) -> str:
    """Words as they are typed, a line each."""
    return words.replace(" ", "\n") + "\n"
