"""What the kernel keeps beyond any screen, in one object: all screens share it.

closegraph() leaves it alone. It is always reached through `KERNEL`, as in `KERNEL.fonts`, so that
`KERNEL.reset()` makes all of it new: a test begins with that.
"""

from dataclasses import dataclass

from bgi.constants import (
    grError,
    grFileNotFound,
    grFontNotFound,
    grInvalidDriver,
    grInvalidFont,
    grInvalidFontNum,
    grInvalidMode,
    grInvalidVersion,
    grIOerror,
    grNoFloodMem,
    grNoFontMem,
    grNoInitGraph,
    grNoLoadMem,
    grNoScanMem,
    grNotDetected,
    grOk,
)
from bgi.errors import GraphicsError
from bgi.fonts.layout import Scale
from bgi.fonts.table import FontTable
from bgi.kernel.callers import call
from bgi.kernel.drivers import DriverTable

MESSAGES = {
    grOk: "No error",
    grNoInitGraph: "(BGI) graphics not installed",
    grNotDetected: "Graphics hardware not detected",
    grFileNotFound: "Device driver file not found ({driver})",
    grInvalidDriver: "Invalid device driver file ({driver})",
    grNoLoadMem: "Not enough memory to load driver",
    grNoScanMem: "Out of memory in scan fill",
    grNoFloodMem: "Out of memory in flood fill",
    grFontNotFound: "Font file not found ({font})",
    grNoFontMem: "Not enough memory to load font",
    grInvalidMode: "Invalid graphics mode for selected driver",
    grError: "Graphics error",
    grIOerror: "Graphics I/O error",
    grInvalidFont: "Invalid font file ({font})",
    grInvalidFontNum: "Invalid font number",
    -16: "Invalid Printer Initialize",
    -17: "Printer Module Not Linked",
    grInvalidVersion: "Invalid File Version Number",
}
"""Borland's sentences for its error codes, with the last driver's file and the last font's."""


class Result:
    """The kernel's one error code: set by whatever fails, cleared by being read."""

    def __init__(self) -> None:
        self._code = grOk
        self.driver_file = ""
        self.font_file = ""
        self.strict = False
        """Whether every error is raised as well: see `bgi.strict`."""

    def set(self, code: int, why: str = "") -> None:
        """Remember `code` until somebody asks; in strict mode raise it, with `why` in its words."""
        self._code = code
        if self.strict and code != grOk:
            raise GraphicsError(*call(), code, self.message(code), why)

    def take(self) -> int:
        """Return the code and clear it, as graphresult() does."""
        code, self._code = self._code, grOk
        return code

    def message(self, code: int) -> str:
        """Borland's sentence for an error code; an unknown one is quoted, as 16 bits unsigned."""
        sentence = MESSAGES.get(code, f"Graphics error ({code & 0xFFFF})")
        return sentence.format(driver=self.driver_file, font=self.font_file)


@dataclass
class Pace:
    """How fast everything is drawn: see `bgi.slow`."""

    rate: int = 0
    """Pixels a second; 0: as fast as can be."""
    stepping: bool = False
    """Whether each call waits for a key."""
    owed: float = 0.0
    """Seconds that have not been waited for yet."""

    @property
    def is_slow(self) -> bool:
        """Whether there is anything to watch."""
        return self.rate > 0 or self.stepping


class Kernel:
    """The error code, the tables of fonts and drivers, and what survives initgraph()."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Everything as it is when a program begins."""
        self.result = Result()
        self.pace = Pace()
        self.fonts = FontTable()
        self.drivers = DriverTable()
        self.arc = 0, 0, 0, 0, 0, 0
        """For getarccoords(): the last curve's centre, then start and end angle and both radii of
        the last curve that set its ends."""
        self.user_scale = Scale(1, 1, 1, 1)
        """What setusercharsize() was given last."""
        self.bufsize = 4096
        """What setgraphbufsize() was given last, in bytes."""
        self.why_no_screen = ""
        """What was wrong with the last initgraph(), if it opened no screen."""
        self.typed = ""
        """What has been typed for scanf() and its like, and not been read yet."""
        self.seed = 1
        """The state of Borland's random numbers: see `bgi.stdlib.rand`."""


KERNEL = Kernel()
