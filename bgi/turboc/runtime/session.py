"""A running C program: what it prints and reads, how long it may run, and how it ends."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path
from typing import Any

from bgi import conio, current
from bgi.errors import BGIError, WindowClosed
from bgi.turboc.runtime.folders import DiskFolder, Folder, MemoryFolder
from bgi.turboc.runtime.livepc import LivePC
from bgi.turboc.runtime.scripted import Scripted
from bgi.turboc.runtime.scriptfile import scripted
from bgi.turboc.runtime.timelimit import TimeLimit
from bgi.turboc.runtime.trace import Trace

SECONDS = 12
"""Of a processor that a scripted program may take."""


class ProgramEnd(BaseException):
    """The program ends: by exit(), or since it has done enough."""

    def __init__(self, reason: str, status: int = 0) -> None:
        super().__init__(reason)
        self.reason = reason
        self.status = status


def _stop(reason: str) -> None:
    raise ProgramEnd(reason)


class Session:
    """One run of a program."""

    def __init__(
        self,
        trace: Path | None = None,
        script_name: str | None = None,
        folder: Path = Path(),
        files: bool = False,
    ) -> None:
        """
        Args:
            trace: the file that gets the trace, None for none.
            script_name: A, B or a file, None for the keyboard and the clock of the window.
            folder: where its files are; a scripted program that may not write sees an empty one.
            files: whether it may write them.
        """
        self.trace = Trace(_stop) if trace else None
        self._trace_file = trace
        self.pc: Scripted | LivePC = scripted(script_name) if script_name else LivePC()
        self.scripted = script_name is not None
        in_memory = self.scripted and not files
        self.folder: Folder = MemoryFolder() if in_memory else DiskFolder(folder, files)
        self.closing: list[Callable[[], Any]] = []
        """What is called at the end, however the program ends."""
        self.at_exit: list[Callable[[], Any]] = []

    def print(self, data: bytes) -> None:
        """Write on the screen as stdio.h does: as DOS would."""
        if self.trace:
            self.trace.print(data)
        if data:
            (current.crt or current.console()).print(data)

    def put(self, data: bytes) -> None:
        """Write on the screen as conio.h does: in the text colour, inside the window."""
        if self.trace:
            self.trace.print(data)
        if data:
            conio.cputs(data)

    def read(self, data: bytes) -> None:
        """Note what was read of the typed text."""
        if self.trace:
            self.trace.read(data)

    def run(self, main: Callable[[], Any]) -> int:
        """Run the program; returns its exit status, and raises what a fault of C raises."""
        reason, status = "exit", 0
        limit = TimeLimit(SECONDS, lambda: _stop("cpu")) if self.scripted else nullcontext()
        try:
            with limit:  # a script has an end: so has the program that follows it
                status = self._whole(main)
        except ProgramEnd as end:
            reason, status = end.reason, end.status
        except WindowClosed:
            raise
        except BGIError as error:
            reason = "nograph"
            self.print(str(error).encode("cp437", "replace") + b"\n")
        except Exception as error:
            reason = "divide" if isinstance(error, ZeroDivisionError) else "crash"
            raise
        finally:
            self._end(reason)
        return status if isinstance(status, int) else 0

    def _whole(self, main: Callable[[], Any]) -> Any:
        """The program, then what it asked for by atexit(); returns its exit status."""
        try:
            status = main() or 0
        except ProgramEnd as end:
            if end.reason != "exit":
                raise
            status = end.status
        while self.at_exit:
            self.at_exit.pop()()
        return status

    def _end(self, reason: str) -> None:
        for close in self.closing:
            close()
        if self.trace and self._trace_file:
            text = self.trace.end(reason)
            self._trace_file.write_text(text, encoding="ascii", newline="\n")
