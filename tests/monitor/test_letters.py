"""Text modes on the screen: letters, colours, the cursor, and what blinks."""

from pathlib import Path

import numpy as np
import pytest

from bgi.fonts.rom import glyphs
from bgi.memory.card import NO_CURSOR, Card, Frame
from bgi.memory.sdl import pygame
from bgi.monitor.display import Display
from bgi.monitor.letters import CURSOR_SECONDS, at_moment
from bgi.monitor.picture import pixels
from tests.skips import needs_pygame


def screen(text: bytes, attribute: int = 7, height: int = 16, attributes: int = 0) -> Card:
    """A card in a text mode of one row."""
    card = Card()
    card.set_text_mode(len(text), 1, height, attributes)
    card.page(0)[::2] = text
    card.page(0)[1::2] = bytes([attribute]) * len(text)
    return card


def frame(card: Card, seconds: float = 0.0) -> Frame:
    found = card.frame()
    assert found is not None
    return at_moment(found, seconds)


@pytest.mark.parametrize("height", [8, 14, 16])
def test_letters_of_the_rom_in_their_colours(height: int) -> None:
    seen = pixels(frame(screen(b"Ag", 0x1E, height)))
    letters = np.hstack([glyphs(height)[ord("A")], glyphs(height)[ord("g")]])
    assert (seen == np.where(letters, 14, 1)).all()


def test_a_blinking_letter_is_seen_and_not_seen_in_turn() -> None:
    card = screen(b"A", 0x9E)
    dark = [2 * CURSOR_SECONDS + 0.01, 3 * CURSOR_SECONDS + 0.01]
    assert 14 in pixels(frame(card))
    assert all((pixels(frame(card, seconds)) == 1).all() for seconds in dark)


def test_bright_backgrounds_in_place_of_blinking() -> None:
    card = screen(b"A", 0x9E, attributes=1)
    for seconds in (0, 2 * CURSOR_SECONDS):
        assert set(pixels(frame(card, seconds)).ravel().tolist()) == {9, 14}


def test_the_cursor_has_its_shape_and_place_and_blinks() -> None:
    card = screen(b"  ")
    card.cursor[0], card.cursor[1] = 1, 0x0D0E
    seen = pixels(frame(card))
    assert np.argwhere(seen).tolist() == [[y, x] for y in (13, 14) for x in range(8, 16)]
    assert not pixels(frame(card, CURSOR_SECONDS * 1.5)).any()
    card.cursor[1] = 0x2000
    assert not pixels(frame(card)).any()
    card.cursor[0], card.cursor[1] = NO_CURSOR, 0x000F
    assert not pixels(frame(card)).any()


def test_a_screen_on_which_nothing_blinks_is_always_the_same() -> None:
    card = screen(b"A")
    assert frame(card, 0) == frame(card, 1.5 * CURSOR_SECONDS) == frame(card, 2.5 * CURSOR_SECONDS)


def test_a_monochrome_monitor_shows_bright_underlined_and_reverse() -> None:
    def colors(attribute: int) -> set[int]:
        return set(pixels(frame(screen(b"A", attribute, attributes=2))).ravel().tolist())

    assert [colors(a) for a in (0x07, 0x0F, 0x70, 0x1E, 0x00)] == [
        {0, 7},
        {0, 15},
        {0, 7},
        {0, 15},
        {0},
    ]
    line = pixels(frame(screen(b" ", 0x01, attributes=2)))
    assert np.flatnonzero(line.any(axis=1)).tolist() == [14]


@needs_pygame
def test_the_window_knows_a_picture_that_is_new_only_because_it_blinks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    card = screen(b"A", 0x9E)
    clock = [0.0]
    monkeypatch.setattr("bgi.monitor.display.time.monotonic", lambda: clock[0])
    display = Display(card, tmp_path)
    display.update()  # the window has just got its shape
    seen = [(display.update(), display.update())]
    clock[0] = 2 * CURSOR_SECONDS + 0.01
    seen.append((display.update(), display.blinked))
    card.page(0)[0] = 66
    seen.append((display.update(), display.blinked))
    assert seen == [(False, False), (True, True), (True, False)]
    pygame.display.quit()
