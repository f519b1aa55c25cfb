"""Time, as dos.h has it."""

import time

from bgi import current
from bgi.arguments import Number


def delay(milliseconds: Number) -> None:
    """Wait for so many milliseconds (0 or more); the window goes on living meanwhile.

    Without a window the time is counted, not waited for, so that a program under test runs at full
    speed. Before initgraph it simply waits. Raises WindowClosed if the window is closed meanwhile,
    TypeError or ValueError for anything but a finite number of 0 or more. Source: dos.h.
    """
    wait = float(milliseconds)
    if not 0 <= wait < float("inf"):
        raise ValueError(f"milliseconds must be a finite number of 0 or more, not {milliseconds!r}")
    if current.loaded() is None:
        time.sleep(wait / 1000)
    else:
        current.screen.monitor.sleep(wait)
