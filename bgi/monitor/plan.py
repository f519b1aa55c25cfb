"""What is to happen to a program that nobody watches: a picture at some moment, a recording.

`python -m bgi` hands its options on in these variables, so they work without it, too:

    ============  =================================================================
    BGI_KEYS      keys that are "pressed", as in ``1 w Wait2s Esc`` (`bgi.monitor.script`)
    BGI_SHOT      a file for a picture of the screen at the end
    BGI_AFTER     when that is, as in ``2s``, ``2.5`` or ``500ms``; unset: when the
                  program closes the screen, or ends
    BGI_RECORD    a file for a recording of everything
    ============  =================================================================
"""

import contextlib
import math
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.monitor.picture import shot
from bgi.monitor.recorder import missing
from bgi.monitor.script import Press, parse_script, parse_time

written: dict[str, bool] = {}
"""The planned files whose time has come, and whether they were written."""


@dataclass
class Plan:
    """A script of keys; files ("": none) for a picture and a recording; seconds until the end."""

    keys: list[Press] = field(default_factory=list)
    shot: str = ""
    after: float = math.inf
    record: str = ""
    kept: bytes = b""
    """A picture of the graphics screen that was left last."""

    @classmethod
    def from_environment(cls, keys: str | None = None) -> "Plan":
        """The plan that the variables describe, or one with other keys.

        ValueError names a variable that makes no sense, or a word that is not a key; BGIError says
        what is missing for a recording.
        """
        after = os.environ.get("BGI_AFTER", "")
        try:
            seconds = parse_time(after) if after else math.inf
        except ValueError as error:
            raise ValueError(f"BGI_AFTER: {error}") from None
        shot, record = (os.environ.get(name, "") for name in ("BGI_SHOT", "BGI_RECORD"))
        if record and (reason := missing()):
            raise BGIError(reason)
        script = os.environ.get("BGI_KEYS", "") if keys is None else keys
        shot, record = (file and os.path.abspath(file) for file in (shot, record))
        return cls(parse_script(script), shot, seconds, record)

    def keep(self, card: Card) -> None:
        """Remember what is on show, for a program that writes nothing on its text screen later."""
        frame = card.frame() if self.shot else None
        if frame is not None:
            self.kept = shot(frame, card.colors())

    def take_shot(self, card: Card) -> None:
        """Write the picture that is planned, once."""
        frame = card.frame() if self.shot else None
        if frame is not None:
            file, self.shot = self.shot, ""
            blank = frame.text is not None and not frame.pixels[::2].strip(b"\0 ")
            with saving(file):
                picture = self.kept if blank and self.kept else shot(frame, card.colors())
                with open(file, "wb") as opened:
                    opened.write(picture)


@contextlib.contextmanager
def saving(file: str) -> Iterator[None]:
    """Write a planned file; if that fails one line says why: to close a screen must not fail."""
    failure = ""
    try:
        yield
    except OSError as error:
        failure = error.strerror or str(error)
    note(file, failure)


def note(file: str, failure: str = "") -> None:
    """Remember that a planned file was written, or say in one line what kept it from being."""
    written[file] = not failure
    if failure:
        print(f"bgi: {file} was not written: {failure}", file=sys.stderr)
