"""Invariants of drawing, on arguments that nobody would choose."""

from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from bgi import CGA, CGAC0, CGAHI, COLOR, VGA, VGAHI
from bgi.fonts.layout import Scale, anchor
from bgi.graphics import Graphics
from bgi.graphics.pen import FEW
from bgi.kernel.arguments import LIMIT
from bgi.kernel.modes import find, window
from bgi.kernel.state import KERNEL
from bgi.raster import lines, polygons
from tests.stroked import segments

LEFT, TOP, RIGHT, BOTTOM = 40, 30, 139, 99
near = st.integers(-60, 160)
huge = st.one_of(near, st.integers(-(10**6), 10**6), st.integers(-(10**30), 10**30))
far = st.one_of(st.integers(0, 479), st.integers(1 - LIMIT, LIMIT - 1), st.just(LIMIT - 1))
color = st.integers(0, 40)
quick = settings(
    deadline=None, max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture]
)

# name -> how many numbers it takes
NUMBERS = {"putpixel": 3, "line": 4, "rectangle": 4, "bar": 4, "circle": 3}
styles = st.tuples(
    st.integers(0, 4),
    st.integers(0, 0xFFFF),
    st.sampled_from([1, 3]),
    st.integers(0, 1),
    st.integers(0, 11),
)


# Drivers that draw differently: by planes, and packed in four colours and two
modes = st.sampled_from([(VGA, VGAHI), (CGA, CGAC0), (CGA, CGAHI)])
WINDOW = (0, 0)  # of 16 million colours


def screen(style=(0, 0, 1, 0, 1), viewport=True, background=True, mode=(VGA, VGAHI)):
    """A screen with a pattern on it, a viewport and styles."""
    made = Graphics(window(320, 200) if mode == WINDOW else find(*mode))
    if background:
        made.page.flat[:] = np.arange(made.page.flat.size) % min(13, made.mode.colors)
    line_style, pattern, width, write_mode, fill = style
    made.setlinestyle(line_style, pattern, width)
    made.setwritemode(write_mode)
    made.setfillstyle(fill, 9)
    made.setcolor(14)
    if viewport:
        made.setviewport(LEFT, TOP, RIGHT, BOTTOM, 1)
    return made


def outside(made):
    """The pixels outside the viewport."""
    rest = made.page.array.copy()
    rest[TOP : BOTTOM + 1, LEFT : RIGHT + 1] = 0
    return rest


@pytest.mark.parametrize("name", NUMBERS)
@quick
@given(data=st.data(), style=styles, mode=modes)
def test_array_call_is_a_loop_of_calls(name, data, style, mode):
    rows = data.draw(
        st.lists(st.tuples(*[near] * NUMBERS[name]), min_size=1, max_size=12), label="calls"
    )
    one, many = screen(style, mode=mode), screen(style, mode=mode)
    for numbers in rows:
        getattr(one, name)(*numbers)
    getattr(many, name)(*np.array(rows).T)
    assert (one.page.array == many.page.array).all()


@pytest.mark.parametrize("name", ["line", "rectangle", "circle"])
@quick
@given(data=st.data(), style=styles, mode=modes)
def test_array_of_colours_is_a_loop_of_setcolor(name, data, style, mode):
    rows = data.draw(st.lists(st.tuples(color, *[near] * NUMBERS[name]), min_size=1, max_size=8))
    one, many = screen(style, mode=mode), screen(style, mode=mode)
    for ink, *numbers in rows:
        one.setcolor(ink)
        getattr(one, name)(*numbers)
    inks, *arrays = np.array(rows).T
    getattr(many, name)(*arrays, color=inks)
    assert (one.page.array == many.page.array).all()
    assert many.getcolor() == 14


polygon = st.lists(st.tuples(near, near), min_size=1, max_size=7)
coarse = st.tuples(st.integers(0, 9).map(lambda n: n * 11), st.integers(0, 9).map(lambda n: n * 7))


@quick
@given(style=styles, corners=st.integers(1, 6), data=st.data(), mode=modes)
def test_array_of_polygons_is_a_loop_of_calls(style, corners, data, mode):
    # Coarse points coincide often: paths close early, sides have no length.
    shape = st.lists(st.one_of(coarse, st.tuples(near, near)), min_size=corners, max_size=corners)
    shapes = data.draw(st.lists(st.tuples(shape, color, color), min_size=1, max_size=6))
    for call in ("fillpoly", "drawpoly"):
        one, many = screen(style, mode=mode), screen(style, mode=mode)
        for points, fill, ink in shapes:
            inks = {"fill": fill, "color": ink} if call == "fillpoly" else {"color": ink}
            getattr(one, call)(points, **inks)
        points, fills, colors = zip(*shapes, strict=True)
        inks = {"fill": fills, "color": colors} if call == "fillpoly" else {"color": colors}
        getattr(many, call)(np.array(points), **inks)
        assert (one.page.array == many.page.array).all(), call


@quick
@given(
    style=styles,
    shape=st.lists(st.tuples(st.integers(-30, 60), st.integers(-30, 60)), min_size=1, max_size=7),
    places=st.lists(st.tuples(near, near), min_size=1, max_size=6),
    mode=modes,
)
def test_a_polygon_that_is_met_again_is_filled_like_a_new_one(style, shape, places, mode):
    """From the second time on a small one is kept, and put where no edge cuts it."""
    new, again = screen(style, mode=mode), screen(style, mode=mode)
    for left, top in [places[0], places[0], *places]:
        points = [(left + x, top + y) for x, y in shape]
        with patch("bgi.graphics.filling.MOST_CORNERS", 0):
            new.fillpoly(points)
        again.fillpoly(points)
        assert (new.page.array == again.page.array).all()


@quick
@given(points=st.lists(st.tuples(far, far), min_size=3, max_size=5))
def test_the_crossings_of_long_sides_are_whole_numbers_of_the_rule(points):
    """Array polygons are computed in floats, a single one in whole numbers."""
    one, many = screen(viewport=False), screen(viewport=False)
    one.fillpoly(points, color=0)
    many.fillpoly([points], color=0)
    assert (one.page.array == many.page.array).all()


@quick
@given(style=styles, points=st.lists(st.tuples(huge, huge), min_size=2, max_size=8))
def test_a_figure_of_many_lines_is_a_loop_of_lines(style, points):
    """Of very many lines the page gets all at once."""
    one, many = screen(style), screen(style)
    corners = [(x + turn, y) for turn in range(FEW) for x, y in points]
    for side in polygons.edges(polygons.paths(corners)):
        one.line(*side)
    many.drawpoly(corners)
    assert (one.page.array == many.page.array).all()


@quick
@given(style=styles, points=st.lists(st.tuples(huge, huge), min_size=1, max_size=8))
@example(style=(0, 0, 1, 0, 1), points=[(50, 50)])
def test_a_polygon_of_many_corners_is_filled_like_one_of_few(style, points):
    one, many = screen(style), screen(style)
    corners = [(x + turn % 3, y) for turn in range(FEW) for x, y in points]
    with patch("bgi.graphics.pen.FEW", 10**9):
        one.fillpoly(corners)
    many.fillpoly(corners)
    assert (one.page.array == many.page.array).all()


@pytest.mark.parametrize("name", NUMBERS)
@quick
@given(data=st.data(), style=styles)
def test_any_int_is_legal_and_nothing_outside_the_viewport_changes(name, data, style):
    numbers = data.draw(st.tuples(*[huge] * NUMBERS[name]))
    made = screen(style)
    before = outside(made)
    getattr(made, name)(*numbers)
    assert (outside(made) == before).all()
    again = screen(style)
    getattr(again, name)(*[[number] for number in numbers])
    assert (again.page.array == made.page.array).all()


@quick
@given(style=styles, points=st.lists(st.tuples(huge, huge), max_size=8))
def test_any_polygon_is_legal(style, points):
    for call in ("fillpoly", "drawpoly"):
        made, again = screen(style), screen(style)
        before = outside(made)
        getattr(made, call)(points)
        assert (outside(made) == before).all()
        if points:
            getattr(again, call)([points])
            assert (again.page.array == made.page.array).all()


@quick
@given(x=huge, y=huge, text=st.one_of(st.text(max_size=40), st.binary(max_size=40)))
def test_any_text_is_legal(x, y, text):
    made = screen()
    before = outside(made)
    made.outtextxy(x, y, text)
    made.moveto(x, y)
    made.outtext(text)
    assert (outside(made) == before).all()


@settings(quick, max_examples=200)
@given(data=st.data(), mode=st.one_of(modes, st.none()), write_mode=st.integers(0, 1))
def test_stroked_text_is_its_lines_drawn_one_by_one(data, mode, write_mode):
    font, direction = data.draw(st.integers(1, 10)), data.draw(st.integers(0, 1))
    size, factors = data.draw(st.integers(0, 5)), st.integers(1, 7)
    horiz, vert = data.draw(st.integers(0, 2)), data.draw(st.integers(0, 2))
    text = data.draw(st.binary(max_size=6))
    pictures = []
    KERNEL.user_scale = Scale(*(data.draw(factors) for _ in "xdyd"))
    places = data.draw(st.lists(st.tuples(near, near), min_size=1, max_size=3))
    for by_lines in (False, True):
        made = screen((0, 0, 1, write_mode, 1), mode=mode or (VGA, VGAHI))
        if mode is None:
            made = Graphics(window(320, 240))
            made.setwritemode(write_mode)
            made.setcolor(COLOR(1, 2, 3))
            made.setviewport(LEFT, TOP, RIGHT, BOTTOM, 1)
        made.settextstyle(font, direction, size)
        made.settextjustify(horiz, vert)
        for x, y in places:
            if not by_lines:
                made.outtextxy(x, y, text)
                continue
            look = made._font, text, made._scale(), direction == 1
            dx, dy = anchor(*look, horiz, vert)
            for line in (segments(*look) + [x + dx, y + dy] * 2).tolist():
                made.line(*line)
        pictures.append(made.page.array)
    assert (pictures[0] == pictures[1]).all()


WRONG = ["12", None, float("nan"), float("inf"), {}, object(), b"1", 1j]


@pytest.mark.parametrize("name", [*NUMBERS, "getpixel", "moveto", "setviewport", "setcolor"])
@pytest.mark.parametrize("wrong", WRONG, ids=lambda value: type(value).__name__)
def test_a_wrong_argument_is_named_and_changes_nothing(name, wrong):
    count = {"getpixel": 2, "moveto": 2, "setviewport": 5, "setcolor": 1}.get(name, 0)
    for place in range(count or NUMBERS[name]):
        made = screen()
        before = made.page.array.copy(), made.settings.view, made.getx(), made.getcolor()
        numbers = [5] * (count or NUMBERS[name])
        numbers[place] = wrong
        with pytest.raises((TypeError, ValueError), match="must be"):
            getattr(made, name)(*numbers)
        assert (made.page.array == before[0]).all()
        assert (made.settings.view, made.getx(), made.getcolor()) == before[1:]


@pytest.mark.parametrize(
    "wrong",
    [
        "abc",
        [[1, 2], [3]],
        [1, 2, 3],
        [[1, 2, 3]],
        [("a", 1)],
        [(1, float("nan"))],
        None,
        7,
        [[[[1, 2]]]],
    ],
    ids=repr,
)
@pytest.mark.parametrize("call", ["fillpoly", "drawpoly"])
def test_a_wrong_polygon_is_an_error(call, wrong):
    made = screen()
    before = made.page.array.copy()
    with pytest.raises((TypeError, ValueError)):
        getattr(made, call)(wrong)
    assert (made.page.array == before).all()


def test_floats_are_truncated_toward_zero():
    one, other = screen(), screen()
    one.line(-0.9, 3.99, 50.5, 20)
    other.line(0, 3, 50, 20)
    one.circle(np.float32(30.7), 30, np.int8(12))
    other.circle(30, 30, 12)
    one.putpixel([1.9, -0.5], 7.5, 3)
    other.putpixel([1, 0], 7, 3)
    assert (one.page.array == other.page.array).all()


def test_small_numpy_integers_do_not_wrap():
    made = screen(background=False)
    made.putpixel(np.uint8(90), np.uint8(60), np.uint8(5))
    assert made.getpixel(np.uint8(90), 60) == 5
    assert made.page.get(LEFT + 90, TOP + 60) == 5


def test_shapes_that_do_not_go_together():
    with pytest.raises(ValueError, match=r"x \(2,\), y \(3,\)"):
        screen().putpixel([1, 2], [1, 2, 3], 1)


@quick
@given(x1=near, y1=near, x2=near, y2=near)
def test_pygames_line_is_the_drivers(x1, y1, x2, y2):
    """Page.line trusts pygame with thin solid lines: prove it against the rule itself."""
    made, traced = (
        screen(viewport=False, background=False),
        screen(viewport=False, background=False),
    )
    made.line(x1 + 60, y1 + 60, x2 + 60, y2 + 60)
    from bgi.raster.lines import trace_many

    xs, ys, _, _ = trace_many(np.array([[x1, y1, x2, y2]]).T + 60)
    traced.putpixel(xs, ys, 14)
    assert (made.page.array == traced.page.array).all()


def test_pygames_line_in_every_slope():
    made, traced = screen(background=False), screen(background=False)
    from bgi.raster.lines import trace_many

    for dx in range(-40, 41):
        for dy in range(-30, 31):
            made.clearviewport()
            traced.clearviewport()
            made.line(50, 35, 50 + dx, 35 + dy)
            xs, ys, _, _ = trace_many(np.array([[50, 35, 50 + dx, 35 + dy]]).T)
            traced.putpixel(xs, ys, 14)
            assert (made.page.array == traced.page.array).all(), (dx, dy)


# Both packed drivers, planes, and a window of 16 million colours
depths = st.sampled_from([(VGA, VGAHI), (CGA, CGAC0), (CGA, CGAHI), WINDOW])
anywhere = st.one_of(near, st.integers(0, 639), huge)
across_it, down_it = st.integers(0, RIGHT - LEFT), st.integers(0, BOTTOM - TOP)
ends = st.one_of(st.tuples(*[anywhere] * 4), st.tuples(across_it, down_it, across_it, down_it))


@quick
@given(style=styles, rows=st.lists(ends, max_size=6), mode=depths)
@example(style=(4, 0x8001, 1, 1, 1), rows=[(10, 10, 309, 190), (309, 10, 10, 190)], mode=WINDOW)
def test_a_line_is_what_the_array_of_it_is(style, rows, mode):
    """Single lines have ways of their own: short ones, level ones, long ones, thick ones."""
    for viewport in (False, True):
        one, many = screen(style, viewport, mode=mode), screen(style, viewport, mode=mode)
        for row in rows:
            one.line(*row)
        with patch(
            "bgi.memory.strokes._LONG", 1 << 60
        ):  # else an array of long ones is a loop, too
            many.line(*np.array(rows, object).reshape(-1, 4).T)
        assert (one.page.array == many.page.array).all()


@pytest.mark.parametrize("width", [1, 3])
@pytest.mark.parametrize("pattern", [0xFFFF, 0xC0F1])
@pytest.mark.parametrize("xor", [0, 1])
def test_lines_in_every_slope_are_what_their_array_is(width, pattern, xor):
    slopes = [(dx, dy) for dx in range(-40, 41, 2) for dy in range(-36, 37)]
    x2, y2 = np.array(slopes).T
    for mode in ((VGA, VGAHI), (CGA, CGAHI)):
        one, many = (screen((4, pattern, width, xor, 1), mode=mode) for _ in range(2))
        for dx, dy in slopes:
            one.line(50, 40, 50 + dx, 40 + dy)
        with patch("bgi.memory.strokes._LONG", 1 << 60):
            many.line(50, 40, 50 + x2, 40 + y2)
        assert (one.page.array == many.page.array).all()


@quick
@given(style=styles, row=ends, mode=depths, data=st.data())
def test_a_rectangle_is_four_lines_in_every_style(style, row, mode, data):
    one, other = screen(style, mode=mode), screen(style, mode=mode)
    left, top, right, bottom = row
    for _ in range(data.draw(st.integers(0, 2))):  # after the second its pixels are kept
        screen(style, mode=mode).rectangle(*row)
    one.rectangle(*row)
    other.line(left, top, right, top)
    other.line(right, top, right, bottom)
    other.line(right, bottom, left, bottom)
    other.line(left, bottom, left, top)
    assert (one.page.array == other.page.array).all()


@given(n=st.integers(2, 4095), data=st.data(), width=st.sampled_from([320, 640, 4096]))
def test_every_pixel_of_a_long_line_is_that_of_the_rule(n, data, width):
    m = data.draw(st.integers(1, n - 1))
    first = data.draw(st.integers(0, 4096 * width - 1))
    steps = np.arange(n + 1, dtype=np.int64)
    shorter = (2 * m * steps + n) // (2 * n)
    for sign in (1, -1):
        for along, across in ((sign, width), (width, sign), (1, sign * width), (sign * width, 1)):
            expected = first + along * steps + across * shorter
            assert (lines.places((first, n, m, along, across)) == expected).all()


def rightward(x1, y1, x2, y2):
    """A line as CGA.BGI draws it, by the rule itself: its pixels in order."""
    if x1 >= x2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy, down = x2 - x1, abs(y2 - y1), 1 if y2 >= y1 else -1
    n = max(dx, dy) or 1
    for i in range(max(dx, dy) + 1):
        across = (2 * min(dx, dy) * i + n) // (2 * n)
        x, y = (i, across) if dx >= dy else (across, i)
        yield x1 + x, y1 + y * down


@pytest.mark.parametrize("pattern", [0xFFFF, 0x8001])
def test_lines_of_cga_in_every_slope(pattern):
    made = screen((4, pattern, 1, 0, 1), background=False, mode=(CGA, CGAHI))
    traced = screen(background=False, mode=(CGA, CGAHI))
    for dx in range(-20, 21):
        for dy in range(-20, 21):
            made.clearviewport()
            traced.clearviewport()
            made.line(50, 35, 50 + dx, 35 + dy)
            for step, pixel in enumerate(rightward(50, 35, 50 + dx, 35 + dy)):
                if pattern << step % 16 & 0x8000:  # the highest bit is the first
                    traced.putpixel(*pixel, 1)
            assert (made.page.array == traced.page.array).all(), (dx, dy)


def test_a_clipped_end_is_moved_before_the_other_one():
    """Moving the first end shows that the line misses the viewport: nothing may be drawn."""
    one, many = screen(background=False), screen(background=False)
    one.line(-1, 0, 0, BOTTOM - TOP + 1)
    many.line([-1], 0, 0, BOTTOM - TOP + 1)
    assert not one.page.array.any()
    assert not many.page.array.any()


@quick
@given(ends=st.lists(st.tuples(huge, huge, huge, huge), min_size=1, max_size=60))
@pytest.mark.parametrize("few", [0, 100])
def test_lines_are_clipped_together_as_each_of_them_is(few, ends):
    box = LEFT, TOP, RIGHT, BOTTOM
    fits = all(abs(number) < 1 << 24 for line in ends for number in line)
    x1, y1, x2, y2 = np.array(ends, np.int64 if fits else object).T
    with patch.object(lines, "_FEW", few):
        found, kept = lines.clip_many((x1, y1, x2, y2), box)
    pieces = [lines.clip(x1, y1, x2, y2, box) for x1, y1, x2, y2 in ends]
    assert kept.tolist() == [number for number, piece in enumerate(pieces) if piece]
    assert list(zip(*(end.tolist() for end in found), strict=True)) == [p for p in pieces if p]


def test_graphresult_is_sticky_until_read():
    made = screen()
    made.setlinestyle(9, 0, 1)
    made.line(0, 0, 5, 5)
    assert KERNEL.result.take() == -11
    assert KERNEL.result.take() == 0
