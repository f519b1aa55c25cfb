"""Numbers at the edge of what floats hold: holes, flat ground or a clear error, no warnings."""

from typing import Any

import numpy as np
import pytest

import bgi
from surfaces import parametric, rotation, surface
from surfaces.shape.grid import Grid
from tests.surfaces.raycast import Canvas


@pytest.fixture(autouse=True)
def _screen():
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "wire", "waterfall", "facets"])
@pytest.mark.parametrize(
    "f",
    [
        lambda x, y: 1e308 * x,
        lambda x, y: 1e-320 * x,
        lambda x, y: np.exp(700 * x * y),
        lambda x, y: 1e29 * x + y,
        lambda x, y: x / (y * 1e-300),
    ],
)
def test_extreme_heights(f, mode):
    plot = surface(f, (-3, 3), (-3, 3), 20, mode)
    plot.pick(320, 240)


@pytest.mark.parametrize("x", [(-1e308, 1e308), (0, 1e-320), (1e200, 2e200)])
def test_extreme_domains_are_an_error(x):
    with pytest.raises(ValueError, match="x must be"):
        surface(lambda x, y: x + y, x, (-1, 1))


def test_no_line_joins_the_two_sides_of_a_pole():
    """1/x jumps from one limit to the other; where it only touches a limit, lines go on."""
    z = np.array([[-1.0, -3.0, 3.0, 2.0], [-3.0, -3.0, 3.0, 3.0], [0.0, np.nan, 1.0, 3.0]])
    along_x, along_y = Grid(np.arange(3.0), np.arange(4.0), z, (-3.0, 3.0)).joined
    assert along_y.tolist() == [[True, False, True], [True, False, True], [False, False, True]]
    assert along_x.tolist() == [[True] * 4, [True, False, True, True]]
    along_x, along_y = Grid(np.arange(3.0), np.arange(4.0), z).joined
    assert along_y.tolist() == [[True] * 3, [True] * 3, [False, False, True]]


FAR = [1e4, 1e6, -1e9, 1.7e9]


def drawn(f: Any, x: Any, y: Any, **how: Any) -> Any:
    canvas = Canvas(320, 240)
    plot = surface(f, x, y, on=canvas, **how)
    return canvas.array, plot


@pytest.mark.parametrize("far", FAR)
@pytest.mark.parametrize(
    "how",
    [
        {"mode": "fill"},
        {"mode": "fill", "transform": rotation((1, 2, 3), 1.0)},
        {"mode": "fill", "mapping": None, "projection": "isometric", "color": "slope"},
        {"mode": "mesh", "transform": rotation("z", 1.0)},
        {"mode": "fill+mesh"},
        {"mode": "waterfall"},
        {"mode": "facets"},
        {"mode": "wire"},
        {"mode": "fill", "contours": [0.25], "floor": [0.25], "box": True},
        {"mode": "fill", "color": lambda x, y: x - x.min() + y - y.min()},
    ],
    ids=lambda how: "-".join([how["mode"], *list(how)[1:]]),
)
def test_far_from_zero_it_looks_as_near_it(far: float, how: dict[str, Any]) -> None:
    def f(x: Any, y: Any) -> Any:
        return np.sin(x) * np.cos(y)

    # 64 cells of 1/8, -1/8 and 1/4: numbers that a double holds exactly, near and far.
    near, _ = drawn(f, (0, 8), (-4, 4), n=64, **how)
    moved = how | {
        name: [level + far for level in how[name]] for name in ("contours", "floor") if name in how
    }
    got, plot = drawn(
        lambda x, y: f(x - far, y + far) + far, (far, far + 8), (-4 - far, 4 - far), n=64, **moved
    )
    assert (near != 0).sum() > 1000
    assert (got != near).sum() <= 4  # the last digit of the heights is lost at 1e9
    point = plot.pick(160, 120)
    assert point is not None
    assert plot.project(point)[:2] == pytest.approx((160, 120), abs=1e-3)


@pytest.mark.parametrize("mode", ["fill", "mesh", "facets"])
def test_data_far_from_zero(mode: str) -> None:
    z = np.add.outer(np.sin(np.arange(101) / 9), np.cos(np.arange(101) / 7))
    near, _ = drawn(z, None, None, mode=mode)
    got, _ = drawn(z, 1.7e9 + np.arange(101.0), np.arange(101.0) - 3e8, mode=mode)
    assert (got == near).all()


@pytest.mark.parametrize("mode", ["fill", "mesh"])
def test_a_body_far_from_zero(mode: str) -> None:
    def ring(far: float) -> Any:
        canvas = Canvas(320, 240)

        def f(u: Any, v: Any) -> Any:
            r = 3 + np.cos(v)
            return far + r * np.cos(u), r * np.sin(u) - far, far + np.sin(v)

        parametric(f, (0, 6.25), (0, 6.25), n=50, mode=mode, on=canvas)
        return canvas.array

    assert (ring(1e6) != ring(0)).sum() <= 20  # the sums lose digits before we see them
