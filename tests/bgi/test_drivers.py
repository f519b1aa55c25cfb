"""The kernel's table of drivers: those of graphics.h, and those that a program adds."""

import pytest

import bgi


@pytest.mark.parametrize(
    "driver, modes",
    [
        (bgi.CGA, (0, 4)),
        (bgi.MCGA, (0, 5)),
        (bgi.EGA, (0, 1)),
        (bgi.EGA64, (0, 1)),
        (bgi.EGAMONO, (3, 3)),
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
    assert bgi.getmoderange(99) == bgi.getmoderange(0) == (-1, -1)
    assert bgi.graphresult() == 0
    with pytest.raises(bgi.BGIError, match="not initialized"):
        bgi.getmoderange(bgi.CURRENT_DRIVER)
    bgi.initgraph(bgi.CGA, bgi.CGAHI)
    assert bgi.getmoderange(bgi.CURRENT_DRIVER) == (0, 4)


def test_svga256():
    driver = bgi.installuserdriver("SVGA256", None)
    assert driver == 16
    assert bgi.installuserdriver("svga256.bgi") == 16
    assert bgi.initgraph(driver, 4) == (16, 4)
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
    assert bgi.initgraph(bgi.DETECT, 0) == (17, 2)
    assert bgi.getmaxy() == 479


def test_a_driver_without_a_file():
    driver = bgi.installuserdriver("NOSUCH")
    with pytest.warns(bgi.BGIWarning, match=r"driver 16 \(NOSUCH\) has no file"):
        assert bgi.initgraph(driver, 0) == (bgi.grFileNotFound, 0)
    code = bgi.graphresult()
    assert bgi.grapherrormsg(code) == "Device driver file not found (NOSUCH.BGI)"


def test_the_driver_table_is_finite():
    assert [bgi.installuserdriver(f"D{n}") for n in range(10)] == list(range(16, 26))
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
