"""How a program ends: one rule, whatever its monitor and however the end comes.

The program's end is the screen's end: windows go, and the files that are planned are written. A
program that ends because its window is gone made no error: its exit status is 0, and one line says
why, unless it was planned.
"""

import atexit
import functools
import signal
import sys
import threading
from collections.abc import Callable
from types import FrameType, TracebackType

from bgi.errors import TimeIsUp, WindowClosed
from bgi.kernel import hints

GRACE_SECONDS = 1.0  # in which a program may make a call, and so learn that its time is up

_interrupted: WindowClosed | None = None
"""Why the program has been interrupted, if it was not the user's Ctrl-C."""


def follow_program(end: Callable[[], None], close: Callable[[], None]) -> None:
    """From now on the program's end is that of its screens.

    `end` lets go of them when it ends by itself, `close` at Ctrl-C: at once.
    """
    before, thread_before = sys.excepthook, threading.excepthook

    def hook(
        kind: type[BaseException], error: BaseException, traceback: TracebackType | None
    ) -> None:
        why = reason(error)
        if why is None:
            if kind is KeyboardInterrupt:
                close()
            hints.add_to(error, traceback)
            before(kind, error, traceback)
            return
        _say(why)
        if not at_a_prompt():
            raise SystemExit(0)  # which Python takes for the program's own

    def thread_hook(args: threading.ExceptHookArgs) -> None:
        why = reason(args.exc_value)
        if why is None:
            thread_before(args)
        else:
            _say_once(why)

    atexit.register(end)
    sys.excepthook, threading.excepthook = hook, thread_hook
    in_main_thread = threading.current_thread() is threading.main_thread()
    if in_main_thread and signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, _ignore_the_user)


def _ignore_the_user(number: int, frame: FrameType | None) -> None:
    """Ctrl-C where it is ignored, as after nohup or `&` in a script: only `interrupt` is heard."""
    if _interrupted:
        raise KeyboardInterrupt


def interrupt(error: WindowClosed) -> None:
    """End a program that makes no call, by something like Ctrl-C that `error` explains.

    Such a program sleeps, computes or waits for something else. One that has met the error is
    left to end in its own way.
    """

    def end() -> None:
        global _interrupted
        met = error.__traceback__ is not None  # raised, so it is on its way through the program
        if met or at_a_prompt():
            return
        _interrupted = error
        if sys.platform == "win32":
            signal.raise_signal(signal.SIGINT)
        else:  # a real signal: it ends a sleep
            signal.pthread_kill(_main_thread(), signal.SIGINT)

    timer = threading.Timer(GRACE_SECONDS, end)
    timer.daemon = True
    timer.start()


def _main_thread() -> int:
    return threading.main_thread().ident or 0


def reason(error: BaseException | None) -> WindowClosed | None:
    """Why a program ends that is about to die of `error`; None if it is an error of its own."""
    if isinstance(error, KeyboardInterrupt):
        return _interrupted
    return error if isinstance(error, WindowClosed) else None


def _say(why: WindowClosed) -> None:
    if not isinstance(why, TimeIsUp) or at_a_prompt():
        print(f"bgi: {why}", file=sys.stderr)


_say_once = functools.cache(_say)  # and not once for every thread


def at_a_prompt() -> bool:
    """Whether somebody sits at Python's prompt, or IDLE's, and will go on after an error."""
    return hasattr(sys, "ps1") or bool(sys.flags.inspect) or "idlelib.run" in sys.modules
