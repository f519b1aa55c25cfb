"""Lines of any width, in windows of initwindow()."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import bgi
from bgi.raster import brush

EVERYWHERE = -1000, -1000, 1000, 1000


@pytest.fixture
def window() -> None:
    bgi.initwindow(60, 40)


def picture() -> NDArray[np.uint32]:
    bgi.setviewport(0, 0, 59, 39, 1)
    return np.asarray(bgi.getpixel(*np.meshgrid(range(60), range(40))))


def drawn() -> list[str]:
    """The rows and columns on which something is, with # for a pixel."""
    found = picture() > 0
    y, x = found.nonzero()
    part = found[y.min() : y.max() + 1, x.min() : x.max() + 1]
    return ["".join(".#"[pixel] for pixel in row) for row in part.astype(int)]


def test_the_brush_is_a_disc(window: None) -> None:
    for width, rows in {
        4: [".##.", "####", "####", ".##."],
        5: [".###.", "#####", "#####", "#####", ".###."],
        7: ["..###..", ".#####.", "#######", "#######", "#######", ".#####.", "..###.."],
    }.items():
        bgi.cleardevice()
        bgi.setlinestyle(bgi.SOLID_LINE, 0, width)
        bgi.line(20, 20, 20, 20)
        assert drawn() == rows
        assert bgi.getlinesettings().thickness == width


def test_a_line_is_what_the_brush_covers_on_its_way(window: None) -> None:
    bgi.line(10, 10, 40, 25)
    thin = np.argwhere(picture())
    covered = np.zeros((40, 60), bool)
    for y, x in thin:
        for row, (before, after) in enumerate(brush.reaches(9), -4):
            covered[y + row, x + before : x + after + 1] = True
    bgi.cleardevice()
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 9)
    bgi.line(10, 10, 40, 25)
    assert np.array_equal(picture() > 0, covered)


ends = st.integers(-30, 30)


@given(x1=ends, y1=ends, x2=ends, y2=ends, half=st.integers(2, 9))
def test_odd_widths_are_symmetric(x1: int, y1: int, x2: int, y2: int, half: int) -> None:
    """The same from either end, and mirrored where the thin line is."""
    width = 2 * half + 1
    rows = brush.rows(x1, y1, x2, y2, width, EVERYWHERE)
    assert rows == brush.rows(x2, y2, x1, y1, width, EVERYWHERE)
    mirrored = [(-right, y, -left, y) for left, y, right, _ in rows]
    assert mirrored == brush.rows(-x1, y1, -x2, y2, width, EVERYWHERE)
    assert [y for _, y, _, _ in rows] == [*range(min(y1, y2) - half, max(y1, y2) + half + 1)]
    assert all(left <= right for left, _, right, _ in rows)


def test_patterns_leave_no_gaps(window: None) -> None:
    bgi.setlinestyle(bgi.DOTTED_LINE, 0, 5)
    bgi.line(10, 10, 30, 10)
    assert drawn() == ["." + 23 * "#" + "."] + 3 * [25 * "#"] + ["." + 23 * "#" + "."]


def test_xor_twice_is_nothing(window: None) -> None:
    bgi.setwritemode(bgi.XOR_PUT)
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 8)
    for _ in range(2):
        bgi.line(5, 5, 50, 30)
        seen = picture().any()
        bgi.line([3, 50], 20, [50, 3], 30)
        bgi.line([3, 50], 20, [50, 3], 30)
        assert picture().any() == seen
    assert not picture().any()


def test_everything_that_is_drawn_with_lines_is_wide(window: None) -> None:
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 5)
    calls = [
        lambda: bgi.rectangle(10, 10, 40, 30),
        lambda: bgi.drawpoly([(10, 10), (40, 30), (40, 10)]),
        lambda: bgi.circle(30, 20, 10),
        lambda: bgi.ellipse(30, 20, 0, 90, 15, 10),
        lambda: bgi.lineto(40, 10),
        lambda: bgi.line([10, 20], 30, [30, 50], 30),
        lambda: bgi.fillpoly(np.array([[(10, 10), (40, 30), (40, 10)], [(9, 9), (9, 20), (5, 5)]])),
    ]
    for call in calls:
        bgi.cleardevice()
        bgi.setfillstyle(bgi.EMPTY_FILL, 0)
        call()
        found = picture() > 0
        assert found.any()
        # Every pixel belongs to a row, or a column, of four pixels at least.
        padded = np.pad(found, 3)
        for y, x in np.argwhere(padded):
            starts = range(4)
            across = any(padded[y, x - start : x - start + 4].all() for start in starts)
            down = any(padded[y - start : y - start + 4, x].all() for start in starts)
            assert across or down


def test_ends_that_are_far_away(window: None) -> None:
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 9)
    bgi.line(-(10**9), 20, 10**9, 20)
    assert drawn() == 9 * [60 * "#"]
    bgi.line(-(10**9), -(10**9), -(10**9), 10**9)
    assert drawn() == 9 * [60 * "#"]
    bgi.setviewport(10, 10, 20, 20, 1)
    bgi.clearviewport()
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 4096)
    bgi.line(5, 5, 5, 5)
    assert picture()[10:21, 10:21].all()
    assert not picture()[25:].any()


def test_widths_that_are_refused(window: None) -> None:
    for width in (-1, 4097, 10**9):
        bgi.setlinestyle(bgi.SOLID_LINE, 0, width)
        assert bgi.graphresult() == bgi.grError
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 4096)
    assert bgi.graphresult() == bgi.grOk
    bgi.initgraph()
    bgi.setlinestyle(bgi.SOLID_LINE, 0, 4)  # as Borland's
    assert bgi.graphresult() == bgi.grError
