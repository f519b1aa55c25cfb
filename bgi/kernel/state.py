"""What the kernel keeps beyond any screen: its tables of drivers and fonts.

closegraph() leaves them alone, and all screens share them.
"""

from collections.abc import Callable
from dataclasses import replace

from bgi.constants import PC3270, grError
from bgi.fonts.table import FontTable
from bgi.kernel import modes
from bgi.kernel.modes import GraphicsMode

Detect = Callable[[], int]


class DriverTable:
    """The drivers of graphics.h, and up to ten that installuserdriver() adds, from number 11 on.

    Of those only SVGA256 brings modes: the driver that gave Borland's programs 256 colours.
    """

    MOST = 10

    def __init__(self) -> None:
        self._installed: list[tuple[str, Detect | None]] = []

    def install(self, name: str, detect: Detect | None) -> int:
        """Add a driver; its number, the one it has if it is there already, or -11 when full."""
        names = [known for known, _ in self._installed]
        if name in names:
            self._installed[names.index(name)] = name, detect
            return PC3270 + 1 + names.index(name)
        if len(names) == self.MOST:
            return grError
        self._installed.append((name, detect))
        return PC3270 + len(self._installed)

    def name(self, driver: int) -> str | None:
        """The name of a driver's file, None for an unknown number."""
        if 0 <= driver - PC3270 - 1 < len(self._installed):
            return self._installed[driver - PC3270 - 1][0]
        return modes.DRIVER_NAMES.get(driver)

    def find(self, driver: int, number: int) -> GraphicsMode | None:
        """The mode with that number of that driver, or None."""
        if driver <= PC3270:
            return modes.find(driver, number)
        known = self.name(driver) == "SVGA256" and 0 <= number < len(modes.SVGA256)
        return replace(modes.SVGA256[number], driver=driver) if known else None

    def mode_range(self, driver: int) -> tuple[int, int]:
        """The lowest and highest mode number of a driver; (-1, -1) without any."""
        if driver <= PC3270:
            return modes.mode_range(driver)
        return (0, len(modes.SVGA256) - 1) if self.find(driver, 0) else (-1, -1)

    def autodetect(self) -> tuple[int, int] | None:
        """Ask the installed drivers, in order; the first that finds its adapter, and its mode."""
        for place, (_, detect) in enumerate(self._installed):
            mode = detect() if detect else -1
            if mode >= 0:
                return PC3270 + 1 + place, mode
        return None


FONTS = FontTable()
DRIVERS = DriverTable()
