"""Points and curves in a scene, hidden where they lie behind; and pictures in a notebook."""

from math import pi
from typing import Any

import numpy as np
import pytest

import bgi
from surfaces import Plot, Svg, Text, parametric, perspective, rotation, surface
from tests.surfaces.raycast import Canvas, edges

MARK = 14
VIEWS: list[dict[str, Any]] = [
    {},
    {"projection": "isometric"},
    {"projection": perspective(2.5)},
    {"transform": rotation("z", 2.0)},
]


def ball(u: Any, v: Any) -> Any:
    return np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)


def scene(**how: Any) -> tuple[Plot, Canvas]:
    canvas = Canvas(200, 150)
    return parametric(ball, (0, 2 * pi), (0, pi), n=60, on=canvas, **how), canvas


def at(plot: Plot, point: Any) -> tuple[int, int]:
    x, y = np.floor(plot.project(point)[:2] + 0.5).astype(int)
    return int(y), int(x)


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("mode", ["fill", "mesh", "wire", "facets"])
def test_a_point_is_seen_before_the_ball_and_on_it_but_not_behind(
    view: dict[str, Any], mode: str
) -> None:
    plot, canvas = scene(mode=mode, lines=7, **view)
    near = plot.pick(*at(plot, (0, 0, 0))[::-1])
    assert near is not None
    direction = np.array(near)
    for distance, seen in ((1.3, True), (1.0, True), (0.5, False), (-1.0, False), (-1.3, False)):
        before = canvas.array.copy()
        plot.points(distance * direction, MARK)
        assert (canvas.array[at(plot, distance * direction)] == MARK) == seen
        canvas.array[:] = before


@pytest.mark.parametrize("view", VIEWS)
def test_points_of_a_surface_are_seen_where_pick_finds_them(view: dict[str, Any]) -> None:
    """Those clearly before or behind; beside the outline a pixel may be either."""
    canvas = Canvas(200, 150)

    def f(x: Any, y: Any) -> Any:
        return np.sin(2 * x) * np.cos(2 * y)

    plot = surface(f, (-2, 2), (-2, 2), n=80, zfrac=0.4, on=canvas, **view)
    x, y = np.random.default_rng(7).uniform(-1.9, 1.9, (2, 150))
    points = np.stack((x, y, f(x, y)), axis=1)
    covered = canvas.array > 0
    seen = hidden = 0
    for point in points:
        place = at(plot, point)
        picked = plot.pick(*place[::-1])
        if edges(covered)[place] or picked is None:
            continue
        depth, nearest = plot.depth(point), plot.depth(picked)
        apart = float(nearest - depth) / np.ptp(plot.depth(points))
        before = canvas.array.copy()
        plot.points(point, MARK, size=1)
        drawn = canvas.array[place] == MARK
        canvas.array[:] = before
        if apart < 0.005:
            assert drawn
            seen += 1
        elif apart > 0.1:
            assert not drawn
            hidden += 1
    assert seen > 60
    assert hidden > 5


def test_a_ring_around_a_ball_goes_behind_it() -> None:
    plot, canvas = scene(projection="isometric")
    turn = np.linspace(0, 2 * pi, 100)
    ring = np.stack((1.2 * np.cos(turn), 1.2 * np.sin(turn), 0 * turn), axis=1)
    on_ball = canvas.array > 0
    plot.curve(ring, MARK)
    lit = canvas.array == MARK
    eye = plot.view.eye
    for point in ring:
        y, x = at(plot, point)
        if not on_ball[y, x] or point @ eye > 0.2:
            assert lit[y - 1 : y + 2, x - 1 : x + 2].any() or edges(on_ball)[y, x]
        elif point @ eye < -0.2 and not edges(edges(on_ball))[y, x]:
            assert not lit[y, x]
    assert (lit & on_ball).any()
    assert (lit & ~on_ball).any()


def test_a_gap_in_a_curve_and_points_that_are_none() -> None:
    plot, canvas = scene()
    before = canvas.array.copy()
    plot.curve([(1.2, -1, 0), (np.nan, 0, 0), (1.2, 1, 0)], MARK)
    plot.points([(np.nan, 0, 0), (np.inf, 0, 0)], MARK)
    plot.points(np.zeros((0, 3)), MARK)
    assert (canvas.array == before).all()
    plot.curve([(1.2, -1, 0), (1.2, 1, 0)], MARK)
    assert (canvas.array != before).any()


def test_a_point_behind_an_eye_near_by_is_not_drawn() -> None:
    plot, canvas = scene(projection=perspective(2.5))
    before = canvas.array.copy()
    plot.points(1.5 * plot.view.eye + (0, 0.3, 0), MARK)
    plot.curve([1.5 * plot.view.eye, 1.6 * plot.view.eye + (0, 1, 0)], MARK)
    assert (canvas.array == before).all()


def test_what_is_refused() -> None:
    plot, canvas = scene()
    before = canvas.array.copy()
    for wrong in ((1, 2), 5, [[1, 2], [3, 4]]):
        with pytest.raises(ValueError, match=r"points must have the shape \(\.\.\., 3\), not"):
            plot.points(wrong)
        with pytest.raises(ValueError, match=r"points must have the shape"):
            plot.curve(wrong)
    with pytest.raises(ValueError, match="size must be"):
        plot.points((0, 0, 0), size=0)
    assert (canvas.array == before).all()


def test_marks_in_a_drawing() -> None:
    drawing = Svg(200, 150)
    plot = parametric(ball, (0, 2 * pi), (0, pi), n=20, on=drawing)
    shapes = str(drawing).count("<path")
    plot.points([(2, 0, 0), (-0.5, 0, 0)], color=12)
    assert str(drawing).count("<path") == shapes + 1
    plot.curve([(2, -1, 0), (2, 1, 0)], color=12)
    assert str(drawing).count("#ff5555") > 5


def test_a_notebook_shows_what_was_drawn() -> None:
    drawing = Svg(200, 150)
    plot = parametric(ball, (0, 2 * pi), (0, pi), n=10, on=drawing)
    assert plot._repr_svg_() == drawing._repr_svg_() == str(drawing)
    assert plot._repr_png_() is None
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    plot = parametric(ball, (0, 2 * pi), (0, pi), n=10)
    png = plot._repr_png_()
    assert png is not None
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert png == bgi.current.screen._repr_png_()
    assert plot._repr_svg_() is None
    plot = parametric(ball, (0, 2 * pi), (0, pi), n=10, on=Text(40, 20))
    assert plot._repr_png_() is None
    assert plot._repr_svg_() is None
