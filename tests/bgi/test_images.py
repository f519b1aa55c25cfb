"""getimage, putimage and Borland's byte layout."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import bgi
from bgi import Image, current
from bgi.kernel.state import KERNEL
from bgi.memory.page import Page
from tests.pictures import read_indices


@pytest.mark.parametrize(
    "corners, size",
    [
        ((0, 0, 0, 0), 10),
        ((0, 0, 7, 7), 38),
        ((0, 0, 8, 0), 14),
        ((15, 15, 0, 0), 134),
        ((0, 0, 99, 49), 2606),
        ((0, 0, 639, 203), 65286),
    ],
)
def test_imagesize(vga, corners, size):
    assert vga.imagesize(*corners) == size
    if vga.imagesize(*corners) < 40:
        assert len(bytes(vga.getimage(*corners))) == size


def test_imagesize_of_64k(vga):
    assert vga.imagesize(0, 0, 639, 204) == 65535
    assert KERNEL.result.take() == -11
    assert vga.getimage(0, 0, 639, 479).array.shape == (480, 640)


@pytest.mark.parametrize("driver, mode, size", [(1, 0, 6 + 3 * 2), (1, 4, 6 + 3), (6, 0, 6 + 15)])
def test_imagesize_in_other_modes(new_screen, driver, mode, size):
    screen = new_screen(driver, mode)
    assert screen.imagesize(0, 0, 4, 2) == size
    assert len(bytes(screen.getimage(0, 0, 4, 2))) == size


def test_layout_of_sixteen_colours(vga):
    """Width - 1, height - 1, then planes intensity, red, green, blue; first pixel highest."""
    vga.putpixel(range(3), 0, [8, 4, 3])
    block = bytes(vga.getimage(0, 0, 2, 0))
    assert block.hex(" ") == "02 00 00 00 80 40 20 20 00 00"


def test_layout_of_four_colours(new_screen):
    screen = new_screen(1, 0)
    screen.putpixel(range(5), 0, [0, 1, 2, 3, 1])
    assert bytes(screen.getimage(0, 0, 4, 0)).hex(" ") == "04 00 00 00 1b 40 00 00"


@settings(deadline=None, max_examples=50)
@given(st.integers(1, 30), st.integers(1, 9), st.sampled_from([2, 4, 16, 256]), st.integers(0, 99))
def test_round_trip(width, height, colors, seed):
    array = np.random.default_rng(seed).integers(0, colors, (height, width)).astype(np.uint8)
    image = Image(array, colors)
    again = Image.frombytes(bytes(image), colors)
    assert (again.array == array).all()
    assert bytes(again) == bytes(image)
    assert (again.width, again.height) == (width, height)


@settings(deadline=None)
@given(st.binary(max_size=80), st.sampled_from([2, 4, 16, 256]))
def test_any_bytes_are_an_image_or_a_clear_error(block, colors):
    try:
        image = Image.frombytes(block, colors)
    except ValueError as error:
        assert "needs" in str(error)
    else:
        assert image.array.max() < colors


def test_the_c_form_fills_a_buffer(vga):
    vga.line(0, 0, 20, 20)
    buffer = bytearray(vga.imagesize(0, 0, 20, 20) + 5)
    image = vga.getimage(0, 0, 20, 20, buffer)
    assert buffer.startswith(bytes(image))
    vga.putimage(100, 100, buffer, bgi.COPY_PUT)
    assert vga.getpixel(120, 120) == 15
    array = np.zeros(1000, np.uint8)
    vga.getimage(0, 0, 20, 20, array)
    assert array[:4].tolist() == [20, 0, 20, 0]
    with pytest.raises(ValueError, match="must hold"):
        vga.getimage(0, 0, 20, 20, bytearray(10))
    for wrong in (b"1234", "x", 7):
        with pytest.raises(TypeError, match="buffer must be"):
            vga.getimage(0, 0, 1, 1, wrong)


@pytest.mark.parametrize(
    "op, shown",
    [
        (bgi.COPY_PUT, 12),
        (bgi.XOR_PUT, 6),
        (bgi.OR_PUT, 14),
        (bgi.AND_PUT, 8),
        (bgi.NOT_PUT, 3),
    ],
)
def test_operators(vga, op, shown):
    vga.putpixel(5, 5, 10)
    vga.putimage(5, 5, Image(np.full((1, 1), 12, np.uint8)), op)
    assert vga.getpixel(5, 5) == shown


def test_an_unknown_operator(vga):
    vga.putimage(0, 0, vga.getimage(0, 0, 3, 3), 5)
    assert KERNEL.result.take() == -11


def test_xor_twice_restores(vga):
    vga.setfillstyle(9, 5)
    vga.bar(0, 0, 100, 100)
    before = vga.page.array.copy()
    sprite = vga.getimage(3, 3, 40, 40)
    for _ in range(2):
        vga.putimage(30, 50, sprite, bgi.XOR_PUT)
    assert (vga.page.array == before).all()


def test_off_the_screen(vga):
    vga.bar(0, 0, 639, 479)
    image = vga.getimage(-5, -5, 4, 4)
    assert image.array[:5].max() == image.array[:, :5].max() == 0
    assert image.array[5:, 5:].min() == 15
    vga.cleardevice()
    for x, y in [(-5, -5), (635, 0), (0, -1), (-1, 475), (10**20, 0), (0, -(10**20)), (0, 10**20)]:
        vga.putimage(x, y, image, bgi.COPY_PUT)
    assert not vga.page.array.any()
    vga.putimage(0, 472, image, bgi.COPY_PUT)  # only the bottom cuts it
    assert vga.page.array.sum() == 5 * 3 * 15
    with pytest.raises(ValueError, match=r"^left, top, right, bottom may hold 67,108,864 pixels"):
        vga.getimage(0, 0, 10**9, 10**9)


def test_viewport_moves_but_does_not_clip_images(vga):
    vga.bar(0, 0, 9, 9)
    image = vga.getimage(0, 0, 9, 9)
    vga.cleardevice()
    vga.setviewport(100, 100, 104, 104, 1)
    vga.putimage(0, 0, image, bgi.COPY_PUT)
    assert vga.page.array.sum() == 100 * 15
    assert vga.getimage(0, 0, 9, 9).array.min() == 15


def test_notebooks_show_screens_and_images(vga, tmp_path):
    vga.bar(3, 4, 20, 30)
    for name, shown, expected in [
        ("screen", vga, vga.page.array),
        ("image", vga.getimage(0, 0, 9, 9), vga.page.array[:10, :10]),
    ]:
        (tmp_path / name).write_bytes(shown._repr_png_())
        assert (read_indices(tmp_path / name) == expected).all()


@pytest.mark.parametrize(
    "array, colors",
    [
        ([[1.5]], 16),
        (np.zeros(5, np.uint8), 16),
        (np.zeros((0, 3), np.uint8), 16),
        ([[300]], 16),
        (np.full((1, 1), 300, np.int32), 16),
        ([[-1]], 16),
        ([[1]], 17),
        ("ab", 16),
    ],
)
def test_what_is_no_image(array, colors):
    with pytest.raises((TypeError, ValueError), match="image"):
        Image(array, colors)


def test_an_image_of_a_list(vga):
    vga.putimage(0, 0, Image([[1, 2], [3, 4]]), bgi.COPY_PUT)
    assert vga.page.array[:2, :2].tolist() == [[1, 2], [3, 4]]


def test_wrong_images(vga):
    for wrong in (None, 5, "abc"):
        with pytest.raises((TypeError, ValueError)):
            vga.putimage(0, 0, wrong, 0)
    with pytest.raises(ValueError, match="needs"):
        vga.putimage(0, 0, b"\x05\x00\x05\x00", 0)


def test_rgb_colours_have_no_place_in_borlands_layout():
    bgi.initwindow(20, 10)
    bgi.putpixel(3, 4, bgi.RED)
    assert Image.frombytes(bytes(bgi.getimage(0, 0, 7, 7))).array[4, 3] == bgi.RED
    bgi.putpixel(3, 5, bgi.COLOR(1, 2, 3))
    with pytest.raises(ValueError, match="RGB colours"):
        bytes(bgi.getimage(0, 0, 7, 7))


def test_writeimagefile(tmp_path):
    bgi.initgraph()
    bgi.setrgbpalette(20, 1, 2, 3)
    bgi.putpixel(np.arange(16), 0, np.arange(16))
    bgi.writeimagefile(tmp_path / "all.png")
    bgi.writeimagefile(str(tmp_path / "part.png"), 0, 0, 15, 0)
    assert (read_indices(tmp_path / "all.png") == current.screen.page.array).all()
    assert read_indices(tmp_path / "part.png").tolist() == [list(range(16))]
    bgi.writeimagefile(tmp_path / "edge.png", -5, 470, 10**9, 10**9)
    assert read_indices(tmp_path / "edge.png").shape == (10, 640)
    with pytest.raises(ValueError, match="nothing of"):
        bgi.writeimagefile(tmp_path / "none.png", 700, 0, 800, 10)
    with pytest.raises(OSError):
        bgi.writeimagefile(tmp_path / "no" / "folder.png")
    (tmp_path / "shut").mkdir()
    assert not (tmp_path / "none.png").exists()


@pytest.mark.parametrize("pixel_bytes", [1, 4])
@settings(deadline=None, max_examples=60)
@given(
    x=st.integers(-12, 40), y=st.integers(-12, 30), op=st.integers(0, 4), seed=st.integers(0, 99)
)
def test_a_page_is_copied_and_combined_pixel_by_pixel(pixel_bytes, x, y, op, seed):
    rng = np.random.default_rng(seed)
    page = Page(memoryview(bytearray(32 * 24 * pixel_bytes)), 32, 24, pixel_bytes)
    page.array[:] = before = rng.integers(0, 16, (24, 32))
    taken = page.copy(x, y, 9, 7)
    image = rng.integers(0, 256, (7, 9)).astype(page.array.dtype)
    mask = 15
    page.combine(x, y, image, op, page.array.dtype.type(mask))
    expected = before.copy()
    operators = [
        lambda there, put: put,
        lambda there, put: there ^ put,
        lambda there, put: there | put,
        lambda there, put: there & put,
        lambda there, put: put ^ mask,
    ]
    for row, column in np.ndindex(7, 9):
        if 0 <= y + row < 24 and 0 <= x + column < 32:
            there = before[y + row, x + column]
            assert taken[row, column] == there
            put = int(image[row, column]) & mask
            expected[y + row, x + column] = operators[op](there, put)
        else:
            assert taken[row, column] == 0
    assert (page.array == expected).all()
    assert (page.copy(0, 0, 32, 24) == expected).all()
