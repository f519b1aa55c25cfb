"""The program's side of the window: starts the child process and talks to it through two pipes.

A thread listens to the child. When the window is lost it wakes whatever waits, and from then on
every call raises.
"""

import contextlib
import math
import os
import subprocess
import threading
import time
from collections.abc import Callable

from bgi.errors import BGIError, TimeIsUp, WindowClosed
from bgi.memory.card import CELL_BYTES, Card, Frame
from bgi.memory.sdl import FOUND
from bgi.monitor import moment
from bgi.monitor.idling import REST_SECONDS, Idling
from bgi.monitor.keyqueue import PIECE_SECONDS, KeyQueue
from bgi.monitor.plan import Plan, note, written
from bgi.monitor.pointer import Mouse
from bgi.monitor.process import start
from bgi.monitor.protocol import TITLE, encode, receive
from bgi.monitor.script import play

START_SECONDS = 60  # the very first import of pygame on a slow disk takes long
END_SECONDS = 1
SAVE_SECONDS = 60  # the same, where a recording is still to be written


class Window:
    """The monitor that is a window; it is open when the constructor returns.

    `on_lost` is called once, from another thread, with the error that every call raises from then
    on. A window `beside` has the same keyboard. Raises BGIError when the window cannot be opened.
    """

    child = "bgi.monitor.child"
    """The module that its process runs."""
    noun = "window"
    """What messages call it."""

    def __init__(
        self,
        card: Card,
        title: str = TITLE,
        on_lost: Callable[[BGIError], None] = lambda error: None,
        plan: Plan | None = None,
        beside: object = None,
    ) -> None:
        if reason := self.missing():
            raise BGIError(reason)
        self._card = card
        self._plan = plan or Plan()
        self.presents = 0  # how many pictures the window has put on the screen
        self._on_lost = on_lost
        self.describe: Callable[[], list[str]] = list
        self._read: Frame | None = None  # the text screen at the last key
        self._owner = os.getpid()
        neighbour = beside if isinstance(beside, Window) else None
        self._keys: KeyQueue = neighbour._keys if neighbour else KeyQueue()
        self._ahead = moment.now() - time.time()  # of the clock on the wall
        self._idling = Idling(card)
        self._mouse = Mouse(self._send)
        self._news = threading.Condition()
        self._error: BGIError | None = None
        self._ready = False
        self._asked = 0
        self._answered = 0
        self._end_seconds = END_SECONDS
        self._process = start(card, self.child)
        assert self._process.stdin and self._process.stdout
        self._input, self._output = self._process.stdin, self._process.stdout
        self._listener = threading.Thread(target=self._listen, name="bgi window", daemon=True)
        self._listener.start()
        try:
            self.set_title(title)
            self._await_opening()
        except BaseException:
            self.close()
            raise
        self._follow_plan()
        if neighbour is None:
            play(self._plan.keys, self._keys)

    @classmethod
    def missing(cls) -> str:
        """What keeps it from opening, in a line that helps; empty if nothing does."""
        return "" if FOUND else "no window: pygame is not installed (pip install pygame)"

    def _await_opening(self) -> None:
        if not self._wait(lambda: self._ready, time.monotonic() + START_SECONDS):
            raise BGIError(f"the {self.noun} did not open within {START_SECONDS} seconds")

    def _follow_plan(self) -> None:
        """Record, and end after some time, if that is planned."""
        if self._plan.record:
            self._end_seconds = SAVE_SECONDS
            self._send("record", self._plan.record)
        if self._plan.after < math.inf:
            clock = threading.Timer(self._plan.after, self._time_is_up)
            clock.daemon = True
            clock.start()

    def _time_is_up(self) -> None:
        with contextlib.suppress(ValueError):  # the program has just closed the card
            self._plan.take_shot(self._card)
        self._lose(TimeIsUp(self._plan.after))

    def show(self) -> None:
        """Return when the visible page, as it is now, has been shown."""
        self._check()
        with self._news:  # sent before any later number: the child answers the last it has read
            self._asked += 1
            number = self._asked
            self._send("show", number)
        self._wait(lambda: self._answered >= number)

    def flip(self) -> None:
        """Nothing: the window looks at the card by itself."""
        self._check()

    def keep_picture(self) -> None:
        """Remember what is on show for the picture that is planned."""
        self._plan.keep(self._card)

    def key_waiting(self) -> bool:
        """Whether `read_key` would return at once; rests a moment if nothing else is done."""
        self._check()
        if not self._keys.waiting() and self._idling.count_question():
            self._keys.wait(REST_SECONDS)
        return self._keys.waiting()

    def read_key(self) -> int:
        """Wait for a key and return its code; keys without a character are 0, then a scan code."""
        self._check()
        code = self._keys.get(self._check)
        self._read = self._text()
        return code

    def read_keystroke(self) -> bytes:
        """Wait for a key and return all of it, one byte or two."""
        self._check()
        keystroke = self._keys.take(self._check)
        self._read = self._text()
        return keystroke

    def _text(self) -> Frame | None:
        """What stands on a text screen."""
        return self._card.frame() if self._card.pixel_bytes == CELL_BYTES else None

    def linger(self) -> None:
        """Wait for a key if something has been written since the last one, and no plan is made."""
        if self._plan == Plan() and self._text() != self._read:
            with contextlib.suppress(BGIError, KeyboardInterrupt):
                self.set_title(f"{self._title} - ended: press a key")
                self._keys.take(self._check)

    @property
    def pid(self) -> int:
        """The number of the window's process."""
        return self._process.pid

    @property
    def keys(self) -> KeyQueue:
        """The program's keyboard: the keys that wait, and those that are down."""
        self._question()
        return self._keys

    @property
    def mouse(self) -> Mouse:
        """The mouse over the window."""
        self._question()
        return self._mouse

    def sound(self, hertz: int) -> None:
        """Play a pitch from now on; 0 is silence."""
        self._check()
        self._send("sound", hertz)

    def time(self) -> float:
        """The time, in seconds since 1970."""
        self._question()
        return time.time() + self._ahead

    def sleep(self, milliseconds: float) -> None:
        """Let that time pass."""
        self._check()
        self._wait(lambda: False, time.monotonic() + milliseconds / 1000)

    def set_title(self, title: str) -> None:
        """Name the window."""
        self._check()
        self._title = title
        self._send("title", title)

    def magnify(self, times: int, follows: str) -> None:
        """Enlarge what is at the `mouse`, or the `pixels` set last; 0: no more."""
        self._check()
        self._send("lens", times, follows)

    def notebook_html(self) -> str:
        """Nothing: a notebook shows a picture."""
        return ""

    def close(self) -> None:
        """Close the window; a second time does nothing. Never raises."""
        if os.getpid() != self._owner:
            return  # a forked copy of the program: the window is not its own
        if self._ready:
            with contextlib.suppress(ValueError):  # the card has been closed already
                self._plan.take_shot(self._card)
        self._lose(BGIError("the window has been closed by the program"), tell=False)
        self._input.close()
        try:
            self._process.wait(self._end_seconds)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if threading.current_thread() is not self._listener:  # it is when on_lost closes
            self._listener.join(END_SECONDS)
        if self._ready and self._plan.record and self._plan.record not in written:
            note(self._plan.record, f"the {self.noun}'s process had ended before")

    def _check(self) -> None:
        if self._error is not None:
            raise self._error.with_traceback(None)
        if os.getpid() != self._owner:
            raise BGIError("the window belongs to the process that opened it, this is a fork of it")

    def _question(self) -> None:
        """Answer at once, with a rest now and then if the program does nothing but ask."""
        self._check()
        if self._idling.count_question():
            self._wait(lambda: False, time.monotonic() + REST_SECONDS)

    def _wait(self, done: Callable[[], bool], until: float = math.inf) -> bool:
        """Wait for news until `done`; False if that takes too long. Raises once lost."""
        with self._news:
            while not done():
                self._check()
                seconds = until - time.monotonic()
                if seconds <= 0:
                    return False
                self._news.wait(min(seconds, PIECE_SECONDS))
        return True

    def _send(self, word: str, *arguments: object) -> None:
        # A child that is gone cannot read; the listening thread finds out and says why.
        with contextlib.suppress(OSError):
            os.write(self._input.fileno(), encode(word, *arguments))

    def _listen(self) -> None:
        with self._output:
            for word, rest in receive(self._output.fileno()):
                self._hear(word, rest)
        status = self._process.wait()
        if status == 0:  # the word that it was closed did not fit into the pipe
            self._lose(WindowClosed(f"the {self.noun} was closed"))
        self._lose(BGIError(f"the {self.noun} process ended unexpectedly (exit status {status})"))

    def _hear(self, word: str, rest: str) -> None:
        match word:
            case "key":
                self._keys.put(bytes(map(int, rest.split())))
            case "shown":
                with self._news:
                    self._answered, self.presents = map(int, rest.split())
                    self._news.notify_all()
            case "mouse":
                self._mouse.hear(*map(int, rest.split()))
            case "wheel":
                self._mouse.roll(int(rest))
            case "held":
                shifts, *names = rest.split()
                self._keys.hold(self, int(shifts), frozenset(names))
            case "facts":
                self._send("facts", "\n".join(self.describe()))
            case "recording":
                self._end_seconds = SAVE_SECONDS
            case "recorded":
                note(self._plan.record, failure=rest)
            case "ready":
                with self._news:
                    self._ready = True
                    self._news.notify_all()
            case "failed":
                self._lose(BGIError(f"no {self.noun}: {rest}"))
            case "closed":
                self._lose(WindowClosed(f"the {self.noun} was closed"))

    def _lose(self, error: BGIError, tell: bool = True) -> None:
        """From now on every call raises `error`; only the first loss counts."""
        with self._news:
            if self._error is not None:
                return
            self._error = error
            self._news.notify_all()
        self._keys.hold(self, 0, frozenset())
        self._keys.wake()
        if tell and self._ready:  # before that the constructor raises it
            self._on_lost(error)
