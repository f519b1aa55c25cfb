"""The painter's order against rays of light: at every pixel the nearest cell must be the last."""

from math import pi

import numpy as np
import pytest

from surfaces import Mapping, affine, apply, compose, rotation, scaling
from surfaces.arrays import Doubles
from surfaces.shape.cells import quads
from surfaces.space.view import eye_from_surface
from surfaces.visible.order import back_to_front

CELLS = (5, 6)


def rays(cells: Doubles, mapping: Mapping, pixels: Doubles) -> Doubles:
    """How near each cell comes to the eye at each pixel, (cells, pixels); NaN where it is not.

    Every cell is two triangles.  Nearness is the distance along the line of sight: p . eye.
    """
    near = np.full((len(cells), len(pixels)), np.nan)
    for corners in ((0, 1, 2), (0, 2, 3)):
        triangle = cells[:, corners]
        screen = mapping.project(triangle)[..., :2]
        a, edges = screen[:, :1], screen[:, 1:] - screen[:, :1]
        u, v = np.moveaxis((pixels - a) @ np.linalg.inv(edges), 2, 0)
        depth = triangle @ mapping.eye
        here = depth[:, :1] + u * (depth[:, 1:2] - depth[:, :1]) + v * (depth[:, 2:] - depth[:, :1])
        inside = (u >= 0) & (v >= 0) & (u + v <= 1)
        near = np.fmax(near, np.where(inside, here, np.nan))
    return near


def surface_points(z: Doubles) -> Doubles:
    x, y = np.linspace(-1, 1, z.shape[0]), np.linspace(-1.3, 0.8, z.shape[1])
    return np.stack((*np.meshgrid(x, y, indexing="ij"), z), axis=-1)


def wrong_pixels(T: Doubles, mapping: Mapping, eye: Doubles, seed: int = 42) -> tuple[int, int]:
    """Pixels where the last cell drawn is not the nearest, and all pixels with a choice."""
    rng = np.random.default_rng(seed)
    z = rng.uniform(-1, 1, size=(CELLS[0] + 1, CELLS[1] + 1))
    nodes = back_to_front(apply(surface_points(z), T), eye)
    cells = quads(nodes).reshape(-1, 4, 3)
    screen = mapping.project(cells)[..., :2].reshape(-1, 2)
    pixels = rng.uniform(screen.min(axis=0), screen.max(axis=0), size=(1500, 2))
    near = rays(cells, mapping, pixels)
    choice = (~np.isnan(near)).sum(axis=0) > 1
    near = near[:, choice]
    last = len(cells) - 1 - np.argmax(~np.isnan(near)[::-1], axis=0)
    return int((last != np.nanargmax(near, axis=0)).sum()), int(choice.sum())


def shear(k: float) -> Doubles:
    return affine(((1, k, 0), (0, 1, -k), (k, 0, 1)))


FIXED = {
    "none": np.eye(4),
    "turned": rotation("z", 130 * pi / 180),
    "from below": rotation("y", pi),
    "reflected in x": scaling(-1, 1, 1),
    "reflected in y": scaling(1, -1, 1),
    "reflected in z": scaling(1, 1, -1),
    "turned and reflected": compose(rotation("z", 2), scaling(-1, 1, 1)),
    "sheared": shear(0.7),
    "sheared the other way": shear(-1.6),
    "leaning": compose(rotation("x", 1), shear(0.5), scaling(1, 3, -0.4)),
}


@pytest.mark.parametrize("T", FIXED.values(), ids=FIXED.keys())
def test_the_nearest_cell_is_the_last(T: Doubles) -> None:
    mapping = Mapping()
    wrong, of = wrong_pixels(T, mapping, eye_from_surface(mapping.eye, T))
    assert (wrong, of > 0) == (0, True)


@pytest.mark.parametrize("seed", range(40))
def test_the_nearest_cell_is_the_last_in_any_view(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mapping = Mapping(
        theta=rng.uniform(0.1, 1.4), rho_z=rng.uniform(0.2, 1), scale=tuple(rng.uniform(0.5, 3, 3))
    )
    turned = rotation(tuple(rng.normal(size=3)), rng.uniform(0, 2 * pi))
    anything = affine(rng.normal(size=(3, 3)), rng.normal(size=3))
    for T in (turned, compose(turned, scaling(*rng.choice((-1, 1), 3))), anything):
        assert wrong_pixels(T, mapping, eye_from_surface(mapping.eye, T), seed)[0] == 0


def test_without_turning_the_eye_back_the_order_is_wrong() -> None:
    """The test can fail: an order that never adapts is wrong after a turn."""
    wrong, of = wrong_pixels(FIXED["turned"], Mapping(), Mapping().eye)
    assert wrong > of / 10


def test_order_of_the_untransformed_surface() -> None:
    """x and y ascend toward the viewer."""
    eye = eye_from_surface(Mapping().eye, np.eye(4))
    field = np.arange(6).reshape(2, 3)
    assert back_to_front(field, eye).tolist() == [[0, 1, 2], [3, 4, 5]]
    assert back_to_front(field, eye * (-1, 1, 1)).tolist() == [[3, 4, 5], [0, 1, 2]]
    assert back_to_front(field, eye * (1, -1, 1)).tolist() == [[2, 1, 0], [5, 4, 3]]
    assert back_to_front(field, eye * (0, 0, 1)).tolist() == [[0, 1, 2], [3, 4, 5]]


def test_the_corners_of_a_cell_go_round() -> None:
    nodes = np.stack(np.meshgrid((0, 1, 2), (5, 6), indexing="ij"), axis=-1)
    assert quads(nodes).shape == (2, 1, 4, 2)
    assert quads(nodes)[1, 0].tolist() == [[1, 5], [2, 5], [2, 6], [1, 6]]


def test_a_transform_that_flattens() -> None:
    with pytest.raises(ValueError, match="transform must be invertible"):
        eye_from_surface(Mapping().eye, scaling(1, 1, 0))
