"""The folder that a C program may see: its own, or an empty one that is gone with the program.

A program of DOS does not tell `DATA.TXT` from `data.txt`, and has its folders on a drive that is
not here: of a path that leads to nothing the last name counts. Nothing outside of the folder is
opened, and nothing is written that the user has not allowed.
"""

from __future__ import annotations

import fnmatch
import io
import os
import sys
from pathlib import Path
from typing import IO

DEVICES = frozenset(["con", "prn", "nul", "aux", "lpt1", "lpt2", "com1", "com2"])
"""Names that were no files in DOS."""


class KeptFile(io.BytesIO):
    """A file in memory, whose bytes stay when it is closed."""

    def __init__(self, files: dict[str, bytes], name: str) -> None:
        super().__init__(files.setdefault(name, b""))
        self._files, self._name = files, name

    def close(self) -> None:
        if not self.closed:
            self._files[self._name] = self.getvalue()
        super().close()


def last_name(path: str) -> str:
    """The last part of a path of DOS."""
    return path.replace("\\", "/").rpartition("/")[2].rpartition(":")[2].strip()


class MemoryFolder:
    """An empty folder in memory: what a scripted program finds, so that all runs are the same."""

    def __init__(self) -> None:
        self._files: dict[str, bytes] = {}

    def open(self, path: str, reading: bool, writing: bool, fresh: bool) -> IO[bytes] | None:
        """A file; None if there is none.

        Args:
            path: what the program calls it.
            reading: whether it has to be there.
            writing: whether it is written.
            fresh: whether what was in it is dropped.
        """
        name = last_name(path).lower()
        if not name or name[0] == "." or (reading and name not in self._files):
            return None
        if fresh:
            self._files[name] = b""
        return KeptFile(self._files, name)

    def path(self, path: str, writing: bool) -> Path | None:
        """Where a file is on the disk: nowhere."""
        return None

    def names(self, pattern: str) -> list[tuple[str, int, float, bool]]:
        """The files of a pattern: name, size, time of change, and whether it is a folder."""
        return []

    def has(self, path: str) -> bool:
        """Whether there is such a file."""
        return last_name(path).lower() in self._files

    def remove(self, path: str) -> bool:
        """Remove a file; whether that was done."""
        return False

    def rename(self, old: str, new: str) -> bool:
        """Rename a file; whether that was done."""
        return False

    def make(self, path: str) -> bool:
        """Make a folder; whether that was done."""
        return False

    def drop(self, path: str) -> bool:
        """Remove a folder; whether that was done."""
        return False

    def enter(self, path: str) -> bool:
        """Go to another folder; whether that was done."""
        return True


class DiskFolder:
    """The folder of a program on the disk."""

    def __init__(self, folder: Path, writable: bool) -> None:
        self._top = folder.resolve()
        self._here = self._top
        self._writable = writable
        self._told = False

    def _allowed(self, path: str) -> bool:
        """Whether something may be written; said once if not."""
        if not self._writable and not self._told:
            self._told = True
            what = f"the program may not write {path}: --files lets it write in its folder"
            print(f"bgi: {what}", file=sys.stderr)
        return self._writable

    def _inside(self, path: Path) -> Path | None:
        """A path, if it really is in the folder."""
        real = path.resolve()
        return path if real == self._top or self._top in real.parents else None

    def _find(self, path: str) -> Path | None:
        """The file or folder that a program means, whatever the case of its letters."""
        parts = [part for part in path.replace("\\", "/").rpartition(":")[2].split("/") if part]
        for tried in (parts, parts[-1:]):
            found: Path | None = self._here
            for part in tried:
                found = _child(found, part) if found is not None else None
            if found is not None and tried and self._inside(found):
                return found
        return None

    def _new(self, path: str) -> Path | None:
        """Where a file is made: in a folder that is there, otherwise in the program's own."""
        name = last_name(path)
        if not name or name in (".", "..") or name.partition(".")[0].lower() in DEVICES:
            return None
        where = path.replace("\\", "/").rpartition("/")[0]
        folder = self._find(where) if where else self._here
        return self._inside((folder if folder and folder.is_dir() else self._here) / name)

    def path(self, path: str, writing: bool) -> Path | None:
        """Where a file is on the disk, or will be; None if it must not be used."""
        if writing:
            return (self._find(path) or self._new(path)) if self._allowed(path) else None
        return self._find(path)

    def open(self, path: str, reading: bool, writing: bool, fresh: bool) -> IO[bytes] | None:
        """A file; None if there is none, or if it must not be written."""
        found = self._find(path)
        if (reading and found is None) or (writing and not self._allowed(path)):
            return None
        found = found or self._new(path)
        try:
            if found is None or found.is_dir():
                return None
            if fresh or (writing and not found.exists()):
                found.write_bytes(b"")
            return found.open("r+b" if writing else "rb")
        except OSError:
            return None

    def names(self, pattern: str) -> list[tuple[str, int, float, bool]]:
        """The files of a pattern: name, size, time of change, and whether it is a folder."""
        wanted = last_name(pattern).lower()
        wanted = "*" if wanted == "*.*" else wanted
        found = []
        for one in sorted(self._here.iterdir(), key=lambda one: one.name.lower()):
            if fnmatch.fnmatchcase(one.name.lower(), wanted) and self._inside(one):
                known = one.stat()
                found.append((one.name, known.st_size, known.st_mtime, one.is_dir()))
        return found

    def has(self, path: str) -> bool:
        """Whether there is such a file or folder."""
        return self._find(path) is not None

    def remove(self, path: str) -> bool:
        """Remove a file; whether that was done."""
        found = self._find(path)
        if found is None or found.is_dir() or not self._allowed(path):
            return False
        return _done(found.unlink)

    def rename(self, old: str, new: str) -> bool:
        """Rename a file; whether that was done."""
        found, to = self._find(old), self._new(new)
        if found is None or to is None or self.has(last_name(new)) or not self._allowed(old):
            return False
        return _done(lambda: os.rename(found, to))

    def make(self, path: str) -> bool:
        """Make a folder; whether that was done."""
        to = self._new(path)
        return bool(to is not None and self._allowed(path) and _done(to.mkdir))

    def drop(self, path: str) -> bool:
        """Remove a folder; whether that was done."""
        found = self._find(path)
        if found is None or found == self._top or not found.is_dir() or not self._allowed(path):
            return False
        return _done(found.rmdir)

    def enter(self, path: str) -> bool:
        """Go to another folder within the program's; whether that was done."""
        if path in ("..", "\\", "/"):
            inside = path == ".." and self._here != self._top
            self._here = self._here.parent if inside else self._top
            return inside or path != ".."
        found = self._find(path)
        if found is None or not found.is_dir():
            return False
        self._here = found
        return True


Folder = MemoryFolder | DiskFolder


def _child(folder: Path, name: str) -> Path | None:
    """What is in a folder under a name, in any case of letters."""
    if name == ".":
        return folder
    if not folder.is_dir() or name == "..":
        return None
    exact = folder / name
    if exact.exists():
        return exact
    return next((one for one in folder.iterdir() if one.name.lower() == name.lower()), None)


def _done(action: object) -> bool:
    """Whether an action on the disk succeeds."""
    try:
        action()  # type: ignore[operator]
    except OSError:
        return False
    return True
