"""What is drawn against what rays of light see: coverage, sides and colours, and picks."""

from math import pi
from typing import Any

import numpy as np
import pytest

from surfaces import FIGURES, Figure, affine, compose, rotation, scaling, surface
from surfaces.arrays import Doubles, middle
from surfaces.systems.colors import UNDER, UPPER
from surfaces.visible.pictures import HeightPicture
from tests.surfaces.raycast import Canvas, Cast, cast, edges

VIEWS: dict[str, Doubles | None] = {
    "as it is": None,
    "turned": rotation("z", 2.0),
    "tumbling": rotation((1, 2, 3), 1.1),
    "from below": rotation((1, 2, 3), 3.0),
    "mirrored": scaling(-1, 1, 1),
    "sheared": affine(((1, 0.4, 0), (0, 1, 0.3), (0, 0.5, 1))),
}


def both(f: Any, x: Any, y: Any, size: tuple[int, int], **how: Any) -> tuple[Any, Canvas, Cast]:
    """A surface as it is drawn, and as rays see it."""
    canvas = Canvas(*size)
    plot = surface(f, x, y, on=canvas, **how)
    low, high = plot.box
    more = 0.05 * (high[2] - low[2])  # between the nodes f may be a little beyond them
    view = plot.view
    z = float(low[2] - more), float(high[2] + more)
    return plot, canvas, cast(f, x, y, z, view.screen, view.eye, *size)


def check(plot: Any, canvas: Canvas, rays: Cast) -> None:
    drawn = canvas.array > 0
    assert plot.picture.swept
    assert (drawn != rays.hit).sum() <= 0.003 * drawn.size
    assert (drawn != rays.hit).sum() <= 0.01 * rays.hit.sum()
    inside = drawn & rays.hit & ~edges(rays.hit) & ~edges(rays.under)
    under = canvas.array >= UNDER[0]
    assert (under[inside] == rays.under[inside]).all()
    low, high = plot.limits
    value = (rays.point[..., 2] - low) / (high - low)
    shown = np.where(
        under,
        (canvas.array - UNDER[0] + 0.5) / len(UNDER),
        (canvas.array - UPPER[0] + 0.5) / len(UPPER),
    )
    wrong = np.abs(shown - value)[inside] > 0.05
    assert wrong.mean() <= 0.005


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("fig", FIGURES, ids=lambda fig: fig.name)
def test_the_figures(fig: Figure, view: str) -> None:
    how = {"n": 200, "transform": VIEWS[view], "zfrac": fig.zfrac}
    check(*both(fig.f, fig.x, fig.y, (160, 120), **how))


def test_on_a_whole_screen_the_outline_is_exact() -> None:
    fig = FIGURES[1]
    how = {"n": 200, "transform": VIEWS["tumbling"], "zfrac": fig.zfrac}
    _, canvas, rays = both(fig.f, fig.x, fig.y, (640, 480), **how)
    assert ((canvas.array > 0) != rays.hit).sum() <= 0.003 * rays.hit.sum()


def smooth(seed: int) -> Any:
    """Some waves in random directions."""
    rng = np.random.default_rng(seed)
    a, b, phase, size = rng.normal(size=(4, 5))

    def f(x: Any, y: Any) -> Any:
        waves = (w * np.sin(2 * (p * x + q * y) + r) for p, q, r, w in zip(a, b, phase, size))  # noqa: B905
        return sum(waves)

    return f


def anything(seed: int) -> Doubles:
    """A random turn, shear and reflection, not too flat."""
    rng = np.random.default_rng(1000 + seed)
    turn = rotation(tuple(rng.normal(size=3)), rng.uniform(0, 2 * pi))
    shear = affine(np.eye(3) + rng.uniform(-0.5, 0.5, size=(3, 3)))
    return compose(turn, shear, scaling(*rng.choice((-1, 1), 3)))


@pytest.mark.parametrize("seed", range(10))
def test_random_surfaces_in_random_views(seed: int) -> None:
    how = {"n": 150, "transform": anything(seed), "zfrac": 0.4}
    plot, canvas, rays = both(smooth(seed), (-2, 2), (-1, 2), (160, 120), **how)
    check(plot, canvas, rays)


@pytest.mark.parametrize("seed", range(5))
def test_picks_are_what_rays_hit(seed: int) -> None:
    f = smooth(seed)
    how = {"n": 300, "transform": anything(seed), "zfrac": 0.4}
    plot, _, rays = both(f, (-2, 2), (-1, 2), (160, 120), **how)
    inside = rays.hit & ~edges(rays.hit) & ~edges(rays.under)
    rows, columns = np.nonzero(inside)
    rng = np.random.default_rng(seed)
    far = 0
    for k in rng.choice(len(rows), 60, replace=False):
        px, py = int(columns[k]), int(rows[k])
        point = plot.pick(px, py)
        assert plot.project(point)[:2] == pytest.approx((px, py), abs=1e-6)
        assert point[2] == pytest.approx(f(point[0], point[1]), abs=0.02)
        # On a fold that is all but hidden, rounding may say the one or the other.
        far += np.abs(np.array(point) - rays.point[py, px])[:2].max() > 0.05
    assert far <= 1


def test_beside_the_surface_there_is_nothing_to_pick() -> None:
    plot, _, rays = both(smooth(1), (-2, 2), (-1, 2), (200, 150))
    assert plot.pick(0, 0) is None
    assert plot.pick(-1000, 5) is None
    rows, columns = np.nonzero(~rays.hit & ~edges(rays.hit))
    assert all(plot.pick(x, y) is None for x, y in zip(columns[::97], rows[::97], strict=True))


@pytest.mark.parametrize("view", VIEWS)
def test_a_level_plane_is_where_it_should_be(view: str) -> None:
    """It has no height to shear along, but it lies at one."""
    canvas = Canvas(200, 150)
    plot = surface(lambda x, y: 0 * x + 5, (-2, 1), (0, 1), n=8, transform=VIEWS[view], on=canvas)
    seen = plot.view
    rays = cast(lambda x, y: 0 * x + 5, (-2, 1), (0, 1), (4, 6), seen.screen, seen.eye, 200, 150)
    assert ((canvas.array > 0) != rays.hit).sum() <= 0.003 * canvas.array.size
    assert rays.hit.sum() > 1000
    x, y = 100, 75
    assert plot.pick(x, y) == pytest.approx(tuple(rays.point[y, x]), abs=1e-3)


@pytest.mark.parametrize("view", VIEWS)
def test_a_mesh_shows_the_lines_that_rays_see(view: str) -> None:
    """Nodes that are seen are lit; what is lit is near a line of the nearest part."""
    f, cells, every = smooth(4), 96, 8
    how = {"n": cells, "transform": VIEWS[view], "zfrac": 0.4}
    _, _, rays = both(f, (-2, 2), (-1, 2), (320, 240), **how)
    canvas = Canvas(320, 240)
    plot = surface(f, (-2, 2), (-1, 2), mode="mesh", every=every, lines=14, on=canvas, **how)
    lit = np.pad(canvas.array, 1) == 14
    lit = sum(lit[i : i + 240, j : j + 320] for i in range(3) for j in range(3)) > 0
    assert isinstance(plot.picture, HeightPicture)
    grid = plot.picture.grids[0]
    nodes = grid.points[::every, ::every].reshape(-1, 3) + middle(plot.box)
    x, y = np.floor(plot.project(nodes)[:, :2].T + 0.5).astype(int)
    near = np.hypot(*(rays.point[y, x] - nodes)[:, :2].T) < 0.02
    clear = rays.hit[y, x] & ~edges(rays.hit)[y, x]
    assert near[clear].sum() > 40
    assert lit[y, x][near & clear].all()
    rows, columns = np.nonzero(canvas.array)
    hit = rays.hit[rows, columns] & ~edges(rays.hit | rays.under)[rows, columns]
    point = rays.point[rows[hit], columns[hit]]
    x_line = np.abs((point[:, 0] + 2) / 4 * 12 % 1 - 0.5)
    y_line = np.abs((point[:, 1] + 1) / 3 * 12 % 1 - 0.5)
    assert (np.maximum(x_line, y_line) < 0.15).mean() < 0.02
