"""dir.h and direct.h: the folder of the program, as if it were `C:\\TC`."""

from __future__ import annotations

import time as _time
from typing import Any

from bgi.turboc.runtime.binding import characters, string
from bgi.turboc.runtime.folders import last_name
from bgi.turboc.runtime.memory import Pointer, write_text
from bgi.turboc.runtime.session import Session

DECLARATIONS = """
int findfirst(text path, ffblk *to, int attributes); int findnext(ffblk *to);
int _dos_findfirst(text path, unsigned attributes, find_t *to); int _dos_findnext(find_t *to);
char *getcwd(char *to, int n); int getcurdir(int drive, char *to); int getdisk(void);
int setdisk(int drive); int chdir(text path); int mkdir(text path); int rmdir(text path);
char *searchpath(text name);
int fnsplit(text path, char *drive, char *dir, char *name, char *ext);
void fnmerge(char *path, text drive, text dir, text name, text ext);
void _splitpath(text path, char *drive, char *dir, char *name, char *ext);
void _makepath(char *path, text drive, text dir, text name, text ext);
char *_fullpath(char *to, text path, int n); void _searchenv(text name, text variable, char *to);
void _searchstr(text name, text path, char *to); int _chdrive(int drive);
int _getdrive(void); int getdrive(void); char *_getdcwd(int drive, char *to, int n);
void _dos_getdrive(unsigned *drive);
void _dos_setdrive(unsigned drive, unsigned *count);
unsigned _dos_getfileattr(text path, unsigned *to);
unsigned _dos_setfileattr(text path, unsigned attributes);
"""

TYPES = {
    "ffblk": """struct @ { char ff_reserved[21]; char ff_attrib; unsigned ff_ftime, ff_fdate;
        long ff_fsize; char ff_name[13]; };""",
    "find_t": """struct @ { char reserved[21]; char attrib; unsigned wr_time, wr_date;
        long size; char name[13]; };""",
}

_HERE = b"C:\\TC"
"""What a program is told of where it is."""


class FolderLibrary:
    """The functions for one program."""

    def __init__(self, program: Session) -> None:
        self._program = program
        self._folder = program.folder
        self._found: list[tuple[str, int, float, bool]] = []

    def _note(self, name: str, given: tuple[Any, ...], answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    def findfirst(self, path: Any, to: Pointer, attributes: int) -> int:
        pattern = characters(path)
        every = self._folder.names(pattern.decode("cp437"))
        self._found = [one for one in every if attributes & 16 or not one[3]][::-1]
        answer = self.findnext(to)
        self._note("findfirst", (pattern,), answer)
        return answer

    def findnext(self, to: Pointer) -> int:
        return self._next_found(to, "ff_name", "ff_fsize", "ff_attrib", "ff_fdate", "ff_ftime")

    def _dos_findfirst(self, path: Any, attributes: int, to: Pointer) -> int:
        every = self._folder.names(characters(path).decode("cp437"))
        self._found = [one for one in every if attributes & 16 or not one[3]][::-1]
        return self._dos_findnext(to)

    def _dos_findnext(self, to: Pointer) -> int:
        return self._next_found(to, "name", "size", "attrib", "wr_date", "wr_time")

    def _next_found(self, to: Pointer, *members: str) -> int:
        """Store the next file that was found; -1 if there is none."""
        if not self._found:
            return -1
        name, size, changed, folder = self._found.pop()
        when = _time.localtime(changed)
        date = max(when.tm_year - 1980, 0) << 9 | when.tm_mon << 5 | when.tm_mday
        time = when.tm_hour << 11 | when.tm_min << 5 | when.tm_sec // 2
        target = to.memory[to.at]
        getattr(target, members[0])[:] = _short(name)
        for member, value in zip(
            members[1:], (size, 16 if folder else 32, date, time), strict=True
        ):
            setattr(target, member, value)
        return 0

    def getcwd(self, to: Pointer | None, n: int) -> Pointer:
        if to is None:
            return string(_HERE)
        write_text(to, _HERE)
        return to

    def getcurdir(self, drive: int, to: Pointer) -> int:
        write_text(to, _HERE[3:])
        return 0

    def getdisk(self) -> int:
        return 2

    def setdisk(self, drive: int) -> int:
        return 3

    def chdir(self, path: Any) -> int:
        where = characters(path)
        self._note("chdir", (where,))
        return 0 if self._folder.enter(where.decode("cp437")) else -1

    def mkdir(self, path: Any) -> int:
        where = characters(path)
        self._note("mkdir", (where,))
        return 0 if self._folder.make(where.decode("cp437")) else -1

    def rmdir(self, path: Any) -> int:
        where = characters(path)
        self._note("rmdir", (where,))
        return 0 if self._folder.drop(where.decode("cp437")) else -1

    def searchpath(self, name: Any) -> Pointer | None:
        path = characters(name)
        there = self._folder.has(path.decode("cp437"))
        return string(_HERE + b"\\" + path) if there else None

    def fnsplit(self, path: Any, drive: Any, folder: Any, name: Any, ext: Any) -> int:
        """The parts of a path; which of them there are is the answer."""
        written = characters(path)
        whole = last_name(written.decode("cp437")).encode("cp437")
        begin = written[: len(written) - len(whole)]
        disk = begin[:2] if begin[1:2] == b":" else b""
        stem, dot, behind = whole.rpartition(b".")
        parts = disk, begin[len(disk) :], stem if dot else whole, dot + behind if dot else b""
        for to, part in zip((drive, folder, name, ext), parts, strict=True):
            if to is not None:
                write_text(to, part)
        bits = zip(parts, (16, 8, 4, 2), strict=True)
        return sum(bit for part, bit in bits if part) | (b"*" in whole or b"?" in whole)

    def fnmerge(self, path: Pointer, *parts: Any) -> None:
        write_text(path, b"".join([characters(part) for part in parts if part is not None]))

    _makepath = fnmerge

    def _splitpath(self, path: Any, drive: Any, folder: Any, name: Any, ext: Any) -> None:
        self.fnsplit(path, drive, folder, name, ext)

    def _fullpath(self, to: Pointer | None, path: Any, n: int) -> Pointer:
        whole = _HERE + b"\\" + characters(path)
        if to is None:
            return string(whole)
        write_text(to, whole)
        return to

    def _searchenv(self, name: Any, variable: Any, to: Pointer) -> None:
        found = self.searchpath(name)
        write_text(to, characters(found) if found is not None else b"")

    _searchstr = _searchenv

    def _chdrive(self, drive: int) -> int:
        return 0 if drive == 3 else -1

    def _getdrive(self) -> int:
        return 3

    getdrive = _getdrive

    def _getdcwd(self, drive: int, to: Pointer | None, n: int) -> Pointer:
        return self.getcwd(to, n)

    def _dos_getdrive(self, drive: Pointer) -> None:
        drive.memory[drive.at] = 3

    def _dos_setdrive(self, drive: int, count: Pointer) -> None:
        count.memory[count.at] = 3

    def _dos_getfileattr(self, path: Any, to: Pointer) -> int:
        to.memory[to.at] = 32
        return 0 if self._folder.has(characters(path).decode("cp437")) else 2

    def _dos_setfileattr(self, path: Any, attributes: int) -> int:
        return 5


def _short(name: str) -> bytes:
    """A name in eight characters and three, as DOS has it."""
    stem, dot, ext = name.upper().rpartition(".")
    stem, ext = (stem, ext) if dot else (ext, "")
    made = f"{stem[:8]}.{ext[:3]}" if ext else stem[:8]
    return made.encode("cp437", "replace").ljust(13, b"\0")
