"""What the kernel keeps beyond any screen, in one object: all screens share it.

closegraph() leaves it alone. It is always reached through `KERNEL`, as in `KERNEL.fonts`, so that
`KERNEL.reset()` makes all of it new: a test begins with that.
"""

from bgi.constants import (
    grError,
    grFileNotFound,
    grFontNotFound,
    grInvalidDeviceNum,
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
from bgi.fonts.table import FontTable
from bgi.kernel.drivers import DriverTable

MESSAGES = {
    grOk: "No error",
    grNoInitGraph: "(BGI) graphics not installed",
    grNotDetected: "Graphics hardware not detected",
    grFileNotFound: "Device driver file not found ({file})",
    grInvalidDriver: "Invalid device driver file ({file})",
    grNoLoadMem: "Not enough memory to load driver",
    grNoScanMem: "Out of memory in scan fill",
    grNoFloodMem: "Out of memory in flood fill",
    grFontNotFound: "Font file not found ({file})",
    grNoFontMem: "Not enough memory to load font",
    grInvalidMode: "Invalid graphics mode for selected driver",
    grError: "Graphics error",
    grIOerror: "Graphics I/O error",
    grInvalidFont: "Invalid font file ({file})",
    grInvalidFontNum: "Invalid font number",
    grInvalidDeviceNum: "Invalid device number",
    grInvalidVersion: "Invalid File Version Number",
}
"""Borland's sentences for its error codes; the file is the one that a font or driver lies in."""


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
        return MESSAGES.get(code, f"Graphics error ({code})").format(file=self._file)


class Kernel:
    """The error code, the tables of fonts and drivers, and what survives initgraph()."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Everything as it is when a program begins."""
        self.result = Result()
        self.fonts = FontTable()
        self.drivers = DriverTable()
        self.curve = 0, 0, ((0, 0), (0, 0))
        """For getarccoords(): the last curve's centre; from there, the ends of the last curve that
        told them."""
        self.bufsize = 4096
        """What setgraphbufsize() was given last, in bytes."""
        self.seed = 1
        """The state of Borland's random numbers: see `bgi.dos.rand`."""


KERNEL = Kernel()
