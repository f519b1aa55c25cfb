"""Files that the explorer writes into the folder where it was started."""

from collections.abc import Callable
from itertools import count
from pathlib import Path

from surfaces.animation import PillowMissing


def save(ending: str, write: Callable[[Path], None]) -> str:
    """Have a file written that is not there yet; what became of it, in words."""
    file = free_name(ending)
    try:
        write(file)
    except OSError as error:
        return f"not saved: {error.strerror}"
    except PillowMissing as error:
        return str(error)
    return f"saved as {file}"


def free_name(ending: str) -> Path:
    """The first of explore-001, explore-002, ... that is no file yet."""
    names = (Path(f"explore-{number:03}{ending}") for number in count(1))
    return next(name for name in names if not name.exists())
