"""What a page shows is what is on the card, index for index, and no more is sent than must be."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some
from numpy.typing import NDArray

import bgi
from bgi import conio, current, mouse
from bgi.kernel.textmodes import TEXT_MODES
from bgi.memory.card import NO_CURSOR, Card, Frame
from bgi.monitor import PageWindow
from bgi.monitor.letters import drawn
from bgi.monitor.web.updates import COLORS, ROWS, Still, between
from tests.monitor.web.page import Page


def on(card: Card) -> NDArray[Any]:
    """The pixels that the card shows."""
    frame = card.frame()
    assert frame is not None
    return Still(frame, card.colors()).pixels


def test_the_picture_is_the_cards(card: Card, window: PageWindow) -> None:
    chance = np.random.default_rng(1)
    with Page(window.url) as page:
        for width, height, size, square in (
            (640, 480, 1, False),
            (320, 200, 1, False),
            (720, 348, 1, False),
            (801, 33, 4, True),
        ):
            card.set_mode(width, height, 2, size, square)
            for _ in range(5):
                start, length = sorted(chance.integers(0, width * height * size, 2))
                noise = chance.integers(0, 256, length - start, np.uint8)
                card.page(0)[start:length] = noise.tobytes()
                card.palette[:] = chance.integers(0, 256, (256, 3), np.uint8)
                page.hear_until(
                    lambda page: (
                        np.array_equal(page.pixels, on(card)) and page.palette == card.colors()
                    )
                )
            assert page.square == square


@pytest.mark.parametrize("mode", TEXT_MODES.values())
def test_a_text_screen(mode: Any, card: Card, window: PageWindow) -> None:
    card.set_text_mode(mode.columns, mode.rows, mode.cell_height)
    cells = card.page(0)
    cells[:] = np.random.default_rng(1).integers(0, 128, len(cells), np.uint8).tobytes()
    card.cursor[0] = NO_CURSOR
    frame = card.frame()
    assert frame is not None and frame.text is not None
    with Page(window.url) as page:
        page.hear_until(lambda page: np.array_equal(page.pixels, drawn(frame, frame.text)))


def test_only_rows_that_changed_are_sent(card: Card, window: PageWindow) -> None:
    with Page(window.url) as page:
        page.hear_until(lambda page: page.pictures == 1)
        page.messages.clear()
        card.page(0)[7 * 640 + 3] = 9
        page.hear_until(lambda page: page.pictures == 2)
        assert page.messages == [
            bytes([ROWS, 1, 128, 2, 224, 1, 7, 0, 1, 0, 0, 0]) + on(card)[7].tobytes()
        ]
        page.messages.clear()
        card.palette[5] = 1, 2, 3  # a palette that cycles costs its own bytes only
        page.hear_until(lambda page: page.pictures == 3)
        assert [len(message) for message in page.messages] == [769, 12]


def test_a_page_that_does_not_answer_holds_up_nobody_else(card: Card, window: PageWindow) -> None:
    with Page(window.url) as slow, Page(window.url) as quick:
        slow.answers = False
        slow.hear_until(lambda page: page.pictures == 1)
        for number in range(1, 100):
            card.page(0)[number] = number
            window.show()
        quick.hear_until(lambda page: page.pixels.any() and page.pixels[0, 99] == 99)
        assert not slow.pixels.any()
        slow.say("shown")  # then it gets the newest
        slow.hear_until(lambda page: page.pictures == 2)
        assert np.array_equal(slow.pixels, on(card))


def test_show_goes_on_without_a_page(card: Card, window: PageWindow) -> None:
    for number in range(1, 20):
        card.page(0)[number] = number
        window.show()
    assert window.presents == 19


def test_a_page_that_comes_later_knows_all(card: Card, window: PageWindow) -> None:
    with Page(window.url) as first:
        first.hear_until(lambda page: page.pictures)
        card.page(0)[5] = 5
        window.sound(440)
        window.mouse.reset(3, 4)
        window.mouse.show()
        window.mouse.limit(1, 2, 300, 200)
        window.show()
        with Page(window.url) as second:
            second.hear_until(lambda page: page.pixels.any() and "typing" in page.words)
            shape = second.words.pop("shape").split()
            assert len(shape) == 2 + 32
            assert second.words == {
                "title": "a test ✓",
                "sound": "440",
                "pointer": "shown",
                "move": "3 4",
                "limits": "1 2 300 200",
                "typing": "no",
            }


def test_a_whole_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "web")
    monkeypatch.setattr("bgi.monitor.web.pagewindow.PAGE_SECONDS", 0)
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    monitor = current.screen.monitor
    assert isinstance(monitor, PageWindow)
    with Page(monitor.url) as page:
        bgi.circle(320, 240, range(10, 160, 10), range(1, 16))
        bgi.setpalette(3, 60)
        mouse.show()
        bgi.swapbuffers()
        expected = on(current.screen.card)
        page.hear_until(lambda page: np.array_equal(page.pixels, expected))
        assert expected.any()
        bgi.restorecrtmode()
        conio.cputs("Hello")
        page.hear_until(
            lambda page: page.pixels.shape == (400, 720) or page.pixels.shape == (400, 640)
        )
        page.say("down", 0, "KeyX", "x")
        assert bgi.getch() == ord("x")
    bgi.closegraph()


def test_another_screen_is_found_at_the_same_address(card: Card, window: PageWindow) -> None:
    window.close()
    again = PageWindow(card)
    beside = PageWindow(card, beside=again)  # there is only one such port
    try:
        assert again.url == window.url
        assert beside.url != again.url
        with Page(again.url) as page, Page(beside.url) as other:
            page.hear_until(lambda page: page.pictures)
            other.hear_until(lambda page: page.pictures)
    finally:
        again.close()
        beside.close()


@pytest.mark.parametrize("rate", ["10", "1000"])
def test_it_keeps_the_pace_that_is_asked_for(
    card: Card, monkeypatch: pytest.MonkeyPatch, rate: str
) -> None:
    monkeypatch.setenv("BGI_RATE", rate)
    monkeypatch.setattr("bgi.monitor.web.pagewindow.PAGE_SECONDS", 0)
    window = PageWindow(card)
    try:
        for _ in range(5):
            window.show()
        assert window.presents == 5
    finally:
        window.close()


frames = some.builds(
    lambda size, width, height, seed: Frame(
        width,
        height,
        size,
        False,
        np.random.default_rng(seed).integers(0, 2, width * height * size, np.uint8).tobytes(),
    ),
    some.sampled_from((1, 4)),
    some.integers(1, 5),
    some.integers(1, 5),
    some.integers(0, 20),
)


@given(some.lists(some.tuples(frames, some.integers(0, 2)), min_size=1))
def test_messages_make_one_picture_of_another(given: list[tuple[Frame, int]]) -> None:
    """Whatever the pictures, each is put together from the last one and the messages."""
    last: Still | None = None
    pixels: NDArray[Any] = np.zeros((0, 0), np.uint8)
    palette = b""
    for frame, tone in given:
        picture = Still(frame, bytes([tone]) * 768)
        for message in between(last, picture):
            if message[0] == COLORS:
                palette = message[1:]
                continue
            first, rows = np.frombuffer(message, "<u2", 2, 6)
            if (first, rows) == (0, frame.height):
                pixels = np.zeros_like(picture.pixels)
            data = np.frombuffer(message, np.uint8, offset=12).view(pixels.dtype)
            pixels[first : first + rows] = data.reshape(rows, frame.width)
        assert np.array_equal(pixels, picture.pixels) and palette == picture.palette
        last = picture
