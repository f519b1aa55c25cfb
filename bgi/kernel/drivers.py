"""The kernel's driver table: which number means which driver, and which modes it has.

The ten drivers of graphics.h have the numbers 1..10; installuserdriver() adds up to ten more, from
16 on. Of those only SVGA256 brings modes: the driver that gave Borland's programs 256 colours.
"""

from collections.abc import Callable
from dataclasses import replace

from bgi.constants import grError, grInvalidDriver
from bgi.kernel import modes
from bgi.kernel.arguments import whole
from bgi.kernel.modes import GraphicsMode

Detect = Callable[[], int]
"""A driver's own detection: returns the mode to use, or a negative number without its adapter."""

FIRST_INSTALLED = 16
MAX_INSTALLED = 10
_SIGNATURE = b"pk\x08\x08"
_NAME_LENGTH = 8  # of a file in DOS


class DriverTable:
    """The drivers by number."""

    def __init__(self) -> None:
        self._installed: dict[str, Detect | None] = {}

    def install(self, name: str, detect: Detect | None) -> int:
        """Add a driver; its number, the one it has if it is there already, or -11 when full."""
        if name not in self._installed and len(self._installed) == MAX_INSTALLED:
            return grError
        self._installed[name] = detect
        return FIRST_INSTALLED + list(self._installed).index(name)

    def register(self, driver: str | bytes) -> int:
        """The first number of a driver by its file's name or bytes; -4 if it is not Borland's."""
        name = name_in_file(driver) if isinstance(driver, bytes) else driver
        numbers = (number for number, known in modes.DRIVERS.items() if known.name == name)
        return next(numbers, grInvalidDriver)

    def name(self, driver: int) -> str | None:
        """The name of a driver's file, None for an unknown number."""
        if 0 <= driver - FIRST_INSTALLED < len(self._installed):
            return list(self._installed)[driver - FIRST_INSTALLED]
        known = modes.DRIVERS.get(driver)
        return known.name if known else None

    def find(self, driver: int, number: int) -> GraphicsMode | None:
        """The mode with that number of that driver, or None."""
        if driver < FIRST_INSTALLED:
            return modes.find(driver, number)
        known = self.name(driver) == "SVGA256" and 0 <= number < len(modes.SVGA256)
        return replace(modes.SVGA256[number], driver=driver) if known else None

    def mode_range(self, driver: int) -> tuple[int, int]:
        """The lowest and highest mode number of a driver; (-1, -1) without any."""
        if driver < FIRST_INSTALLED:
            return modes.mode_range(driver)
        return (0, len(modes.SVGA256) - 1) if self.find(driver, 0) else (-1, -1)

    def autodetect(self) -> tuple[int, int] | None:
        """Ask the installed drivers, in order; the first that finds its adapter, and its mode."""
        for number, detect in enumerate(self._installed.values(), FIRST_INSTALLED):
            mode = whole("detect's answer", detect()) if detect else -1
            if mode >= 0:
                return number, mode
        return None


def name_in_file(data: bytes) -> str:
    """The name that stands in brackets at the start of a .BGI file; "" if it is no such file.

    `pk`, 08h 08h, then a line for people: "BGI Device Driver (EGAVGA) 2.00 - ...".
    """
    if not data.startswith(_SIGNATURE):
        return ""
    _, _, rest = data.partition(b"(")
    return rest[:_NAME_LENGTH].split(b")")[0].decode("latin-1")
