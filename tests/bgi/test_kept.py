"""Tables that fill themselves, and the figures in them."""

from collections import Counter
from unittest.mock import patch

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.raster import offsets
from bgi.raster.kept import MET, Kept


def test_a_table_makes_a_thing_once() -> None:
    asked: list[tuple[int, int]] = []

    def make(a: int, b: int) -> tuple[int, ...]:
        asked.append((a, b))
        return a, b

    table = Kept(make, 10_000)
    assert [table[1, 2], table[3, 4], table[1, 2]] == [(1, 2), (3, 4), (1, 2)]
    assert asked == [(1, 2), (3, 4)]


def test_the_oldest_go_where_all_together_are_too_large() -> None:
    table = Kept(lambda size: (np.zeros(size, np.uint8), (np.zeros(size, np.uint8), 5)), 10_000)
    for size in (1001, 1002, 1003, 1):
        assert len(table[size,][0]) == size
    assert list(table) == [(1002,), (1003,), (1,)]
    assert 2 * (1002 + 1003 + 1) < table.bytes <= 10_000


def test_what_is_too_large_itself_is_not_kept() -> None:
    table = Kept(lambda size: (np.zeros(size, np.uint8),), 10_000)
    table[5,]
    assert len(table[10_001,][0]) == 10_001
    assert not table and table.bytes == 0


def test_what_is_met_again_is_made_once() -> None:
    made: list[int] = []

    def make(number: int) -> tuple[int, ...]:
        made.append(number)
        return (number,)

    table = Kept(make, 10_000)
    assert table.again(7) is None
    assert table.again(7) == table.again(7) == (7,)
    assert made == [7]


def test_few_arguments_are_remembered() -> None:
    table = Kept(lambda number: (number,), 10_000)
    for number in range(3 * MET):
        assert table.again(number) is None
        assert len(table._met) <= MET
    assert not table


@settings(deadline=None)
@given(
    pixels=st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=1),
    xor=st.booleans(),
    most_marks=st.sampled_from([0, 1 << 19]),
)
def test_a_figure_has_each_pixel_once_and_by_xor_the_odd_ones(
    pixels: list[tuple[int, int]], xor: bool, most_marks: int
) -> None:
    x, y = np.array(pixels).T
    with patch.object(offsets, "_MARKS", most_marks):
        found = offsets.figure(x, y, offsets.reach(x, y), 640, xor)
    rows, columns = np.divmod(found.place, 640)
    drawn = zip((columns + found.left).tolist(), (rows + found.top).tolist(), strict=True)
    assert sorted(drawn) == sorted(
        pixel for pixel, times in Counter(pixels).items() if times % 2 or not xor
    )
