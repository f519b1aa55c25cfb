"""The tables of drivers and fonts, and the parity with the manual's list of functions."""

import pytest

import bgi
from bgi import kernel
from bgi.fonts.table import FontTable
from bgi.kernel import DriverTable

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


@pytest.fixture(autouse=True)
def _fresh_tables(monkeypatch):
    """Tables of this test only: they outlive closegraph()."""
    import bgi.api.system
    import bgi.graphics.screen
    import bgi.graphics.text

    drivers, fonts = DriverTable(), FontTable()
    for module in (kernel, bgi.api.system, bgi.graphics.screen, bgi.graphics.text):
        for name, table in (("DRIVERS", drivers), ("FONTS", fonts)):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, table)


def test_every_function_of_graphics_h_is_there():
    assert len(set(MANUAL)) == len(MANUAL)
    assert set(MANUAL) <= set(bgi.__all__)
    assert all(callable(getattr(bgi, name)) for name in MANUAL)


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
