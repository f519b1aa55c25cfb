"""The window on the desktop: the picture in its middle, as large as whole steps allow."""

import itertools
import os
import sys
import time

from bgi.memory.card import Card, Frame
from bgi.memory.sdl import pygame, quietly
from bgi.monitor import art
from bgi.monitor.letters import at_moment
from bgi.monitor.overlays import Overlays
from bgi.monitor.picture import Shape, fit, inside, largest, shot, surface
from bgi.monitor.protocol import TITLE

NOTICE_SECONDS = 2.5  # how long the title says what has just happened


class Display:
    """The window and what is on show in it; pygame.error if there can be none.

    `folder` is where pictures are saved.
    """

    def __init__(self, card: Card, folder: str) -> None:
        self.presents = 0
        self._card = card
        self._folder = folder
        self._shown: object = None
        self._drawn: object = None
        self.blinked = False
        """Whether only what blinks made the last picture a new one."""
        self._title = ""
        self._notice_ends = float("inf")
        self._full = False
        self._resized = False  # by the user, whose wish it then is
        self._size = 0, 0  # of the window, while it fills the whole screen
        self._pointer: tuple[int, int] | None = None
        self.overlays = Overlays(card)
        os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")
        if sys.platform == "linux":
            # Without a graphics processor a copy in shared memory beats OpenGL tenfold.
            os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")
        with quietly():
            pygame.display.init()
        if pygame.display.get_driver() == "offscreen":  # SDL's way of saying that nobody will see
            raise pygame.error(f"the display {os.environ.get('DISPLAY', '')!r} cannot be opened")
        self._maximum = largest(*pygame.display.get_desktop_sizes()[0])
        pygame.display.set_icon(art.picture(art.ICON, 4))
        self._look = art.arrow()
        self._scan_lines = os.environ.get("BGI_CRT") == "1"
        self.set_title(TITLE)
        self._shape = Shape(640, 480)
        self._open()
        self.update()

    # What is seen

    def update(self) -> bool:
        """Present what the card shows, unless it is on show already; return whether it was not."""
        frame = self._card.frame()
        palette = self._card.colors()
        if frame is None:
            return False
        over = self._pointer, self.overlays.state(self._mouse())
        drawn = frame, palette, over
        frame = at_moment(frame, time.monotonic())
        if (frame, palette, over) == self._shown:
            return False
        self._shown = frame, palette, over
        self.blinked, self._drawn = drawn == self._drawn, drawn
        shape = Shape(frame.width, frame.height, frame.square)
        if shape != self._shape:
            self._shape = shape
            self._open()
        self._paint(frame, palette)
        pygame.display.flip()
        self.presents += 1
        return True

    def _paint(self, frame: Frame, palette: bytes) -> None:
        self._page.blit(surface(frame, palette), (0, 0))
        if self._pointer is not None:
            self._look.draw(self._page, *self._pointer)
        # Pixels for which there is room stay crisp; else they blend, so that none is lost.
        crisp = self._place.width >= self._shape.width and self._place.height >= self._shape.height
        scale = pygame.transform.scale if crisp else pygame.transform.smoothscale
        scale(self._page, self._place.size, self._view)
        if self._scan_lines:
            self._darken()
        self.overlays.draw(self._view, frame, palette, self._mouse())

    def _mouse(self) -> tuple[int, int]:
        """The pixel of the page that the mouse is at."""
        return self.to_page(pygame.mouse.get_pos())

    def _darken(self) -> None:
        """Between the lines of a picture tube it is dark, where there is room for that."""
        import numpy as np
        import pygame.surfarray  # which needs numpy: left out when pygame was imported

        rows = pygame.surfarray.pixels2d(self._view).T
        ends = np.arange(1, len(rows) + 1) * self._shape.height // len(rows)
        if len(rows) >= 2 * self._shape.height:
            last = np.flatnonzero(np.diff(ends, prepend=0))
            rows[last] -= rows[last] >> 2 & 0x3F3F3F

    def forget(self) -> None:
        """Something has painted over the window: present again."""
        self._shown = None

    def set_pointer(self, place: tuple[int, int] | None) -> None:
        """Show the mouse driver's arrow at a pixel of the page, or not at all."""
        self._pointer = place

    def shape_pointer(self, *numbers: int) -> None:
        """Give the pointer a look of its own: hot spot and masks; nothing: the arrow again."""
        self._look = art.from_masks(*numbers) if numbers else art.arrow()
        self.forget()

    # The window

    def _open(self) -> None:
        """Open the window for the mode, or make the open one fit it."""
        window = pygame.display.get_surface()
        size = fit(self._shape, *self._maximum)
        # Set anew, it would flicker.
        kept = window and (self._full or self._resized or window.get_size() == size)
        if not kept:
            pygame.display.set_mode(size, pygame.RESIZABLE)
        self.arrange()

    def arrange(self) -> None:
        """Put the picture into the middle of the window, whose size may be new."""
        window = pygame.display.get_surface()
        assert window is not None
        window.fill((0, 0, 0))
        self._place = pygame.Rect((0, 0), inside(self._shape, *window.get_size()))
        self._place.center = window.get_rect().center
        self._place.clamp_ip(window.get_rect())
        self._view = window.subsurface(self._place)
        self._page = pygame.Surface(self._shape[:2], 0, window)
        self.forget()

    def resize(self) -> None:
        """The user has pulled at the window's edge."""
        window = pygame.display.get_surface()
        assert window is not None
        if not self._full:
            self._resized = window.get_size() != fit(self._shape, *self._maximum)
        self.arrange()

    def toggle_full(self) -> None:
        """Fill the whole screen, or go back to a window."""
        window = pygame.display.get_surface()
        assert window is not None
        self._full = not self._full
        if self._full:
            self._size = window.get_size()
            desktop = pygame.display.get_desktop_sizes()[0]
            pygame.display.set_mode(desktop, pygame.FULLSCREEN)
        else:
            # Twice: without a window manager the first one only leaves the whole screen.
            for _ in range(2):
                pygame.display.set_mode(self._size, pygame.RESIZABLE)
        self.arrange()

    def to_page(self, place: tuple[int, int]) -> tuple[int, int]:
        """The pixel of the page at a place in the window, or the nearest."""
        left, top, width, height = self._place
        x = (place[0] - left) * self._shape.width // width
        y = (place[1] - top) * self._shape.height // height
        return min(max(x, 0), self._shape.width - 1), min(max(y, 0), self._shape.height - 1)

    def to_window(self, x: int, y: int) -> tuple[int, int]:
        """The place in the window where the middle of a pixel of the page is seen."""
        left, top, width, height = self._place
        across, down = (2 * x + 1) * width, (2 * y + 1) * height
        return left + across // (2 * self._shape.width), top + down // (2 * self._shape.height)

    # The title

    def set_title(self, title: str) -> None:
        """Name the window; what the desktop could not take is replaced."""
        self._title = title.replace("\0", " ").encode(errors="replace").decode()
        pygame.display.set_caption(self._title)

    def notice(self, text: str, seconds: float = NOTICE_SECONDS) -> None:
        """Say something in the title for a moment."""
        pygame.display.set_caption(f"{text} - {self._title}".replace("\0", " "))
        self._notice_ends = time.monotonic() + seconds

    def end_notice(self) -> None:
        """Put the title back once a notice has stood there long enough."""
        if time.monotonic() >= self._notice_ends:
            self._notice_ends = float("inf")
            pygame.display.set_caption(self._title)

    # Pictures

    def save(self) -> None:
        """Save what is on show, every pixel of the page as one pixel, and say so in the title."""
        frame = self._card.frame()
        if frame is None:
            return
        try:
            file = free_name(self._folder, "png")
            with open(file, "wb") as opened:
                opened.write(shot(frame, self._card.colors()))
        except OSError as error:
            self.notice(f"not saved: {error.strerror}")
        else:
            self.notice(f"saved {os.path.basename(file)}")


def free_name(folder: str, suffix: str) -> str:
    """The first of bgi-001, bgi-002, ... that is not taken: an empty file now."""
    for number in itertools.count(1):
        file = os.path.join(folder, f"bgi-{number:03}.{suffix}")
        try:
            open(file, "xb").close()
        except FileExistsError:
            continue
        return file
    raise AssertionError("there are always more numbers")
