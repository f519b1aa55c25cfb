"""What putimage() makes of the pixels that are there and those of an image, by operator.

Each function changes the part of a page in place; `mask` has all the bits that a pixel may have,
as a number of the page.
"""

from typing import Any

from numpy.typing import NDArray

Pixels = NDArray[Any]


def _copy(part: Pixels, image: Pixels, mask: Any) -> None:
    part[...] = image & mask


def _xor(part: Pixels, image: Pixels, mask: Any) -> None:
    part ^= image & mask


def _or(part: Pixels, image: Pixels, mask: Any) -> None:
    part |= image & mask


def _and(part: Pixels, image: Pixels, mask: Any) -> None:
    part &= image & mask


def _not(part: Pixels, image: Pixels, mask: Any) -> None:
    part[...] = image & mask ^ mask  # the complement of the image; what was there does not matter


OPERATORS = [_copy, _xor, _or, _and, _not]
"""By number: COPY_PUT, XOR_PUT, OR_PUT, AND_PUT, NOT_PUT."""
