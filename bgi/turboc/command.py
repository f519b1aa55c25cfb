"""A C program from the command line: `python -m bgi PROGRAM.C`."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from itertools import takewhile
from pathlib import Path

from bgi.turboc.faults import CError, CErrors, shown
from bgi.turboc.port.porting import ported
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session
from bgi.turboc.understanding import Understood

ENDINGS = (".c", ".cpp", ".cc", ".cxx")
"""Of the files that are C programs, in any case."""


def run_c(
    path: str,
    arguments: Sequence[str] = (),
    *,
    check: bool = False,
    folders: Sequence[str] = (),
    defined: Sequence[str] = (),
    trace: str | None = None,
    script: str | None = None,
    files: bool = False,
    port: str | None = None,
) -> int:
    """Run a C program; returns the exit status.

    Args:
        path: its file.
        arguments: the words behind it: the other files of the program, then what main() gets.
        check: whether it is only looked at.
        folders: where else files lie that it includes.
        defined: macros, as `NAME` or `NAME=VALUE`.
        trace: a file that gets a line for each call of the library.
        script: A, B or a file, for keys, typed text, a mouse and a clock that are always the same.
        files: whether it may write files in its folder.
        port: a file that gets the program in Python, instead of it being run.
    """
    macros = dict((f"{one}=1" if "=" not in one else one).split("=", 1) for one in defined)
    others = [*takewhile(is_source, arguments)]
    try:
        if port is not None:
            return _port(Understood(path, macros, folders, others), port)
        program = Runnable(path, macros, folders, others)
    except CErrors as found:
        for error in found.errors:
            _tell(error, path)
        return 1
    except OSError as error:
        print(f"bgi: {error.filename} cannot be read: {error.strerror}", file=sys.stderr)
        return 2
    if check:
        return 0
    try:
        session = Session(Path(trace) if trace else None, script, Path(path).parent, files)
    except ValueError as error:
        print(f"bgi: {error}", file=sys.stderr)
        return 2
    try:
        return program.run(session, arguments[len(others) :])
    except CError as error:
        _tell(error, path)
        return 3


def _port(program: Understood, file: str) -> int:
    """Write a program in Python; returns the exit status."""
    if not file.lower().endswith((".py", ".pyw")):
        print("bgi: --port writes Python: give it a name that ends in .py", file=sys.stderr)
        return 2
    try:
        text = ported(program)
    except CErrors as found:
        raise program.with_lines(found) from None
    try:
        Path(file).write_text(text, encoding="utf-8", newline="\n")
    except OSError as error:
        print(f"bgi: {file} cannot be written: {error.strerror}", file=sys.stderr)
        return 2
    print(f"bgi: {file} was written", file=sys.stderr)
    return 0


def is_source(file: str) -> bool:
    """Whether a word is the name of a file in C or C++."""
    return file.lower().endswith(ENDINGS)


def _tell(error: CError, path: str) -> None:
    """Print an error, with its line."""
    where = "" if error.place.line else f"{os.path.basename(path)}: "
    print(where + shown(error), file=sys.stderr)
