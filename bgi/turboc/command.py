"""A C program from the command line: `python -m bgi PROGRAM.C`."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from itertools import takewhile
from pathlib import Path

from bgi.turboc.faults import CError, CErrors, shown
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session

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
    """
    macros = dict((f"{one}=1" if "=" not in one else one).split("=", 1) for one in defined)
    others = [*takewhile(is_source, arguments)]
    try:
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


def is_source(file: str) -> bool:
    """Whether a word is the name of a file in C or C++."""
    return file.lower().endswith(ENDINGS)


def _tell(error: CError, path: str) -> None:
    """Print an error, with its line."""
    where = "" if error.place.line else f"{os.path.basename(path)}: "
    print(where + shown(error), file=sys.stderr)
