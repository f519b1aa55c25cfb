"""Heights that are known, and heights cut off."""

import math
from typing import Any

import numpy as np
import pytest

from surfaces import Mapping, data, parametric, sample, surface
from tests.surfaces.raycast import Canvas


def test_an_array_with_ranges() -> None:
    grid = data([[1, 2, 3], [4, 5, 6]], x=(0, 10), y=(-1, 1))
    assert (grid.x.tolist(), grid.y.tolist()) == ([0, 10], [-1, 0, 1])
    assert grid.z.tolist() == [[1, 2, 3], [4, 5, 6]]


def test_an_array_without_axes_counts() -> None:
    grid = data(np.eye(3))
    assert (grid.x.tolist(), grid.y.tolist()) == ([0, 1, 2], [0, 1, 2])


def test_falling_axes_are_turned_round() -> None:
    grid = data([[1, 2, 3], [4, 5, 6]], x=(10, 0), y=[5, 3, -4])
    assert (grid.x.tolist(), grid.y.tolist()) == ([0, 10], [-4, 3, 5])
    assert grid.z.tolist() == [[6, 5, 4], [3, 2, 1]]


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"])
def test_uneven_axes_are_the_same_surface(mode: str) -> None:
    """A plane is a plane, wherever its nodes are."""
    even, uneven = Canvas(160, 120), Canvas(160, 120)
    x = np.array((-1, -0.9, -0.2, 0.1, 0.15, 0.8, 1))
    y = np.array((-1, -0.5, -0.45, 0, 0.9, 1))
    surface(lambda x, y: x + 2 * y, (-1, 1), (-1, 1), n=80, mode="fill", on=even)
    surface(x[:, None] + 2 * y, x, y, mode=mode, lines=14, on=uneven)
    a, b = even.array > 0, uneven.array > 0
    if mode == "fill":
        assert (a != b).sum() <= 5
        assert np.abs(even.array - uneven.array)[a & b & (uneven.array > 15)].max() <= 1
    else:
        assert (b & ~a).sum() <= 200  # the outline


def test_a_grid_is_taken_as_it_is() -> None:
    grid = sample(lambda x, y: x * y, (-1, 1), (-1, 1), 20)
    one, two = Canvas(100, 80), Canvas(100, 80)
    surface(grid, on=one)
    surface(lambda x, y: x * y, (-1, 1), (-1, 1), n=20, on=two)
    assert (one.array == two.array).all()


@pytest.mark.parametrize(
    ("values", "axes", "message"),
    [
        ([1, 2, 3], {}, "2 x 2 numbers or more"),
        ([[1, 2, 3]], {}, "2 x 2 numbers or more"),
        (np.ones((3, 3)), {"x": (0, 1, 1)}, r"x must be \(a, b\) or 3 rising or falling numbers"),
        (np.ones((3, 3)), {"y": (0, 2, 1)}, r"y must be \(a, b\) or 3 rising or falling numbers"),
        (np.ones((3, 3)), {"x": 3}, r"x must be \(a, b\) or 3 rising or falling numbers"),
        (np.ones((3, 3)), {"y": (0, 1, 2, 3)}, r"y must be \(a, b\) or 3 rising"),
        (np.ones((3, 3)), {"x": (0, math.inf)}, r"x must be \(a, b\) or 3"),
        (np.full((3, 3), np.nan), {}, "no finite value"),
        (np.full((3, 3), np.inf), {}, "no finite value"),
        (np.ones((3, 3)), {"z": (1, 1)}, r"z must be \(a, b\) with finite a < b"),
    ],
)
def test_bad_data(values: Any, axes: Any, message: str) -> None:
    canvas = Canvas(20, 20)
    with pytest.raises(ValueError, match=message):
        surface(values, **axes, on=canvas)
    assert not canvas.array.any()


# Heights cut off ---------------------------------------------------------------------------------


def test_infinities_are_cut_to_the_range() -> None:
    grid = data([[np.inf, 5], [-np.inf, np.nan]], z=(-1, 2))
    assert grid.z[0].tolist() == [2, 2]
    assert grid.z[1, 0] == -1
    assert np.isnan(grid.z[1, 1])


def test_without_a_range_infinities_are_missing() -> None:
    assert np.isnan(data([[np.inf, 5], [1, 1]]).z[0, 0])


def test_a_function_is_cut_too() -> None:
    grid = sample(lambda x, y: 10 * x + 0 * y, (-1, 1), (0, 1), 4, z=(-5, 3))
    assert grid.z[:, 0].tolist() == [-5, -5, 0, 3, 3]


def test_a_pole_is_a_hole_and_not_a_wall() -> None:
    grid = sample(lambda x, y: 1 / x + 0 * y, (-1, 1), (0, 1), (5, 3), z=(-2, 2))
    assert grid.whole.tolist() == [[True] * 3, [True] * 3, [False] * 3, [True] * 3, [True] * 3]
    plot = surface(grid, on=Canvas(160, 120))
    pixels = plot.project(
        np.stack((*np.meshgrid((-0.1, 0, 0.1), (0.2, 0.8)), np.zeros((2, 3))), -1)
    )
    picked = [plot.pick(x, y) for x, y, _ in pixels.reshape(-1, 3)]
    assert all(point is None or abs(point[0]) >= 0.2 for point in picked)


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"])
def test_a_surface_without_a_cell_is_an_error(mode: str) -> None:
    """It was blank, without a word."""
    canvas = Canvas(60, 40)
    chessboard = np.where(np.indices((6, 6)).sum(axis=0) % 2, np.nan, 1.0)
    with pytest.raises(ValueError, match="no cell has enough corners with a value"):
        surface(chessboard, mode=mode, on=canvas)
    with pytest.raises(ValueError, match="no cell has enough corners with a value"):
        surface([chessboard, chessboard], mode=mode, axes=True, on=canvas)
    assert not canvas.array.any()


@pytest.mark.parametrize("mode", ["wire", "waterfall"])
def test_lines_are_enough_where_lines_are_drawn(mode: str) -> None:
    canvas = Canvas(60, 40)
    rows = np.where(np.indices((6, 6))[0] % 2, np.nan, 1.0)
    surface(rows, mode=mode, on=canvas)
    assert canvas.array.any()


def test_a_body_without_a_cell_is_an_error() -> None:
    canvas = Canvas(60, 40)

    def rows(u: Any, v: Any) -> Any:
        return u, v, np.where(np.round(u) % 2, np.nan, u * v)

    with pytest.raises(ValueError, match="no cell has enough corners with a value"):
        parametric(rows, (0, 6), (0, 6), 6, on=canvas)
    assert not canvas.array.any()


# What is masked ----------------------------------------------------------------------------------

HEIGHTS = np.add.outer(np.arange(6.0) ** 2, np.arange(5.0))
HIDDEN = HEIGHTS > 20
MASKED = np.ma.masked_where(HIDDEN, HEIGHTS)
HOLES = np.where(HIDDEN, np.nan, HEIGHTS)


def test_what_is_masked_is_a_hole_in_data() -> None:
    assert np.array_equal(data(MASKED).z, HOLES, equal_nan=True)
    assert np.array_equal(data(list(MASKED)).z, HOLES, equal_nan=True)
    assert np.array_equal(data(MASKED.astype(np.int16)).z, HOLES, equal_nan=True)


def test_what_is_masked_is_a_hole_in_a_function() -> None:
    def half(x: Any, y: Any) -> Any:
        return np.ma.masked_where(x > 0, x + y)

    assert np.isnan(sample(half, (-1, 1), (-1, 1), 4).z).sum(axis=1).tolist() == [0, 0, 0, 5, 5]
    one_by_one = sample(lambda x, y: half(float(x), float(y)), (-1, 1), (-1, 1), 4)
    assert np.isnan(one_by_one.z).sum(axis=1).tolist() == [0, 0, 0, 5, 5]


def test_what_is_masked_is_a_hole_in_a_body() -> None:
    pages = []
    for hide in (np.ma.masked_where, lambda there, z: np.where(there, np.nan, z)):
        page = Canvas(60, 40)
        parametric(lambda u, v, h=hide: (u, v, h(u > 1, u * v)), (0, 2), (0, 2), 8, on=page)
        pages.append(page.array)
    assert (pages[0] == pages[1]).all()
    assert pages[0].any()


def test_what_is_masked_has_no_color() -> None:
    pages = [Canvas(60, 40), Canvas(60, 40), Canvas(60, 40)]
    for color, page in zip((MASKED, HOLES, HEIGHTS), pages, strict=True):
        surface(HEIGHTS, color=color, on=page)
    assert (pages[0].array == pages[1].array).all()
    assert (pages[0].array != pages[2].array).any()


# Axes in other forms -----------------------------------------------------------------------------

X, Y = np.array((0.0, 1.0, 3.0, 4.0, 6.0, 7.0)), np.array((5.0, 3.0, 2.0, 1.0, 0.0))


@pytest.mark.parametrize("indexing", ["ij", "xy"])
@pytest.mark.parametrize("sparse", [False, True])
def test_axes_may_be_those_of_meshgrid(indexing: Any, sparse: bool) -> None:
    x, y = np.meshgrid(X, Y, indexing=indexing, sparse=sparse)
    values = HEIGHTS if indexing == "ij" else HEIGHTS.T
    one, other = data(values, x, y), data(HEIGHTS, X, Y)
    assert (one.x.tolist(), one.y.tolist()) == (X.tolist(), Y[::-1].tolist())
    assert (one.z == other.z).all()


def test_axes_that_are_no_grid_are_refused() -> None:
    x, y = np.meshgrid(X, Y, indexing="ij")
    for wrong in ((x + y, y), (x, None), (x[1:], y), (x.T, y)):
        with pytest.raises(ValueError, match=r"^x and y must be axes, or what|^x must"):
            data(HEIGHTS, *wrong)


@pytest.mark.parametrize("indexing", ["ij", "xy"])
def test_colors_are_in_the_order_of_heights(indexing: Any) -> None:
    """With falling axes colours were mirrored, for only the heights had been turned round."""
    x, y = np.meshgrid(X, Y, indexing=indexing)
    as_array, as_function = Canvas(60, 40), Canvas(60, 40)
    values = HEIGHTS if indexing == "ij" else HEIGHTS.T
    surface(values, x, y, color=x - 3 * y, mode="facets", on=as_array)
    surface(values, x, y, color=lambda x, y: x - 3 * y, mode="facets", on=as_function)
    assert (as_array.array == as_function.array).all()


def test_a_list_of_arrays_is_several_surfaces() -> None:
    pages = [Canvas(60, 40), Canvas(60, 40)]
    flat = np.zeros((6, 5))
    surface([HEIGHTS, flat + 9], X, Y, on=pages[0])
    surface([data(HEIGHTS, X, Y), data(flat + 9, X, Y)], on=pages[1])
    assert (pages[0].array == pages[1].array).all()
    surface([HEIGHTS.tolist(), flat.tolist()], X, Y, on=Canvas(60, 40))
    with pytest.raises(ValueError, match="same x and y"):
        surface([HEIGHTS, np.zeros((3, 3))], on=Canvas(60, 40))


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"])
def test_far_too_large_for_the_screen(mode: str) -> None:
    """What is off the screen costs nothing, also without lines and polygons."""
    canvas = Canvas(60, 40)
    huge = Mapping(origin=(30, 20), scale=(1e7, 1e7, 1e7))
    holes = np.where(np.indices((6, 6)).sum(axis=0) == 3, np.nan, 1.0)
    surface(holes, (-1, 1), (-1, 1), mode=mode, mapping=huge, lines=14, on=canvas)
    assert canvas.array.shape == (40, 60)


@pytest.mark.parametrize("x", [None, 3, (1, 2, 3), "ab"])
def test_a_function_needs_a_domain(x: Any) -> None:
    with pytest.raises(ValueError, match=r"x must be \(a, b\) with finite a < b, not "):
        surface(lambda x, y: x, x, (0, 1), on=Canvas(20, 20))
