"""The types of arrays, named for what is in them; and the memory that they take."""

import sys
from functools import cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
"""Numbers of space and of the screen."""
Singles = NDArray[np.float32]
"""The same at half the size, where there is one for every pixel or crossing."""
Ints = NDArray[np.int64]
"""Pixels, colours and places in other arrays."""
Ints32 = NDArray[np.int32]
"""The same at half the size."""
Bools = NDArray[np.bool_]
"""Answers, one for each of something."""

Box = tuple[Doubles, Doubles]
"""The lowest and the highest corner of a box in space, (3,) each."""


def middle(box: Box) -> Doubles:
    """The centre of a box, (3,)."""
    low, high = box
    return low / 2 + high / 2


def corners(box: Box) -> Doubles:
    """The eight corners of a box, (8, 3)."""
    return np.array(list(product(*np.transpose(box))))


def repeat(values: NDArray[Any], counts: NDArray[np.integer[Any]]) -> NDArray[Any]:
    """Each element as often as its count says; counts of any whole numbers.

    numpy takes no int64 for counts where an address has 32 bits, as in a browser.
    """
    return np.repeat(values, counts.astype(np.intp, copy=False))


def masks_exist() -> bool:
    """Whether anything may be a masked array: not before the program has imported numpy.ma.

    numpy imports it when it is first asked for anything, which takes a tenth of the start.
    """
    return "numpy.ma" in sys.modules


BELOW_LIMIT = 31 << 20
"""Bytes of a block just below 32 MiB: larger ones glibc always gives back to the system."""


@cache
def keep_freed_memory() -> None:
    """Make the C library of Linux keep the memory of freed arrays for the next picture's.

    By default, glibc gives a large array's memory back to the system, and the next picture waits
    for new pages: hundreds of page faults, up to a fifth of its time. But when a block just below
    its limit has been freed, it treats blocks of that size as ordinary ones, and keeps up to twice
    as much. This block is never written to, so it costs nothing; other C libraries ignore it.
    """
    np.empty(BELOW_LIMIT, np.uint8)
