"""The magnifier and the board on the page, as in the window: tests/monitor/test_lens.py."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from bgi.memory import imagefile, rgb
from bgi.memory.card import Card
from bgi.monitor import PageWindow, picture
from bgi.monitor.board import board
from bgi.monitor.lens import ROW, magnified, name_of
from bgi.monitor.web.updates import BOARD, board_message
from tests.monitor.web.page import Page
from tests.monitor.web.tabs import CANVAS, canvas, click
from tests.processes import wait_until
from tools.chromium import Tab

LENS = "document.querySelector('.lens canvas')"
BOARD_SHOWN = "document.querySelector('.board canvas')"
SAID = "document.querySelector('.lens:not([hidden]) figcaption')?.textContent"
CTRL = 2


def noise(card: Card, size: int = 1) -> NDArray[Any]:
    """Put pixels of all colours on the card; returns them."""
    card.palette[:] = [(i, 255 - i, i ^ 85) for i in range(256)]
    chance = np.random.default_rng(1)
    if size == 1:
        pixels = chance.integers(0, 256, (480, 640), np.uint8)
    else:
        pixels = chance.integers(0, 1 << 24, (480, 640)).astype("<u4") | rgb.TAG
        pixels[:, ::2] = chance.integers(0, 16, (480, 320))
    card.set_mode(640, 480, 2 if size == 1 else 1, size, False)
    card.page(0)[:] = pixels.tobytes()
    return pixels


def look_at(tab: Tab, x: int, y: int) -> None:
    """Put the mouse on a pixel of the picture, which is not enlarged."""
    left, top = tab.evaluate(f"(({{left, top}}) => [left, top])({CANVAS}.getBoundingClientRect())")
    tab.mouse("Moved", left + x + 0.5, top + y + 0.5)


@pytest.mark.parametrize("size", [1, 4])
@pytest.mark.parametrize("place", [(300, 200), (0, 0), (639, 479)])
def test_it_enlarges_as_in_the_window(
    card: Card, tab: Tab, place: tuple[int, int], size: int
) -> None:
    pixels = noise(card, size)
    look_at(tab, *place)
    for times in (8, 16, 32):
        click(tab, "[data-action=lens]")
        look_at(tab, *place)
        expected = magnified(pixels, picture.colors(card.colors()), place, times, 1)[:-ROW]
        wait_until(lambda expected=expected: np.array_equal(canvas(tab, LENS), expected))
    click(tab, "[data-action=lens]")
    assert tab.evaluate(SAID) is None


def test_it_tells_place_and_color_and_makes_room(card: Card, tab: Tab) -> None:
    card.page(0)[20 * 640 + 30] = 14
    tab.press("F6", "F6", CTRL)
    look_at(tab, 30, 20)
    tab.wait_for(f"{SAID} === 'x 30  y 20  color 14 YELLOW'")
    lens = "document.querySelector('.lens')"
    assert tab.evaluate(f"{lens}.offsetHeight - {LENS}.offsetHeight") == ROW
    box = f"{lens}.getBoundingClientRect()"
    screen = f"{CANVAS}.getBoundingClientRect()"
    for side in ("right", "bottom"):
        assert tab.evaluate(f"{screen}.{side} - {box}.{side}") == 8
    look_at(tab, 600, 400)
    tab.wait_for(f"{SAID} === 'x 600  y 400  color 0 BLACK'")
    for side in ("left", "top"):
        assert tab.evaluate(f"{box}.{side} - {screen}.{side}") == 8


def test_it_follows_the_pixel_that_is_set_last(card: Card, window: PageWindow, tab: Tab) -> None:
    window.magnify(16, "pixels")
    tab.wait_for(f"{SAID} !== undefined")
    card.page(0)[200 * 640 + 100] = 15
    tab.wait_for(f"{SAID} === 'x 100  y 200  color 15 WHITE'")
    tab.press("F8", "F8", CTRL)
    look_at(tab, 1, 2)
    tab.wait_for(f"{SAID} === 'x 1  y 2  color 0 BLACK'")
    window.magnify(0, "mouse")
    tab.wait_for(f"{SAID} === undefined")


def test_the_board_shows_what_the_program_says(card: Card, window: PageWindow, tab: Tab) -> None:
    noise(card)
    card.page(1)[:300] = bytes([4]) * 300
    window.describe = lambda: ["viewport 0 0 639 479"]
    tab.press("F7", "F7", CTRL)
    frame = card.frame()
    assert frame is not None
    expected = board(card, frame, card.colors(), ["viewport 0 0 639 479"])
    wait_until(lambda: np.array_equal(canvas(tab, BOARD_SHOWN), expected))
    tab.press("F7", "F7", CTRL)
    tab.wait_for("document.querySelector('.board').hidden")


def test_the_board_is_sent_to_whoever_wants_it(card: Card, window: PageWindow) -> None:
    facts = ["one"]
    window.describe = lambda: facts
    with Page(window.url) as wants, Page(window.url) as does_not:
        wants.say("board", 1)
        wants.hear_until(lambda page: page.board)
        facts[0] = "two"
        frame = card.frame()
        assert frame is not None
        last = board_message(board(card, frame, card.colors(), facts))
        wants.hear_until(lambda page: page.board == last)
        wants.say("board", 0)
        card.page(0)[5] = 5
        does_not.hear_until(lambda page: page.pixels.any())
        assert not does_not.board and last[0] == BOARD


def test_it_is_no_part_of_a_saved_picture(card: Card, tab: Tab, tmp_path: Path) -> None:
    pixels = noise(card)
    tab.save_to(tmp_path)
    click(tab, "[data-action=lens]")
    look_at(tab, 300, 200)
    tab.wait_for(f"{SAID} === 'x 300  y 200  color {name_of(int(pixels[200, 300]))}'")
    click(tab, "[data-action=png]")
    wait_until((tmp_path / "bgi-001.png").exists)
    assert np.array_equal(imagefile.load(tmp_path / "bgi-001.png").pixels, pixels)
