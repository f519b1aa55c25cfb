"""What the kernel keeps beyond any screen, in one object: all screens share it.

closegraph() leaves it alone. It is always reached through `KERNEL`, as in `KERNEL.fonts`, so that
`KERNEL.reset()` makes all of it new: a test begins with that.
"""

from bgi.constants import ERROR_MESSAGES, grOk
from bgi.fonts.table import FontTable
from bgi.kernel.drivers import DriverTable


class Result:
    """The kernel's one error code: set by whatever fails, cleared by being read."""

    def __init__(self) -> None:
        self._code = grOk
        self._file = ""

    def set(self, code: int, file: str = "") -> None:
        """Remember `code` until somebody asks, and for its message the file it is about."""
        self._code = code
        self._file = file or self._file

    def take(self) -> int:
        """Return the code and clear it, as graphresult() does."""
        code, self._code = self._code, grOk
        return code

    def message(self, code: int) -> str:
        """Borland's sentence for an error code; an unknown code is quoted in it."""
        return ERROR_MESSAGES.get(code, f"Graphics error ({code})").format(file=self._file)


class Kernel:
    """The error code, the tables of fonts and drivers, and two numbers."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Everything as it is when a program begins."""
        self.result = Result()
        self.fonts = FontTable()
        self.drivers = DriverTable()
        self.bufsize = 4096
        """What setgraphbufsize() was given last, in bytes."""
        self.seed = 1
        """The state of Borland's random numbers: see `bgi.dos.rand`."""


KERNEL = Kernel()
