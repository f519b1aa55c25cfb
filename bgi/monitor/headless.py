"""A monitor without a screen: for tests, and for machines that have no display.

Its keys come from a script and its clock is a number, so a program with pauses and questions runs
through at once and the same way every time. Whatever takes time on a real screen moves the clock: a
pause, a picture, and a little every question.
"""

import contextlib
import math
import os
import sys
import threading
import time
from collections.abc import Callable

from bgi.errors import BGIError, NobodyThere, TimeIsUp
from bgi.memory.card import Card
from bgi.monitor import moment
from bgi.monitor.idling import REST_SECONDS, Idling
from bgi.monitor.keyqueue import KeyQueue
from bgi.monitor.letters import spoken
from bgi.monitor.plan import Plan, saving
from bgi.monitor.pointer import Mouse
from bgi.monitor.recorder import Recorder
from bgi.monitor.timeline import Timeline
from bgi.monitor.waiting import Waiting

# Milliseconds that it takes ...
PICTURE = 1000 / 60  # to show a picture
KEY = 250  # to press a key that the program waits for
QUESTION = moment.QUESTION  # to ask whether there is a key, where the mouse is, or the time

# A planned end comes in real time, too, for a program that sleeps by itself as in time.sleep(). One
# that is busy has more: it may be computing a picture.
LOOK_SECONDS = 0.05  # from one look at the program to the next
ASLEEP = 0.1  # of a processor at most
BUSY_TIMES, BUSY_SECONDS = 10, 30  # its share of real time, and the least


class Headless:
    """Shows nothing; counts what it was asked for.

    `plan` is by default that of the environment, `keys` a script instead of its keys. `shown`
    counts the pictures, `now` the milliseconds passed; `sounds` holds when which pitch began to
    play. What the plan wants to see is looked up on `card`. `on_lost` is called with the error that
    every call raises once the planned end has come. Another one `beside` has the same
    keyboard and the same time.
    """

    def __init__(
        self,
        keys: str | None = None,
        title: str = "",
        card: Card | None = None,
        plan: Plan | None = None,
        on_lost: Callable[[BGIError], None] = lambda error: None,
        beside: object = None,
    ) -> None:
        self.shown = 0
        self.title = title
        self.describe: Callable[[], list[str]] = list
        self.sounds: list[tuple[float, int]] = []
        self._mouse = Mouse(lambda *message: None)
        self._owner = os.getpid()
        self._began = moment.now()
        self._card = card
        self._idling = Idling(card) if card is not None else None
        self._waiting = Waiting(card) if card is not None else None
        self._plan = plan or Plan.from_environment(keys)
        neighbour = beside if isinstance(beside, Headless) else None
        self._time: Timeline = neighbour._time if neighbour else Timeline(self._plan.keys)
        self._keys = self._time.keys
        self._recorder = Recorder(self._plan.record) if self._plan.record else None
        self._recorded: tuple[float, object] = (-PICTURE, None)  # the last picture, and when it was
        self._expected = False  # whether the program knows that a key waits
        self._on_lost = on_lost
        self._over: TimeIsUp | None = None
        self._closed = threading.Event()
        if self._plan.after < math.inf:
            threading.Thread(target=self._watch, name="bgi end", daemon=True).start()

    @property
    def now(self) -> float:
        """The milliseconds passed."""
        return self._time.now

    def show(self) -> None:
        """Count one picture."""
        self._wait_for_time(PICTURE)
        self.shown += 1
        self._pass(PICTURE)

    def flip(self) -> None:
        """Count one picture."""
        self.show()

    def keep_picture(self) -> None:
        """Remember what is on show for the picture that is planned."""
        if self._card is not None:
            self._plan.keep(self._card)

    def key_waiting(self) -> bool:
        """Whether the script goes on."""
        self._expected = waiting = self._keys.waiting()
        self._pass_until(self._time.now if waiting else self._time.now + QUESTION)
        if not waiting:
            self._rest_in_vain()
        return waiting

    def read_key(self) -> int:
        """The script's next byte; at its end NobodyThere, or TimeIsUp where an end is planned."""
        self._wait_for_key()
        code = self._keys.get(_nobody)
        self._expected = self._keys.half()
        return code

    def read_keystroke(self) -> bytes:
        """The script's next keystroke."""
        self._wait_for_key()
        self._expected = False
        return self._keys.take(_nobody)

    def _wait_for_key(self) -> None:
        if self._keys.waiting():
            self._pass(0 if self._expected else KEY)
        else:  # it comes later, or the end does, or neither
            later = min(self._time.next_key(), 1000 * self._plan.after)
            self._pass_until(later if later < math.inf else self.now)

    def _rest_in_vain(self) -> None:
        """Let a program rest that asks only for what never comes: keys, clicks, nor an end."""
        never = self._plan.after == math.inf == self._time.next_key()
        if not never or self._idling is None or self._waiting is None:
            return
        if self._idling.count_question():
            time.sleep(REST_SECONDS)
            self._waiting.rest()
        if self._waiting.is_endless():
            raise NobodyThere(
                "the program waits for a key or the mouse, but nobody is there, for there is no "
                'window; to script keys: BGI_KEYS="1 w Left Esc", to plan an end: BGI_AFTER=2s'
            )

    def _wait_for_time(self, milliseconds: float = 0) -> None:
        """The program asks for time, or lets some pass: that does come."""
        if self._idling is not None and self._waiting is not None:
            self._idling.begin_anew()
            self._waiting.delay(milliseconds)

    @property
    def keys(self) -> KeyQueue:
        """The program's keyboard: the keys that wait, and those that are down."""
        self._pass(QUESTION)
        self._rest_in_vain()
        return self._keys

    @property
    def mouse(self) -> Mouse:
        """A mouse that nobody moves."""
        self._pass(QUESTION)
        self._rest_in_vain()
        return self._mouse

    def sound(self, hertz: int) -> None:
        """Remember when which pitch began."""
        self._pass(0)
        self.sounds.append((self.now, hertz))

    def time(self) -> float:
        """The time, in seconds since 1970, if the program had begun when it did."""
        self._wait_for_time()
        self._pass(QUESTION)
        return self._began + self.now / 1000

    def sleep(self, milliseconds: float) -> None:
        """Move the clock on."""
        self._wait_for_time(milliseconds)
        self._pass(max(0.0, milliseconds))

    def set_title(self, title: str) -> None:
        """Remember the title."""
        self.title = title

    def notebook_html(self) -> str:
        """Nothing: a notebook shows a picture."""
        return ""

    def magnify(self, times: int, follows: str) -> None:
        """Nobody is there to look."""

    def linger(self) -> None:
        """Print what stands on the text screen: the terminal is all that there is to read it on."""
        words = spoken(self._card.frame()) if self._card is not None else ""
        terminal = sys.__stdout__
        if words and terminal is not None:
            known = words.encode(terminal.encoding, "replace").decode(terminal.encoding)
            with contextlib.suppress(OSError, ValueError):  # it may be closed
                print(known, end="", file=terminal, flush=True)

    def close(self) -> None:
        """Write the picture and the recording that are planned; once."""
        if os.getpid() != self._owner:
            return  # a forked copy of the program
        self._closed.set()
        if self._card is not None:
            self._record()
            self._plan.take_shot(self._card)
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            with saving(recorder.file):
                recorder.save(self.now / 1000)

    # The end

    def _pass(self, milliseconds: float) -> None:
        """Let time pass, and the end come."""
        self._pass_until(self._time.now + milliseconds)

    def _pass_until(self, then: float) -> None:
        if self._over is not None:
            raise self._over.with_traceback(None)
        if self._recorder is not None and then - self._recorded[0] >= PICTURE:
            self._record()
        end = 1000 * self._plan.after
        self._time.move_to(then if then < end else end)
        if then >= end:
            raise self._end()

    def _end(self) -> TimeIsUp:
        self.close()
        self._over = TimeIsUp(self._plan.after)
        self._on_lost(self._over)
        return self._over

    def _watch(self) -> None:
        """Bring the end of a program that hardly asks for anything which moves the clock."""
        asleep, began, used = 0.0, time.monotonic(), time.process_time()
        while not self._closed.wait(LOOK_SECONDS):
            before, used = used, time.process_time()
            if used - before < ASLEEP * LOOK_SECONDS:
                asleep += LOOK_SECONDS
            busy = time.monotonic() - began > max(BUSY_TIMES * self._plan.after, BUSY_SECONDS)
            if busy or asleep > self._plan.after:
                self._end()

    def _record(self) -> None:
        if self._recorder is None or self._card is None:
            return
        frame, palette = self._card.frame(), self._card.colors()
        if frame is None:
            return
        if (frame, palette) != self._recorded[1]:
            self._recorder.add(self.now / 1000, frame, palette)
        self._recorded = self.now, (frame, palette)


def _nobody() -> None:
    """No key will come."""
    raise NobodyThere(
        "nobody can press a key here, for there is no window; "
        'to script some: BGI_KEYS="1 w Left Esc"'
    )
