"""From pixels to the picture: colours, sizes and shapes, without any window."""

import numpy as np
import pytest

from bgi.memory.card import Frame
from bgi.memory.matching import true_colors
from bgi.memory.sdl import pygame
from bgi.monitor.picture import Shape, fit, inside, largest, pixels, surface
from tests.skips import needs_pygame

PALETTE = np.random.default_rng(1).integers(0, 256, (256, 3), np.uint8)


@pytest.mark.parametrize(
    ("mode", "one", "two"),
    [
        ((640, 480), (640, 480), (1280, 960)),
        ((640, 400), (640, 480), (1280, 960)),
        ((640, 350), (640, 480), (1280, 960)),
        ((640, 200), (640, 480), (1280, 960)),
        ((320, 200), (640, 480), (1280, 960)),
        ((720, 348), (720, 540), (720, 540)),
        ((720, 350), (720, 540), (720, 540)),
        ((800, 600), (800, 600), (800, 600)),
        ((1024, 768), (1024, 768), (1024, 768)),
    ],
)
def test_every_mode_fills_a_4_3_window(
    mode: tuple[int, int], one: tuple[int, int], two: tuple[int, int]
) -> None:
    assert fit(Shape(*mode), 640, 480) == one
    assert fit(Shape(*mode), 1280, 960) == two


@pytest.mark.parametrize(
    ("size", "fitted"),
    [
        ((320, 200), (1280, 800)),
        ((400, 500), (400, 500)),
        ((900, 30), (900, 30)),
        ((1, 1), (960, 960)),
    ],
)
def test_square_pixels_stay_square(size: tuple[int, int], fitted: tuple[int, int]) -> None:
    assert fit(Shape(*size, square=True), 1280, 960) == fitted


def test_no_pixel_is_lost() -> None:
    for width in (1, 7, 100, 720, 1001):
        for height in (1, 3, 480, 1000):
            out_width, out_height = fit(Shape(width, height), 640, 480)
            assert out_width % width == 0
            assert out_height >= height
            assert out_height == out_width * 3 // 4


@pytest.mark.parametrize(
    ("desktop", "size"),
    [
        ((800, 600), (640, 480)),
        ((1024, 768), (640, 480)),
        ((1920, 1080), (1280, 960)),
        ((1600, 1200), (1280, 960)),
        ((2560, 1440), (1280, 960)),
        ((3840, 2160), (1920, 1440)),
        ((0, 0), (640, 480)),
    ],
)
def test_the_window_is_a_whole_multiple_of_640x480(
    desktop: tuple[int, int], size: tuple[int, int]
) -> None:
    assert largest(*desktop) == size


@pytest.mark.parametrize(
    ("shape", "window", "picture"),
    [
        (Shape(640, 480), (1919, 1079), (1280, 960)),
        (Shape(320, 200), (1920, 1080), (1280, 960)),
        (Shape(720, 348), (1920, 1080), (1440, 1080)),
        (Shape(640, 350), (640, 480), (640, 480)),
        (Shape(640, 350), (639, 479), (638, 479)),
        (Shape(640, 480), (320, 480), (320, 240)),
        (Shape(640, 480), (1, 1), (1, 1)),
        (Shape(100, 30, square=True), (999, 100), (300, 90)),
    ],
)
def test_the_picture_inside_a_window(
    shape: Shape, window: tuple[int, int], picture: tuple[int, int]
) -> None:
    assert inside(shape, *window) == picture


@needs_pygame
def test_indices_take_their_colours_from_the_palette() -> None:
    numbers = np.arange(256, dtype=np.uint8).reshape(16, 16)
    picture = surface(Frame(16, 16, 1, False, numbers.tobytes()), PALETTE.tobytes())
    assert pygame.image.tobytes(picture, "RGB") == PALETTE.tobytes()


@needs_pygame
def test_a_pixel_of_four_bytes_is_an_index_below_16_and_else_a_colour() -> None:
    numbers = np.array(
        [[0, 15, 16, 0xFFFFFF], [0x03000000, 0x0300FF80, 0xFF123456, 0x10000005]], "<u4"
    )
    frame = Frame(4, 2, 4, True, numbers.tobytes())
    picture = surface(frame, PALETTE.tobytes())
    seen = np.frombuffer(pygame.image.tobytes(picture, "RGB"), np.uint8).reshape(8, 3)
    assert seen.tolist() == [
        PALETTE[0].tolist(),
        PALETTE[15].tolist(),
        [16, 0, 0],
        [255, 255, 255],
        [0, 0, 0],
        [0x80, 0xFF, 0],
        [0x56, 0x34, 0x12],
        [5, 0, 0],
    ]
    assert (true_colors(pixels(frame), PALETTE)[0, 2:] == numbers[0, 2:]).all()
