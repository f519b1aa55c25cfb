"""Where a verdict is seen: as text, as a picture in a window or a notebook, and in a file."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from pathlib import Path

import bgi
from bgi.errors import BGIError
from bgi.lab.verdict import Verdict
from bgi.machine import display_exists
from bgi.memory.image import Image


def show(verdict: Verdict, with_picture: bool, folder: str | os.PathLike[str] | None) -> None:
    """Print what was found; show the picture if somebody can see it, and save it in a folder."""
    print(verdict)
    if verdict.picture is None:
        return
    if folder is not None:
        file = save(verdict, Path(folder))
        print(f"  the picture: {file}")
    if with_picture:
        if "ipykernel" in sys.modules:
            import_module("IPython.display").display(verdict.picture)
        elif _is_a_window_wanted():
            _in_a_window(verdict.picture, f"{verdict.exercise}: any key closes this")


def save(verdict: Verdict, folder: Path) -> Path:
    """Write a verdict's picture into a folder, which is made if need be; returns the file."""
    assert verdict.picture is not None
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{verdict.exercise}.png"
    file.write_bytes(verdict.picture._repr_png_())
    return file


def _is_a_window_wanted() -> bool:
    wish = os.environ.get("BGI_MONITOR", "")
    return wish in ("window", "web") or (not wish and display_exists())


def _in_a_window(picture: Image, title: str) -> None:
    """Show a picture in a window of its own until a key is pressed, or the window closed."""
    before = bgi.getcurrentwindow()
    try:
        number = bgi.initwindow(picture.width, picture.height, title)
    except BGIError:
        return  # the words have been printed
    try:
        bgi.putimage(0, 0, picture, bgi.COPY_PUT)
        bgi.getch()
    except BGIError:
        pass  # closed
    finally:
        bgi.closewindow(number)
        bgi.setcurrentwindow(before)
