"""What goes wrong, in two kinds.

What Borland answered with a code is a code here too: `result` holds the one sticky number that
`graphresult()` hands out and clears. What Borland's library could only have crashed, hung or ended
the program on raises a `BGIError`.
"""

import sys
from types import TracebackType

from bgi.constants import ERROR_MESSAGES, grOk


class BGIError(RuntimeError):
    """A call that cannot be carried out: no graphics mode, no window, no key to wait for."""


class WindowClosed(BGIError):
    """The user closed the window; raised by the program's next call."""


def say_in_one_line() -> None:
    """From now on, a program that ends because its window was closed says so without a traceback.

    It is what a user does with most programs, and nothing to look into. Whoever else handles
    uncaught exceptions is asked about all others.
    """
    before = sys.excepthook
    if getattr(before, "__module__", None) == __name__:
        return

    def hook(
        kind: type[BaseException], error: BaseException, traceback: TracebackType | None
    ) -> None:
        if isinstance(error, WindowClosed):
            print(f"bgi: {error}", file=sys.stderr)
        else:
            before(kind, error, traceback)

    sys.excepthook = hook


class Result:
    """The kernel's one error code: set by whatever fails, cleared by being read."""

    def __init__(self) -> None:
        self.code = grOk
        self.file = ""

    def set(self, code: int, file: str = "") -> None:
        """Remember `code` until somebody asks, and for its message the file it is about."""
        self.code = code
        self.file = file or self.file

    def take(self) -> int:
        """Return the code and clear it, as graphresult() does."""
        code, self.code = self.code, grOk
        return code


result = Result()


def message(code: int) -> str:
    """Borland's sentence for an error code; an unknown code is quoted in it."""
    return ERROR_MESSAGES.get(code, f"Graphics error ({code})").format(file=result.file)
