"""The keyboard, as conio.h has it: kbhit() and getch() for the graphics window."""

from bgi import current


def kbhit() -> int:
    """Tell whether a key waits to be read: 1 or 0.

    The second byte of an extended key waits too, until getch() has fetched it. Raises BGIError
    before initgraph and WindowClosed once the user has closed the window. Source: conio.h.
    """
    return int(current.screen.monitor.key_waiting())


def getch() -> int:
    """Wait for a key and return its code, without showing it.

    A key without a character (arrows, F1..F12, Home, Alt-letters, ...) returns 0 first; the next
    call returns its scan code: 72, 80, 75, 77 for up, down, left, right. Enter is 13, Esc 27.
    Raises BGIError before initgraph, WindowClosed if the window is closed meanwhile, and BGIError
    without a window once the scripted keys (BGI_KEYS) are used up. Source: conio.h.
    """
    return current.screen.monitor.read_key()
