"""Flood filling: Borland's rules, any shape."""

from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.memory.page import Page
from bgi.raster.floodfill import flood, flood_many
from bgi.raster.patterns import FILL_PATTERNS


def reference(inside, ways, x, y):
    """The runs of `inside` to fill from x, y, by the plainest means: a set of (y, first, last)."""

    def run(x, y):
        first = last = x
        while inside[y, first - 1]:
            first -= 1
        while inside[y, last + 1]:
            last += 1
        return y, first, last

    found, waiting = set(), [run(x, y)]
    while waiting:
        y, first, last = one = waiting.pop()
        if one not in found:
            found.add(one)
            waiting += [
                run(x, row)
                for row in (y - 1, y + 1)
                for x in range(first, last + 1)
                if ways[row, x]
            ]
    return found


@pytest.mark.parametrize("fill", [flood, flood_many])
@settings(deadline=None, max_examples=300)
@given(
    st.integers(1, 12),
    st.integers(1, 12),
    st.integers(0, 2**31),
    st.floats(0.3, 0.95),
    st.sampled_from([0.2, 0.6, 1]),
)
def test_runs(fill, width, height, seed, density, passed):
    rng = np.random.default_rng(seed)
    inside, ways = np.zeros((2, height + 2, width + 2), bool)
    inside[1:-1, 1:-1] = rng.random((height, width)) < density
    x, y = int(rng.integers(width)) + 1, int(rng.integers(height)) + 1
    inside[y, x] = True
    ways[:] = inside & (rng.random(inside.shape) < passed)
    stride = width + 2
    marks = bytearray(inside.tobytes()), bytearray(ways.tobytes())
    place = y * stride + x
    runs = zip(*fill(*marks, stride, place if fill is flood else [place]), strict=True)
    found = [(a // stride, a % stride, (b - 1) % stride) for a, b in runs]
    assert len(found) == len(set(found))
    assert set(found) == reference(inside, ways, x, y)


@settings(deadline=None, max_examples=100)
@given(st.integers(0, 2**31), st.floats(0, 0.5), st.integers(0, 11), st.integers(0, 6))
def test_the_area_is_the_same_however_far_it_is_looked_for_first(seed, density, pattern, near):
    rng = np.random.default_rng(seed)
    page = Page(memoryview(bytearray(40 * 30)), 40, 30)
    page.array[:] = rng.choice(3, (30, 40), p=[1 - density, density / 2, density / 2])
    page.clip_to((3, 2, 37, 28))
    x, y = int(rng.integers(40)), int(rng.integers(30))
    areas = []
    for first in (near, 100):
        with patch("bgi.memory.areas._NEAR", first):
            found = page.area(x, y, 1, 2, FILL_PATTERNS[pattern])
            areas.append(sorted(zip(*found, strict=True)))
    assert areas[0] == areas[1]


def test_many_runs_are_filled_like_few(new_screen):
    one, other = new_screen(), new_screen()
    for screen in (one, other):
        screen.line(range(2, 638, 2), 0, range(2, 638, 2), 478)
        screen.setfillstyle(7, 2)
    one.floodfill(1, 0, 15)
    with patch("bgi.raster.floodfill.FEW", 10**9):
        other.floodfill(1, 0, 15)
    assert (one.page.array == other.page.array).all()


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
