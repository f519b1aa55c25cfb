"""A surface and a body in one scene: which is nearer, pixel by pixel, as two pictures tell."""

from math import pi
from typing import Any

import numpy as np
import pytest

from surfaces import Plot, Svg, perspective, rotation, surface
from surfaces.arrays import corners
from tests.surfaces.raycast import Canvas, edges

VIEWS: list[dict[str, Any]] = [
    {},
    {"projection": "isometric"},
    {"projection": perspective(2.5, 0.5, 0.5)},
    {"transform": rotation((1, 2, 3), 2.8)},
]
BALL: dict[str, Any] = {"u": (0, 2 * pi), "v": (0, pi), "n": 60}


def waves(x: Any, y: Any) -> Any:
    return np.sin(2 * x) * np.cos(2 * y)


def ball(u: Any, v: Any) -> Any:
    return 0.8 * np.cos(u) * np.sin(v), 0.8 * np.sin(u) * np.sin(v), 0.8 * np.cos(v)


def ground(on: Any, **how: Any) -> Plot:
    return surface(waves, (-2, 2), (-2, 2), n=80, zfrac=0.4, on=on, **how)


def hit(x: float, y: float, plot: Plot) -> float:
    """How near the ball is at a pixel, by geometry: a ray against a sphere; -inf if it misses."""
    triples = np.array(((x, y, 0.0), (x, y, 1.0)))
    a, b = plot.unproject(triples)
    way = b - a
    half, rest = a @ way, a @ a - 0.64
    root = half * half - way @ way * rest
    if root < 0:
        return -np.inf
    ends = [a + (-half + sign * np.sqrt(root)) / (way @ way) * way for sign in (-1, 1)]
    return max(float(plot.depth(end)) for end in ends)


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("mode", ["fill", "mesh"])
def test_each_is_hidden_where_the_other_is_nearer(view: dict[str, Any], mode: str) -> None:
    before, canvas = Canvas(160, 120), Canvas(160, 120)
    alone = ground(before, mode=mode, **view)
    scene = ground(canvas, mode=mode, **view).parametric(ball, **BALL, color=lambda u, v: 0 * u + 9)
    changed = canvas.array != before.array
    unsure, right = edges(changed), 0
    close = 0.02 * np.ptp(alone.depth(corners(alone.box)))
    for y in range(2, 120, 5):
        for x in range(2, 160, 5):
            point = alone.pick(x, y)
            near = -np.inf if point is None else float(alone.depth(point))
            of_ball = hit(x, y, alone)
            if unsure[y, x] or abs(near - of_ball) < close:
                continue
            assert changed[y, x] == (of_ball > near) or of_ball > near
            assert not (changed[y, x] and of_ball < near)
            picked = scene.pick(x, y)
            assert (picked is None) == (max(near, of_ball) == -np.inf)
            if picked is not None:
                assert float(scene.depth(picked)) == pytest.approx(max(near, of_ball), abs=close)
                right += of_ball > near
    assert right > 5
    assert changed.sum() > 100


def test_in_a_drawing_whole_cells_are_shown_or_hidden() -> None:
    drawing, all_of_it = Svg(160, 120), Svg(160, 120)
    ground(drawing).parametric(ball, **BALL)
    plain = str(ground(Svg(160, 120)).picture.easel.pen.system).count("<path")
    added = str(drawing).count("<path") - plain
    assert 0 < added < 3600 / 2
    ground(all_of_it).parametric(lambda u, v: (*ball(u, v)[:2], 3 + ball(u, v)[2]), **BALL)
    assert added < str(all_of_it).count("<path") - plain <= 3600


def test_a_body_behind_the_eye_is_refused() -> None:
    canvas = Canvas(80, 60)
    plot = ground(canvas, projection=perspective(2.5))
    before = canvas.array.copy()
    with pytest.raises(ValueError, match="behind the eye"):
        plot.parametric(lambda u, v: tuple(9 * c for c in ball(u, v)), **BALL)
    assert (canvas.array == before).all()
