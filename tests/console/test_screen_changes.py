"""From text to graphics and back, in one window."""

import pytest

import bgi
from bgi import conio, current
from bgi.monitor.plan import Plan
from tests.pictures import read_indices


def text():
    """What stands on the text screen, without the blanks after it."""
    cells = current.console().cells.array
    return (cells & 0xFF).astype("u1").tobytes().decode("cp437").rstrip()


def test_the_first_call_opens_a_text_window_of_80_by_25():
    conio.cputs("Hello")
    info = conio.gettextinfo()
    assert (info.screenwidth, info.screenheight, info.currmode) == (80, 25, conio.C80)
    assert text() == "Hello"
    with pytest.raises(bgi.BGIError, match="Graphics not initialized"):
        bgi.circle(1, 1, 1)


def test_initgraph_goes_on_in_the_same_window_and_closegraph_leads_back():
    conio.textattr(0x1E)
    conio.cputs("before")
    monitor = current.screen.monitor
    bgi.initgraph()
    assert current.screen.monitor is monitor
    conio.cputs("hidden")
    bgi.closegraph()
    assert current.screen.monitor is monitor
    assert text() == ""  # as on the PC, where graphics and text share their memory
    conio.cputs("after")
    assert text() == "after"
    with pytest.raises(bgi.BGIError, match="Graphics not initialized"):
        bgi.circle(1, 1, 1)


def test_a_program_without_text_closes_its_window_by_closegraph():
    bgi.initgraph()
    bgi.closegraph()
    assert not current.is_open()


def test_restorecrtmode_shows_the_text_screen_and_setgraphmode_leads_back():
    bgi.initgraph()
    bgi.restorecrtmode()
    conio.cputs("text")
    assert text() == "text"
    bgi.setgraphmode(bgi.VGAHI)
    bgi.putpixel(1, 1, 5)
    assert bgi.getpixel(1, 1) == 5


def test_textmode_leaves_a_graphics_mode():
    bgi.initgraph()
    conio.textmode(conio.C4350)
    conio.gotoxy(80, 50)
    conio.cputs("x")
    assert conio.gettext(1, 50, 80, 50)[::2].strip() == b""  # scrolled
    assert conio.gettext(80, 49, 80, 49) == b"x\x07"
    with pytest.raises(bgi.BGIError, match="Not in graphics mode"):
        bgi.circle(1, 1, 1)


def test_lastmode_is_the_mode_before():
    conio.textmode(conio.C40)
    conio.textmode(conio.C80)
    conio.textmode(conio.LASTMODE)
    assert conio.gettextinfo().currmode == conio.C40
    conio.textmode(99)
    assert conio.gettextinfo().currmode == conio.C40


def test_a_window_of_initwindow_takes_the_place_of_a_text_screen():
    conio.cputs("text")
    bgi.initwindow(300, 200)
    assert (bgi.getmaxx(), current.screen.mode.is_window) == (299, True)
    conio.gotoxy(37, 12)  # as many columns and rows as there is room for
    assert (conio.wherex(), conio.wherey()) == (37, 12)


@pytest.mark.parametrize("later, kind", [("", 640 * 480), ("bye", 640 * 400)])
def test_the_picture_at_the_end_is_of_the_screen_written_on_last(
    tmp_path, monkeypatch, later, kind
):
    monkeypatch.setenv("BGI_SHOT", str(tmp_path / "shot.png"))
    conio.clrscr()
    bgi.initgraph()
    bgi.bar(0, 0, 100, 100)
    bgi.closegraph()
    conio.cputs(later)
    current.close_screen()
    assert read_indices(tmp_path / "shot.png").size == kind


def test_a_plan_without_a_picture_keeps_none():
    plan = Plan()
    bgi.initgraph()
    plan.keep(current.screen.card)
    assert plan.kept == b""
