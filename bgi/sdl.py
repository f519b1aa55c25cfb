"""The one place that imports pygame: quietly, and with a word when two of it are installed.

pygame and pygame-ce are twins that install the same folder `pygame`. Together they are a mixture,
and uninstalling either breaks the other.
"""

import os
import warnings
from importlib import metadata

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

import pygame as pygame

__all__ = ["pygame"]


def warn_of_twins() -> None:
    """Warn when the other distribution of pygame is installed beside the one imported."""
    other = "pygame" if getattr(pygame, "IS_CE", False) else "pygame-ce"
    try:
        metadata.distribution(other)
    except metadata.PackageNotFoundError:
        return
    warnings.warn(
        "pygame and pygame-ce are both installed and overwrite each other; "
        "type: pip uninstall -y pygame pygame-ce && pip install pygame-ce",
        RuntimeWarning,
        stacklevel=2,
    )


warn_of_twins()
