"""Surfaces from arrays of x, y and z: bent grids, with holes, in scenes."""

from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from surfaces import Plot, parametric, perspective, sheet, surface
from tests.surfaces.raycast import Canvas

MODES = ["fill", "mesh", "fill+mesh", "wire", "facets"]
U, V = np.meshgrid(np.linspace(0, 2 * pi, 31), np.linspace(0, 2 * pi, 21), indexing="ij")


def ring(u: Any, v: Any) -> Any:
    return (2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)


def pictured(draw: Any, *shape: Any, **how: Any) -> Any:
    canvas = Canvas(160, 120)
    draw(*shape, on=canvas, **how)
    return canvas.array


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("projection", [None, "isometric", perspective(3)])
def test_points_of_a_function_are_its_surface(mode: str, projection: Any) -> None:
    how = {"mode": mode, "lines": 14, "projection": projection, "axes": True}
    expected = pictured(parametric, ring, (0, 2 * pi), (0, 2 * pi), (30, 20), **how)
    assert expected.any()
    assert (pictured(sheet, *ring(U, V), **how) == expected).all()


@given(st.integers(2, 9), st.integers(2, 9), st.integers(0, 2**32 - 1))
@settings(deadline=None, max_examples=20)
def test_a_regular_grid_is_a_surface(nx: int, ny: int, seed: int) -> None:
    """The same lines, the same outline, the same point at a pixel."""
    random = np.random.default_rng(seed)
    x, y = (np.cumsum(random.uniform(0.5, 1.5, n)) for n in (nx, ny))
    points = (*np.meshgrid(x, y, indexing="ij"), random.uniform(-1, 1, (nx, ny)))
    how: dict[str, Any] = {"projection": "isometric", "zfrac": 0.3, "axes": True}
    wires = [
        pictured(draw, *shape, mode="wire", **how)
        for draw, shape in ((surface, (points[2], x, y)), (sheet, points))
    ]
    assert (wires[0] == wires[1]).all()
    one, two = Canvas(80, 60), Canvas(80, 60)
    expected = surface(points[2], x, y, mode="facets", on=one, **how)
    plot = sheet(*points, mode="facets", on=two, **how)
    assert ((one.array > 0) == (two.array > 0)).all()
    assert (plot.transform == expected.transform).all()
    assert plot.limits == expected.limits
    above: Any = {"projection": "top", "zfrac": 0.3, "on": Canvas(80, 60)}
    place = (x[0] + x[1]) / 2, (y[0] + y[1]) / 2
    for plot in (surface(points[2], x, y, **above), sheet(*points, **above)):
        px, py, _ = plot.project((*place, 0))
        picked = plot.pick(px, py)
        assert picked and picked[:2] == pytest.approx(place)


def test_nested_lists_and_whole_numbers_are_points() -> None:
    x, y, z = [[0, 1], [0, 1]], [[0, 0], [1, 1]], [[0, 1], [1, 2]]
    as_lists = pictured(sheet, x, y, z)
    assert as_lists.any()
    assert (pictured(sheet, np.float32(x), np.uint8(y), np.array(z)) == as_lists).all()


def test_what_is_masked_or_nan_is_a_hole() -> None:
    x, y, z = ring(U, V)
    hole = np.zeros(x.shape, dtype=bool)
    hole[10:14, 5:9] = True
    whole = pictured(sheet, x, y, z)
    for one in range(3):
        parts = [x, y, z]
        parts[one] = np.where(hole, np.nan, parts[one])
        with_hole = pictured(sheet, *parts)
        parts[one] = np.ma.masked_array((x, y, z)[one], hole)
        assert (pictured(sheet, *parts) == with_hole).all()
        assert (with_hole != whole).any()


def test_colors_of_its_own() -> None:
    assert (pictured(sheet, *ring(U, V), color=ring(U, V)[2]) == pictured(sheet, *ring(U, V))).all()
    canvas = Canvas(160, 120)
    plot = sheet(*ring(U, V), color=100 * U, on=canvas)
    assert plot.limits == (0, pytest.approx(200 * pi))
    of_function = pictured(parametric, ring, (0, 2 * pi), (0, 2 * pi), (30, 20), color=100 * U)
    assert (canvas.array == of_function).all()


def test_far_from_zero_it_is_the_same() -> None:
    x, y, z = ring(U, V)
    at_zero = pictured(sheet, x, y, z)
    far_away = pictured(sheet, x + 2.0**30, y - 2.0**30, z + 2.0**20)
    assert (far_away != at_zero).sum() < 20  # rounded off when moved


def test_in_a_scene_each_hides_the_other() -> None:
    def scene(add: Any) -> tuple[Any, Plot]:
        canvas = Canvas(160, 120)
        plot = surface(lambda x, y: 0 * x, (-3, 3), (-3, 3), 20, zfrac=None, on=canvas)
        return canvas.array, add(plot)

    by_function, _ = scene(lambda plot: plot.parametric(ring, (0, 2 * pi), (0, 2 * pi), (30, 20)))
    by_points, plot = scene(lambda plot: plot.sheet(*ring(U, V)))
    alone, _ = scene(lambda plot: plot)
    assert (by_function != alone).any()
    assert (by_points == by_function).all()
    colored, _ = scene(lambda plot: plot.sheet(*ring(U, V), color=V))
    assert (colored != by_points).any()
    x, y = plot.project((2, 0, 1))[:2]
    assert plot.pick(x, y) == pytest.approx((2, 0, 1), abs=0.05)


ONE, ROWS = np.eye(3), np.indices((3, 3))[0]


@pytest.mark.parametrize(
    ("x", "y", "z", "how", "message"),
    [
        (ONE, ONE, ONE[:2], {}, r"one shape, not \(3, 3\), \(3, 3\) and \(2, 3\)"),
        (ONE[0], ONE[0], ONE[0], {}, r"2 x 2 numbers or more, not \(3,\)"),
        (ONE[:1], ONE[:1], ONE[:1], {}, r"2 x 2 numbers or more, not \(1, 3\)"),
        (ONE, ONE, ONE * np.nan, {}, "no finite point"),
        (ONE, ONE, np.where(ROWS % 2, np.nan, 1), {}, "nothing of the surface can be seen"),
        (ONE, [[1], [2, 3]], ONE, {}, "y must have rows of one length"),
        (ONE, ONE, ONE, {"color": "slope"}, 'color must be "z" or an array, not'),
        (ONE, ONE, ONE, {"color": lambda x, y: x}, 'color must be "z" or an array, not'),
        (ONE, ONE, ONE, {"color": ONE[:2]}, r"color must have the shape \(3, 3\), not \(2, 3\)"),
        (ONE, ONE, ONE, {"mode": "waterfall"}, "mode must be one of"),
    ],
)
def test_bad_points(x: Any, y: Any, z: Any, how: Any, message: str) -> None:
    canvas = Canvas(20, 20)
    with pytest.raises(ValueError, match=message):
        sheet(x, y, z, on=canvas, **how)
    assert not canvas.array.any()


def test_too_large_or_of_another_kind() -> None:
    huge = np.broadcast_to(np.int8(1), (10**5, 10**4))
    with pytest.raises(ValueError, match=r"^x must have at most 16777216 numbers"):
        sheet(huge, huge, huge, on=Canvas(9, 9))
    with pytest.raises(TypeError, match=r"^z must be real numbers"):
        sheet(ONE, ONE, ONE * 1j, on=Canvas(9, 9))


def test_surface_sends_bent_grids_here() -> None:
    x, y, z = ring(U, V)
    with pytest.raises(ValueError, match=r"there is sheet\(x, y, z\)"):
        surface(z, x, y, on=Canvas(9, 9))


def test_a_sheet_may_be_one_triangle() -> None:
    x, y = np.meshgrid((0.0, 1.0), (0.0, 1.0), indexing="ij")
    canvas = Canvas(60, 40)
    sheet(x, y, np.array(((0.0, 0.5), (1.0, np.nan))), "facets", on=canvas)
    assert 100 < np.count_nonzero(canvas.array) < 60 * 40 / 2
