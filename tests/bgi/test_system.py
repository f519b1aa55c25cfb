"""Opening, changing and closing graphics; errors; pages; time and keys."""

import subprocess
import sys

import pytest

import bgi
from bgi import constants, current
from bgi.kernel.modes import MODES, find


def test_initgraph_detects_vga():
    assert bgi.detectgraph() == (bgi.VGA, bgi.VGAHI)
    assert bgi.initgraph() == (bgi.VGA, bgi.VGAHI)
    assert bgi.initgraph(bgi.DETECT, 99, "C:\\TC\\BGI") == (bgi.VGA, bgi.VGAHI)
    assert (bgi.getmaxx(), bgi.getmaxy(), bgi.getmaxcolor()) == (639, 479, 15)
    assert bgi.graphresult() == bgi.grOk


@pytest.mark.parametrize("mode", MODES, ids=lambda m: f"{m.driver}-{m.number}")
def test_every_mode_opens_and_draws(mode):
    assert bgi.initgraph(mode.driver, mode.number) == (mode.driver, mode.number)
    assert (bgi.getmaxx() + 1, bgi.getmaxy() + 1) == (mode.width, mode.height)
    assert bgi.getmaxcolor() == bgi.getcolor() == mode.colors - 1
    bgi.line(0, 0, bgi.getmaxx(), bgi.getmaxy())
    assert bgi.getpixel(0, 0) == bgi.getpixel(bgi.getmaxx(), bgi.getmaxy()) == mode.colors - 1
    bgi.setactivepage(1)
    assert bgi.getpixel(0, 0) == 0
    shown = [tuple(rgb) for rgb in current.screen.card.palette[: mode.colors].tolist()]
    assert shown[0] == (0, 0, 0)
    if mode.colors <= 16:
        assert len(set(shown)) == mode.colors


def test_modes_agree_with_the_constants():
    """Every mode constant of graphics.h names a row of the table, EGAMONOHI by another number."""
    prefix = {
        "CGA": bgi.CGA,
        "MCGA": bgi.MCGA,
        "EGA": bgi.EGA,
        "EGA64": bgi.EGA64,
        "EGAMONO": bgi.EGAMONO,
        "HERCMONO": bgi.HERCMONO,
        "ATT400": bgi.ATT400,
        "VGA": bgi.VGA,
        "PC3270": bgi.PC3270,
        "IBM8514": bgi.IBM8514,
    }
    suffixes = ["C0", "C1", "C2", "C3", "LO", "MED", "HI"]
    named = {
        (number, getattr(constants, driver + suffix))
        for driver, number in prefix.items()
        for suffix in suffixes
        if hasattr(constants, driver + suffix)
    }
    assert {find(*pair) for pair in named} == set(MODES)
    assert find(bgi.EGAMONO, bgi.EGAMONOHI).number == 3


@pytest.mark.parametrize(
    "gd, gm, answer, code",
    [
        (bgi.VGA, 3, (bgi.VGA, 3), bgi.grInvalidMode),
        (bgi.VGA, -1, (bgi.VGA, -1), bgi.grInvalidMode),
        (99, 0, (bgi.grFileNotFound, 0), bgi.grFileNotFound),
        (-7, 0, (bgi.grNotDetected, 0), bgi.grNotDetected),
    ],
)
def test_impossible_modes(gd, gm, answer, code):
    with pytest.warns(bgi.BGIWarning, match=f"driver {gd}"):
        assert bgi.initgraph(gd, gm) == answer
    assert bgi.graphresult() == code
    with pytest.raises(bgi.BGIError, match=rf"not initialized .*: driver {gd}"):
        bgi.line(0, 0, 1, 1)


def test_initgraph_takes_a_path_and_null(tmp_path):
    for path, kept in [(tmp_path, str(tmp_path)), (None, ""), ("X", "X")]:
        assert bgi.initgraph(bgi.DETECT, 0, path) == (bgi.VGA, bgi.VGAHI)
        assert bgi.current.screen.path == kept


@pytest.mark.parametrize("module", ["conio", "dos", "mouse"])
def test_the_modules_come_with_the_package(module):
    """In a program of its own: the tests import them all."""
    subprocess.run([sys.executable, "-c", f"import bgi; bgi.{module}"], check=True)


def test_initgraph_with_wrong_types():
    for arguments in [("VGA",), (bgi.VGA, None), (bgi.VGA, 2, 7), (float("nan"),)]:
        with pytest.raises((TypeError, ValueError), match="must be"):
            bgi.initgraph(*arguments)


def test_initgraph_again_starts_anew_in_the_same_window():
    bgi.initgraph()
    monitor = current.screen.monitor
    bgi.setviewport(10, 10, 20, 20, 1)
    bgi.cleardevice()
    bgi.putpixel(1, 1, 5)
    bgi.initgraph(bgi.VGA, bgi.VGAMED)
    assert current.screen.monitor is monitor
    assert bgi.getmaxy() == 349
    assert not current.screen.page.array.any()


def test_setgraphmode():
    bgi.initgraph()
    bgi.setcolor(3)
    bgi.putpixel(1, 1, 5)
    bgi.setgraphmode(7)
    assert bgi.graphresult() == bgi.grInvalidMode
    assert (bgi.getpixel(1, 1), bgi.getcolor()) == (5, 3)
    bgi.setgraphmode(bgi.VGALO)
    assert (bgi.getmaxy(), bgi.getpixel(1, 1), bgi.getcolor()) == (199, 0, 15)


def test_restorecrtmode_and_back():
    bgi.initgraph()
    bgi.putpixel(1, 1, 5)
    bgi.restorecrtmode()
    with pytest.raises(bgi.BGIError, match="BGI Error: Not in graphics mode"):
        bgi.putpixel(1, 1, 5)
    bgi.setgraphmode(bgi.VGAHI)
    assert bgi.getpixel(1, 1) == 0
    bgi.restorecrtmode()
    assert bgi.initgraph(bgi.EGA, bgi.EGAHI) == (bgi.EGA, bgi.EGAHI)
    bgi.closegraph()
    bgi.closegraph()


def test_error_messages_are_borlands():
    assert bgi.grapherrormsg(bgi.grOk) == "No error"
    assert bgi.grapherrormsg(bgi.grNoInitGraph) == "(BGI) graphics not installed"
    assert bgi.grapherrormsg(bgi.grInvalidMode) == "Invalid graphics mode for selected driver"
    assert bgi.grapherrormsg(-99) == "Graphics error (65437)"
    assert bgi.grapherrormsg(bgi.grInvalidDriver) == "Invalid device driver file ()"
    bgi.initgraph(bgi.CGA, bgi.CGAHI)
    assert bgi.grapherrormsg(bgi.grInvalidDriver) == "Invalid device driver file (CGA.BGI)"
    bgi.settextstyle(bgi.GOTHIC_FONT, 0, 1)
    assert bgi.grapherrormsg(bgi.grFontNotFound) == "Font file not found (GOTH.CHR)"
    assert bgi.graphresult() == 0


def test_keys_and_time(monkeypatch):
    monkeypatch.setenv("BGI_KEYS", "a Up Esc")
    bgi.initgraph()
    assert bgi.kbhit() == 1
    assert [bgi.getch() for _ in range(3)] == [97, 0, 72]
    assert bgi.kbhit() == 1
    assert bgi.getch() == 27
    assert bgi.kbhit() == 0
    with pytest.raises(bgi.BGIError, match="BGI_KEYS"):
        bgi.getch()
    bgi.delay(1e9)
    for wrong in (-1, float("nan"), float("inf"), "soon", None):
        with pytest.raises((TypeError, ValueError)):
            bgi.delay(wrong)


def test_delay_works_without_graphics():
    bgi.delay(1)


def test_the_prompt_needs_no_main_guard():
    """A plain script, star import and all, runs and ends silently."""
    script = "from bgi import *; initgraph(); circle(320, 240, 100); print(getpixel(420, 240))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert (done.stdout, done.stderr, done.returncode) == ("15\n", "", 0)
