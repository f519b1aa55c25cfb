"""The index for picking against asking every triangle."""

from math import pi
from typing import Any

import numpy as np
import pytest

from surfaces import parametric, perspective, sheet, surface
from surfaces.scene import Plot
from surfaces.visible.picking import Triangles, nearest
from tests.surfaces.raycast import Canvas


def ring(u: Any, v: Any) -> Any:
    return (3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)


def dome(x: Any, y: Any) -> Any:
    return np.sqrt(5 - x * x - y * y)


def of_points(canvas: Canvas) -> Plot:
    """A sheet with holes in it."""
    x, y = np.meshgrid(np.linspace(-2, 2, 22), np.linspace(-2, 2, 31), indexing="ij")
    z = np.where((x * y) % 1 > 0.9, np.nan, np.sin(x) * y)
    return sheet(x, y, z, on=canvas)


PLOTS = {
    "closed": lambda canvas: parametric(ring, (0, 2 * pi), (0, 2 * pi), (41, 19), on=canvas),
    "holes": of_points,
    "near by": lambda canvas: surface(
        dome, (-2.5, 2.5), (-2.5, 2.5), 33, projection=perspective(3), on=canvas
    ),
}


def every_triangle(plot: Plot) -> Triangles:
    found = [block.nodes[:, block.corners].T for block in plot.picture.cells()]
    space = np.concatenate(found)
    halves = np.concatenate((space[:, :3], space[:, [0, 2, 3]]))
    return Triangles.of(halves, plot.picture.view)


@pytest.mark.parametrize("kind", PLOTS)
def test_the_tiles_find_what_all_triangles_have_at_a_pixel(kind: str) -> None:
    canvas = Canvas(160, 120)
    plot = PLOTS[kind](canvas)
    triangles, view = every_triangle(plot), plot.picture.view
    hits = 0
    for y, x in np.random.default_rng(3).integers((0, 0), (120, 160), (300, 2)).tolist():
        expected = nearest(triangles.points_at(x, y), view)
        if expected is not None:
            found = plot.picture.pick(x, y)
            assert found is not None and found == pytest.approx(expected, abs=1e-9)
            hits += 1
    assert hits > 30
