"""Fill patterns: whatever is filled, each pixel is read from the pattern's bits."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.memory.areas import KEPT_INKS
from bgi.memory.page import Page
from bgi.raster.spans import Spans

WIDTH, HEIGHT = 85, 40
LEFT, TOP, RIGHT, BOTTOM = 3, 2, 81, 36
BEFORE = 7
places = st.tuples(*[st.integers(-9, 90)] * 4)
patterns = st.binary(min_size=8, max_size=8)


def page(pixel_bytes):
    """A page of one number, which is clipped to a box."""
    made = Page(memoryview(bytearray(WIDTH * HEIGHT * pixel_bytes)), WIDTH, HEIGHT, pixel_bytes)
    made.flat[:] = BEFORE
    made.clip_to((LEFT, TOP, RIGHT, BOTTOM))
    return made


def expected(box, pattern, color):
    """The page after a box, pixel by pixel."""
    left, top, right, bottom = box
    return [
        [
            color * (pattern[y & 7] >> (7 - (x & 7)) & 1)
            if max(left, LEFT) <= x <= min(right, RIGHT)
            and max(top, TOP) <= y <= min(bottom, BOTTOM)
            else BEFORE
            for x in range(WIDTH)
        ]
        for y in range(HEIGHT)
    ]


def ordered(corners):
    """Left, top, right and bottom."""
    x1, y1, x2, y2 = corners
    return min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2)


def as_box(made, corners, color, pattern):
    made.fill(*corners, color, pattern)


def as_rows(made, corners, color, pattern):
    left, top, right, bottom = ordered(corners)
    rows = range(max(top, TOP), min(bottom, BOTTOM) + 1)
    made.fill_rows((rows, [right] * len(rows), [left] * len(rows)), color, pattern)


def as_spans(made, corners, color, pattern):
    left, top, right, bottom = ordered(corners)
    y = np.arange(max(top, TOP), min(bottom, BOTTOM) + 1)
    ends = np.full(len(y), left), np.full(len(y), right)
    made.fill_spans(Spans(y, *ends, np.zeros(len(y), int)), np.array([color]), pattern)


@pytest.mark.parametrize("fill", [as_box, as_rows, as_spans])
@pytest.mark.parametrize(("pixel_bytes", "color"), [(1, 15), (1, 255), (4, 0x1FEDCBA)])
@settings(deadline=None, max_examples=40)
@given(corners=places, pattern=st.one_of(patterns, st.sampled_from([b"\xff" * 8, bytes(8)])))
def test_each_pixel_is_read_from_the_patterns_bits(fill, pixel_bytes, color, corners, pattern):
    made = page(pixel_bytes)
    fill(made, corners, color, pattern)
    assert made.array.tolist() == expected(ordered(corners), pattern, color)


def test_a_page_keeps_few_bytes_of_patterns():
    made = Page(memoryview(bytearray(4096 * 8 * 4)), 4096, 8, 4)
    for color in range(1, 50):
        made.fill(0, 0, 9, 7, color, b"\xaa" * 8)
        assert made.array[0, :2].tolist() == [color, 0]
        assert sum(kept.block.nbytes for kept in made._inks.values()) <= KEPT_INKS
