"""Circles, arcs, ellipses, pies: the check values of the manual, and their edge cases."""

from contextlib import nullcontext
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import bgi
from bgi import CGA, CGAC0, CGAHI, VGA, VGAHI
from bgi.graphics import Graphics
from bgi.kernel.modes import find
from bgi.kernel.state import KERNEL
from bgi.memory.page import Page
from bgi.raster import ellipses as curves
from bgi.raster import slices
from bgi.raster.kept import Kept
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
    x, y = curves.quadrant(12, 5)
    assert list(zip(x.tolist(), y.tolist(), strict=True)) == steps


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
    vga.drawpoly([(x + dx, y + dy) for dx, dy in zip(*curves.thick_points(*curve), strict=True)])
    assert drawn == points(vga)


def stepped(rx, ry):
    """The quadrant as the kernel walks along it, from pixel to pixel: the captured rule."""
    square = 100 * max(rx, ry) ** 2
    p, q = square // rx // rx, square // ry // ry
    x, y = 0, ry
    error, dv, dh = q * ry * ry - square, 2 * q * ry, 0
    while True:  # the flat part: every x once
        yield x, y
        h, v = dh + p, dv - q
        if 2 * error + 2 * h >= v:
            y, error, dv = y - 1, error - v, v - q
        x, error, dh = x + 1, error + h, h + p
        if dh >= dv:
            break
    while y >= 0:  # the steep part: every y once
        yield x, y
        h, v = dh + p, dv - q
        if h // 2 + error <= v:
            x, error, dh = x + 1, error + h, h + p
        y, error, dv = y - 1, error - v, v - q


radii = st.one_of(st.integers(1, 60), st.integers(1, 1100), st.integers(1, 6553))


def assert_stepped(rx, ry):
    square = 100 * max(rx, ry) ** 2
    for steps in curves._walked, curves._computed:
        x, y = steps(ry, square, square // rx // rx, square // ry // ry)
        assert list(zip(x.tolist(), y.tolist(), strict=True)) == list(stepped(rx, ry)), (rx, ry)


@settings(deadline=None, max_examples=200)
@given(rx=radii, ry=radii)
@example(rx=8, ry=1015)
@example(rx=1035, ry=806)
@example(rx=100, ry=2)
def test_a_quadrant_is_what_the_stepper_walks(rx, ry):
    """Of a large one all points are computed at once, by square roots."""
    assert_stepped(rx, ry)


def test_small_quadrants_are_what_the_stepper_walks():
    for rx in range(1, 41):
        for ry in range(1, 41):
            assert_stepped(rx, ry)


ANGLES = st.one_of(st.integers(0, 360), st.sampled_from([0, 90, 180, 270, 360]))
CURVES = {
    "circle": st.tuples(st.integers(0, 60)),
    "arc": st.tuples(ANGLES, ANGLES, st.integers(0, 60)),
    "ellipse": st.tuples(ANGLES, ANGLES, st.integers(0, 60), st.integers(0, 60)),
    "fillellipse": st.tuples(st.integers(0, 60), st.integers(0, 60)),
    "pieslice": st.tuples(ANGLES, ANGLES, st.integers(0, 60)),
    "sector": st.tuples(ANGLES, ANGLES, st.integers(0, 60), st.integers(0, 60)),
}
curve_calls = st.sampled_from(list(CURVES)).flatmap(
    lambda name: st.tuples(st.just(name), CURVES[name])
)
centres = st.tuples(st.integers(-70, 170), st.integers(-70, 140))
MODES = st.sampled_from([(VGA, VGAHI), (CGA, CGAC0), (CGA, CGAHI)])
quick = settings(deadline=None, max_examples=150)


def drawn(call, centre, style=(0, 0, 1), xor=0, mode=(VGA, VGAHI), fill=1, box=(40, 30, 139, 99)):
    """The page after a curve in a viewport, its pattern behind it."""
    screen = Graphics(find(*mode))
    screen.page.flat[:] = np.arange(screen.page.flat.size) % min(13, screen.mode.colors)
    screen.setlinestyle(*style)
    screen.setwritemode(xor)
    screen.setfillstyle(fill, 9)
    screen.setcolor(14)
    left, top, right, bottom = box
    screen.setviewport(left, top, right, bottom, 1)
    name, numbers = call
    x, y = centre
    getattr(screen, name)(x - box[0], y - box[1], *numbers)
    return screen.page.array


@quick
@given(call=curve_calls, centre=centres, mode=MODES, fill=st.integers(0, 11))
@example(call=("sector", (0, 192, 46, 0)), centre=(8, 99), mode=(VGA, VGAHI), fill=0)
def test_a_thin_curve_in_a_viewport_is_what_is_seen_of_the_whole(call, centre, mode, fill):
    """A slice may have lines, whose clipped pixels may differ: it is drawn without."""
    with (
        patch.object(Graphics, "_segment", lambda *_: None),
        patch.object(Graphics, "_outline", lambda *_: None),
    ):
        whole = drawn(call, centre, mode=mode, fill=fill, box=(0, 0, 319, 199))
        cut = drawn(call, centre, mode=mode, fill=fill)
    assert (cut[30:100, 40:140] == whole[30:100, 40:140]).all()
    cut[30:100, 40:140] = 0
    blank = drawn(("circle", (-1,)), centre, mode=mode)
    blank[30:100, 40:140] = 0
    assert (cut == blank).all()


@quick
@given(call=curve_calls, centre=centres, mode=MODES, fill=st.integers(0, 11))
def test_a_curve_that_is_met_again_has_the_same_pixels(call, centre, mode, fill):
    """Then it is kept: its outline, and the rows that fill it."""
    with (
        patch("bgi.graphics.curves.CURVES", Kept(curves._curve, 1 << 20)),
        patch("bgi.graphics.curves.REGIONS", Kept(slices._region, 1 << 20)),
    ):
        new, again, kept = (drawn(call, centre, mode=mode, fill=fill) for _ in range(3))
    assert (new == again).all()
    assert (new == kept).all()


def test_a_filled_curve_is_kept_when_it_is_met_again(vga):
    with (
        patch("bgi.graphics.curves.CURVES", Kept(curves._curve, 1 << 20)) as outlines,
        patch("bgi.graphics.curves.REGIONS", Kept(slices._region, 1 << 20)) as regions,
    ):
        vga.fillellipse(100, 100, 30, 20)
        assert not outlines and not regions
        vga.fillellipse(200, 200, 30, 20)
        assert outlines and regions


@quick
@given(
    ends=st.tuples(ANGLES, ANGLES),
    rx=st.integers(0, 160),
    ry=st.integers(0, 160),
    centre=centres,
    xor=st.integers(0, 1),
    mode=MODES,
)
@example(ends=(0, 360), rx=120, ry=90, centre=(50, 50), xor=1, mode=(CGA, CGAC0))
def test_a_thick_curve_that_an_edge_cuts_is_thick_lines(ends, rx, ry, centre, xor, mode):
    def drawn_by(name, *numbers):
        call = name, numbers
        return drawn(call, centre, style=(0, 0, 3), xor=xor, mode=mode)

    def sides(screen, x, y, *curve):
        for dx1, dy1, dx2, dy2 in np.stack(curves.thick_sides(*curve), axis=-1).tolist():
            screen.line(x + dx1, y + dy1, x + dx2, y + dy2)

    with patch.object(Graphics, "sides", sides, create=True):
        assert (drawn_by("ellipse", *ends, rx, ry) == drawn_by("sides", *ends, rx, ry)).all()


styles = st.tuples(st.integers(0, 4), st.integers(0, 0xFFFF), st.sampled_from([1, 3]))


@quick
@given(
    call=curve_calls,
    centre=st.one_of(centres, st.tuples(st.integers(90, 110), st.integers(60, 80))),
    style=styles,
    xor=st.integers(0, 1),
    mode=MODES,
    fill=st.integers(0, 11),
)
def test_kept_curves_are_those_drawn_line_by_line(call, centre, style, xor, mode, fill):
    """Thick curves, and slices with their arcs."""
    kept = drawn(call, centre, style, xor, mode, fill)

    def by_lines(*key):
        piece = slices._piece(*key)
        rows = slices._scanned_rows(piece.edge.dx, piece.edge.dy)
        return piece._replace(rows=rows, smooth=False)

    def cut(self, *_):
        return False

    thin = style[2] == 1
    with (
        patch("bgi.graphics.curves.PIECES", Kept(by_lines, 1000)),
        patch.object(curves, "is_fine", lambda *_: False),
        patch.object(Page, "holds", cut),
        nullcontext() if thin else patch.object(Page, "put_offsets", cut),
    ):
        plain = drawn(call, centre, style, xor, mode, fill)
    assert (kept == plain).all()


@quick
@given(
    piece=st.sampled_from([0, 90, 180, 270]),
    ends=st.tuples(st.integers(0, 90), st.integers(0, 90)),
    rx=radii,
    ry=radii,
)
@example(piece=0, ends=(0, 90), rx=40, ry=30)
def test_a_smooth_piece_of_a_slice_is_filled_like_any_polygon(piece, ends, rx, ry):
    first, last = (piece + angle for angle in sorted(ends))
    found = slices._piece(first, last, rx, ry, 640)
    if (first, last, rx, ry) == (0, 90, 40, 30):
        assert found.smooth
    scanned = slices._scanned_rows(found.edge.dx, found.edge.dy)
    for one, other in zip(found.rows, scanned, strict=True):
        assert one.tolist() == other.tolist()


@quick
@given(
    quarter=st.sampled_from([0, 90, 180, 270]),
    ends=st.tuples(st.integers(0, 90), st.integers(0, 90)),
    rx=st.one_of(radii, st.integers(0, 2000)),
    ry=st.one_of(radii, st.integers(0, 2000)),
)
@example(quarter=270, ends=(0, 90), rx=46, ry=3)  # which does not end at 46
@example(quarter=270, ends=(0, 90), rx=1, ry=0)
@example(quarter=0, ends=(0, 90), rx=40, ry=30)
def test_the_edge_of_a_slice_is_an_arc(quarter, ends, rx, ry):
    """Also where it is taken as a stretch of the quadrant, as most are."""
    first, last = (quarter + angle for angle in sorted(ends))
    stretch = slices._stretch(first, last, rx, ry)
    if (first, last, rx, ry) == (0, 90, 40, 30):
        assert stretch
    if stretch:
        dx, dy = stretch
        arc_dx, arc_dy = curves.arc(first, last, rx, ry)
        assert (dx.tolist(), dy.tolist()) == (arc_dx.tolist(), arc_dy.tolist())
        assert slices._smooth(dx, dy)


@quick
@given(
    call=curve_calls,
    x=st.sampled_from([-(10**30), -(1 << 40), -(1 << 24), 50, 1 << 62, 10**30]),
    y=st.sampled_from([-(10**30), -(1 << 40), -(1 << 24), 50, 1 << 62, 10**30]),
    style=styles,
    xor=st.integers(0, 1),
)
def test_curves_may_be_anywhere(call, x, y, style, xor):
    if (x, y) != (50, 50):
        nothing = drawn(("circle", (-1,)), (0, 0))
        assert (drawn(call, (x, y), style, xor) == nothing).all()
