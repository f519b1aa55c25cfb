"""What other programs take, from their beginning to their end."""

import subprocess
import sys
import time
from collections.abc import Mapping, Sequence


def wall_seconds(command: Sequence[str], environment: Mapping[str, str] | None = None) -> float:
    """How long one waits for a program."""
    start = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True, env=environment)
    return time.perf_counter() - start


def cpu_seconds(command: Sequence[str]) -> float:
    """The processor time that a program uses; on Windows how long one waits for it."""
    if sys.platform == "win32":
        return wall_seconds(command)
    import resource

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    wall_seconds(command)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
