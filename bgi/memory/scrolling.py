"""Moving what is on a page up or down."""

from typing import Any

from numpy.typing import NDArray


def scroll(part: NDArray[Any], lines: int, blank: int) -> None:
    """Move an array's rows up by so many, or down if that is less than 0; `blank` comes behind."""
    kept = max(len(part) - abs(lines), 0)
    if lines > 0:
        part[:kept] = part[lines : lines + kept].copy()
        part[kept:] = blank
    else:
        part[len(part) - kept :] = part[:kept].copy()
        part[: len(part) - kept] = blank
