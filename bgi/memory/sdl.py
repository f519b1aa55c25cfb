"""The one place that imports pygame: quietly, and with a word when two of it are installed.

pygame and pygame-ce are twins that install the same folder `pygame`. Together they are a mixture,
and uninstalling either breaks the other.
"""

import contextlib
import os
import warnings
from collections.abc import Iterator
from pathlib import Path

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

import pygame as pygame

__all__ = ["pygame", "quietly"]


@contextlib.contextmanager
def quietly() -> Iterator[None]:
    """Keep off the terminal what the system's libraries say when a device is not there."""
    try:
        kept = os.dup(2)
    except OSError:  # the program runs without a standard error: nothing can be said
        yield
        return
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)


def warn_of_twins(folder: Path) -> None:
    """Warn when both distributions have been installed into `folder`."""
    # importlib.metadata could tell too, but it imports random and half the standard library, and
    # many a program has a random.py of its own beside it.
    if all(any(folder.glob(f"{name}-*-info")) for name in ("pygame", "pygame_ce")):
        warnings.warn(
            "pygame and pygame-ce are both installed and overwrite each other; "
            "type: pip uninstall -y pygame pygame-ce && pip install pygame-ce",
            RuntimeWarning,
            stacklevel=2,
        )


warn_of_twins(Path(pygame.__file__).parents[1])
