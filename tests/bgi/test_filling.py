"""Filled shapes: boxes and polygons, in every pattern."""

from fractions import Fraction
from itertools import pairwise, product
from math import trunc

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from bgi.kernel.state import KERNEL
from bgi.memory.page import Page
from bgi.raster import polygons
from bgi.raster.patterns import SOLID_ROWS
from bgi.settings import fillsettingstype
from tests.pictures import points


def test_setfillstyle_refuses_patterns_and_takes_any_colour(vga):
    for pattern in (13, 12, -1):
        vga.setfillstyle(pattern, 1)
        assert KERNEL.result.take() == -11
    vga.bar(0, 0, 1, 1)
    assert vga.getpixel(0, 0) == 15
    for color, shown in [(16, 0), (255, 15), (-3, 13)]:
        vga.setfillstyle(1, color)
        assert vga.getfillsettings() == fillsettingstype(1, color)
        vga.bar([0, 5], 0, [1, 6], 1)
        assert vga.getpixel(0, 0) == vga.getpixel(6, 1) == shown


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
        with pytest.raises(ValueError, match=r"^points and flat: "):
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


def test_quads_of_a_few_points_are_filled_like_single_ones(new_screen):
    """Also if they come back to their first corner midway: then the fourth side is a path."""
    one, many = new_screen(), new_screen()
    shapes = list(product([(0, 0), (5, 3), (2, 7), (7, 6), (0, 9)], repeat=4))
    left, top = np.arange(len(shapes)) % 60 * 10, np.arange(len(shapes)) // 60 * 10
    quads = np.array(shapes) + np.stack((left, top), axis=-1)[:, None]
    for quad in quads.tolist():
        one.fillpoly(quad, color=0)
    many.fillpoly(quads, color=0)
    assert (one.page.array == many.page.array).all()


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


def test_an_outline_is_left_out_in_colour_0_alone(new_screen):
    for color, left in [(0, 5), (16, 0), (256, 5)]:
        one, many = new_screen(), new_screen()
        corners = [(0, 0), (9, 0), (9, 9)]
        for screen, figure in ((one, corners), (many, [corners])):
            screen.setfillstyle(1, 5)
            screen.fillpoly(figure, color=color)
            assert screen.getpixel(4, 0) == left
            assert screen.getpixel(7, 2) == 5


def test_a_polygon_of_one_point_is_that_point(new_screen):
    for corners in ([(3, 4)], [(3, 4)] * 2, [(3, 4)] * 5):
        one, many = new_screen(), new_screen()
        one.fillpoly(corners)
        many.fillpoly([corners])
        assert one.getpixel(3, 4) == many.getpixel(3, 4) == 15
        assert one.page.array.sum() == many.page.array.sum() == 15


def test_packed_pixels_have_their_own_patterns(new_screen):
    four = new_screen(1, 0)
    four.setfillstyle(3, 2)  # 01 02 04 ...: four columns further
    four.bar(0, 0, 7, 1)
    assert points(four) == {(3, 0), (2, 1)}
    two = new_screen(1, 4)
    two.setfillstyle(9, 0)  # a pattern in colour 0 is drawn in 1
    two.bar(0, 0, 3, 0)
    assert points(two) == {(0, 0), (1, 0)}
    two.setfillstyle(1, 0)
    two.bar(0, 0, 3, 0)
    assert not points(two)


def test_packed_pixels_take_the_largest_colour(new_screen):
    four, two = new_screen(1, 0), new_screen(1, 4)
    for screen in (four, two):
        screen.setcolor(6)
        screen.line(0, 0, 5, 0)
        screen.circle(50, 50, 9)
        screen.putpixel(0, 9, 6)
    assert (four.getpixel(0, 0), four.getpixel(59, 50), four.getpixel(0, 9)) == (3, 3, 2)
    assert (two.getpixel(0, 0), two.getpixel(59, 50), two.getpixel(0, 9)) == (1, 0, 0)


def test_bar3d_sorts_its_corners_as_unsigned_numbers(vga):
    vga.setviewport(100, 100, 300, 300, 0)
    vga.bar3d(-10, 0, 20, 30, 8, 0)  # -10 counts as the far side: the depth hangs there
    assert vga.getpixel(-2, 24) == vga.getpixel(-10, 30) == 15
    assert vga.getpixel(28, 24) == 0
    vga.cleardevice()
    vga.bar3d(0, 0, 20, 30, -8, 1)  # a negative depth rises far above the screen
    assert vga.getpixel(20, 29) == 15
    assert vga.getpixel(12, 36) == 0


def test_setfillpattern_refuses(vga):
    vga.setfillpattern(bytes(8), 16)
    assert KERNEL.result.take() == -11
    for wrong in (bytes(7), [1] * 9):
        with pytest.raises(ValueError, match="8 bytes"):
            vga.setfillpattern(wrong, 1)
    assert vga.getfillpattern() == b"\xff" * 8


def crossings(corners, row):
    """Where the sides of one path cross a row, by the rule itself."""
    found = []
    for (x1, y1), (x2, y2) in pairwise([*corners, corners[0]]):
        if y1 > y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 <= row < y2:
            found.append(x1 + trunc(Fraction((row - y1) * (x2 - x1), y2 - y1)))
    return sorted(found)


@settings(deadline=None, max_examples=100)
@given(st.lists(st.tuples(st.integers(-20, 80), st.integers(-20, 60)), min_size=3, max_size=9))
@example([(40, 0), (4, 45), (76, 17), (4, 2), (60, 40)])
def test_sides_that_cross_are_paired_row_by_row(corners):
    first = corners[0]
    corners = [first, *(corner for corner in corners[1:] if corner != first)]  # one path
    page = Page(memoryview(bytearray(64 * 48)), 64, 48)
    outline = polygons.paths([*corners, first])
    page.fill_rows(polygons.scan(outline, 0, 47), 1, SOLID_ROWS)
    expected = np.zeros((48, 64), int)
    for row in range(48):
        ends = crossings(corners, row)
        for left, right in zip(ends[::2], ends[1::2], strict=True):
            expected[row, max(left, 0) : max(right + 1, 0)] = 1
    assert (page.array == expected).all()
