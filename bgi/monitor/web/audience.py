"""All pages that look at a program: what is sent to each, and which of them types."""

import asyncio
from collections.abc import Callable

from websockets.asyncio.server import ServerConnection

from bgi.monitor.web.updates import Still
from bgi.monitor.web.viewer import Viewer
from bgi.monitor.web.words import ENDED, FULL, LEFT, Said

MOST = 16
"""Pages that may look at once."""
LEAVE_SECONDS = 5.0
"""After the last page was closed, until the program is taken for closed: a page loads anew."""


class Audience:
    """The pages.

    Args:
        hear: is told what the page says that types.
        let_go: is called when it types no more.
        count: is told how many pages look, whenever that changes.
        left: is called when the last page was closed, and none has come back.
    """

    def __init__(
        self,
        hear: Callable[[Said], None],
        let_go: Callable[[], None],
        count: Callable[[int], None],
        left: Callable[[], None],
    ) -> None:
        self._hear = hear
        self._let_go = let_go
        self._count = count
        self._left = left
        self._viewers: list[Viewer] = []
        self._typist: Viewer | None = None
        self._words: dict[str, str] = {}  # what a page must know that comes later
        self._picture: Still | None = None
        self._leaving: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return len(self._viewers)

    def tell(self, word: str, rest: str) -> None:
        """Tell all pages, and those that come later."""
        self._words[word] = rest
        for viewer in self._viewers:
            viewer.tell(word, rest)

    def tell_others(self, word: str, rest: str) -> None:
        """Tell all but the one that types, which knows, and those that come later."""
        self._words[word] = rest
        for viewer in self._viewers:
            if viewer is not self._typist:
                viewer.tell(word, rest)

    def show(self, picture: Still) -> None:
        """Show a picture on all pages."""
        self._picture = picture
        for viewer in self._viewers:
            viewer.show(picture)

    @property
    def wants_board(self) -> bool:
        """Whether any page shows the board."""
        return any(viewer.wants_board for viewer in self._viewers)

    def show_board(self, message: bytes) -> None:
        """Show the board on the pages that want it."""
        for viewer in self._viewers:
            viewer.show_board(message)

    async def admit(self, connection: ServerConnection) -> None:
        """Serve a page until it goes."""
        if len(self._viewers) >= MOST:
            await connection.close(FULL, "too many are looking")
            return
        if self._leaving is not None:
            self._leaving.cancel()
        viewer = Viewer(connection)
        self._viewers.append(viewer)
        self._welcome(viewer)
        try:
            code = await viewer.run(lambda said: self._listen(viewer, said))
        finally:
            self._viewers.remove(viewer)
            if viewer is self._typist:
                self._give_keyboard(None)
            self._count(len(self._viewers))
        if code == LEFT and not self._viewers:
            self._leaving = asyncio.get_running_loop().call_later(LEAVE_SECONDS, self._left)

    def _welcome(self, viewer: Viewer) -> None:
        for word, rest in self._words.items():
            viewer.tell(word, rest)
        if self._typist is None:
            self._give_keyboard(viewer)
        else:
            viewer.tell("typing", "no")
        if self._picture is not None:
            viewer.show(self._picture)
        self._count(len(self._viewers))

    def _listen(self, viewer: Viewer, said: Said) -> None:
        word, numbers, _ = said
        if word == "type":
            self._give_keyboard(viewer)
        elif word == "board":
            viewer.wants_board = bool(numbers[0])
        elif viewer is self._typist:
            self._hear(said)

    def _give_keyboard(self, viewer: Viewer | None) -> None:
        before, self._typist = self._typist, viewer
        if before is not None and before is not viewer:
            self._let_go()
            before.tell("typing", "no")
        if viewer is not None:
            viewer.tell("typing", "yes")

    async def close(self) -> None:
        """The program has ended: tell all pages."""
        goodbyes = (viewer.close(ENDED, "the program has ended") for viewer in self._viewers)
        await asyncio.gather(*goodbyes, return_exceptions=True)
