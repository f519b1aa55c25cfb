"""A monitor without a screen: for tests, and for machines that have no display.

Its keys come from a script and its clock is a number, so a program with pauses and questions runs
through at once and the same way every time. Whatever takes time on a real screen moves the clock: a
pause, a picture, and a little every question that is answered with no.
"""

import math
import sys
import time

from bgi.errors import BGIError, WindowClosed
from bgi.memory.card import Card
from bgi.monitor.keyboard import KeyQueue
from bgi.monitor.plan import Plan, or_say_why
from bgi.monitor.pointer import Mouse
from bgi.monitor.recorder import Recorder

# Milliseconds that it takes ...
PICTURE = 1000 / 60  # to show a picture
KEY = 250  # to press a key that the program waits for
QUESTION = 0.1  # to ask whether there is a key, or what time it is


class Headless:
    """Shows nothing; counts what it was asked for.

    `plan` is by default that of the environment, `keys` a script instead of its keys. `shown`
    counts the calls of show(), `now` the milliseconds passed; `sounds` holds when which pitch
    began to play. What the plan wants to see is looked up on `card`.
    """

    def __init__(
        self,
        keys: str | None = None,
        title: str = "",
        card: Card | None = None,
        plan: Plan | None = None,
    ) -> None:
        self.shown = 0
        self.now = 0.0
        self.title = title
        self.sounds: list[tuple[float, int]] = []
        self.mouse = Mouse(lambda *message: None)
        self.keys = KeyQueue(limit=sys.maxsize)
        self._began = time.time()
        self._card = card
        self._plan = plan or Plan.from_environment(keys)
        self._recorder = Recorder(self._plan.record) if self._plan.record else None
        self._recorded: tuple[float, object] = (-PICTURE, None)  # the last picture, and when it was
        self._expected = False  # whether the program knows that a key waits
        self._over: WindowClosed | None = None
        self.keys.load(self._plan.keys)
        self.keys.close(
            BGIError(
                "there is no window to type in and no scripted key is left; "
                'give keys in the variable BGI_KEYS, as in BGI_KEYS="1 w Left Esc"'
            )
        )

    def show(self) -> None:
        """Count one picture."""
        self.shown += 1
        self._pass(PICTURE)

    def key_waiting(self) -> bool:
        """Whether the script goes on."""
        self._expected = self.keys.waiting()
        self._pass(0 if self._expected else QUESTION)
        return self._expected

    def read_key(self) -> int:
        """The script's next byte; at its end BGIError, or WindowClosed where an end is planned."""
        self._wait_for_key()
        code = self.keys.get()
        self._expected = self.keys.half()
        return code

    def read_keystroke(self) -> bytes:
        """The script's next keystroke."""
        self._wait_for_key()
        self._expected = False
        return self.keys.take()

    def _wait_for_key(self) -> None:
        if not self.keys.waiting() and self._plan.after < math.inf:
            self._pass(math.inf)
        self._pass(0 if self._expected else KEY)

    def sound(self, hertz: int) -> None:
        """Remember when which pitch began."""
        self._pass(0)
        self.sounds.append((self.now, hertz))

    def time(self) -> float:
        """The time, in seconds since 1970, if the program had begun when it did."""
        self._pass(QUESTION)
        return self._began + self.now / 1000

    def sleep(self, milliseconds: float) -> None:
        """Move the clock on."""
        self._pass(max(0.0, milliseconds))

    def set_title(self, title: str) -> None:
        """Remember the title."""
        self.title = title

    def close(self) -> None:
        """Write the picture and the recording that are planned; once."""
        if self._card is not None:
            self._record(self._card)
            self._plan.take_shot(self._card)
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            with or_say_why(recorder.file):
                recorder.save(self.now / 1000)

    def _pass(self, milliseconds: float) -> None:
        """Let time pass, and the end come."""
        if self._over is not None:
            raise self._over.with_traceback(None)
        due = self.now + milliseconds - self._recorded[0] >= PICTURE
        if due and self._card is not None:
            self._record(self._card)
        end = 1000 * self._plan.after
        self.now = min(self.now + milliseconds, end)
        if self.now >= end:
            self.close()
            self._over = WindowClosed(f"{self._plan.after:g} seconds are over, as planned")
            raise self._over

    def _record(self, card: Card) -> None:
        frame = card.frame() if self._recorder else None
        if self._recorder is None or frame is None:
            return
        palette = card.palette.tobytes()
        if (frame, palette) != self._recorded[1]:
            self._recorder.add(self.now / 1000, frame, palette)
        self._recorded = self.now, (frame, palette)
