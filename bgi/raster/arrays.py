"""What numpy's arrays need on some machines: counts on those of 32 bits, and memory by glibc."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def repeat(values: NDArray[Any], counts: NDArray[np.integer[Any]]) -> NDArray[Any]:
    """Each element as often as its count says; counts of any whole numbers.

    numpy takes no int64 for counts where an address has 32 bits.
    """
    return np.repeat(values, counts.astype(np.intp, copy=False))


_KEPT = 1 << 22
"""Bytes: more than the arrays together that work on one part of a call."""


def keep_memory() -> None:
    """Have the memory of arrays that are gone kept for the next ones.

    glibc gives what is free at the end of its heap back to the system, which clears every page of
    it before it comes again: that takes longer than to draw. It keeps twice as much as the largest
    block that it has seen freed. This one is not touched, so it takes no memory.
    """
    np.empty(_KEPT, np.uint8)
