"""The window's process: the interpreter, the flags and the search path of the program.

It must run this very package and what the program would, and nothing of the folder that the
program lies in: a `random.py` there is a game's, not the standard library's. So it gets the
program's search path without that folder, and the package is loaded from where it lies.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.memory.sdl import FOUND, pygame

PACKAGE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))

# What the process runs first: its search path is the program's before anything is imported. Of the
# package it takes the files that the window needs, not all that a program does; and pygame, which
# asks for numpy if that is there, comes without: so the window opens in half of the time.
_BOOT = """\
import importlib, sys
from types import ModuleType
package, path, child = sys.argv[1], sys.argv[2].split("\\n"), sys.argv[3]
del sys.argv[1:4]
sys.path[:] = path
for name, folder in ("bgi", ""), ("bgi.monitor", "/monitor"):
    sys.modules[name] = ModuleType(name)
    sys.modules[name].__path__ = [package + folder]
sys.modules["numpy"] = None
import bgi.memory.sdl
del sys.modules["numpy"]
importlib.import_module(child).main()
"""

_FLAGS = {
    "isolated": "-I",
    "ignore_environment": "-E",
    "no_user_site": "-s",
    "no_site": "-S",
    "dont_write_bytecode": "-B",
}


def start(card: Card, child: str) -> subprocess.Popen[bytes]:
    """Start the process for a card whose module is `child`; BGIError if that fails."""
    command = [
        sys.executable,
        *(flag for name, flag in _FLAGS.items() if getattr(sys.flags, name)),
        "-P",  # nothing of the current folder
        *("-W", "ignore"),  # the program has shown the warnings already
        *("-c", _BOOT, PACKAGE, "\n".join(search_path()), child, card.handle, _folder()),
    ]
    try:
        with _without_debugger():
            return subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=None if _is_open(2) else subprocess.DEVNULL,
                bufsize=0,
                pass_fds=card.inherit,
                # Apart from the program's terminal: Ctrl-C there is for the program alone, and on
                # Windows no console opens.
                process_group=None if sys.platform == "win32" else 0,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
    except OSError as error:
        # Windows does not say which file it has not found.
        reason = f"{sys.executable}: {error.strerror}"
        raise BGIError(f"no window: its process could not be started: {reason}") from None


def _without_debugger() -> AbstractContextManager[None]:
    """While a process is started that no debugger is to follow.

    That of VS Code and PyCharm joins each Python that its program starts, and holds it until its
    user goes on: no window would open before that.
    """
    debugger = sys.modules.get("_pydev_bundle.pydev_monkey")
    skip: Callable[[], AbstractContextManager[None]] = getattr(
        debugger, "skip_subprocess_arg_patch", nullcontext
    )
    return skip()


def search_path() -> list[str]:
    """Where the program finds modules, but for its own folder; at last where pygame lies."""
    program = getattr(sys.modules.get("__main__"), "__file__", None)
    own = {_folder(), os.path.dirname(os.path.abspath(program)) if program else ""}
    found = [os.path.abspath(entry) for entry in sys.path if entry]
    needed = [os.path.dirname(os.path.dirname(os.path.abspath(pygame.__file__)))] if FOUND else []
    return list(dict.fromkeys([*(entry for entry in found if entry not in own), *needed]))


def _folder() -> str:
    """The current folder; a program may go on in one that has been removed."""
    try:
        return os.path.abspath("")
    except OSError:
        return os.path.abspath(os.sep)


def _is_open(descriptor: int) -> bool:
    try:
        os.fstat(descriptor)
    except OSError:
        return False
    return True
