"""An eye near by: the map and its way back, and what it sees against what rays of light see."""

from itertools import product
from math import inf, nan, pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import (
    Perspective,
    Svg,
    apply,
    compose,
    orthographic,
    parametric,
    perspective,
    rotation,
    scaling,
    surface,
)
from surfaces.arrays import Bools, Doubles
from surfaces.systems.colors import UNDER, UPPER
from tests.surfaces.raycast import Canvas, Cast, cast, edges

VIEWS: dict[str, tuple[Perspective, Doubles | None]] = {
    "usual": (perspective(), None),
    "very near": (perspective(2.1, 2.5, 0.4), None),
    "above the middle": (perspective(3, 0.3, 1.5), None),
    "between the sides": (perspective(2, -pi / 2, 0.3), None),
    "from below": (perspective(4, 0.5, -0.6), None),
    "tumbling": (perspective(), rotation((1, 2, 3), 1.1)),
    "mirrored": (perspective(), scaling(-1, 1, 1)),
}


def waves(x: Any, y: Any) -> Any:
    return np.sin(2 * x) * np.cos(1.5 * y) + 0.2 * x


def both(view: str, n: int = 120, **how: Any) -> tuple[Any, Canvas, Cast]:
    """A surface as it is drawn, and as rays from the eye see it."""
    canvas = Canvas(200, 150)
    projection, transform = VIEWS[view]
    plot = surface(
        waves, (-2, 2), (-2, 2), n, transform=transform, projection=projection, on=canvas, **how
    )
    low, high = plot.box
    z = float(low[2] - 0.01), float(high[2] + 0.01)
    seen = plot.view
    return plot, canvas, cast(waves, (-2, 2), (-2, 2), z, seen.screen, seen.eye, 200, 150)


def around(field: Bools) -> Bools:
    """Whether a pixel or one of its neighbours, all eight, is like that."""
    return field | edges(field)


angle = st.floats(-3, 3)
part = st.floats(-1, 1)


@given(st.floats(2, 100), angle, st.floats(0.1, 1.5), part, part, part)
def test_there_and_back(
    distance: float, azimuth: float, elevation: float, x: float, y: float, z: float
) -> None:
    view = perspective(distance, azimuth, elevation).placed((320, 240), 100, 0.8)
    assert view.unproject(view.project((x, y, z))) == pytest.approx((x, y, z), abs=1e-9)
    assert view.M4 @ view.M4_inverse == pytest.approx(np.eye(4), abs=1e-9)
    # All on the line to the eye is on one pixel.
    nearer = np.array((x, y, z)) + 0.3 * (view.eye - (x, y, z))
    assert view.project(nearer)[:2] == pytest.approx(view.project((x, y, z))[:2], abs=1e-6)
    assert np.linalg.norm(view.eye) == pytest.approx(distance)


def test_what_is_half_as_far_is_twice_as_large() -> None:
    view = perspective(4, 0, 1e-9)  # from (4, 0, 0)
    assert view.eye == pytest.approx((4, 0, 0), abs=1e-6)
    for x, size in ((0, 1), (2, 2), (-4, 0.5), (3, 4)):
        (left, _, _), (right, _, _) = view.project([(x, 0, 0), (x, 1, 0)])
        assert right - left == pytest.approx(size)


def test_parallels_meet_in_one_vanishing_point() -> None:
    view = perspective().placed((320, 240), 100)
    far = view.project([(-1e9, y, z) for y, z in product((-1, 0, 1), repeat=2)])[:, :2]
    assert far == pytest.approx(np.broadcast_to(far[0], far.shape), abs=1e-4)
    assert np.abs(far).max() < 2000


def test_from_far_away_it_is_orthographic() -> None:
    points = np.random.default_rng(1).uniform(-1, 1, (50, 3))
    far = orthographic(0.6, 0.3).project(points)
    assert perspective(1e9, 0.6, 0.3).project(points) == pytest.approx(far, abs=1e-6)


@given(angle, part, part, part)
def test_a_turn_of_triples_is_a_turn_of_space(turn: float, x: float, y: float, z: float) -> None:
    """The paper's (16), w included."""
    view, T = perspective(), rotation("z", turn)
    turned = apply(view.project((x, y, z)), view.screen_matrix(T))
    assert turned == pytest.approx(view.project(apply((x, y, z), T)), abs=1e-9)


@pytest.mark.parametrize("view", VIEWS)
def test_it_shows_what_rays_see(view: str) -> None:
    plot, canvas, rays = both(view)
    drawn = canvas.array > 0
    assert (drawn != rays.hit).sum() <= 0.01 * rays.hit.sum()
    inside = drawn & rays.hit & ~edges(rays.hit) & ~edges(rays.under)
    under = canvas.array >= UNDER[0]
    assert (under[inside] == rays.under[inside]).all()
    low, high = plot.limits
    value = (rays.point[..., 2] - low) / (high - low)
    shades = np.where(under, canvas.array - UNDER[0], canvas.array - UPPER[0]) + 0.5
    shown = shades / np.where(under, len(UNDER), len(UPPER))
    assert (np.abs(shown - value)[inside] > 0.05).mean() <= 0.005
    assert inside.sum() > 2000


@pytest.mark.parametrize("mode", ["fill", "mesh", "waterfall"])
@pytest.mark.parametrize("view", VIEWS)
def test_pick_is_the_inverse_of_what_is_drawn(view: str, mode: str) -> None:
    plot, _, rays = both(view, mode=mode, every=5)
    clear = rays.hit & ~edges(rays.hit) & ~edges(rays.under)
    rows, columns = (found[::211] for found in np.nonzero(clear))
    right = 0
    for x, y in zip(columns.tolist(), rows.tolist(), strict=True):
        point = plot.pick(x, y)
        assert point is not None
        assert plot.project(point)[:2] == pytest.approx((x, y), abs=1e-6)
        assert plot.unproject(plot.project(point)) == pytest.approx(point, abs=1e-6)
        right += np.abs(np.array(point) - rays.point[y, x]).max() < 0.1
    assert right >= 0.95 * len(rows) > 10
    assert plot.pick(0, 0) is None


@pytest.mark.parametrize("view", VIEWS)
def test_a_mesh_hides_what_rays_do_not_reach(view: str) -> None:
    """What is lit lies on a line of the grid, of the nearest part of the surface."""
    _, canvas, rays = both(view, mode="mesh", n=16, every=1, lines=14)
    lit = (canvas.array == 14) & ~edges(edges(rays.hit))
    cell = rays.point[..., :2] * 4 % 1
    beside = np.minimum(cell, 1 - cell).min(axis=2) < 0.2
    assert (~around(beside)[lit]).mean() < 0.02
    assert lit.sum() > 1000


@pytest.mark.parametrize("view", VIEWS)
def test_contours_are_hidden_behind(view: str) -> None:
    plain, lined = (both(view, contours=levels, lines=14) for levels in (0, [0.3]))
    _, canvas, rays = lined
    lit = (canvas.array == 14) & ~edges(edges(rays.hit))
    assert not (plain[1].array == 14).any()
    level = np.abs(rays.point[..., 2] - 0.3) < 0.2
    assert around(level)[lit].mean() > 0.985
    assert lit.sum() > 20


def test_depth_tells_the_nearer_of_two() -> None:
    plot, _, _ = both("usual")
    eye = plot.view.eye
    points = np.array((0.1, 0.2, 0.3)) + np.linspace(0, 0.9, 9)[:, None] * (eye - (0.1, 0.2, 0.3))
    assert (np.diff(plot.depth(points)) > 0).all()


def test_two_surfaces_that_cross() -> None:
    canvas = Canvas(200, 150)
    pair = [waves, lambda x, y: 0.3 * y]
    plot = surface(pair, (-2, 2), (-2, 2), 100, projection="perspective", color="z", on=canvas)
    seen = plot.view
    how = (-2, 2), (-2, 2), (-2, 2), seen.screen, seen.eye, 200, 150
    one, other = cast(waves, *how), cast(pair[1], *how)
    near = [np.where(rays.hit, seen.nearness(rays.point), -inf) for rays in (one, other)]
    first = near[0] > near[1]
    point = np.where(first[..., None], one.point, other.point)
    hit = (one.hit | other.hit) & ~edges(one.hit | other.hit) & ~edges(first)
    hit &= ~edges(one.under) & ~edges(other.under)
    low, high = plot.limits
    value = (point[..., 2] - low) / (high - low)
    under = canvas.array >= UNDER[0]
    shades = np.where(under, canvas.array - UNDER[0], canvas.array - UPPER[0]) + 0.5
    shown = shades / np.where(under, len(UNDER), len(UPPER))
    assert (np.abs(shown - value)[hit] > 0.05).mean() < 0.01


def test_one_large_cell_has_its_colors_in_perspective() -> None:
    """Half way on the screen is not half way in space."""
    canvas = Canvas(200, 150)
    plot = parametric(
        lambda u, v: (u, v, 0 * u),
        (-1, 1),
        (-1, 1),
        n=1,
        color=lambda u, v: u,
        projection=perspective(2.2, 0, 0.4),
        on=canvas,
    )
    for u in np.linspace(-0.9, 0.9, 7):
        x, y = np.floor(plot.project((u, 0.1, 0))[:2] + 0.5).astype(int)
        part = (plot.pick(x, y)[0] + 1) / 2  # type: ignore[index]
        assert canvas.array[y, x] == pytest.approx(UPPER[0] + part * len(UPPER), abs=1.01)


def test_axes_stand_at_their_numbers() -> None:
    """Ticks are not even on the screen: the nearer, the wider apart."""
    drawing = Svg(640, 480)
    plot = surface(waves, (0, 6), (0, 6), n=20, projection=perspective(2.5), axes=True, on=drawing)
    low, _ = plot.box
    starts = [
        tuple(map(int, line.split('d="M')[1].split("L")[0].split()))
        for line in str(drawing).splitlines()
        if 'd="M' in line and "L" in line and "z" not in line.split('"')[1]
    ]
    for x in (2.0, 4.0):
        foot = np.floor(plot.project((x, 6.0, low[2]))[:2] + 0.5)
        assert any(np.abs(np.array(start) - foot).max() <= 1 for start in starts)


@pytest.mark.parametrize("distance", [1.0, 1.3])
def test_an_eye_inside_the_box_is_refused(distance: float) -> None:
    canvas = Canvas(60, 40)
    with pytest.raises(ValueError, match="behind the eye: the perspective's distance must be gre"):
        surface(waves, (-2, 2), (-2, 2), projection=perspective(distance), on=canvas)
    with pytest.raises(ValueError, match="too near to turn the surface: its distance must be abo"):
        turn, side = rotation("z", 1), perspective(1.4, 0, 0.2)
        surface(waves, (-2, 2), (-2, 2), transform=turn, projection=side, on=canvas)
    with pytest.raises(ValueError, match="behind the eye"):
        moved = compose(scaling(9, 9, 9))
        surface(waves, (-2, 2), (-2, 2), transform=moved, projection="perspective", on=canvas)
    assert not canvas.array.any()


@pytest.mark.parametrize("distance", [0, -1, nan, inf])
def test_bad_distance(distance: float) -> None:
    with pytest.raises(ValueError, match="distance must be above 0 and finite"):
        perspective(distance)


def test_a_transform_must_be_affine() -> None:
    """Its last column was never asked; an inverse's is not exactly 0, 0, 0, 1."""
    canvas, other = Canvas(60, 40), Canvas(60, 40)
    turn = rotation("x", 0.4)
    inexact = turn + np.outer(np.ones(4), (0, 0, 0, 1e-17))
    surface(waves, (-2, 2), (-2, 2), transform=turn, on=canvas)
    surface(waves, (-2, 2), (-2, 2), transform=inexact, on=other)
    assert (canvas.array == other.array).all()
