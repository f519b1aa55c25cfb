"""The web monitor's process: it looks at the card as the window's does, and shows it to pages.

`bgi.monitor.process` starts it. It goes when the program goes: at the end of its input, or when it
finds itself adopted by another process.
"""

import asyncio
import os
import signal
import sys
import threading
import time
from collections.abc import Callable

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.monitor import art
from bgi.monitor.letters import at_moment
from bgi.monitor.pace import FACTS_SECONDS, IDLE_AFTER, IDLE_FRAME, LATE, frame_seconds
from bgi.monitor.protocol import encode, receive, take_pipes
from bgi.monitor.recorder import Recorder
from bgi.monitor.web.audience import Audience
from bgi.monitor.web.guard import Guard
from bgi.monitor.web.pageinputs import PageInputs
from bgi.monitor.web.updates import Still, board_message
from bgi.monitor.web.webserver import WebServer, asked_address, asked_port, shown_address
from bgi.monitor.web.words import Said

_ARROW = " ".join(map(str, (0, 0, *art.to_masks(art.ARROW))))

LINGER = 60  # seconds at most, to finish a recording


class WebChild:
    """What the program says goes to the pages, what is done there to the program."""

    def __init__(self, card: Card, output: int) -> None:
        self._card = card
        self._output = output
        self._loop = asyncio.get_running_loop()
        self._over = asyncio.Event()
        self._parent = os.getppid()
        self._inputs = PageInputs(self._send, self._size, self._point)
        self._audience = Audience(self._hear, self._inputs.let_go, self._count, self._close)
        self._audience.tell("shape", _ARROW)
        self._recorder: Recorder | None = None
        self._seen: tuple[object, ...] = ()
        self._size_seen = 640, 480
        self._presents = 0
        self._asked = ""  # the number of the picture the program waits for
        self._frame = frame_seconds()
        self._free = 0.0  # no picture before this moment
        self._facts_due = 0.0  # when the program is to be asked about its screen
        self._lively = self._loop.time()  # when something has happened last
        self._timer = self._loop.call_later(0, self._look)
        self._reactions: dict[str, Callable[..., None]] = {
            "down": self._inputs.press,
            "up": self._inputs.release,
            "blur": self._inputs.let_go,
            "mouse": self._inputs.point,
            "wheel": self._inputs.roll,
            "close": self._close,
        }

    async def run(self) -> None:
        """Serve until the program ends or its user closes it."""
        try:
            address = asked_address()
            guard = Guard.from_environment(address)
            port = await WebServer(guard, self._audience.admit).listen(address, asked_port())
        except (OSError, ValueError) as error:
            self._send("failed", error)
            return
        reach = "wide" if guard.wide else "local"
        self._send("address", shown_address(address), port, guard.token, reach)
        self._send("ready")
        await self._over.wait()
        self._timer.cancel()
        self._show_page()  # what has been drawn last
        await self._audience.close()
        self._save()

    # What the program says

    def obey(self, word: str, rest: str) -> None:
        """Carry out what the program says."""
        self._stir()
        match word:
            case "show":
                self._asked = rest
                self._look_at(self._free)
            case "title" | "sound" | "pointer" | "move" | "lens":
                self._audience.tell(word, rest)
            case "shape":
                self._audience.tell(word, rest or _ARROW)
            case "limits":
                self._inputs.limit(*map(int, rest.split()))
                self._audience.tell(word, rest)
            case "facts":
                self._show_board(rest)
            case "record":
                self._record(rest)

    def end(self) -> None:
        """The program has ended."""
        self._over.set()

    # Pictures

    def _stir(self) -> None:
        """Something happens: look soon, however idle it was."""
        self._lively = self._loop.time()
        if self._timer.when() > self._lively + self._frame:
            self._look_at(self._lively + self._frame)

    def _look_at(self, when: float) -> None:
        self._timer.cancel()
        self._timer = self._loop.call_at(when, self._look)

    def _look(self) -> None:
        """Look at the card, answer a program that waits, and decide when to look again."""
        if os.getppid() != self._parent:
            self.end()
            return
        start = self._loop.time()
        self._ask_for_facts(start)
        changed = self._show_page()
        if changed:
            self._presents += 1
        if changed or self._asked:
            self._lively = start
        # If the program does not read, its pipe is full: then it learns of it next time.
        if self._asked and self._send("shown", self._asked, self._presents):
            self._asked = ""
        idle = start - self._lively > IDLE_AFTER
        self._free = max(self._free + self._frame, start + self._frame - LATE)
        self._look_at(start + IDLE_FRAME if idle else self._free)

    def _show_page(self) -> bool:
        """Show the pages what is on the card, if it has changed."""
        if not self._audience and self._recorder is None:
            self._seen = ()
            return bool(self._asked)
        frame, palette = self._card.frame(), self._card.colors()
        if frame is None:
            return False
        now = self._loop.time()
        frame = at_moment(frame, now)
        if (frame, palette) == self._seen:
            return False
        self._seen = frame, palette
        self._size_seen = frame.width, frame.height
        self._audience.show(Still(frame, palette))
        if self._recorder is not None:
            self._recorder.add(now, frame, palette)
        return True

    # The board

    def _ask_for_facts(self, now: float) -> None:
        if self._audience.wants_board and now >= self._facts_due:
            self._facts_due = now + FACTS_SECONDS
            self._send("facts")

    def _show_board(self, facts: str) -> None:
        from bgi.monitor.board import board  # late: most pages never show it

        if (frame := self._card.frame()) is not None:
            frame = at_moment(frame, self._loop.time())
            picture = board(self._card, frame, self._card.colors(), facts.splitlines())
            self._audience.show_board(board_message(picture))

    def _size(self) -> tuple[int, int]:
        return self._size_seen

    # Recording

    def _record(self, file: str) -> None:
        try:
            self._recorder = Recorder(file)
        except BGIError as error:
            print(f"bgi: {error}", file=sys.stderr, flush=True)
        else:
            self._send("recording")

    def _save(self) -> None:
        if self._recorder is not None:
            failure = ""
            try:
                self._recorder.save(self._loop.time())
            except OSError as error:
                failure = error.strerror or str(error)
            self._send("recorded", failure)

    # What pages say

    def _hear(self, said: Said) -> None:
        word, numbers, texts = said
        self._stir()
        self._reactions[word](*numbers, *texts)

    def _point(self, x: int, y: int) -> None:
        self._audience.tell_others("move", f"{x} {y}")

    def _count(self, pages: int) -> None:
        self._stir()
        self._send("pages", pages)

    def _close(self) -> None:
        self._send("closed")
        self._over.set()

    def close_politely(self) -> None:
        """Somebody has asked the process to end."""
        self._loop.call_soon_threadsafe(self._close)

    def _send(self, word: str, *arguments: object) -> bool:
        """Tell the program; False if it does not read: that must not stop the pages, too."""
        try:
            os.write(self._output, encode(word, *arguments))
        except BlockingIOError:
            return False
        except OSError:
            self._over.set()  # the program is gone
        return True


def _listen(told: int, child: WebChild, loop: asyncio.AbstractEventLoop) -> None:
    """Hand the program's messages on, and end with the program in any case."""
    for message in receive(told):
        loop.call_soon_threadsafe(child.obey, *message)
    loop.call_soon_threadsafe(child.end)
    time.sleep(LINGER)
    os._exit(0)


async def _serve(card: Card, told: int, output: int) -> None:
    child = WebChild(card, output)
    signal.signal(signal.SIGTERM, lambda number, frame: child.close_politely())
    loop = asyncio.get_running_loop()
    threading.Thread(target=_listen, args=[told, child, loop], daemon=True).start()
    await child.run()


def main() -> None:
    """Show the card that the command line names."""
    told, output = take_pipes()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C belongs to the program
    handle, _ = sys.argv[1:]
    try:
        card = Card.attach(handle)
    except ValueError as error:
        os.write(output, encode("failed", error))
        return
    asyncio.run(_serve(card, told, output))
    os._exit(0)  # at once, whatever threads do
