"""The structures of graphics.h, and the settings that graphdefaults() resets."""

from dataclasses import dataclass, field
from typing import NamedTuple

from bgi.constants import (
    COPY_PUT,
    DEFAULT_FONT,
    HORIZ_DIR,
    LEFT_TEXT,
    NORM_WIDTH,
    SOLID_FILL,
    SOLID_LINE,
    TOP_TEXT,
)
from bgi.raster.patterns import SOLID_ROWS


class pointtype(NamedTuple):
    """A corner of a polygon: drawpoly() and fillpoly() take a list of these, or of plain pairs."""

    x: int
    y: int


@dataclass(slots=True)
class linesettingstype:
    """What getlinesettings() returns: style 0..4, the sixteen bits given, and thickness."""

    linestyle: int = SOLID_LINE
    upattern: int = 0
    thickness: int = NORM_WIDTH


@dataclass(slots=True)
class fillsettingstype:
    """What getfillsettings() returns: pattern 0..12 and the colour given."""

    pattern: int
    color: int


@dataclass(slots=True)
class textsettingstype:
    """What gettextsettings() returns: font, direction, size, and both justifications."""

    font: int = DEFAULT_FONT
    direction: int = HORIZ_DIR
    charsize: int = 1
    horiz: int = LEFT_TEXT
    vert: int = TOP_TEXT


@dataclass(slots=True)
class viewporttype:
    """What getviewsettings() returns: absolute corners, inclusive, and whether clipping is on."""

    left: int
    top: int
    right: int
    bottom: int
    clip: int


@dataclass(slots=True)
class arccoordstype:
    """What getarccoords() returns: centre, start and end of the last arc, in the viewport."""

    x: int
    y: int
    xstart: int
    ystart: int
    xend: int
    yend: int


@dataclass(slots=True)
class palettetype:
    """What getpalette() returns: the number of entries and their hardware colours."""

    size: int
    colors: list[int]


@dataclass(slots=True)
class text_info:
    """What gettextinfo() returns: the window, attributes, mode and size, and the cursor in it."""

    winleft: int
    wintop: int
    winright: int
    winbottom: int
    attribute: int
    normattr: int
    currmode: int
    screenheight: int
    screenwidth: int
    curx: int
    cury: int


@dataclass(slots=True)
class Settings:
    """Everything that graphdefaults() puts back, except the palette."""

    color: int
    fill: fillsettingstype
    view: viewporttype
    x: int = 0
    y: int = 0
    user_rows: bytes = SOLID_ROWS
    line: linesettingstype = field(default_factory=linesettingstype)
    text: textsettingstype = field(default_factory=textsettingstype)
    writemode: int = COPY_PUT

    @classmethod
    def defaults(cls, maxcolor: int, width: int, height: int) -> "Settings":
        """The settings after initgraph: the largest colour, the whole screen, solid everything."""
        return cls(
            color=maxcolor,
            fill=fillsettingstype(SOLID_FILL, maxcolor),
            view=viewporttype(0, 0, width - 1, height - 1, 1),
        )
