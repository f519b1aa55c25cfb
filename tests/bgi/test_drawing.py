"""Small pictures: what each call draws, spelt out."""

import pytest

from bgi.kernel.state import KERNEL
from tests.pictures import picture


def top_left(screen, width, height):
    """The upper left corner of the active page."""
    return screen.page.array[:height, :width].tolist()


def points(screen):
    """The pixels set, as (x, y), row by row."""
    ys, xs = screen.page.array.nonzero()
    return sorted(zip(xs.tolist(), ys.tolist(), strict=True))


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
    assert points(vga) == sorted(pixels)


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
    assert points(vga) == [(x, 0) for x in plotted]


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


@pytest.mark.parametrize(
    "radius, quadrant",
    [
        (5, [(0, 5), (1, 5), (2, 5), (3, 4), (4, 3), (5, 2), (5, 1), (5, 0)]),
        (1, [(0, 1), (1, 0)]),
        (0, [(0, 1), (1, 0)]),
    ],
)
def test_circle(vga, radius, quadrant):
    vga.circle(20, 20, radius)
    assert points(vga) == sorted(
        {(20 + sx * x, 20 + sy * y) for x, y in quadrant for sx in (1, -1) for sy in (1, -1)}
    )


def test_circle_is_flattened_where_pixels_are_tall(new_screen):
    screen = new_screen(9, 1)
    screen.circle(20, 20, 10)
    quadrant = [
        (0, 7),
        (1, 7),
        (2, 7),
        (3, 7),
        (4, 6),
        (5, 6),
        (6, 6),
        (7, 5),
        (8, 4),
        (9, 3),
        (10, 2),
        (10, 1),
        (10, 0),
    ]
    assert points(screen) == sorted(
        {(20 + sx * x, 20 + sy * y) for x, y in quadrant for sx in (1, -1) for sy in (1, -1)}
    )


def test_circle_that_overflowed_the_original_draws_nothing(vga):
    vga.circle(0, 6553, 6553)
    assert points(vga)
    vga.cleardevice()
    vga.circle(0, 6554, 6554)
    vga.circle(100, 100, -5)
    vga.circle(100, 100, 10**30)
    assert not points(vga)


def test_fillpoly_spans(vga):
    """The check value of the manual's rule: rows 0..7 of a triangle, outline not drawn."""
    vga.fillpoly([(10, 0), (20, 5), (0, 8)], color=0)
    spans = [(10, 10), (9, 12), (8, 14), (7, 16), (5, 18), (4, 20), (3, 14), (2, 7)]
    assert points(vga) == sorted((x, y) for y, (a, b) in enumerate(spans) for x in range(a, b + 1))


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


def test_empty_fill_erases_a_bar_but_leaves_a_polygon(vga):
    vga.bar(0, 0, 30, 30)
    vga.setfillstyle(0, 3)
    vga.fillpoly([(5, 5), (10, 5), (10, 10)], color=0)
    assert vga.getpixel(9, 6) == 15
    vga.bar(5, 5, 10, 10)
    assert vga.getpixel(9, 6) == 0


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
    assert points(vga) == [(0, 0), (1, 0), (4, 0), (5, 0)]


def test_setlinestyle_refuses(vga):
    for style, width in [(5, 1), (-1, 1), (0, 2), (0, 0)]:
        vga.setlinestyle(style, 0, width)
        assert KERNEL.result.take() == -11
    vga.line(0, 0, 3, 0)
    assert len(points(vga)) == 4


def test_setfillstyle_refuses(vga):
    for pattern, color in [(13, 1), (-1, 1), (1, 16), (1, -1)]:
        vga.setfillstyle(pattern, color)
        assert KERNEL.result.take() == -11
    vga.bar(0, 0, 1, 1)
    assert vga.getpixel(0, 0) == 15


def test_setviewport_refuses(vga):
    vga.setviewport(10, 10, 20, 20, 1)
    for corners in [(-1, 0, 5, 5), (0, 0, 640, 5), (5, 0, 4, 5), (0, 9, 5, 8), (0, 0, 5, 480)]:
        vga.setviewport(*corners, 1)
        assert KERNEL.result.take() == -11
    vga.putpixel(0, 0, 3)
    assert vga.page.get(10, 10) == 3


def test_text_is_cut_by_whole_characters(vga):
    vga.setviewport(0, 0, 19, 7, 1)
    vga.outtextxy(-3, 0, "AAA")
    left = vga.page.array[:8, :5].any()
    assert not left
    assert vga.page.array[:8, 5:13].any()
    assert not vga.page.array[:8, 13:].any()
    vga.cleardevice()
    vga.outtextxy(0, 1, "A")
    assert not vga.page.array.any()


def test_text_is_code_page_437(new_screen):
    one, other = new_screen(), new_screen()
    one.outtextxy(0, 0, "Ä☺é⌂→€")
    other.outtextxy(0, 0, bytes([142, 1, 130, 127, 26]) + b"?")
    assert (one.page.array == other.page.array).all()


def test_text_measures(vga):
    assert (vga.textwidth("Hello"), vga.textwidth(b""), vga.textheight("Hello")) == (40, 0, 8)
    for wrong in (42, None, ["a"], 1.5):
        for call in (vga.textwidth, vga.textheight, vga.outtext):
            with pytest.raises(TypeError, match="str or bytes"):
                call(wrong)


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
