"""The kernel's font table: which number means which font, and where its file is.

The ten fonts of graphics.h have the numbers 1..10; installuserfont and registerbgifont add up to
ten more. A font is looked for among the registered ones, then in the folder given to initgraph,
then in the current folder, as the original did, and at last among those that come with this
package. File names are compared as DOS did, without regard to case.
"""

import os
import time
from functools import lru_cache

from bgi.constants import grError, grFontNotFound, grInvalidFont, grInvalidFontNum, grIOerror
from bgi.errors import brief
from bgi.fonts import read
from bgi.fonts.chr import MAX_BYTES, FontError, StrokedFont, parse

STANDARD = ("TRIP", "LITT", "SANS", "GOTH", "SCRI", "SIMP", "TSCR", "LCOM", "EURO", "BOLD")
"""The fonts of graphics.h: TRIPLEX_FONT is 1, BOLD_FONT is 10."""

_MAX_FONTS = 20
_NAME_LENGTH = 8  # of a file in DOS
_EXTENSION = ".CHR"
_SETTLED = 3 * 10**9  # nanoseconds: a change that old and the next one differ in their times


class FontTable:
    """The fonts by number."""

    def __init__(self) -> None:
        self._names = list(STANDARD)
        self._registered: dict[int, StrokedFont] = {}

    def install(self, name: str) -> int:
        """Give a font file a number: the one it has, or the next, or -11 if there is none left.

        `name` is a file name of at most 8 characters or a path, with or without `.CHR`; the file
        is not opened before `load`.
        """
        path = name.replace("\\", "/")
        if path.upper().endswith(_EXTENSION):
            path = path[: -len(_EXTENSION)]
        folder, stem = os.path.split(path)
        if not stem or (not folder and len(stem) > _NAME_LENGTH):
            return grError
        return self._number(path)

    def register(self, data: bytes) -> int:
        """Take a font from memory; its number, -13 if it is not one, -11 if the table is full."""
        view = memoryview(data)
        if view.nbytes > MAX_BYTES:
            return grInvalidFont
        try:
            font = parse(bytes(view))
        except FontError:
            return grInvalidFont
        number = self._number(font.name)
        if number > 0:
            self._registered[number] = font
        return number

    def is_registered(self, number: int) -> bool:
        """Whether a font of that number was registered: it comes before any file."""
        return number in self._registered

    def load(self, number: int, path: str | os.PathLike[str] = "") -> StrokedFont:
        """The font of that number; `path` is the folder given to initgraph.

        Raises FontError with Borland's code: -14 no such number, -8 no such file, -13 not a font
        file, -12 a file that cannot be read.
        """
        if not 1 <= number <= len(self._names):
            raise FontError(f"No font has the number {brief(number)}.", grInvalidFontNum)
        if number in self._registered:
            return self._registered[number]
        folder, stem = os.path.split(self._names[number - 1])
        file = stem.upper() + _EXTENSION
        for place in [folder] if folder else [os.fspath(path).replace("\\", "/"), ""]:
            found = _find(place or os.curdir, file)
            if found is not None:
                return _open(found, file)
        if not folder and stem in STANDARD:
            return _shipped(stem)
        raise FontError(f"Font file not found ({file})", grFontNotFound)

    def file(self, number: int) -> str:
        """The name of a font's file, "" for a number that no font has."""
        known = 1 <= number <= len(self._names)
        return os.path.split(self._names[number - 1])[1].upper() + _EXTENSION if known else ""

    def _number(self, name: str) -> int:
        """The number of a name, which joins the table if there is room, or -11."""
        known = [other.upper() for other in self._names]
        if name.upper() in known:
            return known.index(name.upper()) + 1
        if len(self._names) == _MAX_FONTS:
            return grError
        self._names.append(name)
        return len(self._names)


def _find(folder: str, file: str) -> str | None:
    """The path of the file of that name, in whatever case; None also if there is no such folder."""
    try:
        status = os.stat(folder)
        settled = time.time_ns() - status.st_mtime_ns > _SETTLED
        look = _known_fonts if settled else _fonts
        return look(folder, status.st_dev, status.st_ino, status.st_mtime_ns).get(file)
    except (OSError, ValueError):  # ValueError: a path with a zero byte
        return None


def _fonts(folder: str, device: int, number: int, changed: int) -> dict[str, str]:
    """The paths of the font files in a folder, by name; the numbers tell it from later states."""
    with os.scandir(folder) as entries:
        found = [entry for entry in entries if entry.name.upper().endswith(_EXTENSION)]
    # Of several that differ in case only, the first one counts.
    return {entry.name.upper(): entry.path for entry in reversed(found) if entry.is_file()}


_known_fonts = lru_cache(maxsize=32)(_fonts)


def _open(path: str, file: str) -> StrokedFont:
    try:
        status = os.stat(path)
        return _parsed(os.path.abspath(path), status.st_mtime_ns, status.st_size)
    except FontError as error:
        raise FontError(f"Invalid font file ({file}): {error}", error.code) from None
    except OSError as error:
        raise FontError(f"{file} cannot be read: {error}", grIOerror) from None


@lru_cache(maxsize=32)
def _parsed(path: str, changed: int, size: int) -> StrokedFont:
    """The font in a file, parsed again only when the file's time or size is new."""
    with open(path, "rb") as stream:
        return parse(stream.read(MAX_BYTES + 1))


@lru_cache(maxsize=len(STANDARD))
def _shipped(name: str) -> StrokedFont:
    """One of the ten fonts of this package."""
    return parse(read(name + _EXTENSION))
