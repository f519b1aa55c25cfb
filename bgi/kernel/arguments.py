"""Numbers as a BGI call takes them.

An int is taken as it is; a float is truncated toward zero, as C converts it. Anything else in the
place of a number is a TypeError or ValueError that names the argument. Arrays (and lists, tuples
and ranges) of numbers broadcast against each other, and mean the call of one number each, repeated
in order.
"""

import operator
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from math import trunc
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.errors import brief
from bgi.kernel.hints import for_argument

Number = int | float | np.integer[Any] | np.floating[Any]
Numbers = Number | list[Any] | tuple[Any, ...] | range | NDArray[Any]
"""A number, or what `is_array` accepts; a Sequence would let a str pass.

The public modules keep annotations unevaluated (`from __future__ import annotations`): so help()
shows these two names, not what they stand for.
"""


LIMIT = 1 << 24
"""Array coordinates below it stay int64: their quotients are exact in floating point."""


CHUNK = 8192
"""Elements worked on at a time: such arrays fit into the processor's cache."""


MAX_NUMBERS = 1 << 24
"""Numbers in an array, and calls that arrays ask for at once: as many as the largest window has
pixels. An array may cost no memory and still stand for more (numpy.broadcast_to, a range)."""


MAX_DIMENSIONS = 32
"""Of an array: the least that a numpy of ours can take."""


TO_INT: dict[type, Callable[[Any], int]] = {
    **dict.fromkeys((int, np.int32, np.int64), operator.index),
    **dict.fromkeys((float, np.float64), trunc),
    np.bool_: int,
}
"""How numbers of the commonest types become ints: `TO_INT[type(value)](value)`.

Where that is one of `NOT_SO_SIMPLE`, it is another type, an array or no finite number: `whole`
knows.
"""
NOT_SO_SIMPLE = KeyError, ValueError, OverflowError


def whole(name: str, value: object) -> int:
    """One number as an int; TypeError or ValueError names the argument."""
    if type(value) is int:
        return value
    try:
        return TO_INT[type(value)](value)
    except NOT_SO_SIMPLE:
        pass
    if isinstance(value, np.ndarray) and value.ndim == 0:
        _check_mask(name, value)
        value = value.item()
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        pass
    if not isinstance(value, (float, np.floating, np.bool_)):
        hint = for_argument(name, value)
        kind = type(value).__name__
        raise TypeError(f"{name} must be a number, not {kind}: {brief(value)}{hint}")
    if not np.isfinite(value):
        raise ValueError(f"{name} must be a finite number, not {value!r}")
    return int(value)


def flag(name: str, value: object) -> bool:
    """Yes or no, as a bool or a number; TypeError or ValueError names the argument."""
    return whole(name, value) != 0


def length(name: str, values: object) -> int:
    """How many numbers a sequence holds; TypeError names the argument if it is not one."""
    if isinstance(values, (Sequence, bytearray, np.ndarray)) and not isinstance(values, str):
        if isinstance(values, range):
            return _range_length(values)
        if not isinstance(values, np.ndarray) or values.ndim > 0:
            return len(values)
    kind = type(values).__name__
    raise TypeError(f"{name} must be a sequence of numbers, not {kind}: {brief(values)}")


def octets(name: str, value: object) -> memoryview:
    """The memory of bytes, of a bytearray or the like, not copied; else TypeError names it.

    Arrays of numbers are refused, of Python's objects above all: their memory is none of ours.
    """
    with suppress(TypeError, ValueError):  # ValueError: numpy has numbers that no buffer can hold
        memory = memoryview(value)  # type: ignore[arg-type]
        if memory.ndim == memory.itemsize == 1:
            return memory
    kind = type(value).__name__
    raise TypeError(f"{name} must be bytes, not {kind}: {brief(value)}")


def check_function(name: str, value: object) -> None:
    """TypeError, which names the argument, for what can be neither called nor left out."""
    if value is not None and not callable(value):
        kind = type(value).__name__
        raise TypeError(f"{name} must be a function or None, not {kind}: {brief(value)}")


def check_text(name: str, value: object) -> None:
    """TypeError, which names the argument, for anything but a str."""
    check_kind(name, value, str)


def check_kind(name: str, value: object, kind: type) -> None:
    """TypeError, which names the argument, for anything but one of a class."""
    if not isinstance(value, kind):
        given = type(value).__name__
        raise TypeError(f"{name} must be a {kind.__name__}, not {given}: {brief(value)}")


def real(name: str, value: object) -> int | float:
    """One number as it is, an int of any size or a float; TypeError names the argument."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        _check_mask(name, value)
        value = value.item()
    if isinstance(value, (float, np.floating)):
        return float(value)
    return whole(name, value)


def is_array(value: object) -> bool:
    """Whether an argument asks for the array form of a call."""
    if type(value) in TO_INT or value is None:
        return False
    return isinstance(value, (list, tuple, range)) or (
        isinstance(value, np.ndarray) and value.ndim > 0
    )


def whole_array(name: str, values: object) -> NDArray[Any]:
    """An array of whole numbers: int64, or Python ints (dtype object) where any reaches LIMIT."""
    check_count(name, values)
    _check_mask(name, values)
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} must be an array of numbers, all rows of one length") from None
    if array.ndim > MAX_DIMENSIONS:
        raise ValueError(f"{name} may have {MAX_DIMENSIONS} dimensions, not {array.ndim}")
    if array.size == 0:
        return np.zeros(array.shape, dtype=np.int64)
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{name} must hold numbers, not {array.dtype}: {brief(values)}")
    if array.dtype == np.float16:  # which cannot be compared with LIMIT
        array = array.astype(np.float32)
    if array.dtype != object and array.min() > -LIMIT and array.max() < LIMIT:
        return array.astype(np.int64, copy=False)
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        whole(name, array[~np.isfinite(array)][0])
    numbers = [whole(name, item) for item in array.ravel().tolist()]
    fits = all(abs(number) < LIMIT for number in numbers)
    return np.array(numbers, dtype=np.int64 if fits else object).reshape(array.shape)


def _count(values: object) -> int:
    """How many numbers there are in an array, or in sequences within each other."""
    count, ranges = 1, 0
    for _ in range(MAX_DIMENSIONS + 1):  # deeper ones are refused; a list may hold itself
        if not isinstance(values, (list, tuple)) or not values or count > MAX_NUMBERS:
            break
        count *= len(values)
        ranges = max([ranges, *(_range_length(one) for one in values if type(one) is range)])
        values = values[0]
    if isinstance(values, range):
        ranges = max(ranges, _range_length(values))
    return count * (values.size if isinstance(values, np.ndarray) else max(ranges, 1))


def _range_length(values: range) -> int:
    """The length of a range: MAX_NUMBERS + 1 stands for all that is too long, also for len()."""
    return len(values[: MAX_NUMBERS + 1])


def check_count(name: str, values: object) -> None:
    """ValueError, which names the argument, for more numbers than a call takes."""
    if _count(values) > MAX_NUMBERS:
        raise ValueError(f"{name} may hold {MAX_NUMBERS:,} numbers at most in one call")


def _check_mask(name: str, values: object) -> None:
    """ValueError, which names the argument, for numbers that numpy.ma has taken out."""
    if "numpy.ma" not in sys.modules:  # which takes long to import: nobody has masked anything
        return
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ValueError(f"{name} must hold no masked numbers")


def broadcast(**arguments: object) -> list[NDArray[Any]]:
    """The arguments as flat arrays of one length; ValueError if their shapes do not match."""
    arrays = [whole_array(name, value) for name, value in arguments.items()]
    try:
        together = np.broadcast_arrays(*arrays)
    except ValueError:
        shapes = ", ".join(
            f"{name} {array.shape}" for name, array in zip(arguments, arrays, strict=True)
        )
        raise ValueError(f"the arrays do not go together: {shapes}") from None
    check_count(", ".join(arguments), together[0])
    return [array.ravel() for array in together]


def in_chunks(**arguments: object) -> Iterator[list[NDArray[Any]]]:
    """`broadcast`, CHUNK elements at a time."""
    arrays = broadcast(**arguments)
    for start in range(0, len(arrays[0]), CHUNK):
        yield [array[start : start + CHUNK] for array in arrays]


def polygon_points(points: object, flat: object) -> list[tuple[int, int]] | NDArray[Any]:
    """One polygon as a list of points, or many as an array (n, k, 2), from any form of the call.

    Those are [(x, y), ...], an array (k, 2), a flat list x, y, x, y, ..., an array (n, k, 2), and
    as in C the number of points followed by a flat list.
    """
    if flat is not None:
        count = whole("points", points)
        numbers = whole_array("flat", flat).ravel().tolist()
        if not 0 <= 2 * count <= len(numbers):
            needed = f"{brief(2 * count)} numbers for {brief(count)} points"
            raise ValueError(f"points and flat: {needed}, not {len(numbers)}")
        return list(zip(numbers[0 : 2 * count : 2], numbers[1 : 2 * count : 2], strict=True))
    if type(points) is list or type(points) is tuple:
        with suppress(TypeError, ValueError):  # anything but pairs of ints goes the longer way
            whole_pairs = [(x, y) for x, y in points if type(x) is int and type(y) is int]
            if len(whole_pairs) == len(points):
                return whole_pairs
    array = whole_array("points", points)
    if array.ndim == 1 and len(array) % 2 == 0:
        array = array.reshape(-1, 2)
    if array.ndim == 2 and array.shape[1] == 2:
        return [(x, y) for x, y in array.tolist()]
    if array.ndim == 3 and array.shape[1] > 0 and array.shape[2] == 2:
        return array
    raise ValueError(
        "points must be [(x, y), ...], a flat list of even length, or an array of shape"
        f" (k, 2) or (n, k, 2); not of shape {array.shape}"
    )
