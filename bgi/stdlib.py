"""Numbers and chance, as stdlib.h of Turbo C++ 3 has them.

Whole numbers have C's bits here, 16 in an int and 32 in a long; real ones 15 digits. `from
bgi.stdlib import *` brings all but `random`, since Python has a `random` of its own: write `from
bgi import stdlib`, and `stdlib.random(6)`. C's abs(), min() and max() are Python's own.
"""

from __future__ import annotations

from bgi import current
from bgi.clib.numbers import (
    atof,
    atoi,
    atol,
    div,
    div_t,
    ecvt,
    fcvt,
    gcvt,
    itoa,
    labs,
    ldiv,
    ltoa,
    strtod,
    strtol,
    strtoul,
    ultoa,
)
from bgi.errors import brief
from bgi.kernel.arguments import Number, whole
from bgi.kernel.state import KERNEL
from bgi.monitor import moment

__all__ = [
    "RAND_MAX",
    "atof",
    "atoi",
    "atol",
    "div",
    "div_t",
    "ecvt",
    "fcvt",
    "gcvt",
    "itoa",
    "labs",
    "ldiv",
    "ltoa",
    "rand",
    "randomize",
    "srand",
    "strtod",
    "strtol",
    "strtoul",
    "ultoa",
]

RAND_MAX = 32767
"""The largest number that rand() returns."""


# Chance: Borland's linear congruential generator, which multiplies and adds; its upper bits count

_MULTIPLIER = 0x015A4E35


def srand(seed: Number) -> None:
    """Make rand() begin anew; the same seed (0 to 65535) always gives the same numbers.

    Source: stdlib.h.
    """
    KERNEL.seed = whole("seed", seed) & 0xFFFF


def rand() -> int:
    """Return a random whole number from 0 to RAND_MAX (32767): 346, 130, 10982, ...

    Without srand() or randomize() always the same, number for number Borland's. Source: stdlib.h.
    """
    KERNEL.seed = (KERNEL.seed * _MULTIPLIER + 1) & 0xFFFFFFFF
    return KERNEL.seed >> 16 & RAND_MAX


def random(num: Number) -> int:
    """Return a random whole number from 0 to num - 1, as Turbo C++ 3 computed it.

    Args:
        num: how many numbers there are to choose from, 1 to 32767; of none, 0, comes a 0.

    ValueError for a number below 0. Source: stdlib.h.
    """
    count = whole("num", num)
    if count < 0:
        raise ValueError(f"num must be 0 or more, not {brief(count)}")
    return rand() * count >> 15


def randomize() -> None:
    """Make rand() and random() different in every run, by the clock. Source: stdlib.h."""
    from calendar import timegm  # late, as most programs need it never

    srand(timegm(moment.local(current.now())))
