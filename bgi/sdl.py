"""The one place that imports pygame: quietly, and with a word when two of it are installed.

pygame and pygame-ce are twins that install the same folder `pygame`. Together they are a mixture,
and uninstalling either breaks the other.
"""

import os
import warnings
from pathlib import Path

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

import pygame as pygame

__all__ = ["pygame"]


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
