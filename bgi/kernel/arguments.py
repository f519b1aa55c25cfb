"""Numbers as a BGI call takes them.

An int is taken as it is; a float is truncated toward zero, as C converts it. Anything else in the
place of a number is a TypeError or ValueError that names the argument. Arrays (and lists, tuples
and ranges) of numbers broadcast against each other, and mean the call of one number each, repeated
in order.
"""

import operator
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

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


def whole(name: str, value: object) -> int:
    """One number as an int; TypeError or ValueError names the argument."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        pass
    if not isinstance(value, (float, np.floating)):
        hint = for_argument(name, value)
        raise TypeError(f"{name} must be a number, not {type(value).__name__}: {value!r:.60}{hint}")
    if not np.isfinite(value):
        raise ValueError(f"{name} must be a finite number, not {value!r}")
    return int(value)


def real(name: str, value: object) -> int | float:
    """One number as it is, an int of any size or a float; TypeError names the argument."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (float, np.floating)):
        return float(value)
    return whole(name, value)


def is_array(value: object) -> bool:
    """Whether an argument asks for the array form of a call."""
    return isinstance(value, (list, tuple, range)) or (
        isinstance(value, np.ndarray) and value.ndim > 0
    )


def whole_array(name: str, values: object) -> NDArray[Any]:
    """An array of whole numbers: int64, or Python ints (dtype object) where any reaches LIMIT."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} must be an array of numbers, all rows of one length") from None
    if array.size == 0:
        return np.zeros(array.shape, dtype=np.int64)
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{name} must hold numbers, not {array.dtype}: {values!r:.60}")
    if array.dtype != object and array.min() > -LIMIT and array.max() < LIMIT:
        return array.astype(np.int64, copy=False)
    numbers = [whole(name, item) for item in array.ravel().tolist()]
    fits = all(abs(number) < LIMIT for number in numbers)
    return np.array(numbers, dtype=np.int64 if fits else object).reshape(array.shape)


def broadcast(**arguments: object) -> list[NDArray[Any]]:
    """The arguments as flat arrays of one length; ValueError if their shapes do not match."""
    arrays = [whole_array(name, value) for name, value in arguments.items()]
    try:
        return [array.ravel() for array in np.broadcast_arrays(*arrays)]
    except ValueError:
        shapes = ", ".join(
            f"{name} {array.shape}" for name, array in zip(arguments, arrays, strict=True)
        )
        raise ValueError(f"the arrays do not go together: {shapes}") from None


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
        count = whole("numpoints", points)
        numbers = whole_array("polypoints", flat).ravel().tolist()
        if not 0 <= 2 * count <= len(numbers):
            raise ValueError(f"{count} points need {2 * count} numbers, not {len(numbers)}")
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
