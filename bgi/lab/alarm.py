"""Ends a call that takes too long and runs no lines that could be counted, as `while True: pass`.

A thread raises an exception in the one that makes the call, again and again until the call is over.
Only Python's own code can be ended so: nothing ends `time.sleep(1000)` before its time.
"""

from __future__ import annotations

import ctypes
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress

LOOK_SECONDS = 0.2
IDLE_LOOKS = 10
"""After so many looks at nothing the thread ends; the next call begins another one."""

LATE = 1000
"""Rounds of a loop in which one comes through that was raised just before the end."""

# Looked up at once: in a submission that is graded nothing may be looked up later.
_raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc


class Alarm:
    """Watches one call at a time."""

    def __init__(self, error: type[BaseException]) -> None:
        self._error = error
        self._lock = threading.Lock()
        self._end: float | None = None
        self._thread_id = 0
        self._looks_left = 0
        self.rang = False
        """Whether the last call had to be ended."""

    @contextmanager
    def after(self, seconds: float) -> Iterator[None]:
        """End what follows if it takes longer; one within another is not watched."""
        if self._end is not None:
            yield
            return
        with self._lock:
            self.rang = False
            self._thread_id = threading.get_ident()
            self._end = time.monotonic() + seconds
            asleep, self._looks_left = self._looks_left <= 0, IDLE_LOOKS
        if asleep:
            with suppress(RuntimeError):  # there are no threads in a browser
                threading.Thread(target=self._watch, name="bgi lab", daemon=True).start()
        try:
            yield
        finally:
            with suppress(self._error):  # one may come twice
                with self._lock:
                    self._end = None
                for _ in range(LATE if self.rang else 0):
                    pass
            self._end = None

    def _watch(self) -> None:
        while True:
            time.sleep(LOOK_SECONDS)
            with self._lock:
                if self._end is None:
                    self._looks_left -= 1
                elif time.monotonic() > self._end:
                    self.rang = True
                    _raise_in(ctypes.c_ulong(self._thread_id), ctypes.py_object(self._error))
                if self._looks_left <= 0:
                    return
