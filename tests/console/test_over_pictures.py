"""The original's text over pictures: what printf, cprintf and clrscr did in graphics modes."""

import numpy as np
import pytest

import bgi
from bgi import conio, current
from tests.cases import as_written, load
from tests.console.calls import call
from tests.pictures import assert_same, read_indices

CASES = {case["name"]: case for case in load() if case["group"] == "console"}

PRINTED = 15
"""The colour of what printf writes in the captures: the emulator's; DOS writes in light grey."""

ON_PURPOSE = {
    "cprintf_cga": "hidden text is seen there as some stray pixels: text and CGA share memory",
}
"""Cases in which we differ, and what the original does."""


def play(case):
    """Make a case's calls; returns the page and what the calls answered."""
    bgi.initgraph(case["driver"], case["gmode"])
    answers = {}
    for number, (name, *arguments) in enumerate(case["calls"]):
        drawing = getattr(bgi, name, None)
        answer = drawing(*arguments) if drawing else call(name, *arguments)
        answers[str(number)] = as_written(answer)
    asked = {number: answers[number] for number in case["results"]}
    return current.screen.page.array.copy(), asked


def expected(case):
    """A case's picture, in the colours that are ours on purpose."""
    picture = read_indices(case["picture"]).copy()
    if case["name"].startswith("printf"):
        picture[picture == PRINTED] = bgi.LIGHTGRAY
    if case["name"] == "clrscr":  # the emulator's own: empty is in some colour of text
        picture[(picture == 14)] = 0
        picture[picture == PRINTED] = bgi.LIGHTGRAY
    return picture


@pytest.mark.parametrize("name", [name for name in CASES if name not in ON_PURPOSE])
def test_written_and_answered_alike(name):
    got, answers = play(CASES[name])
    assert_same(got, expected(CASES[name]), f"console-{name}")
    assert answers == CASES[name]["results"]


@pytest.mark.parametrize("name", ON_PURPOSE)
def test_different_on_purpose(name):
    got, answers = play(CASES[name])
    assert (got != expected(CASES[name])).any()
    assert answers == CASES[name]["results"]


def test_the_bios_writes_over_the_picture_in_the_colour_of_text(monkeypatch):
    monkeypatch.setattr(conio, "directvideo", 0)
    bgi.initgraph()
    bgi.cleardevice()
    conio.textattr(bgi.YELLOW)
    conio.gotoxy(3, 2)
    conio.cputs("█")
    page = current.screen.page.array
    assert (page[16:32, 16:24] == bgi.YELLOW).all()
    assert np.count_nonzero(page) == 16 * 8


def test_the_picture_scrolls_at_the_last_row():
    bgi.initgraph()
    bgi.line(0, 0, 639, 479)
    before = current.screen.page.array.copy()
    crt = current.console()
    crt.move(0, 29)
    crt.teletype(b"a\r\nb")
    page = current.screen.page.array
    assert (page[:448] == before[16:464]).all()
    assert not page[464:, 8:].any()


def test_writing_goes_to_the_page_that_is_drawn_on():
    bgi.initgraph(bgi.VGA, bgi.VGAMED)
    bgi.setactivepage(1)
    current.console().teletype(b"A")
    first, second = (page.array for page in current.screen.pages)
    assert not first.any() and np.count_nonzero(second[:14, :8])


def test_letters_are_cut_where_a_window_is_small(monkeypatch):
    monkeypatch.setattr(conio, "directvideo", 0)
    bgi.initwindow(5, 5)
    current.console().teletype(b"AB\r\nC")
    current.console().page.write(0, 0, b"AB", 7)
    assert current.screen.page.array.any()
    conio.clrscr()
    assert not current.screen.page.array.any()
