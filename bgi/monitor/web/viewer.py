"""One page that looks: what it is sent, and never more than it can take.

Nothing waits in a queue: of each word the newest goes, and a picture only when the last one is on
the page's screen. So a slow line makes fewer pictures, and the program goes on as ever.
"""

import asyncio
import contextlib
from collections.abc import Callable

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from bgi.monitor.web.updates import Still, between
from bgi.monitor.web.words import REFUSED, Said, understood

GOODBYE_SECONDS = 0.3  # for the last picture, and then for the last word


class Viewer:
    """A page, by its connection."""

    def __init__(self, connection: ServerConnection) -> None:
        self._connection = connection
        self._words: dict[str, str] = {}
        self._picture: Still | None = None
        self._seen: Still | None = None
        self._board = self._board_seen = b""
        self.wants_board = False
        """Whether the page shows the board."""
        self._answered = True
        self._news = asyncio.Event()
        self._idle = asyncio.Event()  # there is nothing to send

    def tell(self, word: str, rest: str) -> None:
        """Send a word of `bgi.monitor.protocol`, in place of an older one that still waits."""
        self._words.pop(word, None)
        self._words[word] = rest
        self._wake()

    def show(self, picture: Still) -> None:
        """Send a picture, as soon as the page has shown the last one."""
        self._picture = picture
        self._wake()

    def show_board(self, message: bytes) -> None:
        """Send the board, if the page shows it and has another one."""
        if self.wants_board:
            self._board = message
            self._wake()

    def _wake(self) -> None:
        self._idle.clear()
        self._news.set()

    async def run(self, hear: Callable[[Said], None]) -> int | None:
        """Serve the page until it goes; returns the code that it gave for the reason, if any."""
        sender = asyncio.create_task(self._send())
        try:
            async for message in self._connection:
                self._hear(message, hear)
        except ConnectionClosed:
            pass
        except ValueError as error:
            await self._connection.close(REFUSED, str(error))
        finally:
            sender.cancel()
        return self._connection.close_code

    def _hear(self, message: str | bytes, hear: Callable[[Said], None]) -> None:
        said = understood(message)
        if said[0] == "shown":
            self._answered = True
            self._news.set()
        else:
            hear(said)

    async def _send(self) -> None:
        with contextlib.suppress(ConnectionClosed):
            while True:
                await self._news.wait()
                self._news.clear()
                while self._words:
                    word = next(iter(self._words))
                    await self._connection.send(f"{word} {self._words.pop(word)}")
                if self._board != self._board_seen:
                    self._board_seen = self._board
                    await self._connection.send(self._board)
                if self._picture is not self._seen and self._answered:
                    await self._send_picture()
                if self._picture is self._seen and not self._words:
                    self._idle.set()

    async def _send_picture(self) -> None:
        picture = self._picture
        assert picture is not None
        self._answered = False
        for message in between(self._seen, picture):
            await self._connection.send(message)
        self._seen = picture

    async def close(self, code: int, reason: str) -> None:
        """Send what there is to send, if that is soon done, and close the line."""
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._idle.wait(), GOODBYE_SECONDS)
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._connection.close(code, reason), GOODBYE_SECONDS)
