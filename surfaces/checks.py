"""Options as they are given, made plain before anything is drawn: one function for each kind.

A number is a number, whether Python's or numpy's, and 20.0 is as whole as 20. What has no plain
meaning is a TypeError, and what is out of range a ValueError; both name the option.
"""

import operator
from collections.abc import Callable, Collection
from math import isfinite
from numbers import Real
from typing import Any, TypeVar

import numpy as np

Kind = TypeVar("Kind")

MOST_LEVELS = 1000
"""Contour lines at most, counted or listed."""


def flag(name: str, given: Any) -> bool:
    """True or False; 1 and 0 stand for them."""
    if isinstance(given, (bool, int, np.bool_, np.integer)) and given in (0, 1):
        return bool(given)
    raise TypeError(f"{name} must be True or False, not {given!r:.60}")


def number(name: str, given: Any) -> float:
    """A real number."""
    if isinstance(given, np.ndarray) and given.ndim == 0:
        given = given.item()
    if isinstance(given, Real):
        return float(given)
    raise TypeError(f"{name} must be a number, not {given!r:.60}")


def finite(name: str, given: Any) -> float:
    """A number that is no infinity and not NaN."""
    found = number(name, given)
    if not isfinite(found):
        raise ValueError(f"{name} must be finite, not {given!r}")
    return found


def whole(name: str, given: Any) -> int:
    """A whole number."""
    if isinstance(given, np.ndarray) and given.ndim == 0:
        given = given.item()
    if isinstance(given, (float, np.floating)) and float(given).is_integer():
        return int(given)
    try:
        return operator.index(given)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {given!r:.60}") from None


def count(name: str, given: Any) -> int:
    """A whole number of 1 or more."""
    found = whole(name, given)
    if found < 1:
        raise ValueError(f"{name} must be at least 1, not {given!r}")
    return found


def text(name: str, given: Any) -> str:
    """A text."""
    if not isinstance(given, str):
        raise TypeError(f"{name} must be a text, not {given!r:.60}")
    return given


def choice(name: str, given: Any, names: Collection[str]) -> str:
    """One of some names."""
    if not isinstance(given, str) or given not in names:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, names))}, not {given!r:.60}")
    return given


def one_or_two(name: str, given: Any) -> int | tuple[int, int]:
    """A whole number, or a pair of them as a tuple, a list or an array."""
    if not _is_series(given):
        return whole(name, given)
    if len(given) != 2:
        raise ValueError(f"{name} must be one number or two, not {given!r:.60}")
    return whole(name, given[0]), whole(name, given[1])


def axes(name: str, given: Any) -> bool | tuple[str, ...]:
    """Whether to draw axes, or what to call the three of them."""
    if not (isinstance(given, str) or _is_series(given)):
        return flag(name, given)
    if len(given) != 3:
        raise ValueError(f"{name} must be True, False or three names, not {given!r:.60}")
    return tuple(text(name, one) for one in given)


def log(name: str, given: Any) -> str:
    """Which axes are logarithmic, each by its letter."""
    letters = text(name, given)
    if set(letters) - set("xyz") or len(set(letters)) < len(letters):
        raise ValueError(f'{name} must be made of x, y and z, as in "xz", not {given!r:.60}')
    return letters


def levels(name: str, given: Any) -> int | list[float]:
    """How many contour lines, or at which heights."""
    if _is_series(given) or isinstance(given, range):
        if len(given) <= MOST_LEVELS:
            return [finite(name, one) for one in given]
    elif 0 <= whole(name, given) <= MOST_LEVELS:
        return whole(name, given)
    raise ValueError(f"{name} must be a number from 0 to {MOST_LEVELS}, or as many heights")


def system(name: str, given: Any) -> Any:
    """A graphics system; what it must have says `surfaces.systems.pen.System`."""
    for call in ("getmaxx", "getmaxy", "getmaxcolor", "putpixel"):
        if not hasattr(given, call):
            raise TypeError(f"{name} must be a graphics system; {given!r:.60} has no {call}")
    return given


def or_none(check: Callable[[str, Any], Kind]) -> Callable[[str, Any], Kind | None]:
    """The same, where None may stand, too."""
    return lambda name, given: None if given is None else check(name, given)


def _is_series(given: Any) -> bool:
    """Whether something holds several things in order."""
    return isinstance(given, (tuple, list)) or (isinstance(given, np.ndarray) and given.ndim == 1)
