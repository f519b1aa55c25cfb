"""The magnifier, and the board of the card: arrays of colours, without any window."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import bgi
from bgi import current
from bgi.memory import rgb
from bgi.memory.card import Card
from bgi.memory.sdl import pygame
from bgi.monitor.board import laid_out
from bgi.monitor.display import Display
from bgi.monitor.headless import Headless
from bgi.monitor.lens import (
    GRID,
    INK,
    ROW,
    SIZE,
    TIMES,
    Lens,
    last_changed,
    magnified,
    name_of,
    written,
)

PALETTE = np.random.default_rng(1).integers(1, 60, (256, 3), np.uint8)


@pytest.fixture
def picture() -> np.ndarray:
    return np.random.default_rng(2).integers(0, 16, (480, 640), np.uint8)


@pytest.mark.parametrize("times", [4, *TIMES[1:]])
@pytest.mark.parametrize("tall", [1.0, 2.4])
@pytest.mark.parametrize("place", [(300, 200), (0, 0), (639, 479)])
def test_every_pixel_around_the_place_is_a_box_of_its_color(
    picture: np.ndarray, times: int, tall: float, place: tuple[int, int]
) -> None:
    large = magnified(picture, PALETTE, place, times, tall)
    high = round(times * tall)
    assert large.shape[1] <= SIZE[0] + 2 * times and large.shape[0] - ROW <= SIZE[1] + 2 * high
    across, down = large.shape[1] // times // 2, (large.shape[0] - ROW) // high // 2
    for row in range(-down, down + 1):
        for column in range(-across, across + 1):
            x, y = place[0] + column, place[1] + row
            box = large[(row + down) * high :, (column + across) * times :][:high, :times]
            inside = 0 <= x < 640 and 0 <= y < 480
            color = PALETTE[picture[y, x]] if inside else GRID
            assert_array_equal(box[high // 2, times // 2], color)
            if max(abs(row), abs(column)) > 1:  # those beside the middle share its frame
                assert (box[0] == GRID).all() and (box[:, 0] == GRID).all()


def test_the_pixel_in_the_middle_is_framed_and_told(picture: np.ndarray) -> None:
    picture[20, 30] = 14
    large = magnified(picture, PALETTE, (30, 20), 16, 1)
    middle = large[(large.shape[0] - ROW) // 32 * 16 :, large.shape[1] // 32 * 16 :]
    assert (middle[0, :17] == 255).all() and (middle[1, 1:16] == 0).all()
    assert_array_equal(large[-ROW:], written("x 30  y 20  color 14 YELLOW", large.shape[1]))


def test_colors_have_names() -> None:
    assert [name_of(n) for n in (0, 15, 16, 255)] == ["0 BLACK", "15 WHITE", "16", "255"]
    assert name_of(rgb.join(1, 2, 3)) == "RGB 1 2 3"


def test_words_are_letters_of_the_rom() -> None:
    assert (written("A", 8) == INK).all(axis=2).sum() > 20
    assert written("much too long", 16).shape == (ROW, 16, 3)


def test_which_pixel_was_set_last(picture: np.ndarray) -> None:
    after = picture.copy()
    assert last_changed(picture, after) is None
    after[5, 7] ^= 1
    after[4, 600] ^= 1
    assert last_changed(picture, after) == (7, 5)
    assert last_changed(picture, after[:9]) is None


def test_the_key_goes_through_all_sizes_and_out() -> None:
    lens, seen = Lens(), []
    for _ in range(5):
        lens = lens.next()
        seen.append(lens.times)
    assert seen == [8, 16, 32, 0, 8]


def test_the_board_shows_palette_and_pages(picture: np.ndarray) -> None:
    shown = laid_out(PALETTE, 16, [picture, picture * 0], 1, ["hello"])
    assert_array_equal(shown[:ROW], written("hello", SIZE[0]))
    assert_array_equal(shown[ROW + 5, 5::21][:16], PALETTE[:16])
    pages = shown[ROW + 21 :]
    assert_array_equal(pages[4, 4], PALETTE[picture[0, 0]])
    assert_array_equal(pages[4, SIZE[0] // 2 + 4], PALETTE[0])
    assert (pages[0, SIZE[0] // 2 :] == INK).all() and (pages[0, : SIZE[0] // 2] == GRID).all()


@pytest.fixture
def display(tmp_path: Path) -> Display:
    card = Card()
    card.set_mode(640, 480, 2)
    card.colors()
    return Display(card, str(tmp_path))


def pixels() -> np.ndarray:
    window = pygame.display.get_surface()
    assert window is not None
    return pygame.surfarray.array3d(window).swapaxes(0, 1)


def test_it_lies_over_the_picture_and_goes_again(display: Display) -> None:

    display.update()
    before = pixels()
    display.overlays.enlarge()
    assert display.update() and not display.update()
    assert (pixels() != before).any()
    for _ in TIMES[1:]:
        display.overlays.enlarge()
    assert display.update()
    assert_array_equal(pixels(), before)
    display.overlays.toggle_board()
    assert display.update()
    assert (pixels() != before).any()
    display.overlays.toggle_board()
    assert display.update()
    assert_array_equal(pixels(), before)


def test_it_follows_what_is_set(display: Display) -> None:

    display.overlays.use_lens(Lens(16, follows_pixels=True))
    display.update()
    display._card.page(0)[200 * 640 + 100] = 15
    assert display.update()
    width = 2 * (SIZE[0] // 32) * 16 + 16
    said = pixels()[-8 - ROW : -8, -8 - width : -8]
    assert_array_equal(said, written("x 100  y 200  color 15 WHITE", width))


def test_the_program_can_ask_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    bgi.initgraph()
    asked = []
    monkeypatch.setattr(Headless, "magnify", lambda self, *given: asked.append(given))
    bgi.magnifier()
    bgi.magnifier(8, "pixels")
    bgi.magnifier(0)
    assert asked == [(16, "mouse"), (8, "pixels"), (0, "mouse")]
    for wrong in [(65,), (-1,), (8, "me")]:
        with pytest.raises(ValueError, match=r"times|follow"):
            bgi.magnifier(*wrong)


def test_the_screen_tells_of_itself() -> None:
    bgi.initgraph(bgi.EGA, bgi.EGAHI)
    bgi.setviewport(1, 2, 30, 40, 1)
    bgi.setactivepage(1)
    bgi.moveto(5, 6)
    assert current.screen.monitor.describe() == [
        "viewport 1 2 30 40, clipping",
        "active page 1, at 5, 6",
        "color 15, fill 1 in 15",
    ]
