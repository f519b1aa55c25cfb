"""What a program may ask about the machine it runs on: `from bgi.machine import display_exists`."""

import os
import sys


def display_exists() -> bool:
    """Tell whether there is a display that a window could appear on.

    True on Windows and macOS; elsewhere if a variable of the environment names a display: DISPLAY,
    WAYLAND_DISPLAY or SDL_VIDEODRIVER. (SDL itself cannot be asked: without a display it draws into
    the void.)
    """
    return sys.platform in ("win32", "darwin") or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")
    )
