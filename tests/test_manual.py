"""Parity with the manual's lists: every function, constant and structure of graphics.h."""

import inspect

import pytest

import bgi

MANUAL = [
    "arc",
    "bar",
    "bar3d",
    "circle",
    "cleardevice",
    "clearviewport",
    "closegraph",
    "detectgraph",
    "drawpoly",
    "ellipse",
    "fillellipse",
    "fillpoly",
    "floodfill",
    "getarccoords",
    "getaspectratio",
    "getbkcolor",
    "getcolor",
    "getdefaultpalette",
    "getdrivername",
    "getfillpattern",
    "getfillsettings",
    "getgraphmode",
    "getimage",
    "getlinesettings",
    "getmaxcolor",
    "getmaxmode",
    "getmaxx",
    "getmaxy",
    "getmodename",
    "getmoderange",
    "getpalette",
    "getpalettesize",
    "getpixel",
    "gettextsettings",
    "getviewsettings",
    "getx",
    "gety",
    "graphdefaults",
    "grapherrormsg",
    "_graphfreemem",
    "_graphgetmem",
    "graphresult",
    "imagesize",
    "initgraph",
    "installuserdriver",
    "installuserfont",
    "line",
    "linerel",
    "lineto",
    "moverel",
    "moveto",
    "outtext",
    "outtextxy",
    "pieslice",
    "putimage",
    "putpixel",
    "rectangle",
    "registerbgidriver",
    "registerbgifont",
    "registerfarbgidriver",
    "registerfarbgifont",
    "restorecrtmode",
    "sector",
    "setactivepage",
    "setallpalette",
    "setaspectratio",
    "setbkcolor",
    "setcolor",
    "setfillpattern",
    "setfillstyle",
    "setgraphbufsize",
    "setgraphmode",
    "setlinestyle",
    "setpalette",
    "setrgbpalette",
    "settextjustify",
    "settextstyle",
    "setusercharsize",
    "setviewport",
    "setvisualpage",
    "setwritemode",
    "textheight",
    "textwidth",
]

NUMBERED_FROM_ZERO = {
    "drivers": "DETECT CGA MCGA EGA EGA64 EGAMONO IBM8514 HERCMONO ATT400 VGA PC3270",
    "modes of CGA": "CGAC0 CGAC1 CGAC2 CGAC3 CGAHI",
    "modes of MCGA": "MCGAC0 MCGAC1 MCGAC2 MCGAC3 MCGAMED MCGAHI",
    "modes of EGA": "EGALO EGAHI",
    "modes of EGA64": "EGA64LO EGA64HI",
    "modes of EGAMONO": "EGAMONOHI",
    "modes of HERCMONO": "HERCMONOHI",
    "modes of ATT400": "ATT400C0 ATT400C1 ATT400C2 ATT400C3 ATT400MED ATT400HI",
    "modes of VGA": "VGALO VGAMED VGAHI",
    "modes of PC3270": "PC3270HI",
    "modes of IBM8514": "IBM8514LO IBM8514HI",
    "colours": "BLACK BLUE GREEN CYAN RED MAGENTA BROWN LIGHTGRAY DARKGRAY LIGHTBLUE LIGHTGREEN"
    " LIGHTCYAN LIGHTRED LIGHTMAGENTA YELLOW WHITE",
    "line styles": "SOLID_LINE DOTTED_LINE CENTER_LINE DASHED_LINE USERBIT_LINE",
    "fill patterns": "EMPTY_FILL SOLID_FILL LINE_FILL LTSLASH_FILL SLASH_FILL BKSLASH_FILL"
    " LTBKSLASH_FILL HATCH_FILL XHATCH_FILL INTERLEAVE_FILL WIDE_DOT_FILL CLOSE_DOT_FILL USER_FILL",
    "fonts": "DEFAULT_FONT TRIPLEX_FONT SMALL_FONT SANS_SERIF_FONT GOTHIC_FONT SCRIPT_FONT"
    " SIMPLEX_FONT TRIPLEX_SCR_FONT COMPLEX_FONT EUROPEAN_FONT BOLD_FONT",
    "directions": "HORIZ_DIR VERT_DIR",
    "across": "LEFT_TEXT CENTER_TEXT RIGHT_TEXT",
    "up and down": "BOTTOM_TEXT CENTER_TEXT TOP_TEXT",
    "putimage": "COPY_PUT XOR_PUT OR_PUT AND_PUT NOT_PUT",
    "errors": "grOk grNoInitGraph grNotDetected grFileNotFound grInvalidDriver grNoLoadMem"
    " grNoScanMem grNoFloodMem grFontNotFound grNoFontMem grInvalidMode grError grIOerror"
    " grInvalidFont grInvalidFontNum grInvalidDeviceNum",
}
"""The manual's enumerations, in order; the errors downwards."""

OTHER_NUMBERS = {
    "CURRENT_DRIVER": -1,
    "grInvalidVersion": -18,
    "MAXCOLORS": 15,
    "BLINK": 128,
    "NORM_WIDTH": 1,
    "THICK_WIDTH": 3,
    "USER_CHAR_SIZE": 0,
    **{"CGA_LIGHTGREEN": 1, "CGA_LIGHTRED": 2, "CGA_YELLOW": 3},
    **{"CGA_LIGHTCYAN": 1, "CGA_LIGHTMAGENTA": 2, "CGA_WHITE": 3},
    **{"CGA_GREEN": 1, "CGA_RED": 2, "CGA_BROWN": 3},
    **{"CGA_CYAN": 1, "CGA_MAGENTA": 2, "CGA_LIGHTGRAY": 3},
    **{"EGA_BLACK": 0, "EGA_BLUE": 1, "EGA_GREEN": 2, "EGA_CYAN": 3},
    **{"EGA_RED": 4, "EGA_MAGENTA": 5, "EGA_BROWN": 20, "EGA_LIGHTGRAY": 7},
    **{"EGA_DARKGRAY": 56, "EGA_LIGHTBLUE": 57, "EGA_LIGHTGREEN": 58, "EGA_LIGHTCYAN": 59},
    **{"EGA_LIGHTRED": 60, "EGA_LIGHTMAGENTA": 61, "EGA_YELLOW": 62, "EGA_WHITE": 63},
}

STRUCTURES = {
    "palettetype": "size colors",
    "linesettingstype": "linestyle upattern thickness",
    "textsettingstype": "font direction charsize horiz vert",
    "fillsettingstype": "pattern color",
    "pointtype": "x y",
    "viewporttype": "left top right bottom clip",
    "arccoordstype": "x y xstart ystart xend yend",
}


def test_every_function_of_graphics_h_is_there():
    assert len(set(MANUAL)) == len(MANUAL)
    assert set(MANUAL) <= set(bgi.__all__)
    assert all(callable(getattr(bgi, name)) for name in MANUAL)


@pytest.mark.parametrize("kind", NUMBERED_FROM_ZERO)
def test_every_enumeration_of_graphics_h_is_there(kind):
    names = NUMBERED_FROM_ZERO[kind].split()
    step = -1 if kind == "errors" else 1
    assert [getattr(bgi, name) for name in names] == [step * n for n in range(len(names))]
    assert set(names) <= set(bgi.__all__)


def test_every_other_constant_of_graphics_h_is_there():
    assert {name: getattr(bgi, name) for name in OTHER_NUMBERS} == OTHER_NUMBERS
    assert set(OTHER_NUMBERS) <= set(bgi.__all__)


@pytest.mark.parametrize("name", STRUCTURES)
def test_every_structure_of_graphics_h_is_there(name):
    assert list(getattr(bgi, name).__annotations__) == STRUCTURES[name].split()
    assert name in bgi.__all__


def test_signatures_are_those_of_the_manual():
    names = list(inspect.signature(bgi.initgraph).parameters)
    assert names == ["gd", "gm", "path"]
