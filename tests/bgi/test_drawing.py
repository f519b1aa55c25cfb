"""Points, lines and outlines: small pictures, spelt out."""

import numpy as np
import pytest

from bgi.kernel.state import KERNEL
from bgi.settings import linesettingstype
from tests.pictures import picture, points


class Whole(int):
    """An int of a type of its own, as an IntEnum's members are."""


def top_left(screen, width, height):
    """The upper left corner of the active page."""
    return screen.page.array[:height, :width].tolist()


@pytest.mark.parametrize(
    "line, pixels",
    [
        ((0, 0, 7, 3), [(0, 0), (1, 0), (2, 1), (3, 1), (4, 2), (5, 2), (6, 3), (7, 3)]),
        ((0, 0, 3, 7), [(0, 0), (0, 1), (1, 2), (1, 3), (2, 4), (2, 5), (3, 6), (3, 7)]),
        ((7, 0, 0, 3), [(7, 0), (6, 0), (5, 1), (4, 1), (3, 2), (2, 2), (1, 3), (0, 3)]),
        ((0, 3, 7, 0), [(7, 0), (6, 0), (5, 1), (4, 1), (3, 2), (2, 2), (1, 3), (0, 3)]),
    ],
)
def test_line(vga, line, pixels):
    vga.line(*line)
    assert points(vga) == set(pixels)


@pytest.mark.parametrize(
    "style, plotted",
    [
        (1, [2, 3, 6, 7, 10, 11, 14, 15]),
        (2, [3, 4, 5, 6, 10, 11, 12, 13, 14, 15]),
        (3, [3, 4, 5, 6, 7, 11, 12, 13, 14, 15]),
    ],
)
def test_line_styles(vga, style, plotted):
    vga.setlinestyle(style, 0, 1)
    vga.line(0, 0, 15, 0)
    assert points(vga) == {(x, 0) for x in plotted}


def test_thick_line_has_no_caps(vga):
    vga.setlinestyle(0, 0, 3)
    vga.line(2, 2, 5, 2)
    assert top_left(vga, 8, 5) == picture("........ ..ffff.. ..ffff.. ..ffff.. ........").tolist()


def test_xor_line_twice_is_gone(vga):
    vga.bar(0, 0, 20, 20)
    before = vga.page.array.copy()
    vga.setwritemode(1)
    vga.setcolor(5)
    vga.line(3, 4, 40, 17)
    assert vga.getpixel(3, 4) == 15 ^ 5
    vga.line(3, 4, 40, 17)
    assert (vga.page.array == before).all()


def test_rectangle_in_xor_spares_its_corners(vga):
    vga.setwritemode(1)
    vga.rectangle(1, 1, 5, 4)
    assert (
        top_left(vga, 7, 6) == picture("....... ..fff.. .f...f. .f...f. ..fff.. .......").tolist()
    )


@pytest.mark.parametrize(
    "corners",
    [
        (1, 1, 5, 4),
        (5, 4, 1, 1),
        (5, 1, 1, 4),
        (2, 2, 2, 2),
        (2, 1, 2, 5),
        (-3, -3, 700, 500),
        (1, 3, 6, 3),
        (638, 100, 700, 200),  # two columns of it are seen: pygame's own clipping filled them
        (100, -50, 200, 1),
    ],
)
def test_rectangle_is_four_lines(new_screen, corners):
    one, other = new_screen(), new_screen()
    left, top, right, bottom = corners
    one.rectangle(*corners)
    other.line(left, top, right, top)
    other.line(right, top, right, bottom)
    other.line(right, bottom, left, bottom)
    other.line(left, bottom, left, top)
    assert (one.page.array == other.page.array).all()


def test_lines_and_current_position(vga):
    vga.moveto(5, 5)
    vga.lineto(10, 5)
    vga.linerel(0, 5)
    vga.moverel(-2, -3)
    assert (vga.getx(), vga.gety()) == (8, 7)
    vga.setlinestyle(1, 0, 1)
    vga.cleardevice()
    vga.moveto(0, 0)
    vga.lineto(7, 0)  # a level line to a point starts its pattern there
    assert points(vga) == {(0, 0), (1, 0), (4, 0), (5, 0)}


def test_setlinestyle_refuses(vga):
    for style, width in [(5, 1), (-1, 1), (0, 4), (0, -1)]:
        vga.setlinestyle(style, 0, width)
        assert KERNEL.result.take() == -11
    vga.line(0, 0, 3, 0)
    assert len(points(vga)) == 4


def test_pixels_keep_the_low_bits(vga):
    vga.putpixel(3, 4, 0x1F5)
    assert points(vga) == {(3, 4)}
    assert (vga.getpixel(3, 4), vga.getpixel(-1, 4), vga.getpixel(640, 4)) == (5, 0, 0)


def test_drawpoly_is_lines_from_point_to_point(new_screen):
    one, other = new_screen(), new_screen()
    one.drawpoly([(1, 1), (9, 3), (4, 8)], color=3)
    other.line(1, 1, 9, 3, 3)
    other.line(9, 3, 4, 8, 3)
    assert (one.page.array == other.page.array).all()


@pytest.mark.parametrize(
    "given, kept",
    [
        ((0, 0x1234, 1), (0, 0x1234, 1)),
        ((1, 0, 0), (1, 0, 0)),
        ((4, 0x1234, 2), (4, 0x1234, 2)),
        ((4, 0x91234, 1), (4, 0x1234, 1)),
    ],
)
def test_getlinesettings(vga, given, kept):
    assert vga.getlinesettings() == linesettingstype(0, 0, 1)
    vga.setlinestyle(*given)
    assert vga.getlinesettings() == linesettingstype(*kept)
    vga.getlinesettings().thickness = 3  # a copy
    assert vga.getlinesettings() == linesettingstype(*kept)


@pytest.mark.parametrize(
    "number", [float, np.float32, np.float64, np.int64, np.int32, np.int16, Whole]
)
def test_every_type_of_number_draws_as_the_int_does(new_screen, number):
    one, other = new_screen(), new_screen()
    for screen, kind in ((one, int), (other, number)):
        screen.line(kind(-2), kind(3), kind(90), kind(40))
        screen.rectangle(kind(5), kind(60), kind(40), kind(90))
        screen.circle(kind(60), kind(60), kind(12), kind(4))
        screen.moveto(kind(7), kind(8))
        screen.lineto(kind(50), kind(9))
        screen.putpixel(kind(5), kind(7), kind(3))
    np.testing.assert_array_equal(one.page.array, other.page.array)


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), np.float64("-inf")])
def test_a_number_that_is_not_finite_is_refused_by_its_name(vga, bad):
    with pytest.raises(ValueError, match="y1 must be a finite number"):
        vga.line(1, bad, 3, 4)
    with pytest.raises(ValueError, match="color must be a finite number") as caught:
        vga.putpixel(1, 2, bad)
    assert caught.value.__context__ is None  # no second traceback of how it was found
