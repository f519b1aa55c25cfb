"""The one place that imports pygame: quietly, and with advice where it is broken.

pygame and pygame-ce are twins that install the same folder `pygame`. Together they are a mixture,
and uninstalling either breaks the other. Where neither is there, as in a browser's Python, all but
the window goes on with numpy alone (`bgi.memory.backend`); BGI_PYGAME=none does as if.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from pathlib import Path

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

ADVICE = "type: pip uninstall -y pygame pygame-ce && pip install pygame-ce"


@contextlib.contextmanager
def _without(name: str) -> Iterator[None]:
    """A module that is not there while it is optional to another one's import."""
    before = sys.modules.get(name, ...)
    sys.modules[name] = None  # type: ignore[assignment]  # as if it were not installed
    try:
        yield
    finally:
        del sys.modules[name]
        if before is not ...:
            sys.modules[name] = before


class _NoPygame:
    """Stands where pygame would: any use says that it is not there."""

    def __getattr__(self, name: str) -> NoReturn:
        raise ImportError("pygame is not installed; type: pip install pygame")


FOUND = os.environ.get("BGI_PYGAME") != "none" and find_spec("pygame") is not None

# pygame asks setuptools for its font, if that is installed. To import it takes a tenth of a second,
# and it imports random: many a program has a random.py of its own beside it.
if TYPE_CHECKING or FOUND:
    try:
        with _without("pkg_resources"):
            import pygame as pygame
        # Gone when a twin has been uninstalled.
        from pygame import Surface as _Surface  # noqa: F401
    except ImportError as error:
        raise ImportError(f"pygame is there, but broken ({error}); {ADVICE}") from error
else:
    pygame = _NoPygame()

__all__ = ["FOUND", "pygame", "quietly", "twins"]


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


def twins(folder: Path | None = None) -> str:
    """What is wrong, and what to type, if both pygames have been installed into one folder; or "".

    Asked for when something has gone wrong: it looks through the folder of all packages.
    """
    from pathlib import Path  # late, as it takes a while

    folder = folder or Path(pygame.__file__).parents[1]
    # importlib.metadata could tell too, but it imports random and half the standard library, and
    # many a program has a random.py of its own beside it.
    if all(any(folder.glob(f"{name}-*-info")) for name in ("pygame", "pygame_ce")):
        return f"pygame and pygame-ce are both installed and overwrite each other; {ADVICE}"
    return ""
