"""Scan conversion against its definition: a pixel is covered if its middle is in the triangle."""

import numpy as np
import pytest

from surfaces.arrays import Doubles
from surfaces.visible.scan import covered, reaching

WIDTH, HEIGHT = 30, 20


def by_definition(x: Doubles, y: Doubles, border: float) -> set[tuple[int, int, int]]:
    """Pixels within the three sides of each triangle, moved outwards by a border."""
    found = set()
    columns, rows = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    for triangle, (xs, ys) in enumerate(zip(x.T, y.T, strict=True)):
        turns = [
            (xs[k] - xs[k - 1]) * (rows - ys[k - 1]) - (ys[k] - ys[k - 1]) * (columns - xs[k - 1])
            for k in range(3)
        ]
        inside = (np.min(turns, axis=0) >= -border) | (np.max(turns, axis=0) <= border)
        found |= {(int(px), int(py), triangle) for py, px in np.argwhere(inside)}
    return found


@pytest.mark.parametrize("size", [0.7, 3.0, 40.0])
@pytest.mark.parametrize("whole", [False, True], ids=["anywhere", "corners on pixels"])
def test_triangles_cover_the_pixels_within(size: float, whole: bool) -> None:
    """And none off the screen; on a side, rounding decides."""
    rng = np.random.default_rng(5)
    middle = rng.uniform((-3, -3), (WIDTH + 3, HEIGHT + 3), (300, 2))
    x, y = (middle + rng.uniform(-size, size, (3, 300, 2))).transpose(2, 0, 1)
    if whole:
        x, y = np.round(x), np.round(y)
    area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])
    x, y = x[:, area != 0], y[:, area != 0]
    pixels = covered(x, y, WIDTH, HEIGHT)
    found = list(zip(*(way.astype(int).tolist() for way in pixels), strict=True))
    assert len(found) == len(set(found))
    assert by_definition(x, y, -1e-9) <= set(found) <= by_definition(x, y, 1e-9)
    assert set(pixels[2].tolist()) <= set(np.flatnonzero(reaching(x, y, WIDTH, HEIGHT)).tolist())


def test_a_level_side_belongs_to_its_triangle() -> None:
    x, y = np.array(((2.0, 6.0, 4.0), (2.0, 6.0, 4.0))).T, np.array(((3, 3, 5), (5, 5, 3.0))).T
    column, row, owner = covered(x, y, WIDTH, HEIGHT)
    for triangle, level in ((0, 3), (1, 5)):
        assert column[(owner == triangle) & (row == level)].tolist() == [2, 3, 4, 5, 6]
