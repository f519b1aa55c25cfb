"""Keeps a submission from doing harm, by accident or as a joke: limits, and calls that are refused.

The refusals are those of Python's audit hooks, which nothing in the process can take away again. It
is no prison for a determined attacker: that takes a machine of its own.
"""

from __future__ import annotations

import mmap
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

MEGABYTE = 1 << 20
LARGEST_FILE = 16 * MEGABYTE
MOST_FILES = 100
"""So many files may be opened for writing."""
SPARE_SECONDS = 5
"""The teacher's process ends this one at its time, and says so; the system only if it has not."""

PROCESSES = {
    *("os.fork", "os.forkpty", "os.exec", "os.spawn", "os.posix_spawn", "os.system"),
    *("os.startfile", "pty.spawn"),
    *("subprocess.Popen", "os.kill", "os.killpg", "signal.pthread_kill", "webbrowser.open"),
    *("_winapi.CreateProcess", "_winapi.OpenProcess", "_winapi.TerminateProcess"),
}
NETWORK = {"socket.connect", "socket.bind", "socket.sendto", "socket.getaddrinfo"}
MACHINE = {
    *("ctypes.dlopen", "ctypes.dlsym", "ctypes.call_function", "ctypes.cdata", "winreg.OpenKey"),
    *("winreg.CreateKey", "winreg.SetValue", "winreg.DeleteKey", "winreg.DeleteValue"),
}
MODULES = {"multiprocessing", "ctypes", "_posixsubprocess"}
"""Ways around: they may not be imported any more."""
Places = tuple[int, ...]
CHANGES: dict[str, tuple[Places, Places]] = {
    **dict.fromkeys(("os.remove", "os.rmdir", "shutil.rmtree"), ((0,), (1,))),
    **dict.fromkeys(("os.mkdir", "os.chmod"), ((0,), (2,))),
    **dict.fromkeys(("os.chown", "os.utime"), ((0,), (3,))),
    **dict.fromkeys(("os.truncate", "os.chflags", "os.setxattr", "os.removexattr"), ((0,), ())),
    **dict.fromkeys(("shutil.chown", "tempfile.mkdtemp", "tempfile.mkstemp"), ((0,), ())),
    **dict.fromkeys(("os.rename", "os.link"), ((0, 1), (2, 3))),
    **{"os.symlink": ((0, 1), (2,)), "shutil.move": ((0, 1), ())},
    **dict.fromkeys(("shutil.copyfile", "shutil.copytree", "shutil.unpack_archive"), ((1,), ())),
}
"""What changes files: which of its arguments are their names, and which the folders of these."""
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


class Refused(PermissionError):
    """What a submission may not do."""


def confine(folder: Path, answers: Path, megabytes: int, seconds: int) -> None:
    """From now on this process may write in its folder only, and start nothing.

    Args:
        folder: where it may write.
        answers: a file that it may write, too.
        megabytes: memory that it may take from now on, where the system keeps count.
        seconds: of a processor's time.
    """
    _limit(megabytes, seconds)
    sys.addaudithook(_Guard(folder, answers))


def _limit(megabytes: int, seconds: int) -> None:
    if sys.platform == "win32":
        _limit_on_windows(megabytes)
        return
    import resource

    now = _address_space()
    limits = {
        "RLIMIT_AS": now + megabytes * MEGABYTE,
        "RLIMIT_CPU": seconds + SPARE_SECONDS,
        "RLIMIT_FSIZE": LARGEST_FILE,
        "RLIMIT_CORE": 0,
    }
    for name, value in limits.items():
        try:
            resource.setrlimit(getattr(resource, name), (value, value))
        except (OSError, ValueError):  # as on macOS, which does not limit all of them
            continue


def _address_space() -> int:
    """The bytes of address space in use already."""
    try:
        pages = int(Path("/proc/self/statm").read_text("ascii").split()[0])
    except OSError:
        return 4096 * MEGABYTE
    return pages * mmap.PAGESIZE


def _limit_on_windows(megabytes: int) -> None:
    """A job object: memory, one process, and its end is that of all in it."""
    if sys.platform != "win32":
        return
    import ctypes
    from ctypes import wintypes

    class Basic(ctypes.Structure):
        _fields_ = [
            ("process_time", wintypes.LARGE_INTEGER),
            ("job_time", wintypes.LARGE_INTEGER),
            ("flags", wintypes.DWORD),
            ("least_set", ctypes.c_size_t),
            ("largest_set", ctypes.c_size_t),
            ("processes", wintypes.DWORD),
            ("affinity", ctypes.c_size_t),
            ("priority", wintypes.DWORD),
            ("scheduling", wintypes.DWORD),
        ]

    class Extended(ctypes.Structure):
        _fields_ = [
            ("basic", Basic),
            ("counters", ctypes.c_ulonglong * 6),
            ("process_memory", ctypes.c_size_t),
            ("job_memory", ctypes.c_size_t),
            ("peak_process", ctypes.c_size_t),
            ("peak_job", ctypes.c_size_t),
        ]

    kernel = ctypes.WinDLL("kernel32")
    kernel.CreateJobObjectW.restype = ctypes.c_void_p
    kernel.GetCurrentProcess.restype = ctypes.c_void_p
    job = ctypes.c_void_p(kernel.CreateJobObjectW(None, None))
    one_process, process_memory, die_together = 0x8, 0x100, 0x2000
    limits = Extended()
    limits.basic.flags = one_process | process_memory | die_together
    limits.basic.processes = 1
    limits.process_memory = megabytes * MEGABYTE
    extended_limits = 9
    kernel.SetInformationJobObject(
        job, extended_limits, ctypes.byref(limits), ctypes.sizeof(limits)
    )
    kernel.AssignProcessToJobObject(job, ctypes.c_void_p(kernel.GetCurrentProcess()))


class _Guard:
    """An audit hook: raises at what is refused."""

    def __init__(self, folder: Path, answers: Path) -> None:
        self._folder = os.path.realpath(folder)
        self._answers = os.path.realpath(answers)
        self._opened = 0
        self._rules: dict[str, Callable[[tuple[Any, ...]], None]] = {
            "open": self._open,
            "import": self._import,
            **{event: self._changing(*which) for event, which in CHANGES.items()},
            **{event: self._refusing(event) for event in PROCESSES | NETWORK | MACHINE},
        }

    def __call__(self, event: str, arguments: tuple[Any, ...]) -> None:
        rule = self._rules.get(event)
        if rule is not None:
            rule(arguments)

    def _refusing(self, event: str) -> Callable[[tuple[Any, ...]], None]:
        def rule(arguments: tuple[Any, ...]) -> None:
            raise Refused(f"a submission may not do that: {event}")

        return rule

    def _changing(self, names: Places, folders: Places) -> Callable[[tuple[Any, ...]], None]:
        def rule(arguments: tuple[Any, ...]) -> None:
            if any(isinstance(arguments[n], int) and arguments[n] >= 0 for n in folders):
                raise Refused("a submission may change files by their names only")
            for number in names:
                self._check(arguments[number])

        return rule

    def _open(self, arguments: tuple[Any, ...]) -> None:
        path, mode, flags = arguments[:3]
        writes = isinstance(mode, str) and set(mode) & set("wax+")
        if not (writes or (isinstance(flags, int) and flags & WRITING)) or isinstance(path, int):
            return
        self._check(path)
        self._opened += 1
        if self._opened > MOST_FILES and os.path.realpath(os.fsdecode(path)) != self._answers:
            raise Refused(f"a submission may write {MOST_FILES} files")

    def _import(self, arguments: tuple[Any, ...]) -> None:
        name = str(arguments[0])
        if name.partition(".")[0] in MODULES:
            raise Refused(f"a submission may not import {name}")

    def _check(self, path: Any) -> None:
        """Refuse a name outside of the folder; a number is a file that is open already."""
        if isinstance(path, int):
            return
        place = os.path.realpath(os.fsdecode(path))
        if place != self._answers and not place.startswith(self._folder + os.sep):
            raise Refused(f"a submission may write in its own folder only, not {path!r}")
