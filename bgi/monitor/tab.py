"""The monitor inside a browser, where Python itself runs in a page: that page is the screen.

The program has a worker of the page for itself. What it draws goes to the page as the web monitor's
pictures (`bgi.monitor.web.updates`), and what is done there comes back in the same words
(`bgi.monitor.web.words`), each line with the window's number before it. In between stands the
page's JavaScript, the module `bgi_port` (tools/site/page/port.js):

==========================  ================================================================
``send(window, bytes)``     a message of bytes
``tell(window, word, rest)``  a message of text
``wait(milliseconds)``      return when the page has said something, or after that time; where a
                            page cannot share memory, a promise of that
``news()``                  the lines that the page has said
``stopped()``               whether the program is to end, where no signal says so
==========================  ================================================================

Drawing knows nothing of it. While a program draws and asks for nothing, the page has it interrupted
sixty times a second, by a signal, to look at the card.
"""

import math
import signal
import sys
import time
from collections.abc import Callable
from itertools import count
from typing import Any

import bgi_port as port
from pyodide.ffi import run_sync

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.monitor import art
from bgi.monitor.idling import REST_SECONDS, Idling
from bgi.monitor.keyqueue import KeyQueue
from bgi.monitor.letters import at_moment
from bgi.monitor.pace import FACTS_SECONDS
from bgi.monitor.pointer import Event, Mouse
from bgi.monitor.protocol import TITLE
from bgi.monitor.web.pageinputs import PageInputs
from bgi.monitor.web.updates import Still, between, board_message
from bgi.monitor.web.words import understood

FRAME_SECONDS = 1 / 60
END_SECONDS = 0.5
"""At most, for the page to show the last picture: a page that nobody sees shows none."""
LONG = 0.1
"""Seconds of a wait, in pieces: what blinks is to be seen."""

_open: dict[int, "Tab"] = {}
"""The program's windows by their numbers."""


class TabMouse(Mouse):
    """A mouse whose handlers are called at once: a page's Python has no threads."""

    def _dispatch(self, event: Event) -> None:
        self._serve_one(event)


class Tab:
    """The monitor that is the page itself. One `beside` has the same keyboard."""

    def __init__(self, card: Card, title: str = TITLE, beside: object = None) -> None:
        self._card = card
        self.describe: Callable[[], list[str]] = list
        neighbour = beside if isinstance(beside, Tab) else None
        self._keys: KeyQueue = neighbour._keys if neighbour else KeyQueue()
        self._number = next(number for number in count() if number not in _open)
        self._idling = Idling(card)
        self._inputs = PageInputs(self._take, self._size, lambda x, y: None)
        self._mouse = TabMouse(self._tell)
        self._seen: tuple[object, ...] = ()
        self._picture: Still | None = None
        self._sent = self._shown = 0
        self._busy = False  # sending: a signal comes between any two instructions
        self._board_due = math.inf  # when the board is to be shown
        self._closed = False
        _open[self._number] = self
        if sys.platform != "win32":  # where there are no signals of this kind, nor pages
            signal.signal(signal.SIGUSR1, _look_at_all)
        self._tell("open")
        self._tell("shape")
        self.set_title(title)
        self._send_picture()

    # Pictures

    def show(self) -> None:
        """Return when the visible page, as it is now, has been shown."""
        self._check()
        self._send_picture()
        self._await_page()

    def _await_page(self, seconds: float = math.inf) -> None:
        """Wait until the page has shown what was sent."""
        wanted, end = self._sent, time.monotonic() + seconds
        while self._shown < wanted and time.monotonic() < end:
            _wait(LONG)

    def flip(self) -> None:
        """Nothing: the page has the card looked at."""
        self._check()
        _turn()

    def keep_picture(self) -> None:
        """Nothing: no picture is planned here."""

    def look(self) -> None:
        """Show what is on the card, if it is not on show already."""
        frame = self._card.frame()
        if frame is None or self._busy:
            return
        now = at_moment(frame, time.monotonic()), self._card.colors()
        if now != self._seen and self._shown == self._sent:
            self._send_picture()
        if time.monotonic() >= self._board_due:
            self._board_due = time.monotonic() + FACTS_SECONDS
            self._send_board()

    def _send_picture(self) -> None:
        frame = self._card.frame()
        if frame is None:
            return
        self._busy = True
        frame, palette = at_moment(frame, time.monotonic()), self._card.colors()
        self._seen = frame, palette
        picture = Still(frame, palette)
        for message in between(self._picture, picture):
            port.send(self._number, message)
        self._picture = picture
        self._sent += 1
        self._busy = False

    def _send_board(self) -> None:
        frame = self._card.frame()
        if frame is not None:
            from bgi.monitor.board import board  # late: few programs show it

            self._busy = True
            frame = at_moment(frame, time.monotonic())
            picture = board(self._card, frame, self._card.colors(), self.describe())
            port.send(self._number, board_message(picture))
            self._busy = False

    def _size(self) -> tuple[int, int]:
        if self._picture is None:
            return 640, 480
        width, height, *_ = self._picture.shape
        return width, height

    # Keys and mouse

    def key_waiting(self) -> bool:
        """Whether `read_key` would return at once; rests a moment if nothing else is done."""
        self._check()
        _turn()
        if not self._keys.waiting() and self._idling.count_question():
            _wait(REST_SECONDS)
        return self._keys.waiting()

    def read_key(self) -> int:
        """Wait for a key and return its code; keys without a character are 0, then a scan code."""
        self._wait_for_key()
        return self._keys.get(self._check)

    def read_keystroke(self) -> bytes:
        """Wait for a key and return all of it, one byte or two."""
        self._wait_for_key()
        return self._keys.take(self._check)

    def _wait_for_key(self) -> None:
        self._check()
        _listen()
        while not self._keys.waiting():
            _look_at_all()
            _wait(LONG)

    @property
    def keys(self) -> KeyQueue:
        """The program's keyboard: the keys that wait, and those that are down."""
        self._question()
        return self._keys

    @property
    def mouse(self) -> Mouse:
        """The mouse over the page."""
        self._question()
        return self._mouse

    def _question(self) -> None:
        """Hear what is new, with a rest now and then if the program does nothing but ask."""
        self._check()
        _turn()
        if self._idling.count_question():
            _look_at_all()
            _wait(REST_SECONDS)

    def hear(self, message: str) -> None:
        """Take note of something that the page says."""
        word, numbers, texts = understood(message)
        match word:
            case "shown":
                self._shown += 1
            case "down":
                self._inputs.press(numbers[0], *texts)
            case "up":
                self._inputs.release(numbers[0], *texts)
            case "blur":
                self._inputs.let_go()
            case "mouse":
                self._inputs.point(*numbers)
            case "wheel":
                self._inputs.roll(*numbers)
            case "board":
                self._board_due = time.monotonic() if numbers[0] else math.inf

    def _take(self, word: str, *arguments: Any) -> bool:
        """What the inputs have made of it, as `bgi.monitor.protocol` has it."""
        match word, arguments:
            case "key", _:
                self._keys.put(bytes(arguments))
            case "held", (shifts, *names):
                self._keys.hold(self, shifts, frozenset(names))
            case "mouse", _:
                self._mouse.hear(*arguments)
            case "wheel", (clicks,):
                self._mouse.roll(clicks)
        return True

    # Time and sound

    def sound(self, hertz: int) -> None:
        """Play a pitch from now on; 0 is silence."""
        self._check()
        self._tell("sound", hertz)

    def time(self) -> float:
        """The time, in seconds since 1970."""
        self._question()
        return time.time()

    def sleep(self, milliseconds: float) -> None:
        """Let that time pass."""
        self._check()
        end = time.monotonic() + milliseconds / 1000
        _look_at_all()
        while (left := end - time.monotonic()) > 0:
            _wait(min(left, LONG))
            _look_at_all()

    # The window

    def set_title(self, title: str) -> None:
        """Name the window."""
        self._check()
        self._tell("title", title)

    def magnify(self, times: int, follows: str) -> None:
        """Show a part enlarged, 0 times for none, around the `mouse` or the last `pixels` set."""
        self._check()
        self._tell("lens", times, follows)

    def notebook_html(self) -> str:
        """Nothing: there the picture is shown."""
        return ""

    def linger(self) -> None:
        """Nothing: what is on the page stays there."""

    def close(self) -> None:
        """Leave the last picture on the page; a second time does nothing. Never raises."""
        if not self._closed:
            self._closed = True
            self._send_picture()
            self._send_board()  # whoever looks at what was drawn may ask for it
            self._await_page(END_SECONDS)
            self._keys.hold(self, 0, frozenset())
            self._tell("close")
            del _open[self._number]

    def _check(self) -> None:
        if self._closed:
            raise BGIError("the window has been closed by the program")

    def _tell(self, word: str, *arguments: object) -> None:
        if word == "shape" and not arguments:
            arguments = (0, 0, *art.to_masks(art.ARROW))
        if word == "limits":
            self._inputs.limit(*(int(str(number)) for number in arguments))
        port.tell(self._number, word, " ".join(map(str, arguments)))


def _look_at_all(*signal: object) -> None:
    """Hear and show what is new (called by the page's signal, too: at any moment)."""
    _listen()
    for tab in [*_open.values()]:
        tab.look()


_listening = False


def _listen() -> None:
    global _listening
    if _listening:  # a signal has come in between
        return
    _listening = True
    try:
        for line in port.news().splitlines():
            number, _, message = line.partition(" ")
            tab = _open.get(int(number))
            if tab is not None:
                tab.hear(message)
    finally:
        _listening = False


def _wait(seconds: float) -> None:
    """Wait for the page to say something, but not longer than that, and hear it."""
    _until(port.wait(1000 * seconds))
    _listen()


_turned = 0.0


def _turn() -> None:
    """Let the page have its turn, where it has none by itself: it cannot share memory."""
    global _turned
    if port.shared:
        _listen()
    elif time.monotonic() - _turned > FRAME_SECONDS:
        _look_at_all()
        _wait(0)
        _turned = time.monotonic()


def _until(promise: object) -> None:
    if promise is not None:
        run_sync(promise)
    if port.stopped():
        raise KeyboardInterrupt
