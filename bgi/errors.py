"""The exceptions of the package.

What Borland answered with a code is a code here too: `graphresult()` hands it out. A `BGIError` is
raised where Borland's library could only have crashed, hung or ended the program.
"""

import sys
from types import TracebackType


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
