"""The window: a child process, `python -m bgi.monitor.window HANDLE`, the only pygame.display.

It looks at the card sixty times a second and presents the visible page when it differs from what
is on show, so drawing costs the program nothing. It sends keys, and it goes when the program goes:
at the end of its input, or when it finds itself adopted by another process.
"""

import contextlib
import math
import os
import signal
import sys
import threading
import time
from types import FrameType

import numpy as np

from bgi.card import Card
from bgi.keyboard import encode as encode_key
from bgi.monitor.picture import Shape, fit, largest, surface
from bgi.monitor.protocol import encode, receive
from bgi.sdl import pygame

FRAME = 1 / 60
LATE = 0.002  # a wait rounds up to milliseconds; so much is made good at the next picture
MESSAGE = pygame.USEREVENT


class Screen:
    """The window and what is on show in it; pygame.error if there can be none."""

    def __init__(self, card: Card) -> None:
        self.presents = 0
        self._card = card
        self._shown: object = None
        pygame.display.init()
        if pygame.display.get_driver() == "offscreen":  # SDL's way of saying that nobody will see
            raise pygame.error(f"the display {os.environ.get('DISPLAY', '')!r} cannot be opened")
        self._maximum = largest(*pygame.display.get_desktop_sizes()[0])
        self.set_title("pybgi")
        self._open(Shape(640, 480))
        self.update()

    def set_title(self, title: str) -> None:
        """Name the window; what the desktop could not take is replaced."""
        pygame.display.set_caption(title.replace("\0", " ").encode(errors="replace").decode())

    def update(self) -> bool:
        """Present what the card shows, unless it is on show already; return whether it was not."""
        frame = self._card.frame()
        palette = self._card.palette.tobytes()
        if frame is None or (frame, palette) == self._shown:
            return False
        self._shown = frame, palette
        shape = Shape(frame.width, frame.height, frame.square)
        if shape != self._shape:
            self._open(shape)
        colours = np.frombuffer(palette, np.uint8).reshape(256, 3)
        self._page.blit(surface(frame, colours), (0, 0))
        pygame.transform.scale(self._page, self._window.get_size(), self._window)
        pygame.display.flip()
        self.presents += 1
        return True

    def forget(self) -> None:
        """Something has painted over the window: present again."""
        self._shown = None

    def _open(self, shape: Shape) -> None:
        """Open the window for a mode, or make the open one fit it."""
        self._shape = shape
        size = fit(shape, *self._maximum)
        window = pygame.display.get_surface()
        if window is None or window.get_size() != size:  # else it would only flicker
            window = pygame.display.set_mode(size)
        self._window = window
        self._page = pygame.Surface((shape.width, shape.height), 0, window)


class Child:
    """The main loop: keys to the program, pictures to the screen."""

    def __init__(self, screen: Screen, output: int) -> None:
        self._screen = screen
        self._output = output
        self._parent = os.getppid()
        self._asked = ""  # the number of the picture the program waits for
        self._free = 0.0  # no present before this moment
        self._closed = False

    def run(self) -> None:
        """Run until the user closes the window or the program is gone."""
        while not self._closed and os.getppid() == self._parent:
            self._sleep()
            self._present()
        self._send("closed")

    def _sleep(self) -> None:
        """Wait for an event, at most until it is time to look at the card again."""
        seconds = self._free - time.monotonic() if self._asked else FRAME
        if seconds > 0:
            for event in (pygame.event.wait(math.ceil(seconds * 1000)), *pygame.event.get()):
                self._handle(event)

    def _handle(self, event: pygame.event.Event) -> None:
        if event.type == pygame.KEYDOWN:
            if keystroke := encode_key(event.key, event.mod, event.unicode):
                self._send("key", *keystroke)
        elif event.type == MESSAGE and event.word == "show":
            self._asked = event.rest
        elif event.type == MESSAGE and event.word == "title":
            self._screen.set_title(event.rest)
        elif event.type == pygame.WINDOWEXPOSED:
            self._screen.forget()
        elif event.type == pygame.QUIT:
            self._closed = True

    def _present(self) -> None:
        start = time.monotonic()
        if start < self._free:
            return
        changed = self._screen.update()
        if not changed and not self._asked:
            return
        cost = time.monotonic() - start
        # Where a present is slow, a program that only draws keeps half of the time to itself; one
        # that waits for its picture gets it as soon as can be.
        pause = max(FRAME, cost if self._asked else 2 * cost)
        self._free = max(self._free + pause, start + pause - LATE)
        if self._asked:
            self._send("shown", self._asked, self._screen.presents)
            self._asked = ""

    def _send(self, word: str, *arguments: object) -> None:
        os.write(self._output, encode(word, *arguments))


def _listen() -> None:
    """Turn the program's messages into events, and end with the program."""
    for word, rest in receive(0):
        pygame.event.post(pygame.event.Event(MESSAGE, word=word, rest=rest))
    os._exit(0)


def _ask_to_close(number: int, frame: FrameType | None) -> None:
    pygame.event.post(pygame.event.Event(pygame.QUIT))


def main() -> None:
    """Open the window for the card named on the command line and run it."""
    # The protocol gets a pipe of its own; whatever a library prints goes to the terminal.
    output = os.dup(1)
    os.dup2(2, 1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C belongs to the program
    try:
        child = Child(Screen(Card.attach(sys.argv[1])), output)
    except (pygame.error, ValueError) as error:
        os.write(output, encode("failed", error))
        return
    pygame.key.set_repeat(500, 33)
    signal.signal(signal.SIGTERM, _ask_to_close)
    os.write(output, encode("ready"))
    # Not before SDL is up: its events are the way from this thread to the main loop.
    threading.Thread(target=_listen, daemon=True).start()
    with contextlib.suppress(BrokenPipeError):
        child.run()
    # At once, without SDL's tidying up: the listener may be in the middle of posting an event.
    os._exit(0)


if __name__ == "__main__":
    main()
