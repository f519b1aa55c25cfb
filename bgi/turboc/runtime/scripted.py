"""A PC whose keyboard, clock, mouse and ports follow a script: the same in every run."""

from __future__ import annotations

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

KEYS: list[int | str] = [
    13,
    "1",
    " ",
    0x14D,
    "2",
    0x150,
    "a",
    13,
    0x14B,
    "3",
    "d",
    0x148,
    "w",
    "y",
    "s",
    13,
]
KEYS += [0x13B, "+", "-", "4"]
ENDLESS: list[int | str] = [
    27,
    "q",
    13,
    "n",
    "x",
    "0",
    "5",
    "6",
    "7",
    "8",
    "9",
    "4",
    "y",
    "Q",
    "X",
    "e",
]
"""Keys that are pressed once KEYS are through; extended ones have 0x100 before their scan code."""

PLACES = [(100, 100), (200, 150), (320, 240), (50, 400), (600, 20)]
PLACES += [(320, 10), (10, 10), (635, 470), (400, 300), (150, 450)]
"""Where the mouse is, for eight questions each."""

_ROWS = "\x1b1234567890-=\b\tqwertyuiop[]\r\0asdfghjkl;'`\0\\zxcvbnm,./"


def _scan(code: int) -> int:
    """The scan code of a character's key."""
    if code in (27, 32, 43):
        return {27: 1, 32: 0x39, 43: 0x0D}[code]
    place = _ROWS.find(chr(code).lower())
    return place + 1 if place > 0 else 0


class Scripted:
    """Answers what a program asks of the PC."""

    def __init__(self, typed: str, keys: list[int] | None = None) -> None:
        self._typed = typed
        self._at = 0
        self._keys = [ord(k) if isinstance(k, str) else k for k in KEYS] if keys is None else keys
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
        if self._taken < len(self._keys):
            return self._keys[self._taken]
        key = ENDLESS[(self._taken - len(self._keys)) % len(ENDLESS)]
        return ord(key) if isinstance(key, str) else key

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

    def milliseconds(self) -> int:
        """Those that have passed; the question takes time, too."""
        now = self._milliseconds
        self._milliseconds += QUESTION
        return now

    def now(self) -> float:
        """Seconds since 1970."""
        return NOON + self.milliseconds() / 1000

    def seed(self) -> int:
        """What randomize() begins with."""
        return NOON + self._milliseconds // 1000

    # The mouse, and ports

    def mouse(self, look: bool = True) -> tuple[int, int, int]:
        """Buttons and place."""
        block, step = divmod(self._looks, 8)
        x, y = PLACES[block % 10]
        buttons = 1 if step in (4, 5) else 2 if step == 6 and block % 5 == 4 else 0
        self._looks += look
        return buttons, x, y

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
    return Scripted(TYPED[name].replace(" ", "\n") + "\n")
