"""Functions of two numbers, evaluated at every node of a grid."""

from collections.abc import Callable, Sequence
from datetime import date
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Doubles, masks_exist
from surfaces.checks import one_or_two

Function = Callable[[Any, Any], Any]
"""A function of two numbers or, faster, of two arrays."""
Interval = tuple[float, float]
Dated = Sequence[date] | Sequence[np.datetime64]
"""Dates, of which a datetime is one, too."""
Axis = Interval | Sequence[float] | Dated | NDArray[Any]
"""Where the nodes are: from a to b in even steps, or at each of these numbers."""
Table = Sequence[Any] | NDArray[Any]
"""Numbers in rows of one length: an array, or lists in a list."""

HUGE = 1e30
"""What is larger counts as infinite..."""
TINY = 1 / HUGE
"""... and what is smaller as 0, so that no later arithmetic overflows."""

MOST_POINTS = 1 << 24
"""The points of a surface at most; a picture of so many takes about a gigabyte."""


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
    plain = one_or_two("n", n)
    counts = plain if isinstance(plain, tuple) else (plain, plain)
    if min(counts) < 1:
        raise ValueError(f"n must be at least 1 in each direction, not {n!r}")
    if (counts[0] + 1) * (counts[1] + 1) > MOST_POINTS:
        raise ValueError(f"n must leave at most {MOST_POINTS} points, which n={n!r:.60} does not")
    first, second = (
        np.linspace(*interval(name, given), count + 1)
        for (name, given), count in zip(intervals.items(), counts, strict=True)
    )
    return first, second


def evaluate(f: Function, x: Doubles, y: Doubles, name: str = "f") -> Doubles:
    """f at every point of two arrays of one shape, NaN where it has no value."""
    with np.errstate(all="ignore"):
        try:
            z = real(f(x, y), name)
            whole = z.shape == x.shape
        except Exception:  # whatever a function of single numbers does when given arrays
            whole = False
        if not whole:
            z = np.vectorize(_or_nan(f, name), otypes=[np.float64])(x, y)
    return z


def is_table(values: Any) -> bool:
    """Whether these are numbers in rows."""
    try:
        return np.ndim(values) == 2
    except ValueError:  # rows of different lengths
        return False


def real(values: Any, name: str = "f") -> Doubles:
    """Numbers of any kind as floats; what is masked is NaN.

    Raises:
        TypeError: for complex numbers, dates, and what is no number.
        ValueError: for more than can be drawn, or rows of different lengths.
    """
    if getattr(values, "size", 0) > MOST_POINTS:
        raise ValueError(f"{name} must have at most {MOST_POINTS} numbers, not {values.size}")
    may_be_masked = masks_exist() and isinstance(values, (list, tuple, np.ma.MaskedArray))
    try:
        table = np.ma.asarray(values) if may_be_masked else np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} must have rows of one length, all of numbers") from None
    if table.dtype.kind == "M":
        counted = f"({name} - {name}[0]) / np.timedelta64(1, 'h')"
        raise TypeError(f"{name} must be numbers, not dates: count them, as in {counted}")
    if table.dtype.kind not in "biufO":
        raise TypeError(f"{name} must be real numbers, not {table.dtype}")
    try:
        floats = table.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be numbers, not {values!r:.60}") from None
    return np.ma.filled(floats, np.nan) if may_be_masked else floats


def cut(z: Doubles, limits: Interval | None) -> Doubles:
    """Heights within the limits; without limits, infinities become NaN."""
    if limits is not None:
        return np.clip(z, *limits)
    z = np.where(np.abs(z) < TINY, 0.0, z)
    return np.where(np.abs(z) > HUGE, np.nan, z)


def _or_nan(f: Function, name: str) -> Callable[[float, float], float]:
    """f for single numbers, with NaN where Python's arithmetic gives up."""

    def value(x: float, y: float) -> float:
        try:
            return float(real(f(x, y), name))
        except (ArithmeticError, ValueError):  # 1/0, math.log(-1), math.exp(1000)
            return float("nan")

    return value
