"""Numbers at the edge of what floats hold: holes, flat ground or a clear error, no warnings."""

import numpy as np
import pytest

import bgi
from surfaces import surface
from surfaces.shape.grid import Grid


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
