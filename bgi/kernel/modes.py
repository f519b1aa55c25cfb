"""The table of drivers and modes: what each adapter of the PC could show.

Sizes, colours, aspect ratios and names are those of Borland's own driver tables. Two things are
chosen: every mode has at least two pages, so that double buffering works everywhere (the adapter's
own number stands beside it), and the 8514 driver reports all of its 256 colours.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

from bgi.constants import (
    ATT400,
    CGA,
    EGA,
    EGA64,
    EGAMONO,
    EGAMONOHI,
    HERCMONO,
    IBM8514,
    MCGA,
    PC3270,
    VGA,
    VGAHI,
)

YASP = 10_000
"""The second number of every mode's aspect ratio: getaspectratio() returns xasp, YASP."""


class Driver(NamedTuple):
    """A .BGI file: its name, and how it draws where drivers differ (Turbo C++ 3.0, captured)."""

    name: str
    packed: bool = False
    """Whether it packs several pixels into a byte. Such a driver draws lines to the right, others
    draw them downwards; the highest bit of a line pattern is the first, not the lowest; a colour
    that the mode lacks is the largest, where others take its low bits; fill patterns differ."""
    tall_text: bool = False
    """Whether the built-in font, enlarged, grows once more in height than in width."""


_CGA = Driver("CGA", packed=True)
_EGAVGA = Driver("EGAVGA")
DRIVERS = {
    CGA: _CGA,
    MCGA: _CGA,
    EGA: _EGAVGA,
    EGA64: _EGAVGA,
    EGAMONO: _EGAVGA,
    IBM8514: Driver("IBM8514"),
    HERCMONO: Driver("HERC", packed=True, tall_text=True),
    ATT400: Driver("ATT"),
    VGA: _EGAVGA,
    PC3270: Driver("PC3270"),
}
"""The drivers by number; those that have not been studied draw like EGAVGA."""


@dataclass(frozen=True, slots=True)  # read at every call, and slots are read fastest
class GraphicsMode:
    """One row of the table."""

    driver: int
    number: int
    width: int
    height: int
    colors: int
    pages: int
    """Pages of memory here: at least two."""
    original_pages: int
    """Pages that the adapter had."""
    xasp: int
    palette: str
    """The name of its default palette in `bgi.memory.palette`."""
    name: str
    """What getmodename() says, blanks and all."""

    pixel_bytes: int = 1
    """4 in a window: an index, or a colour of its own as `bgi.memory.rgb` writes it."""
    square: bool = False
    """Whether its pixels are shown as squares; else the picture is stretched to 4:3."""
    maxcolor: int = field(init=False)
    """The largest colour index, which is also the mask of a pixel's bits."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "maxcolor", self.colors - 1)

    @property
    def is_window(self) -> bool:
        """Whether it is a window of initwindow()."""
        return self.pixel_bytes == 4

    @property
    def file(self) -> Driver:
        """The driver that draws in it; one that was installed draws like EGAVGA."""
        return DRIVERS.get(self.driver, _EGAVGA)


MODES = [
    # driver, mode, width, height, colours, pages, original, xasp, palette, name
    *(
        GraphicsMode(d, m, 320, 200, 4, 2, 1, 8333, f"CGAC{m}", f"320 x 200 CGA {letter}{m}  ")
        for d, letter in ((CGA, "C"), (MCGA, "C"), (ATT400, "P"))
        for m in range(4)
    ),
    GraphicsMode(CGA, 4, 640, 200, 2, 2, 1, 4167, "CGAHI", "640 x 200 CGA     "),
    GraphicsMode(MCGA, 4, 640, 200, 2, 2, 1, 4167, "CGAHI", "640 x 200 CGA     "),
    GraphicsMode(MCGA, 5, 640, 480, 2, 2, 1, 10000, "CGAHI", "640 x 480 MCGA    "),
    GraphicsMode(EGA, 0, 640, 200, 16, 4, 4, 4500, "EGA200", "640 x 200 EGA"),
    GraphicsMode(EGA, 1, 640, 350, 16, 2, 2, 7750, "EGA350", "640 x 350 EGA"),
    GraphicsMode(EGA64, 0, 640, 200, 16, 2, 1, 4500, "EGA200", "640 x 200 EGA"),
    GraphicsMode(EGA64, 1, 640, 350, 4, 2, 1, 7750, "EGA64HI", "640 x 350 EGA"),
    GraphicsMode(EGAMONO, 3, 640, 350, 2, 4, 4, 7750, "MONO", "640 X 350 EGA MONO"),
    GraphicsMode(IBM8514, 0, 640, 480, 256, 2, 1, 10000, "IBM8514", "640 x 480  8514/A AI"),
    GraphicsMode(IBM8514, 1, 1024, 768, 256, 2, 1, 10000, "IBM8514", "1024 x 768 8514/A AI"),
    GraphicsMode(HERCMONO, 0, 720, 348, 2, 2, 2, 7500, "MONO", "720 x 348 HERCULES"),
    GraphicsMode(ATT400, 4, 640, 200, 2, 2, 1, 4167, "CGAHI", "640 x 200 CGA     "),
    GraphicsMode(ATT400, 5, 640, 400, 2, 2, 1, 8750, "CGAHI", "640 x 400 AT&T"),
    GraphicsMode(VGA, 0, 640, 200, 16, 4, 4, 4500, "EGA200", "640 x 200 EGA"),
    GraphicsMode(VGA, 1, 640, 350, 16, 2, 2, 7750, "EGA350", "640 x 350 EGA"),
    GraphicsMode(VGA, 2, 640, 480, 16, 2, 1, 10000, "EGA350", "640 x 480 VGA"),
    GraphicsMode(PC3270, 0, 720, 350, 2, 2, 1, 6481, "MONO", "720 x 350 3270 PC"),
]
SVGA256 = [
    GraphicsMode(0, number, width, height, 256, 2, 1, xasp, "IBM8514", f"{width}x{height}x256 SVGA")
    for number, (width, height, xasp) in enumerate(
        [
            (320, 200, 8333),
            (640, 400, 8333),
            (640, 480, 10000),
            (800, 600, 10000),
            (1024, 768, 10000),
        ]
    )
]
"""The modes of the well-known driver SVGA256.BGI, which installuserdriver() adds."""

BIOS_ONLY = [
    GraphicsMode(VGA, 0x0D, 320, 200, 16, 8, 8, 8333, "EGA200", "320 x 200 EGA"),
    GraphicsMode(VGA, 0x13, 320, 200, 256, 2, 1, 8333, "IBM8514", "320 x 200 VGA"),
]
"""Modes that no driver has, and programs set by interrupt 10h; their numbers are the BIOS's."""

_BY_NUMBER = {(mode.driver, mode.number): mode for mode in MODES}
_BY_NUMBER[EGAMONO, EGAMONOHI] = _BY_NUMBER[EGAMONO, 3]  # to graphics.h it is 0, to the driver 3


def window(width: int, height: int) -> GraphicsMode:
    """The mode of a window of any size, in 16 colours and 16 million: WinBGIm's initwindow()."""
    name = f"{width} x {height} window"
    return GraphicsMode(
        VGA, VGAHI, width, height, 16, 4, 4, YASP, "WINDOW", name, pixel_bytes=4, square=True
    )


def find(driver: int, number: int) -> GraphicsMode | None:
    """The mode with that number of that driver, or None."""
    return _BY_NUMBER.get((driver, number))


def mode_range(driver: int) -> tuple[int, int]:
    """The lowest and highest mode number of a driver; (-1, -1) for an unknown one."""
    numbers = [mode.number for mode in MODES if mode.driver == driver]
    return (min(numbers), max(numbers)) if numbers else (-1, -1)
