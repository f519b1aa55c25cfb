"""Which keys are down now, for games: `from bgi import keyboard`.

getch() and kbhit() tell what has been typed, one key after another. Here several keys can be down
at once, and for as long as the player likes.
"""

from __future__ import annotations

from bgi import current
from bgi.kernel.arguments import check_text
from bgi.monitor.keycodes import key_named

__all__ = ["pressed"]


def pressed(key: str) -> bool:
    """Tell whether a key is down now, at the window in front.

    Args:
        key: a single character, such as "a", which is the same key as "A"; or in any case one of
            Esc, Enter, Space, Tab, Backspace, Up, Down, Left, Right, Home, End, PgUp, PgDn, Ins,
            Del, F1 to F12, Shift, Ctrl, Alt.

    Any of several windows may be in front. The key is typed as well: kbhit() and getch() go on
    beside this. Raises ValueError for what is not a key, and what kbhit() raises. Windows has it as
    GetAsyncKeyState().
    """
    check_text("key", key)
    return key_named(key) in current.screen.monitor.keys.held
