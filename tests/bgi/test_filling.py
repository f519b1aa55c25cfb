"""Filled shapes: boxes and polygons, in every pattern."""

import pytest

from bgi.kernel.state import KERNEL
from bgi.settings import fillsettingstype
from tests.pictures import points


def test_setfillstyle_refuses(vga):
    for pattern, color in [(13, 1), (-1, 1), (1, 16), (1, -1)]:
        vga.setfillstyle(pattern, color)
        assert KERNEL.result.take() == -11
    vga.bar(0, 0, 1, 1)
    assert vga.getpixel(0, 0) == 15


def test_bar_is_anchored_to_the_screen(vga):
    vga.setfillstyle(9, 6)
    vga.bar(0, 0, 100, 50)
    whole = vga.page.array.copy()
    vga.cleardevice()
    vga.setviewport(3, 5, 200, 200, 1)
    vga.bar(-3, -5, 40, 45)
    vga.bar(41, -5, 97, 45)
    vga.bar(-1, -1, -2, -3)
    expected = whole.copy()
    expected[:5], expected[:, :3] = 0, 0
    assert (vga.page.array == expected).all()


def test_empty_fill_erases_a_bar_but_leaves_a_polygon(vga):
    vga.bar(0, 0, 30, 30)
    vga.setfillstyle(0, 3)
    vga.fillpoly([(5, 5), (10, 5), (10, 10)], color=0)
    assert vga.getpixel(9, 6) == 15
    vga.bar(5, 5, 10, 10)
    assert vga.getpixel(9, 6) == 0


def test_bar3d(vga):
    vga.setfillstyle(1, 2)
    vga.bar3d(10, 40, 20, 60, 15, 1)
    assert vga.getpixel(25, 31) == 0  # neither side nor top is filled
    assert {(35, 49), (35, 29), (25, 29)} <= points(vga)  # 15 to the right, 11 up
    assert vga.getpixel(15, 50) == 2


def test_fillpoly_spans(vga):
    """The check value of the manual's rule: rows 0..7 of a triangle, outline not drawn."""
    vga.fillpoly([(10, 0), (20, 5), (0, 8)], color=0)
    spans = [(10, 10), (9, 12), (8, 14), (7, 16), (5, 18), (4, 20), (3, 14), (2, 7)]
    assert points(vga) == {(x, y) for y, (a, b) in enumerate(spans) for x in range(a, b + 1)}


@pytest.mark.parametrize(
    "form",
    [
        ([(10, 0), (20, 5), (0, 8)],),
        ([10, 0, 20, 5, 0, 8],),
        (3, [10, 0, 20, 5, 0, 8, 99, 99]),
        ([[(10, 0), (20, 5), (0, 8)]],),
        ([[10.7, -0.2], [20, 5], [0, 8]],),
    ],
)
def test_polygon_forms(new_screen, form):
    one, other = new_screen(), new_screen()
    one.fillpoly(*form)
    other.fillpoly(((10, 0), (20, 5), (0, 8)))
    assert (one.page.array == other.page.array).all()


def test_polygons_of_too_few_numbers(vga):
    for form in [(4, [1, 2, 3]), (-1, [1, 2])]:
        with pytest.raises(ValueError, match="points need"):
            vga.fillpoly(*form)


def test_fillpoly_even_odd_and_two_paths(vga):
    square = [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0)]
    hole = [(3, 3), (6, 3), (6, 6), (3, 6), (3, 3)]
    vga.fillpoly(square + hole, fill=2, color=0)
    assert vga.getpixel(1, 4) == vga.getpixel(8, 4) == 2
    assert vga.getpixel(4, 4) == vga.getpixel(5, 5) == 0


def test_fillpoly_leaves_the_rows_between_paths_empty(new_screen):
    def square(x, y):
        return [(x, y), (x + 9, y), (x + 9, y + 10), (x, y + 10), (x, y)]

    figure = square(0, 0) + square(20, 0) + square(0, 20)
    one, many = new_screen(), new_screen()
    one.fillpoly(figure, color=0)
    many.fillpoly([figure], color=0)
    for screen in (one, many):
        assert screen.page.array[:10, :10].all()
        assert screen.page.array[:10, 20:30].all()
        assert not screen.page.array[10:20].any()
        assert not screen.page.array[:10, 10:20].any()


def test_a_pattern_of_ones_own(vga):
    assert vga.getfillsettings() == fillsettingstype(1, 15)
    assert vga.getfillpattern() == b"\xff" * 8
    rows = bytes([0x80, 0, 0x01, 0, 0, 0, 0, 0])
    vga.setfillpattern(rows, 5)
    vga.bar(0, 0, 8, 7)
    assert points(vga) == {(0, 0), (8, 0), (7, 2)}
    assert vga.getpixel(0, 0) == 5
    assert vga.getfillsettings() == fillsettingstype(12, 5)
    vga.setfillstyle(3, 2)
    assert vga.getfillpattern() == rows  # whatever is in use
    vga.setfillstyle(12, 4)
    vga.bar(0, 0, 8, 7)
    assert vga.getpixel(0, 0) == 4


def test_setfillpattern_refuses(vga):
    vga.setfillpattern(bytes(8), 16)
    assert KERNEL.result.take() == -11
    for wrong in (bytes(7), [1] * 9):
        with pytest.raises(ValueError, match="8 bytes"):
            vga.setfillpattern(wrong, 1)
    assert vga.getfillpattern() == b"\xff" * 8
