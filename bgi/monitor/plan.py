"""What is to happen to a program that nobody watches: a picture at some moment, a recording.

`python -m bgi` hands its options on in these variables, so they work without it, too:

    ============  =================================================================
    BGI_KEYS      keys that are "pressed", as in ``1 w Left Esc``
    BGI_SHOT      a file for a picture of the screen at the end
    BGI_AFTER     when that is, in seconds; unset: when the program closes the screen
    BGI_RECORD    a file for a recording of everything
    ============  =================================================================
"""

import contextlib
import math
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from bgi.memory import imagefile
from bgi.memory.card import Card, Frame
from bgi.monitor.keyboard import parse_script
from bgi.monitor.picture import Colours, pixels


@dataclass
class Plan:
    """Keystrokes to come; files ("": none) for a picture and a recording; seconds until the end."""

    keys: list[bytes] = field(default_factory=list)
    shot: str = ""
    after: float = math.inf
    record: str = ""

    @classmethod
    def from_environment(cls, keys: str | None = None) -> "Plan":
        """The plan that the variables describe, or one with other keys.

        ValueError names a variable that makes no sense, or a word that is no key.
        """
        after = os.environ.get("BGI_AFTER", "")
        try:
            seconds = float(after or math.inf)
        except ValueError:
            raise ValueError(f"BGI_AFTER is {after!r}; it may be a number of seconds") from None
        shot, record = (os.environ.get(name, "") for name in ("BGI_SHOT", "BGI_RECORD"))
        script = os.environ.get("BGI_KEYS", "") if keys is None else keys
        shot, record = (file and os.path.abspath(file) for file in (shot, record))
        return cls(parse_script(script), shot, seconds, record)

    def take_shot(self, card: Card) -> None:
        """Write the picture that is planned, once; if that fails one line says so."""
        frame = card.frame() if self.shot else None
        if frame is not None:
            with or_say_why(self.shot):
                Path(self.shot).write_bytes(shot(frame, card.palette))
            self.shot = ""


@contextlib.contextmanager
def or_say_why(file: str) -> Iterator[None]:
    """Whoever closes a screen must not fail because a file cannot be written."""
    try:
        yield
    except OSError as error:
        print(f"bgi: {file} was not written: {error.strerror}", file=sys.stderr)


def shot(frame: Frame, palette: Colours) -> bytes:
    """A PNG file of a frame: its indices and palette, or its colours."""
    return imagefile.png(pixels(frame), palette)
