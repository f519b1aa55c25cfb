"""What the tests of the window share: processes to wait for, and how a window can be lost."""

import os
import signal
import subprocess
import time
from collections.abc import Callable

from bgi.errors import BGIError, WindowClosed

PATIENCE = 30  # seconds until a test gives up; nothing is measured by it

LOSSES = [
    (signal.SIGTERM, WindowClosed, "the window was closed"),  # as polite as the close button
    (signal.SIGKILL, BGIError, "the window process ended unexpectedly (exit status -9)"),
]


def wait_until(done: Callable[[], bool]) -> None:
    """Wait for something that will happen soon."""
    deadline = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.005)


def gone(pid: int) -> bool:
    """Whether a process has ended; one that nobody has buried yet has."""
    state = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True)
    return state.stdout.strip()[:1] in ("", "Z")


def memory_of(pid: int) -> int:
    """The memory that a process really uses, in kilobytes (Linux only)."""
    with open(f"/proc/{pid}/status") as status:
        return int(next(line for line in status if line.startswith("VmRSS")).split()[1])


def shared_memory() -> set[str]:
    """The names of shared memory there are on this machine."""
    return set(os.listdir("/dev/shm")) if os.path.isdir("/dev/shm") else set()
