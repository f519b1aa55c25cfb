"""Functions of two numbers, evaluated at every node of a grid."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Doubles

Function = Callable[[Any, Any], Any]
"""A function of two numbers or, faster, of two arrays."""
Interval = tuple[float, float]
Axis = Interval | Sequence[float] | NDArray[Any]
"""Where the nodes are: from a to b in even steps, or at each of these numbers."""
Table = Sequence[Any] | NDArray[Any]
"""Numbers in rows of one length: an array, or lists in a list."""

HUGE = 1e30
"""What is larger counts as infinite..."""
TINY = 1 / HUGE
"""... and what is smaller as 0, so that no later arithmetic overflows."""


def interval(name: str, given: Any) -> Interval:
    """An interval (a, b) as it was given; ValueError, with its name, unless a < b."""
    try:
        a, b = given
        ordered = -np.inf < a < b < np.inf
    except (TypeError, ValueError):
        ordered = False
    if not ordered:
        raise ValueError(f"{name} must be (a, b) with finite a < b, not {given!r}")
    if max(abs(a), abs(b)) > HUGE or b - a < TINY:
        raise ValueError(f"{name} must be a range of floats' middle size, not {given!r}")
    return a, b


def nodes(n: int | tuple[int, int], **intervals: Any) -> tuple[Doubles, Doubles]:
    """The nodes of n by n cells, or n = (nx, ny), over two intervals given with their names.

    `nodes((2, 4), x=(0, 1), y=(0, 1))` are 3 numbers for x and 5 for y.

    Raises:
        ValueError: unless n is 1 or more and the intervals are (a, b) with a < b.
    """
    counts = n if isinstance(n, tuple) else (n, n)
    if min(counts) < 1:
        raise ValueError(f"n must be at least 1 in each direction, not {n!r}")
    first, second = (
        np.linspace(*interval(name, given), count + 1)
        for (name, given), count in zip(intervals.items(), counts, strict=True)
    )
    return first, second


def evaluate(f: Function, x: Doubles, y: Doubles) -> Doubles:
    """f at every point of two arrays of one shape, NaN where it has no value."""
    with np.errstate(all="ignore"):
        try:
            z = real(f(x, y))
            whole = z.shape == x.shape
        except Exception:  # whatever a function of single numbers does when given arrays
            whole = False
        if not whole:
            z = np.vectorize(_or_nan(f), otypes=[np.float64])(x, y)
    return z


def real(values: Any) -> Doubles:
    """What a function returned, as floats; TypeError for complex numbers."""
    if np.iscomplexobj(values):
        raise TypeError("f must return real numbers, not complex ones")
    return np.asarray(values, dtype=np.float64)


def _or_nan(f: Function) -> Callable[[float, float], float]:
    """f for single numbers, with NaN where Python's arithmetic gives up."""

    def value(x: float, y: float) -> float:
        try:
            return float(real(f(x, y)))
        except (ArithmeticError, ValueError):  # 1/0, math.log(-1), math.exp(1000)
            return float("nan")

    return value
