"""What time it is, for a program without a screen and where the clock of a screen begins.

A program whose keys come from a script (BGI_KEYS) always begins at the same moment: so all that it
reads off the clock, dice included, is the same in every run.
"""

import itertools
import os
import time

QUESTION = 0.1  # milliseconds that it takes to ask what time it is, where time is counted

TICKS = 18.2
"""What the PC's timer counts in a second."""

_SCRIPTED = 1992, 1, 1, 12, 0, 0, 0, 0, -1  # noon, where the program is: chosen

_began = time.time()
_questions = itertools.count()


def began() -> float:
    """When the program began, in seconds since 1970."""
    return time.mktime(_SCRIPTED) if _has_script() else _began


def now() -> float:
    """The time, in seconds since 1970; with a script every question takes a moment."""
    return began() + next(_questions) * QUESTION / 1000 if _has_script() else time.time()


def local(now: float) -> time.struct_time:
    """A moment as the clock on the wall shows it; ValueError for one that is too far away."""
    try:
        return time.localtime(now)
    except (OSError, OverflowError, ValueError):
        raise ValueError("the clock does not go so far: the program has waited too long") from None


def _has_script() -> bool:
    return bool(os.environ.get("BGI_KEYS"))
