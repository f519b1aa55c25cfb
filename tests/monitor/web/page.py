"""A page without a browser: it says and shows what ours does, by the library's client."""

import contextlib
import struct
from collections.abc import Callable
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from bgi.monitor.web.updates import BOARD, COLORS, ROWS
from tests.processes import PATIENCE


def addressed(url: str) -> tuple[str, str]:
    """Host and token of the address that a program printed."""
    place, _, token = url.partition("#")
    return place.removeprefix("http://").rstrip("/"), token


class Page:
    """A page at an address; it answers every picture, unless `answers` is set to False."""

    def __init__(self, url: str, **more: Any) -> None:
        host, token = addressed(url)
        self._closing = contextlib.ExitStack()
        self.line = self._closing.enter_context(
            connect(f"ws://{host}/line?token={token}", max_size=None, **more)
        )
        self.answers = True
        self.pictures = 0
        self.messages: list[bytes] = []
        self.words: dict[str, str] = {}
        self.palette = bytes(768)
        self.board = b""
        self.pixels: NDArray[Any] = np.zeros((0, 0), np.uint8)
        self.square = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Go."""
        self._closing.close()

    def say(self, *words: object) -> None:
        """Say something to the program."""
        self.line.send(" ".join(map(str, words)))

    def hear(self) -> None:
        """Take the next message; ConnectionClosed when there will be none, TimeoutError."""
        message = self.line.recv(PATIENCE)
        if isinstance(message, str):
            word, _, rest = message.partition(" ")
            self.words[word] = rest
            return
        self.messages.append(message)
        if message[0] == COLORS:
            self.palette = message[1:]
            return
        if message[0] == BOARD:
            self.board = message
            return
        assert message[0] == ROWS
        size, width, height, first, rows, square = struct.unpack_from("<x B 4H B", message)
        kind = np.dtype({1: "u1", 4: "<u4"}[size])
        if self.pixels.shape != (height, width) or self.pixels.dtype != kind:
            assert (first, rows) == (0, height)
            self.pixels = np.zeros((height, width), kind)
        data = np.frombuffer(message, np.uint8, offset=12)
        self.pixels[first : first + rows] = data.view(kind).reshape(rows, width)
        self.square = bool(square)
        self.pictures += 1
        if self.answers:
            self.say("shown")

    def hear_until(self, done: Callable[[Self], object]) -> None:
        """Take messages until the page is as it shall be."""
        while not done(self):
            self.hear()

    def end(self) -> int | None:
        """Take messages until the line is closed; the code it is closed by."""
        try:
            while True:
                self.hear()
        except ConnectionClosed:
            code: int | None = self.line.close_code
            return code
