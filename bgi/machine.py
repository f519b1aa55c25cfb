"""What a program may ask about the machine it runs on: `from bgi.machine import display_exists`."""

import functools
import os
import sys

from bgi.memory.sdl import FOUND, pygame, quietly

UNSEEN = 1920, 1080
"""The size of the desktop where there is none: chosen."""


def display_exists() -> bool:
    """Tell whether there is a display that a window could appear on.

    True on Windows and macOS; elsewhere if a variable of the environment names a display: DISPLAY,
    WAYLAND_DISPLAY or SDL_VIDEODRIVER. (SDL itself cannot be asked: without a display it draws into
    the void.)
    """
    return sys.platform in ("win32", "darwin") or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")
    )


@functools.cache  # it takes a while to ask, and programs ask for width and height one by one
def desktop_size() -> tuple[int, int]:
    """Return width and height of the desktop in pixels, of the first screen if there are several.

    1920, 1080 where there is no display.
    """
    if not (FOUND and display_exists()) or os.environ.get("BGI_MONITOR") == "none":
        return UNSEEN
    ours = not pygame.display.get_init()  # a program may use pygame's display itself
    try:
        with quietly():
            pygame.display.init()
        return pygame.display.get_desktop_sizes()[0]
    except pygame.error:
        return UNSEEN
    finally:
        if ours:
            pygame.display.quit()
