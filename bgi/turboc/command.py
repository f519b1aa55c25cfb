"""A C program from the command line: `python -m bgi PROGRAM.C`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from bgi.errors import NobodyThere
from bgi.turboc.faults import CError, CErrors, shown
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session


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
        arguments: the words behind it.
        check: whether it is only looked at.
        folders: where else files lie that it includes.
        defined: macros, as `NAME` or `NAME=VALUE`.
        trace: a file that gets a line for each call of the library.
        script: A, B or a file, for keys, typed text, a mouse and a clock that are always the same.
        files: whether it may write files in its folder.
    """
    macros = dict((f"{one}=1" if "=" not in one else one).split("=", 1) for one in defined)
    try:
        program = Runnable(path, macros, folders)
    except CErrors as found:
        for error in found.errors:
            print(shown(error, _line(path, error)), file=sys.stderr)
        return 1
    if check:
        return 0
    try:
        session = Session(Path(trace) if trace else None, script, Path(path).parent, files)
    except ValueError as error:
        print(f"bgi: {error}", file=sys.stderr)
        return 2
    try:
        return program.run(session, arguments)
    except CError as error:
        print(shown(error, program.line(error.place)), file=sys.stderr)
        return 3
    except NobodyThere as end:
        print(f"bgi: {end}", file=sys.stderr)
        return 0


def _line(path: str, error: CError) -> str:
    """The line of a source that an error is in."""
    file = Path(path).parent / error.place.file
    if not file.is_file():
        return ""
    lines = file.read_bytes().decode("cp437").splitlines()
    return lines[error.place.line - 1] if 0 < error.place.line <= len(lines) else ""
