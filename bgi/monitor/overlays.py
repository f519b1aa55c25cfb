"""What lies over the window's picture when asked for: the magnifier, and the board of the card."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bgi.memory.card import Card, Frame
from bgi.memory.sdl import pygame

# What needs numpy is imported late: most windows never show any of it, and open sooner without.
if TYPE_CHECKING:
    from bgi.monitor.lens import Colors, Lens, Pixels, Place

MARGIN = 8
"""Pixels of the window between its picture's edge and what lies over it."""


class Overlays:
    """What is asked for, and how it is drawn."""

    def __init__(self, card: Card) -> None:
        self._card = card
        self._lens: Lens | None = None
        self._set: Place = 0, 0  # where a pixel was set last
        self._before: Pixels | None = None
        self.board = False
        """Whether the board is shown."""
        self.facts: tuple[str, ...] = ()
        """What the program says of its screen."""

    def use_lens(self, lens: Lens) -> None:
        """Show the magnifier like that."""
        self._lens = lens if lens.times else None
        self._before = None

    def enlarge(self) -> None:
        """The key for it: larger, and at last gone."""
        from bgi.monitor.lens import Lens

        self.use_lens((self._lens or Lens()).next())

    def follow(self) -> None:
        """The other key: from the mouse to the pixel that was set last, and back."""
        from bgi.monitor.lens import TIMES, Lens

        lens = self._lens or Lens(TIMES[1])
        self.use_lens(lens._replace(follows_pixels=not lens.follows_pixels))

    def toggle_board(self) -> None:
        """Show the board, or no longer."""
        self.board = not self.board

    def state(self, mouse: Place) -> object:
        """Something that changes when there is something else to be drawn."""
        follows_mouse = self._lens is not None and not self._lens.follows_pixels
        return self._lens, mouse if follows_mouse else None, self.board, self.facts

    def draw(self, view: pygame.Surface, frame: Frame, palette: bytes, mouse: Place) -> None:
        """Draw it over the picture, which fills `view`; the mouse is at a pixel of the page."""
        if self._lens is not None:
            self._draw_lens(self._lens, view, frame, palette, mouse)
        if self.board:
            from bgi.monitor.board import board

            lay(view, board(self._card, frame, palette, self.facts), left=True, top=True)

    def _draw_lens(
        self, lens: Lens, view: pygame.Surface, frame: Frame, palette: bytes, mouse: Place
    ) -> None:
        from bgi.monitor.lens import last_changed, magnified
        from bgi.monitor.picture import colors, pixels

        now = pixels(frame)
        if self._before is not None:
            self._set = last_changed(self._before, now) or self._set
        self._before = now
        x, y = self._set if lens.follows_pixels else mouse
        x, y = min(x, frame.width - 1), min(y, frame.height - 1)
        tall = view.get_height() * frame.width / (view.get_width() * frame.height)
        picture = magnified(now, colors(palette), (x, y), lens.times, tall)
        lay(view, picture, left=2 * x >= frame.width, top=2 * y >= frame.height)


def lay(view: pygame.Surface, picture: Colors, left: bool, top: bool) -> None:
    """Put a picture into a corner, shrunk where there is no room for it."""
    high, wide = picture.shape[:2]
    surface = pygame.image.frombuffer(picture.tobytes(), (wide, high), "RGB")
    room = view.get_width() - 2 * MARGIN, view.get_height() - 2 * MARGIN
    part = min(1, room[0] / wide, room[1] / high)
    if part < 1:
        size = max(int(wide * part), 1), max(int(high * part), 1)
        surface = pygame.transform.smoothscale(surface.convert(view), size)
    place = surface.get_rect()
    place.left = MARGIN if left else view.get_width() - MARGIN - place.width
    place.top = MARGIN if top else view.get_height() - MARGIN - place.height
    view.blit(surface, place)
