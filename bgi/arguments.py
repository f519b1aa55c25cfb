"""Numbers as a BGI call takes them.

An int is taken as it is, a float truncated toward zero, as C converts it. Anything else a caller
can pass where a number belongs is a TypeError or ValueError that names the argument. Arrays (and lists
and tuples) of numbers broadcast against each other, and mean the scalar call repeated in order.
"""

import operator
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Number = int | float | np.integer[Any] | np.floating[Any]
Numbers = Number | Sequence[Any] | NDArray[Any]
"""A number, or an array, list or tuple of numbers."""


LIMIT = 1 << 30
"""Array coordinates below it stay int64: products of two of them cannot overflow."""


def whole(name: str, value: object) -> int:
    """One number as an int; TypeError or ValueError names the argument."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        pass
    if not isinstance(value, (float, np.floating)):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}: {value!r:.60}")
    if not np.isfinite(value):
        raise ValueError(f"{name} must be a finite number, not {value!r}")
    return int(value)


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
    """The arguments as flat arrays of one length; ValueError if their shapes do not go together."""
    arrays = [whole_array(name, value) for name, value in arguments.items()]
    try:
        return [array.ravel() for array in np.broadcast_arrays(*arrays)]
    except ValueError:
        shapes = ", ".join(
            f"{name} {array.shape}" for name, array in zip(arguments, arrays, strict=True)
        )
        raise ValueError(f"the arrays do not go together: {shapes}") from None
