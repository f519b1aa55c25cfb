"""An end for a program that nobody ends: a thread watches how long it computes.

Every system has threads; a timer of the processor's time, as setitimer() is, Windows has not.
"""

from __future__ import annotations

import _thread
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from types import TracebackType

LOOK_SECONDS = 1.0
"""Between two looks at the clock: longer than the way out of a deep recursion takes."""


class TimeLimit:
    """Ends what the main thread computes in its block, once that has taken too long."""

    def __init__(self, seconds: float, stop: Callable[[], None]) -> None:
        """
        Args:
            seconds: of the processor.
            stop: called in the main thread when they are over; raises what ends the program.
        """
        self._seconds = seconds
        self._stop = stop
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> None:
        self._before = signal.signal(signal.SIGTERM, self._hear)
        with suppress(RuntimeError):  # a page has no threads: there its tab can be closed
            self._thread.start()

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._ended.set()
        if self._thread.is_alive():
            self._thread.join()
        signal.signal(signal.SIGTERM, self._before or signal.SIG_DFL)

    def _watch(self) -> None:
        """Interrupt the main thread again and again: what it is in may swallow an exception."""
        begin = time.process_time()
        while not self._ended.wait(LOOK_SECONDS):
            if time.process_time() - begin > self._seconds:
                _thread.interrupt_main(signal.SIGTERM)

    def _hear(self, number: int, frame: object) -> None:
        if not self._ended.is_set():
            self._stop()
