"""What the tests of the window share: processes to wait for, and how a window can be lost."""

import ctypes
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import pytest

from bgi.errors import BGIError, WindowClosed

PATIENCE = 30  # seconds until a test gives up; nothing is measured by it
SYNCHRONIZE = 0x100000  # the right to wait for a process

posix = pytest.mark.skipif(sys.platform == "win32", reason="uses POSIX signals or fork")

_UNEXPECTED = "the window process ended unexpectedly (exit status {})"
LOSSES: list[tuple[signal.Signals, type[BGIError], str]]
if sys.platform == "win32":  # there any signal just ends a process, with its number for a status
    KILL = signal.SIGTERM
    LOSSES = [(KILL, BGIError, _UNEXPECTED.format(15))]
else:
    KILL = signal.SIGKILL
    LOSSES = [
        (signal.SIGTERM, WindowClosed, "the window was closed"),  # as polite as the close button
        (KILL, BGIError, _UNEXPECTED.format(-9)),
    ]


def wait_until(done: Callable[[], bool]) -> None:
    """Wait for something that will happen soon."""
    deadline = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.005)


def gone(pid: int) -> bool:
    """Whether a process has ended; one that nobody has buried yet has."""
    if sys.platform == "win32":
        kernel = ctypes.WinDLL("kernel32")
        kernel.OpenProcess.restype = ctypes.c_void_p
        process = ctypes.c_void_p(kernel.OpenProcess(SYNCHRONIZE, False, pid))
        ended = not process or kernel.WaitForSingleObject(process, 0) == 0
        kernel.CloseHandle(process)
        return ended
    state = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True)
    return state.stdout.strip()[:1] in ("", "Z")


def memory_of(pid: int) -> int:
    """The memory that a process really uses, in kilobytes (Linux only)."""
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return int(next(line for line in status if line.startswith("VmRSS")).split()[1])


def shared_memory() -> set[str]:
    """The names of shared memory there are on this machine."""
    return set(os.listdir("/dev/shm")) if os.path.isdir("/dev/shm") else set()
