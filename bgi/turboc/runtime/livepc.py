"""The PC that a program meets when somebody plays it: the window's keyboard, mouse and clock."""

from __future__ import annotations

from bgi import bios, conio, current, dos, mouse, stdio
from bgi.stdlib import randomize

TURN = 8 / 33_000
"""Milliseconds of an empty loop's turn: 8 cycles of a 486, of 1990, at 33 MHz."""


class LivePC:
    """Answers what a program asks of the PC, as `Scripted` does."""

    def __init__(self) -> None:
        self._owed = 0.0
        """Milliseconds of empty loops that have not been waited for."""

    def getc(self) -> str:
        """The next typed character."""
        return stdio.TYPED.getc()

    def ungetc(self, character: str) -> None:
        """Take it back."""
        stdio.TYPED.ungetc(character)

    def getch(self) -> int:
        """The next code of the keyboard."""
        return conio.getch()

    def ungetch(self, code: int) -> None:
        """Let a code come again."""
        conio.ungetch(code)

    def kbhit(self) -> int:
        """Whether there is a key."""
        return int(conio.kbhit())

    def bioskey(self, command: int) -> int:
        """What the BIOS says of the keyboard."""
        return bios.bioskey(command & 0xF)

    def pass_time(self, milliseconds: int) -> None:
        """Wait."""
        dos.delay(milliseconds)

    def busy(self, turns: int) -> None:
        """Wait as long as a loop takes that does nothing."""
        self._owed += max(turns, 0) * TURN
        if self._owed >= 1:
            dos.delay(int(self._owed))
            self._owed %= 1

    def milliseconds(self) -> int:
        """Those that have passed since the program began."""
        return int(dos.clock() * 1000 / dos.CLK_TCK)

    def now(self) -> float:
        """Seconds since 1970."""
        return current.now()

    def seed(self) -> int:
        """What randomize() begins with."""
        randomize()
        return -1

    def mouse(self, look: bool = True) -> tuple[int, int, int]:
        """Buttons and place."""
        return mouse.buttons(), *mouse.position()

    def port(self, number: int) -> int:
        """What a port gives: the vertical retrace comes and goes."""
        return 8 if number == 0x3DA and self.milliseconds() % 16 < 2 else 0
