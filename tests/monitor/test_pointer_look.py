"""What the mouse driver's pointer looks like on the page."""

import pytest

from bgi.memory.sdl import pygame
from bgi.monitor import art

GREY, RED = (170, 170, 170), (255, 0, 0)


def page() -> pygame.Surface:
    surface = pygame.Surface((20, 20))
    surface.fill(GREY)
    surface.set_at((3, 0), RED)
    return surface


def test_masks_make_pixels_black_white_as_they_are_and_inverted() -> None:
    screen, cursor = [0x3FFF] + [0xFFFF] * 15, [0x5000] + [0] * 15
    surface = page()
    art.from_masks(0, 0, *screen, *cursor).draw(surface, 0, 0)
    row = [tuple(surface.get_at((x, 0)))[:3] for x in range(5)]
    assert row == [(0, 0, 0), (255, 255, 255), GREY, (0, 255, 255), GREY]
    assert tuple(surface.get_at((0, 1)))[:3] == GREY


@pytest.mark.parametrize("place", [(-100, -100), (0, 0), (19, 19), (40, 5)])
def test_it_may_stick_out(place: tuple[int, int]) -> None:
    surface = page()
    art.from_masks(8, 8, *[0xFFFF] * 32).draw(surface, *place)
    inverted = {
        (x, y)
        for x in range(20)
        for y in range(20)
        if tuple(surface.get_at((x, y)))[:3] in ((85, 85, 85), (0, 255, 255))
    }
    left, top = place[0] - 8, place[1] - 8
    assert inverted == {
        (x, y)
        for x in range(max(left, 0), min(left + 16, 20))
        for y in range(max(top, 0), min(top + 16, 20))
    }
