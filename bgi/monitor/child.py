"""The window's process (`bgi.monitor.process` starts it): the loop that it lives in.

It looks at the card sixty times a second and presents the visible page when it differs from what
is on show, so drawing costs the program nothing. It sends what the user does, and it goes when the
program goes: at the end of its input, or when it finds itself adopted by another process.
"""

import contextlib
import math
import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.memory.sdl import pygame, twins
from bgi.monitor.display import Display, free_name
from bgi.monitor.inputs import Inputs
from bgi.monitor.letters import at_moment
from bgi.monitor.pace import FACTS_SECONDS, IDLE_AFTER, IDLE_FRAME, LATE, frame_seconds
from bgi.monitor.protocol import encode, receive, take_pipes
from bgi.monitor.recorder import Recorder
from bgi.monitor.speaker import Speaker

# Seconds.
NAP, IDLE_NAP = 0.004, 0.010  # between two looks for events; pygame's own wait looks every 0.001
LINGER = 60  # at most, to finish a recording

Inbox = queue.SimpleQueue[tuple[str, str]]


class Child:
    """The main loop: what the user does goes to the program, pictures to the screen."""

    def __init__(self, card: Card, folder: str, inbox: Inbox, output: int) -> None:
        self._card = card
        self._folder = folder
        self._inbox = inbox
        self._output = output
        self._display = Display(card, folder)
        self._speaker = Speaker()
        self._recorder: Recorder | None = None
        self._planned = ""  # the file that the program asked for
        self._parent = os.getppid()
        self._frame = frame_seconds()
        self._asked = ""  # the number of the picture the program waits for
        self._free = 0.0  # no present before this moment
        self._lively = time.monotonic()  # when something has happened last
        self._over = False
        self._facts_due = math.inf  # when the program is to be asked about its screen
        overlays = self._display.overlays
        self._inputs = Inputs(
            self._display,
            self._send,
            {
                (pygame.K_F11, 0): self._display.toggle_full,
                (pygame.K_RETURN, pygame.KMOD_ALT): self._display.toggle_full,
                (pygame.K_F12, 0): self._display.save,
                (pygame.K_F5, pygame.KMOD_CTRL): self._toggle_recording,
                (pygame.K_F6, pygame.KMOD_CTRL): overlays.enlarge,
                (pygame.K_F7, pygame.KMOD_CTRL): self._toggle_board,
                (pygame.K_F8, pygame.KMOD_CTRL): overlays.follow,
            },
        )
        self._orders: dict[str, Callable[[str], None]] = {
            "show": self._show,
            "title": self._display.set_title,
            "sound": lambda hertz: self._speaker.sound(int(hertz)),
            "pointer": self._inputs.use_pointer,
            "shape": lambda rest: self._display.shape_pointer(*map(int, rest.split())),
            "move": lambda rest: self._inputs.move(*map(int, rest.split())),
            "limits": lambda rest: self._inputs.limit(*map(int, rest.split())),
            "record": self._record_as_planned,
            "notice": self._display.notice,
            "lens": self._use_lens,
            "facts": self._take_facts,
            "close": lambda rest: self._close(),
            "end": lambda rest: self._end(),
        }
        self._events: dict[int, Callable[[], None]] = {
            pygame.QUIT: self._close,
            pygame.WINDOWSIZECHANGED: self._display.resize,
            pygame.WINDOWEXPOSED: self._display.forget,
        }

    def run(self) -> None:
        """Run until the user closes the window or the program is gone."""
        while not self._over and os.getppid() == self._parent:
            self._wait()
            for event in pygame.event.get():
                self._lively = time.monotonic()
                if reaction := self._events.get(event.type):
                    reaction()
                self._inputs.handle(event)
            self._inputs.flush()
            self._ask_for_facts()
            self._present()
            self._display.end_notice()
        self._stop_recording()

    def _wait(self) -> None:
        """Wait for an order, at most until it is time to look for events or at the card again."""
        now = time.monotonic()
        nap = IDLE_NAP if now - self._lively > IDLE_AFTER else NAP
        seconds = min(self._free - now, nap) if self._asked else nap
        with contextlib.suppress(queue.Empty):
            order = self._inbox.get(timeout=max(seconds, 0))
            while True:
                word, rest = order
                if obey := self._orders.get(word):
                    obey(rest)
                self._lively = now
                order = self._inbox.get_nowait()

    def _show(self, number: str) -> None:
        self._asked = number

    def _present(self) -> None:
        start = time.monotonic()
        if start < self._free:
            return
        changed = self._display.update()
        if changed and self._recorder is not None:
            self._record_frame(self._recorder)
        now = time.monotonic()
        if changed or self._asked:
            if self._asked or not self._display.blinked:
                self._lively = now
            # Where a present is slow, a program that only draws keeps half of the time to itself;
            # one that waits for its picture gets it as soon as can be.
            pause = max(self._frame, (now - start) * (1 if self._asked else 2))
        else:
            pause = IDLE_FRAME if now - self._lively > IDLE_AFTER else self._frame
        self._free = max(self._free + pause, start + pause - LATE)
        # If the program does not read, its pipe is full: then it learns of it next time.
        if self._asked and self._send("shown", self._asked, self._display.presents):
            self._asked = ""

    # What lies over the picture

    def _use_lens(self, rest: str) -> None:
        from bgi.monitor.lens import Lens

        times, follows = rest.split()
        self._display.overlays.use_lens(Lens(int(times), follows == "pixels"))

    def _toggle_board(self) -> None:
        self._display.overlays.toggle_board()
        self._facts_due = 0.0 if self._display.overlays.board else math.inf

    def _ask_for_facts(self) -> None:
        if time.monotonic() >= self._facts_due:
            self._facts_due = time.monotonic() + FACTS_SECONDS
            self._send("facts")

    def _take_facts(self, text: str) -> None:
        self._display.overlays.facts = tuple(text.splitlines())

    # Recording

    def _toggle_recording(self) -> None:
        if self._recorder is None:
            self._record("")
        else:
            self._stop_recording()

    def _record_as_planned(self, file: str) -> None:
        self._planned = file
        self._record(file)

    def _record(self, file: str) -> None:
        """Begin to record, into the next free file beside the program if it has no name."""
        try:
            self._recorder = Recorder(file or free_name(self._folder, "gif"))
        except (BGIError, OSError) as error:
            print(f"bgi: {error}", file=sys.stderr, flush=True)
            self._display.notice(str(error))
            return
        self._send("recording")
        self._record_frame(self._recorder)
        self._display.notice("recording", float("inf"))

    def _record_frame(self, recorder: Recorder) -> None:
        frame = self._card.frame()
        if frame is not None:
            now = time.monotonic()
            recorder.add(now, at_moment(frame, now), self._card.colors())

    def _stop_recording(self) -> None:
        """Write the recording in a thread of its own: the window goes on meanwhile."""
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            self._record_frame(recorder)  # what has been drawn last
            threading.Thread(target=self._save, args=[recorder, time.monotonic()]).start()

    def _save(self, recorder: Recorder, now: float) -> None:
        failure = ""
        try:
            recorder.save(now)
        except OSError as error:
            failure = error.strerror or str(error)
        name = os.path.basename(recorder.file)
        self._inbox.put(("notice", f"not saved: {failure}" if failure else f"saved {name}"))
        if recorder.file == self._planned:
            self._send("recorded", failure)

    # The end

    def _close(self) -> None:
        self._send("closed")
        self._over = True

    def _end(self) -> None:
        self._over = True

    def _send(self, word: str, *arguments: object) -> bool:
        """Tell the program; False if it does not read: that must not stop the window, too."""
        try:
            os.write(self._output, encode(word, *arguments))
        except BlockingIOError:
            return False
        except OSError:
            self._over = True  # the program is gone: a broken pipe, on Windows an invalid argument
        return True


def _listen(told: int, inbox: Inbox) -> None:
    """Hand the program's messages on, and end with the program in any case."""
    for message in receive(told):
        inbox.put(message)
    inbox.put(("end", ""))
    time.sleep(LINGER)
    os._exit(0)


def main() -> None:
    """Open the window for the card named on the command line and run it."""
    told, output = take_pipes()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C belongs to the program
    handle, folder = sys.argv[1:]
    inbox: Inbox = queue.SimpleQueue()
    try:
        child = Child(Card.attach(handle), folder, inbox, output)
    except (pygame.error, ValueError) as error:
        os.write(output, encode("failed", "; ".join(filter(None, (str(error), twins())))))
        return
    pygame.key.set_repeat(500, 33)
    signal.signal(signal.SIGTERM, lambda number, frame: inbox.put(("close", "")))
    os.write(output, encode("ready"))
    threading.Thread(target=_listen, args=[told, inbox], daemon=True).start()
    child.run()
    for thread in threading.enumerate():  # a recording that is being written
        if not thread.daemon and thread is not threading.main_thread():
            thread.join(LINGER)
    # At once, without tidying up: SDL's threads may be anywhere.
    os._exit(0)
