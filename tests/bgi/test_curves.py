"""Circles, arcs, ellipses, pies: the check values of the manual, and their edge cases."""

import pytest

import bgi
from bgi.kernel.state import KERNEL
from bgi.raster import ellipses as curves
from bgi.settings import arccoordstype
from tests.pictures import points


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
    assert points(vga) == {
        (20 + sx * x, 20 + sy * y) for x, y in quadrant for sx in (1, -1) for sy in (1, -1)
    }


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
    assert points(screen) == {
        (20 + sx * x, 20 + sy * y) for x, y in quadrant for sx in (1, -1) for sy in (1, -1)
    }


def test_circle_that_overflowed_the_original_draws_nothing(vga):
    vga.circle(0, 6553, 6553)
    assert points(vga)
    vga.cleardevice()
    vga.circle(0, 6554, 6554)
    vga.circle(100, 100, -5)
    vga.circle(100, 100, 10**30)
    assert not points(vga)


@pytest.mark.parametrize(
    "mode, arc, ends",
    [
        (2, (0, 0, 30, 60, 100), (86, -50, 50, -86)),
        (1, (0, 0, 45, 135, 100), (70, -54, -71, -54)),
        (2, (0, 0, 0, 200, 50), (50, 0, -47, 18)),
    ],
)
def test_getarccoords(new_screen, mode, arc, ends):
    screen = new_screen(9, mode)
    screen.arc(*arc)
    assert screen.getarccoords() == arccoordstype(0, 0, *ends)
    screen.setviewport(100, 100, 200, 200, 1)
    screen.ellipse(7, 8, 0, 90, 10, 5)
    assert screen.getarccoords() == arccoordstype(7, 8, 17, 8, 7, 3)


def test_every_curve_moves_the_centre_and_thin_ones_the_ends(vga):
    vga.arc(0, 0, 0, 90, 10)
    vga.arc(20, 30, 45, 45, 50)
    assert vga.getarccoords() == arccoordstype(20, 30, 30, 30, 20, 20)
    vga.arc(5, 5, -1, 90, 50)
    assert vga.getarccoords().x == 20
    vga.fillellipse(50, 50, 6, 7)
    assert vga.getarccoords() == arccoordstype(50, 50, 56, 50, 56, 50)
    vga.circle([1, 2], 50, 6)
    assert vga.getarccoords() == arccoordstype(2, 50, 8, 50, 8, 50)
    vga.setlinestyle(0, 0, 3)
    vga.circle(70, 70, 30)
    assert vga.getarccoords() == arccoordstype(70, 70, 76, 70, 76, 70)
    vga.pieslice(0, 0, 90, 0, 20)
    assert vga.getarccoords() == arccoordstype(0, 0, 20, 0, 0, -20)


def test_the_ends_outlive_the_mode():
    bgi.initgraph()
    bgi.arc(0, 0, 0, 90, 10)
    bgi.graphdefaults()
    bgi.closegraph()
    bgi.initgraph()
    assert bgi.getarccoords() == arccoordstype(0, 0, 10, 0, 0, -10)


def test_ellipse_of_the_check_values():
    steps = [
        *((x, 5) for x in range(6)),
        *((x, 4) for x in (6, 7, 8)),
        (9, 3),
        (10, 3),
        (11, 2),
        (12, 1),
        (12, 0),
    ]
    assert curves.quadrant(12, 5) == steps


def test_flat_ellipses_fall_short_as_in_the_original(vga):
    vga.ellipse(200, 200, 0, 360, 100, 2)
    assert max(x for x, _ in points(vga)) == 294


def test_arcs_join_to_a_circle(new_screen):
    one, other = new_screen(), new_screen()
    one.circle(100, 100, 60)
    for start in range(0, 360, 30):
        other.arc(100, 100, start, start + 30, 60)
    assert points(one) == points(other)


@pytest.mark.parametrize(
    "angles, same",
    [
        ((-90, 90), (270, 90)),
        ((380, 400), (20, 40)),
        ((350, 370), (350, 10)),
        ((10, 370), (0, 360)),
        ((10**20, 10**20 + 50), (280, 330)),
    ],
)
def test_angles_are_brought_into_a_turn(new_screen, angles, same):
    one, other = new_screen(), new_screen()
    one.arc(100, 100, *angles, 60)
    other.arc(100, 100, *same, 60)
    assert points(one) == points(other)


def test_large_arcs_are_arcs(vga):
    """Above a radius of 1000 the original's arithmetic mixes the quadrants up; ours does not."""
    vga.arc(-1800, 240, -5, 5, 2000)
    shown = points(vga)
    assert {x for x, _ in shown} <= set(range(185, 201))
    assert {y for _, y in shown} == set(range(66, 416))
    vga.cleardevice()
    vga.sector(-1800, 240, 0, 10, 2000, 2000)
    assert vga.getpixel(100, 100) == 15
    assert vga.getpixel(100, 300) == 0


def test_equal_angles_draw_nothing(vga):
    vga.arc(100, 100, 45, 45, 60)
    assert not points(vga)


def test_thin_curves_ignore_style_and_write_mode(new_screen):
    one, other = new_screen(), new_screen()
    other.setlinestyle(3, 0, 1)
    other.setwritemode(1)
    for screen in (one, other):
        screen.bar(0, 0, 50, 50)
        screen.setcolor(4)
        screen.ellipse(50, 50, 0, 360, 40, 30)
    assert (one.page.array == other.page.array).all()


def test_circle_and_fillellipse_share_their_edge(new_screen):
    one, other = new_screen(), new_screen()
    one.circle(100, 100, 37)
    other.setfillstyle(1, 2)
    other.fillellipse(100, 100, 37, 37)
    assert points(one) == {(x, y) for x, y in points(other) if other.getpixel(x, y) == 15}


def test_aspect_ratio(vga):
    assert vga.getaspectratio() == (10000, 10000)
    vga.setaspectratio(5000, 10000)
    vga.circle(100, 100, 40)
    assert max(y for _, y in points(vga)) == 120
    vga.graphdefaults()
    assert vga.getaspectratio() == (5000, 10000)
    for bad in [(1, 0), (-1, 1), (1, -1)]:
        vga.setaspectratio(*bad)
        assert KERNEL.result.take() == -11
    assert vga.getaspectratio() == (5000, 10000)


def test_pieslice_of_no_angle_is_a_dot(vga):
    vga.pieslice(100, 100, 45, 45, 60)
    assert points(vga) == {(100, 100)}


@pytest.mark.parametrize("angle, same", [(-90, 286), (-211, 165), (450, 90), (720, 0)])
def test_angles_of_a_slice_are_unsigned(new_screen, angle, same):
    one, other = new_screen(), new_screen()
    one.pieslice(100, 100, angle, 200, 60)
    other.pieslice(100, 100, same, 200, 60)
    assert points(one) == points(other)


@pytest.mark.parametrize(
    "angles, same",
    [
        ((-90, 0), (0, 360)),  # so the original: as unsigned numbers the start is not below the end
        ((-10, 10), (0, 360)),
        ((-400, -100), (320, 620)),
        ((0, 720), (0, 360)),  # too many corners for the original, which drew nothing
        ((86, -395), (86, 325)),
        ((45, 45), (0, 360)),
    ],
)
def test_angles_of_a_thick_arc(new_screen, angles, same):
    one, other = new_screen(), new_screen()
    for screen, (start, end) in ((one, angles), (other, same)):
        screen.setlinestyle(0, 0, 3)
        screen.arc(100, 100, start, end, 60)
    assert points(one) == points(other)


def test_pieslice_goes_from_the_lesser_angle(new_screen):
    one, other = new_screen(), new_screen()
    one.pieslice(100, 100, 300, 60, 60)
    other.pieslice(100, 100, 60, 300, 60)
    assert points(one) == points(other)


def test_negative_and_overflowing_radii_draw_nothing(vga):
    for radius in (-1, 6554, 10**30):
        vga.circle(100, 100, radius)
        vga.arc(100, 100, 0, 90, radius)
        vga.pieslice(100, 100, 0, 90, radius)
        vga.ellipse(100, 100, 0, 90, radius, 5)
        vga.fillellipse(100, 100, 5, radius)
        vga.sector(100, 100, 0, 90, 5, radius)
    assert not points(vga)


@pytest.mark.parametrize(
    "curve", [(0, 360, 50, 30), (20, 200, 7, 40), (350, 10, 1, 0), (5, 5, 9, 9)]
)
@pytest.mark.parametrize("place", [(100, 100), (60, 45), (5, 100), (100, 3)])
def test_a_thick_curve_is_thick_lines_from_degree_to_degree(vga, curve, place):
    x, y = place
    vga.setlinestyle(0, 0, 3)
    vga.ellipse(x, y, *curve)
    drawn = points(vga)
    vga.cleardevice()
    vga.drawpoly([(x + dx, y + dy) for dx, dy in curves.thick_points(*curve)])
    assert drawn == points(vga)
