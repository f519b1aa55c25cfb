"""A monitor without a screen: for tests, and for machines that have no display.

Its keys come from a script and its clock is a number, so a program with pauses and questions runs
through at once and the same way every time.
"""

import os
import sys

from bgi.errors import BGIError
from bgi.keyboard import KeyQueue, parse_script


class Headless:
    """Shows nothing; counts what it was asked for.

    `keys` is a script such as `"1 w Left Esc"`, by default that of the variable BGI_KEYS.
    `shown` counts the calls of show(), `now` the milliseconds slept.
    """

    def __init__(self, keys: str | None = None, title: str = "") -> None:
        script = os.environ.get("BGI_KEYS", "") if keys is None else keys
        self.shown = 0
        self.now = 0.0
        self.title = title
        self._keys = KeyQueue(limit=sys.maxsize)
        for keystroke in parse_script(script):
            self._keys.put(keystroke)
        self._keys.close(
            BGIError(
                "there is no window to type in and no scripted key is left; "
                'give keys in the variable BGI_KEYS, as in BGI_KEYS="1 w Left Esc"'
            )
        )

    def show(self) -> None:
        """Count one picture."""
        self.shown += 1

    def key_waiting(self) -> bool:
        """Whether the script goes on."""
        return self._keys.waiting()

    def read_key(self) -> int:
        """The script's next byte; BGIError at its end."""
        return self._keys.get()

    def sleep(self, milliseconds: float) -> None:
        """Move the clock on."""
        self.now += max(0.0, milliseconds)

    def set_title(self, title: str) -> None:
        """Remember the title."""
        self.title = title

    def close(self) -> None:
        """Nothing to let go of."""
