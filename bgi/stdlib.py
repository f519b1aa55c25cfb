"""Numbers and chance, as stdlib.h of Turbo C++ 3 has them.

Whole numbers have C's bits here, 16 in an int and 32 in a long; real ones 15 digits. `from
bgi.stdlib import *` brings all but `random`, since Python has a `random` of its own: write `from
bgi import stdlib`, and `stdlib.random(6)`. C's abs(), min() and max() are Python's own.
"""

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
from bgi.dos import RAND_MAX, rand, randomize, srand
from bgi.dos import random as random  # by name: see above

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
