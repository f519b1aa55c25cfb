"""What the mouse has done since the last look: how far it went, what was held, how it rolled."""

from dataclasses import dataclass

from bgi import mouse

LEFT, RIGHT = 1, 2
"""The buttons as `bgi.mouse` adds them up."""


@dataclass(frozen=True)
class Motion:
    """A move of the mouse, and false if there was none."""

    x: int
    y: int
    """Where it is now."""
    across: int
    down: int
    """How far it went, in pixels."""
    held: int
    """The buttons that were down all the way."""
    clicks: int
    """Of the wheel; up is negative."""

    def __bool__(self) -> bool:
        return bool(self.across or self.down or self.clicks)


class Tracker:
    """The mouse, looked at from time to time."""

    def __init__(self) -> None:
        self._place, self._buttons = mouse.position(), mouse.buttons()

    def look(self) -> Motion:
        """What it has done since the last look."""
        (x, y), buttons = mouse.position(), mouse.buttons()
        across, down = x - self._place[0], y - self._place[1]
        # What was held before too: the way to where a button goes down is no dragging.
        held = buttons & self._buttons
        self._place, self._buttons = (x, y), buttons
        return Motion(x, y, across, down, held, mouse.wheel())
