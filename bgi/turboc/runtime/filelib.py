"""Files of stdio.h and io.h: those of the program's folder."""

from __future__ import annotations

from typing import Any

from bgi.turboc.runtime.binding import characters, string
from bgi.turboc.runtime.files import EOF, DiskFile, File
from bgi.turboc.runtime.memory import Pointer, write_text
from bgi.turboc.runtime.plaindata import Plain
from bgi.turboc.runtime.session import Session
from bgi.turboc.runtime.stdiolib import StdioLibrary

DECLARATIONS = """
FILE *fopen(text name, text mode); FILE *freopen(text name, text mode, FILE *stream);
FILE *fdopen(int handle, text mode); int fclose(FILE *stream); int fcloseall(void);
int fflush(FILE *stream); int flushall(void); int feof(FILE *stream); int ferror(FILE *stream);
void clearerr(FILE *stream); int fileno(FILE *stream); FILE *tmpfile(void); char *tmpnam(char *s);
char *mktemp(char *name);
unsigned fread(data to, unsigned size, unsigned n, FILE *stream);
unsigned fwrite(data from, unsigned size, unsigned n, FILE *stream);
int fseek(FILE *stream, long offset, int whence); long ftell(FILE *stream);
void rewind(FILE *stream); int fgetpos(FILE *stream, long *pos);
int fsetpos(FILE *stream, long *pos);
int setvbuf(FILE *stream, char *buffer, int kind, unsigned size);
void setbuf(FILE *stream, char *buffer); int remove(text name); int unlink(text name);
int rename(text old, text new_);
int open(text name, int access, ...); int _open(text name, int access); int creat(text name, int m);
int _creat(text name, int m); int creatnew(text name, int m); int creattemp(char *name, int m);
int sopen(text name, int access, int share, ...);
int close(int handle); int _close(int handle); int read(int handle, data to, unsigned n);
int _read(int handle, data to, unsigned n); int write(int handle, data from, unsigned n);
int _write(int handle, data from, unsigned n); long lseek(int handle, long offset, int whence);
long tell(int handle); long filelength(int handle); int eof(int handle);
int access(text name, int m);
int isatty(int handle); int chmod(text name, int m); int _chmod(text name, int f, ...);
unsigned _dos_open(text name, unsigned mode, int *handle); unsigned _dos_close(int handle);
unsigned _dos_creat(text name, unsigned attributes, int *handle);
unsigned _dos_creatnew(text name, unsigned attributes, int *handle);
unsigned _dos_read(int handle, data to, unsigned n, unsigned *done);
unsigned _dos_write(int handle, data from, unsigned n, unsigned *done);
FILE *_fsopen(text name, text mode, int share); int rmtmp(void); char *tempnam(char *a, char *b);
int dup(int handle); int setmode(int handle, int mode); int chsize(int handle, long size);
"""

CONSTANTS = {
    **{"O_RDONLY": 1, "O_WRONLY": 2, "O_RDWR": 4, "O_CREAT": 0x100, "O_TRUNC": 0x200},
    **{"O_EXCL": 0x400, "O_APPEND": 0x800, "O_TEXT": 0x4000, "O_BINARY": 0x8000},
    **{"S_IREAD": 0x100, "S_IWRITE": 0x80, "S_IFMT": 0xF000, "S_IFDIR": 0x4000, "S_IFREG": 0x8000},
    **{"FA_RDONLY": 1, "FA_HIDDEN": 2, "FA_SYSTEM": 4, "FA_LABEL": 8, "FA_DIREC": 16},
    **{"FA_ARCH": 32, "_A_NORMAL": 0, "_A_RDONLY": 1, "_A_HIDDEN": 2, "_A_SYSTEM": 4},
    **{"_A_VOLID": 8, "_A_SUBDIR": 16, "_A_ARCH": 32, "MAXPATH": 80, "MAXDRIVE": 3, "MAXDIR": 66},
    **{"MAXFILE": 9, "MAXEXT": 5, "WILDCARDS": 1, "EXTENSION": 2, "FILENAME": 4, "DIRECTORY": 8},
    **{"DRIVE": 16, "SEEK_SET": 0, "SEEK_CUR": 1, "SEEK_END": 2, "BUFSIZ": 512, "FOPEN_MAX": 20},
    **{"_IOFBF": 0, "_IOLBF": 1, "_IONBF": 2, "L_tmpnam": 13, "TMP_MAX": 0x7FFF, "SH_COMPAT": 0},
    **{"SH_DENYNONE": 64, "SH_DENYNO": 64, "SH_DENYRD": 48, "SH_DENYWR": 32, "SH_DENYRW": 16},
}

MOST_FILES = 20
"""Open at a time."""


class FileLibrary:
    """The functions for one program."""

    def __init__(self, program: Session, stdio: StdioLibrary) -> None:
        self._program, self._stdio = program, stdio
        self._folder = program.folder
        screen = stdio.screen
        self._handles: list[File | None] = [stdio.keyboard, screen, screen, screen, screen]
        self._numbered = 0
        program.closing.append(self.fcloseall)

    def _note(self, name: str, given: tuple[Any, ...], answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    # Streams

    def fopen(self, name: Any, mode: Any) -> File | None:
        where, how = characters(name), characters(mode)
        found = self._opened(where.decode("cp437"), how.decode("cp437"))
        self._note("fopen", (where, how), int(found is not None))
        return found

    def _opened(self, path: str, mode: str) -> File | None:
        if self._handles.count(None) == 0 and len(self._handles) >= MOST_FILES + 5:
            return None
        kind, both = mode[:1], "+" in mode
        if kind not in ("r", "w", "a"):
            return None
        writes = both or kind != "r"
        data = self._folder.open(path, kind == "r", writes, kind == "w")
        if data is None:
            return None
        file = DiskFile(data, "b" not in mode, both or kind == "r", writes, kind == "a")
        self._handle(file)
        return file

    def _handle(self, file: File) -> int:
        """A number for an open file."""
        if None in self._handles:
            number = self._handles.index(None)
            self._handles[number] = file
            return number
        self._handles.append(file)
        return len(self._handles) - 1

    def freopen(self, name: Any, mode: Any, stream: File | None) -> File | None:
        self.fclose(stream)
        return self.fopen(name, mode)

    def fdopen(self, handle: int, mode: Any) -> File | None:
        return self._file(handle)

    def fileno(self, stream: File | None) -> int:
        return self._handles.index(stream) if stream in self._handles else -1

    def fclose(self, stream: File | None) -> int:
        if stream is None or not stream.close():
            return EOF
        number = self.fileno(stream)
        if number > 4:
            self._handles[number] = None
        return 0

    def fcloseall(self) -> int:
        return sum(1 for file in self._handles[5:] if self.fclose(file) == 0)

    def fflush(self, stream: File | None) -> int:
        return 0

    def flushall(self) -> int:
        return 5

    def feof(self, stream: File | None) -> int:
        return int(stream is None or stream.ended)

    def ferror(self, stream: File | None) -> int:
        return int(stream is None or stream.failed)

    def clearerr(self, stream: File | None) -> None:
        if stream is not None:
            stream.clear()

    def tmpnam(self, s: Pointer | None) -> Pointer:
        self._numbered += 1
        name = f"TMP{self._numbered}.$$$"
        if s is None:
            return string(name)
        write_text(s, name.encode())
        return s

    def mktemp(self, name: Pointer) -> Pointer:
        return self.tmpnam(name)

    def tmpfile(self) -> File | None:
        return self._opened(characters(self.tmpnam(None)).decode(), "w+b")

    def tempnam(self, folder: Any, prefix: Any) -> Pointer:
        return self.tmpnam(None)

    def rmtmp(self) -> int:
        return 0

    def _fsopen(self, name: Any, mode: Any, share: int) -> File | None:
        return self.fopen(name, mode)

    def fread(self, to: Plain, size: int, n: int, stream: File | None) -> int:
        data = stream.read(size * n) if stream is not None else b""
        to.put(data)
        return len(data) // size if size else 0

    def fwrite(self, source: Plain, size: int, n: int, stream: File | None) -> int:
        return n if stream is not None and stream.write(source.get(size * n)) else 0

    def fseek(self, stream: File | None, offset: int, whence: int) -> int:
        return 0 if stream is not None and stream.seek(offset, whence) else -1

    def ftell(self, stream: File | None) -> int:
        return stream.tell() if stream is not None else -1

    def rewind(self, stream: File | None) -> None:
        self.fseek(stream, 0, 0)

    def fgetpos(self, stream: File, pos: Pointer) -> int:
        pos.memory[pos.at] = stream.tell()
        return 0

    def fsetpos(self, stream: File, pos: Pointer) -> int:
        return self.fseek(stream, pos.memory[pos.at], 0)

    def setvbuf(self, stream: File | None, buffer: Any, kind: int, size: int) -> int:
        return 0

    def setbuf(self, stream: File | None, buffer: Any) -> None:
        """There is no need of one."""

    def remove(self, name: Any) -> int:
        path = characters(name)
        self._note("remove", (path,))
        return 0 if self._folder.remove(path.decode("cp437")) else -1

    unlink = remove

    def rename(self, old: Any, new: Any) -> int:
        before, after = characters(old), characters(new)
        self._note("rename", (before, after))
        return 0 if self._folder.rename(before.decode("cp437"), after.decode("cp437")) else -1

    # Handles

    def _file(self, handle: int) -> File | None:
        return self._handles[handle] if 0 <= handle < len(self._handles) else None

    def open(self, name: Any, access: int, *more: Any) -> int:
        path = characters(name)
        handle = self._open_handle(path.decode("cp437"), access & 0xFFFF)
        self._note("open", (path,), int(handle >= 0))
        return handle

    def _open_handle(self, path: str, access: int) -> int:
        there = self._folder.has(path)
        if (not there and not access & 0x100) or (there and access & 0x500 == 0x500):
            return -1
        writes = bool(access & 6)
        data = self._folder.open(path, False, writes or not there, bool(access & 0x200))
        if data is None:
            return -1
        text = bool(access & 0x4000)
        return self._handle(DiskFile(data, text, access & 6 != 2, writes, bool(access & 0x800)))

    def _open(self, name: Any, access: int) -> int:
        return self.open(name, access | 1)

    def sopen(self, name: Any, access: int, share: int, *more: Any) -> int:
        return self.open(name, access)

    def creat(self, name: Any, mode: int) -> int:
        return self.open(name, 0x304)

    _creat = creat

    def creatnew(self, name: Any, mode: int) -> int:
        return self.open(name, 0x704)

    def creattemp(self, name: Pointer, mode: int) -> int:
        return self.creat(self.tmpnam(name), mode)

    def close(self, handle: int) -> int:
        return self.fclose(self._file(handle)) if handle > 2 else -1

    _close = close

    def dup(self, handle: int) -> int:
        file = self._file(handle)
        return self._handle(file) if file is not None else -1

    def setmode(self, handle: int, mode: int) -> int:
        return 0

    def chsize(self, handle: int, size: int) -> int:
        return -1

    def _dos_open(self, name: Any, mode: int, handle: Pointer) -> int:
        return self._given(handle, self.open(name, (1, 2, 4)[mode & 3 if mode & 3 < 3 else 0]))

    def _dos_creat(self, name: Any, attributes: int, handle: Pointer) -> int:
        return self._given(handle, self.creat(name, 0))

    def _dos_creatnew(self, name: Any, attributes: int, handle: Pointer) -> int:
        return self._given(handle, self.creatnew(name, 0))

    def _given(self, to: Pointer, answer: int) -> int:
        """Store an answer; the error of DOS if it is none."""
        to.memory[to.at] = max(answer, 0)
        return 2 if answer < 0 else 0

    def _dos_close(self, handle: int) -> int:
        return 0 if self.close(handle) == 0 else 6

    def _dos_read(self, handle: int, to: Plain, n: int, done: Pointer) -> int:
        return self._given(done, self.read(handle, to, n))

    def _dos_write(self, handle: int, source: Plain, n: int, done: Pointer) -> int:
        return self._given(done, self.write(handle, source, n))

    def read(self, handle: int, to: Plain, n: int) -> int:
        file = self._file(handle)
        if file is None:
            return -1
        data = self._stdio.line(file, n, keep=True) if handle == 0 else file.read(n)
        to.put(data or b"")
        return len(data or b"")

    _read = read

    def write(self, handle: int, source: Plain, n: int) -> int:
        file = self._file(handle)
        return n if file is not None and file.write(source.get(n)) else -1

    _write = write

    def lseek(self, handle: int, offset: int, whence: int) -> int:
        file = self._file(handle)
        return file.tell() if file is not None and file.seek(offset, whence) else -1

    def tell(self, handle: int) -> int:
        file = self._file(handle)
        return file.tell() if file is not None else -1

    def filelength(self, handle: int) -> int:
        file = self._file(handle)
        return file.size() if file is not None else -1

    def eof(self, handle: int) -> int:
        return int(self.tell(handle) >= self.filelength(handle))

    def access(self, name: Any, mode: int) -> int:
        return 0 if self._folder.has(characters(name).decode("cp437")) else -1

    def chmod(self, name: Any, mode: int) -> int:
        return self.access(name, 0)

    def _chmod(self, name: Any, function: int, *more: int) -> int:
        return 32 if self.access(name, 0) == 0 else -1

    def isatty(self, handle: int) -> int:
        return int(0 <= handle < 3)
