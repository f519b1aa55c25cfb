"""Which call of ours a program has made, and where: for errors, and for learners."""

import inspect
import linecache
import os
from types import FrameType


def call() -> tuple[str, dict[str, object]]:
    """The call under way, the outermost one in this package: its name, and its arguments."""
    frame, outer = inspect.currentframe(), None
    while frame is not None and _is_ours(frame):
        frame, outer = frame.f_back, frame
    assert outer is not None
    names = inspect.getargs(outer.f_code).args
    return outer.f_code.co_name, {name: outer.f_locals[name] for name in names if name != "self"}


def line() -> str:
    """Which line of the program has called: its file, its number, and what stands there."""
    frame = inspect.currentframe()
    while frame is not None and _is_ours(frame):
        frame = frame.f_back
    if frame is None:
        return ""
    file = frame.f_code.co_filename
    source = linecache.getline(file, frame.f_lineno, frame.f_globals).strip()
    if file.startswith("<"):  # no file: a notebook's cell, or a C program, which says it all itself
        return source
    return f"{os.path.basename(file)}:{frame.f_lineno}: {source}"


def _is_ours(frame: FrameType) -> bool:
    name = frame.f_globals.get("__name__", "")
    return name.startswith("bgi.") and not name.startswith("bgi.demos")
