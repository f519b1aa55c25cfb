"""A turn as a GIF: pictures go in one after another, a file that moves comes out.

Pillow writes it; it comes with `pip install ".[record]"`. A bar on the terminal shows how far the
drawing has come.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterable, Iterator, Sequence
from os import PathLike
from typing import TextIO, TypeVar

T = TypeVar("T")

WIDTH = 40
"""The bar's length in characters."""


class PillowMissing(RuntimeError):
    """A GIF was asked for, and there is nothing to write it with."""


def save_gif(
    file: str | PathLike[str], pictures: Iterable[str | PathLike[str]], milliseconds: int
) -> None:
    """Write pictures as a GIF that never ends, each of them in its own palette.

    Args:
        file: The GIF.
        pictures: Files, each of them read when its turn comes: so one file can be all of them, if
            an iterator draws the next picture into it.
        milliseconds: How long each is shown, a multiple of 10.

    Raises:
        PillowMissing: where Pillow is not installed; its text is a line that helps.
        OSError: if a file cannot be opened.
    """
    if importlib.util.find_spec("PIL") is None:
        raise PillowMissing('a GIF needs Pillow; type: pip install ".[record]"')
    from PIL import Image

    def read(picture: str | PathLike[str]) -> Image.Image:
        with Image.open(picture) as image:
            return image.copy()

    images = map(read, pictures)
    first = next(images)  # if it fails, no file is touched
    with open(file, "wb") as out:
        first.save(
            out,
            format="GIF",
            save_all=True,
            append_images=images,
            duration=milliseconds,
            loop=0,
            optimize=False,
        )


def progress(steps: Sequence[T], what: str, to: TextIO | None = None) -> Iterator[T]:
    """Hand on the steps of a long work, one by one, with a bar that grows on stderr."""
    stream = sys.stderr if to is None else to
    for done, step in enumerate(steps, 1):
        yield step
        full = WIDTH * done // len(steps)
        bar = "#" * full + "." * (WIDTH - full)
        print(f"\r{what} [{bar}] {done}/{len(steps)}", end="", file=stream, flush=True)
    print(file=stream)
