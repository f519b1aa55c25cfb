"""The tables of drivers and fonts, and the parity with the manual's list of functions."""

import pytest

import bgi
from bgi.kernel.state import KERNEL

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


def test_a_reset_makes_everything_new():
    """What a test leaves in the kernel, the next one does not find."""
    bgi.installuserdriver("D")
    bgi.installuserfont("F")
    bgi.setgraphbufsize(1)
    bgi.dos.srand(7)
    KERNEL.result.set(bgi.grError)
    KERNEL.reset()
    assert bgi.graphresult() == 0
    assert bgi.installuserdriver("E") == bgi.installuserfont("G") == 11
    assert bgi.setgraphbufsize(1) == 4096
    assert bgi.dos.rand() == 346


def test_queries_of_the_mode():
    bgi.initgraph()
    assert bgi.getdrivername() == "EGAVGA"
    assert (bgi.getgraphmode(), bgi.getmaxmode()) == (2, 2)
    assert [bgi.getmodename(n) for n in (-1, 0, 1, 2, 3)] == [
        None,
        "640 x 200 EGA",
        "640 x 350 EGA",
        "640 x 480 VGA",
        None,
    ]
    bgi.restorecrtmode()
    assert bgi.getgraphmode() == 2
    bgi.setgraphmode(bgi.getgraphmode())


@pytest.mark.parametrize(
    "driver, modes",
    [
        (bgi.CGA, (0, 4)),
        (bgi.MCGA, (0, 5)),
        (bgi.EGA, (0, 1)),
        (bgi.EGA64, (0, 1)),
        (bgi.EGAMONO, (0, 0)),
        (bgi.IBM8514, (0, 1)),
        (bgi.HERCMONO, (0, 0)),
        (bgi.ATT400, (0, 5)),
        (bgi.VGA, (0, 2)),
        (bgi.PC3270, (0, 0)),
    ],
)
def test_getmoderange_works_before_initgraph(driver, modes):
    assert bgi.getmoderange(driver) == modes
    assert bgi.graphresult() == 0


def test_getmoderange_of_the_current_and_of_unknown_drivers():
    assert bgi.getmoderange(99) == (-1, -1)
    assert bgi.graphresult() == bgi.grInvalidDriver
    with pytest.raises(bgi.BGIError, match="not initialized"):
        bgi.getmoderange(bgi.CURRENT_DRIVER)
    bgi.initgraph(bgi.CGA, bgi.CGAHI)
    assert bgi.getmoderange(bgi.CURRENT_DRIVER) == (0, 4)


def test_svga256():
    driver = bgi.installuserdriver("SVGA256", None)
    assert driver == 11
    assert bgi.installuserdriver("svga256.bgi") == 11
    assert bgi.initgraph(driver, 4) == (11, 4)
    assert (bgi.getmaxx(), bgi.getmaxy(), bgi.getmaxcolor()) == (1023, 767, 255)
    assert (bgi.getdrivername(), bgi.getmaxmode()) == ("SVGA256", 4)
    bgi.setrgbpalette(77, 252, 0, 0)
    assert bgi.graphresult() == 0
    bgi.setgraphmode(0)
    assert (bgi.getmaxx(), bgi.getmaxy()) == (319, 199)
    bgi.setgraphmode(5)
    assert bgi.graphresult() == bgi.grInvalidMode


def test_autodetection_asks_installed_drivers_first():
    bgi.installuserdriver("OTHER", lambda: -1)
    bgi.installuserdriver("SVGA256", lambda: 2)
    assert bgi.initgraph(bgi.DETECT, 0) == (12, 2)
    assert bgi.getmaxy() == 479


def test_a_driver_without_a_file():
    driver = bgi.installuserdriver("NOSUCH")
    assert bgi.initgraph(driver, 0) == (bgi.grFileNotFound, 0)
    code = bgi.graphresult()
    assert bgi.grapherrormsg(code) == "Device driver file not found (NOSUCH.BGI)"


def test_the_driver_table_is_finite():
    assert [bgi.installuserdriver(f"D{n}") for n in range(10)] == list(range(11, 21))
    assert bgi.installuserdriver("D10") == bgi.graphresult() == bgi.grError
    with pytest.raises(TypeError, match="name must be"):
        bgi.installuserdriver(5)


def test_registering_drivers():
    assert bgi.registerbgidriver(bgi.EGAVGA_driver) == bgi.EGA
    assert bgi.registerfarbgidriver(bgi.CGA_driver) == bgi.CGA
    assert bgi.registerbgidriver(b"pk\x08\x08BGI Device Driver (HERC) 2.00 - ") == bgi.HERCMONO
    for wrong in ("NONE", b"", b"pk\x08\x08", b"(CGA)"):
        assert bgi.registerbgidriver(wrong) == bgi.graphresult() == bgi.grInvalidDriver
    with pytest.raises(TypeError, match="driver must be"):
        bgi.registerbgidriver(None)


def test_registering_fonts():
    assert bgi.registerbgifont(bgi.gothic_font) == bgi.GOTHIC_FONT
    assert bgi.registerfarbgifont(bgi.triplex_font) == bgi.TRIPLEX_FONT
    assert bgi.registerbgifont(b"no font") == bgi.graphresult() == bgi.grInvalidFont
    with pytest.raises(TypeError):
        bgi.registerbgifont(7)


def test_buffers():
    assert bgi.setgraphbufsize(1000) == 4096
    assert bgi.setgraphbufsize(4096) == 1000
    block = bgi._graphgetmem(100)
    assert len(block) == 100
    assert bgi._graphfreemem(block, 100) is None


def test_fonts_that_cannot_be_had(tmp_path):
    bgi.initgraph(bgi.VGA, bgi.VGAHI, str(tmp_path))
    number = bgi.installuserfont("MINE")
    assert number == 11
    for font, code, text in [
        (number, bgi.grFontNotFound, "Font file not found (MINE.CHR)"),
        (99, bgi.grInvalidFontNum, "Invalid font number"),
    ]:
        bgi.settextstyle(font, bgi.HORIZ_DIR, 2)
        assert bgi.grapherrormsg(bgi.graphresult()) == text, code
        assert bgi.gettextsettings().font == bgi.DEFAULT_FONT
        assert bgi.textwidth("ab") == 32
    (tmp_path / "mine.chr").write_bytes(b"PK\x08\x08 rubbish")
    bgi.settextstyle(number, 0, 4)
    assert bgi.graphresult() == bgi.grInvalidFont
    assert bgi.grapherrormsg(bgi.grInvalidFont) == "Invalid font file (MINE.CHR)"


def test_stroked_text():
    bgi.initgraph()
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 5)
    assert (bgi.textwidth("Hello, World"), bgi.textheight("x")) == (260, 41)
    bgi.moveto(10, 10)
    bgi.outtext("Hello, World")
    assert (bgi.getx(), bgi.gety()) == (270, 10)
    bgi.setusercharsize(2, 1, 1, 1)
    assert bgi.gettextsettings().charsize == bgi.USER_CHAR_SIZE
    assert (bgi.textwidth("Hello, World"), bgi.textheight("x")) == (390, 31)
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    assert bgi.textwidth("Hello, World") == 195
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, bgi.USER_CHAR_SIZE)
    assert bgi.textwidth("Hello, World") == 390
    for bad in [(1, 0, 1, 1), (1, 1, 1, 0), (40000, 1, 1, 1)]:
        bgi.setusercharsize(*bad)
        assert bgi.graphresult() == bgi.grError
    bgi.settextjustify(3, 0)
    assert bgi.graphresult() == bgi.grError


def test_bitmap_text_sizes_and_justification():
    bgi.initgraph()
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 0)
    assert bgi.textwidth("abc") == 24
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 99)
    assert bgi.textheight("abc") == 80
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 2)
    bgi.settextjustify(bgi.RIGHT_TEXT, bgi.BOTTOM_TEXT)
    bgi.outtextxy(100, 100, "\xdb")  # a full block: '█' in code page 437 is 219
    bgi.outtextxy(100, 100, b"\xdb")
    assert (bgi.getpixel(84, 84), bgi.getpixel(99, 99), bgi.getpixel(100, 100)) == (15, 15, 0)
