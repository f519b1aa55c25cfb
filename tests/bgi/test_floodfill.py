"""Flood filling: Borland's rules, any shape."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.raster.floodfill import flood


def reference(inside, x, y):
    """The 4-connected area by the plainest means."""
    area, waiting = np.zeros_like(inside), [(x, y)]
    while waiting:
        x, y = waiting.pop()
        within = 0 <= y < inside.shape[0] and 0 <= x < inside.shape[1]
        if within and inside[y, x] and not area[y, x]:
            area[y, x] = True
            waiting += [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]
    return area


@settings(deadline=None)
@given(st.integers(1, 12), st.integers(1, 12), st.integers(0, 2**31), st.floats(0.3, 0.95))
def test_area(width, height, seed, density):
    rng = np.random.default_rng(seed)
    inside = rng.random((height, width)) < density
    x, y = int(rng.integers(width)), int(rng.integers(height))
    inside[y, x] = True
    marks = bytearray(inside.tobytes())
    area = np.zeros_like(inside)
    for row, first, last in zip(*flood(marks, marks, width, x, y), strict=True):
        assert not area[row, first : last + 1].any()
        area[row, first : last + 1] = True
    assert (area == reference(inside, x, y)).all()


def test_only_the_border_colour_stops_it(vga):
    vga.setcolor(4)
    vga.rectangle(10, 10, 30, 30)
    vga.setcolor(15)
    vga.rectangle(5, 5, 40, 40)
    vga.setfillstyle(1, 2)
    vga.floodfill(20, 20, 15)
    assert (vga.page.array[6:40, 6:40] == 2).all()
    assert vga.page.array[41:].max() == 0


def test_seed_on_the_border_or_outside_does_nothing(vga):
    vga.setviewport(10, 10, 50, 50, 1)
    before = vga.page.array.copy()
    vga.floodfill(5, 5, 0)
    vga.floodfill(-1, 5, 15)
    vga.floodfill(41, 5, 15)
    vga.floodfill(10**20, 5, 15)
    assert (vga.page.array == before).all()


def test_the_viewport_confines_it_when_clipping(vga):
    vga.setviewport(10, 10, 50, 50, 1)
    vga.floodfill(5, 5, 4)
    assert vga.page.array.sum() == 41 * 41 * 15
    vga.cleardevice()
    vga.setviewport(10, 10, 50, 50, 0)
    vga.floodfill(5, 5, 4)
    assert vga.page.array.min() == 15


def test_filled_areas_stop_it(vga):
    """What already looks like the fill is taken as done: a wall of the fill colour holds."""
    vga.setfillstyle(1, 2)
    vga.bar(0, 100, 639, 110)
    vga.floodfill(5, 5, 15)
    assert vga.getpixel(5, 99) == 2
    assert vga.getpixel(5, 111) == 0


def test_a_comb_and_a_maze(vga):
    vga.line(range(2, 638, 2), 0, range(2, 638, 2), 478)
    vga.setfillstyle(1, 2)
    vga.floodfill(1, 0, 15)
    assert (vga.page.array[:479, 1::2] == 2).all()
    assert (vga.page.array[479] == 2).all()


def test_nothing_is_entered_by_the_first_or_last_column_alone(vga):
    """So the original: seen where a line met the edge."""
    vga.line([0, 639], 6, [6, 633], 0)
    vga.setfillstyle(1, 2)
    vga.floodfill([1, 638], 1, 15)
    assert [vga.getpixel(x, 4) for x in (0, 1, 638, 639)] == [2, 2, 2, 2]
    assert vga.getpixel(0, 5) == vga.getpixel(639, 5) == 0


@pytest.mark.parametrize("pattern", range(12))
def test_every_pattern_fills_like_a_bar(new_screen, pattern):
    one, other = new_screen(), new_screen()
    for screen in (one, other):
        screen.setfillstyle(pattern, 5)
        screen.setcolor(15)
    one.rectangle(9, 9, 101, 71)
    one.floodfill(50, 40, 15)
    other.bar(10, 10, 100, 70)
    other.rectangle(9, 9, 101, 71)
    assert (one.page.array == other.page.array).all()
