"""Runs the page's programs, one after another, each in modules as fresh as a new process's."""

import atexit
import os
import sys
import traceback
from pathlib import Path

FOLDER = Path("/home/pyodide/programs")
OURS = "bgi", "surfaces", "gallery"

os.environ["BGI_MONITOR"] = "tab"
FOLDER.mkdir(parents=True, exist_ok=True)
_kept = set(sys.modules)
_path = [*sys.path]
_used = False


def run(name: str, program: str) -> int:
    """Run a program, whose file has that name, to its end; returns its exit status.

    The name's ending says whether it is one in Python or in C.
    """
    global _used
    if _used:
        _forget_the_last_one()
    _used = True
    code = "utf-8" if name.endswith(".py") else "cp437"  # as a PC of 1990 stored it
    (FOLDER / name).write_text(program, code, "replace")
    os.chdir(FOLDER)
    sys.path[:] = ["", *_path]  # the first one is the program's
    try:
        from bgi.__main__ import main

        return main([name])
    except KeyboardInterrupt:
        print("Stopped.", file=sys.stderr)
        return 130
    except BaseException:
        traceback.print_exc()
        return 1
    finally:
        sys.stdout.flush()
        sys.stderr.flush()


def _forget_the_last_one() -> None:
    atexit._clear()
    sys.excepthook = sys.__excepthook__
    for name in set(sys.modules) - _kept:
        file = getattr(sys.modules[name], "__file__", None) or ""
        if name.partition(".")[0] in OURS or file.startswith((str(FOLDER), "/packages/demos")):
            del sys.modules[name]
