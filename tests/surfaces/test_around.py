"""Fields, contours, ticks, the box and the axes, several surfaces in one picture."""

from itertools import combinations
from math import atan, cos, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import (
    PROJECTIONS,
    Axonometry,
    Mapping,
    Pen,
    compose,
    orthographic,
    parametric,
    rotation,
    sample,
    scaling,
    surface,
)
from surfaces.frame import Frame
from surfaces.shape.contours import contours
from surfaces.shape.fields import field
from surfaces.space.view import View
from surfaces.systems.colors import UNDER, UPPER
from surfaces.visible.pictures import HeightPicture
from tests.surfaces.raycast import Canvas

SQUARE: dict[str, Any] = {"x": (-1, 1), "y": (-1, 1)}


class Writer(Canvas):
    """A canvas that keeps what is written on it."""

    def __init__(self, width: int = 320, height: int = 240) -> None:
        super().__init__(width, height)
        self.texts: list[tuple[int, int, str]] = []

    def setcolor(self, color: int) -> None:
        pass

    def outtextxy(self, x: int, y: int, text: str) -> None:
        self.texts.append((x, y, text))


# Projections -------------------------------------------------------------------------------------

angles = st.floats(-3, 3)
elevations = st.floats(0.05, 1.5) | st.floats(-1.5, -0.05)
arrows = st.tuples(st.floats(-2, 2), st.floats(-2, 2))
points = st.tuples(*[st.floats(-10, 10)] * 3)


@given(angles, elevations)
def test_orthographic_is_a_camera(azimuth: float, elevation: float) -> None:
    """Gauss: the columns of the matrix are perpendicular and of length one."""
    view = orthographic(azimuth, elevation)
    assert pytest.approx(np.eye(2), abs=1e-12) == view.M32.T @ view.M32
    c = cos(elevation)
    eye = (c * cos(azimuth), c * sin(azimuth), sin(elevation))
    assert view.eye == pytest.approx(eye, abs=1e-12)


@given(arrows, arrows, arrows, points)
def test_any_three_arrows_have_a_way_back(x: Any, y: Any, z: Any, point: Any) -> None:
    if abs(x[0] * y[1] - x[1] * y[0]) < 0.1:
        return
    view = Axonometry(x, y, z, origin=(5, 6), scale=(1, 2, 3))
    assert view.unproject(view.project(point)) == pytest.approx(point, abs=1e-9)
    assert view.eye @ view.M32 == pytest.approx((0, 0), abs=1e-9)


def test_lengths_of_the_presets() -> None:
    lengths = {
        name: np.linalg.norm(view.M32, axis=1).round(6).tolist()
        for name, view in PROJECTIONS.items()
    }
    short = round(sqrt(2 / 3), 6)
    assert lengths["paper"] == lengths["military"] == [1, 1, 1]
    assert lengths["cabinet"] == [0.5, 1, 1]
    assert lengths["isometric"] == [short] * 3
    x, y, z = lengths["dimetric"]
    assert (2 * x, y) == pytest.approx((z, z), abs=1e-5)
    assert lengths["top"] == [1, 1, 0]
    long = round(sqrt(15) / 4, 6)
    assert lengths["front"] == [1, 0.25, long]
    assert lengths["side"] == [0.25, 1, long]
    assert pytest.approx(np.array(((-sin(pi / 4), cos(pi / 4)), (1, 0), (0, -1)))) == Mapping().M32
    assert orthographic(pi / 4, atan(sqrt(0.5))) == PROJECTIONS["isometric"]


@pytest.mark.parametrize("bad", [0, 2, -2, float("nan")])
def test_bad_elevation(bad: float) -> None:
    with pytest.raises(ValueError, match="elevation must be"):
        orthographic(0, bad)


def test_arrows_on_one_line() -> None:
    with pytest.raises(ValueError, match="x and y must not lead along one line"):
        Axonometry((1, 1), (2, 2), (0, -1))
    with pytest.raises(ValueError, match="z must be two finite numbers"):
        Axonometry((1, 0), (0, 1), (0, float("inf")))
    with pytest.raises(ValueError, match=r"projection must be one of paper, .*, not 'fisheye'"):
        surface(lambda x, y: x, **SQUARE, projection="fisheye", on=Canvas(20, 20))


# What colours tell -------------------------------------------------------------------------------


def test_fields() -> None:
    grid = sample(lambda x, y: 3 * x + 4 * y, (0, 1), (0, 1), 4)
    assert field("z", grid, np.eye(4)).limits == (0, 7)
    slope = field("slope", grid, np.eye(4))
    assert slope.limits == pytest.approx((5, 5))
    lit = field("light", sample(lambda x, y: 0 * x, (0, 1), (0, 1), 2), np.eye(4)).value
    below = field("light", sample(lambda x, y: 0 * x, (0, 1), (0, 1), 2), scaling(1, 1, -1)).value
    assert lit[0, 0] > 0.7
    assert np.sqrt(below[0, 0]) == pytest.approx(1 - np.sqrt(lit[0, 0]))
    mine = field(lambda x, y: x, grid, np.eye(4))
    assert (mine.value[:, 0].tolist(), mine.limits) == ([0, 0.25, 0.5, 0.75, 1], (0, 1))
    assert field(grid.z * 2, grid, np.eye(4)).limits == (0, 14)


@pytest.mark.parametrize(
    ("color", "message"),
    [
        ("warmth", "color must be 'z', 'slope', 'light', an array or a function, not 'warmth'"),
        (np.ones((2, 2)), r"color must have the shape \(5, 5\), not \(2, 2\)"),
        (np.full((5, 5), np.nan), "color has no finite value"),
    ],
)
def test_bad_fields(color: Any, message: str) -> None:
    canvas = Canvas(20, 20)
    with pytest.raises(ValueError, match=message):
        surface(lambda x, y: x, **SQUARE, n=4, color=color, on=canvas)
    assert not canvas.array.any()


def test_colors_follow_the_field() -> None:
    canvas = Canvas(200, 150)
    plot = surface(lambda x, y: 0 * x, **SQUARE, n=20, color=lambda x, y: y, on=canvas)
    assert plot.limits == (-1, 1)
    x, y, _ = np.floor(plot.project([(0, -0.5, 0), (0, 0.5, 0)]) + 0.5).astype(int).T
    expected = UPPER[0] + len(UPPER) * np.array((0.25, 0.75))
    assert canvas.array[y, x] == pytest.approx(expected, abs=2)


# Contours ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("level", [-0.5, 0.0, 0.31])
def test_contours_lie_on_the_surface(level: float) -> None:
    grid = sample(lambda x, y: np.sin(3 * x) * np.cos(2 * y), (-2, 2), (-2, 2), 80)
    lines = contours(grid, level)
    x, y, z = np.concatenate((lines.starts, lines.ends)).T
    assert (z == level).all()
    assert np.sin(3 * x) * np.cos(2 * y) == pytest.approx(level, abs=0.01)


def test_a_circle_is_as_long_as_it_should_be_and_closed() -> None:
    grid = sample(lambda x, y: x * x + y * y, (-2, 2), (-2, 2), 100)
    lines = contours(grid, 1.03)
    assert np.linalg.norm(lines.ends - lines.starts, axis=1).sum() == pytest.approx(
        2 * pi * sqrt(1.03), rel=1e-3
    )
    ends = np.round(np.concatenate((lines.starts, lines.ends)), 9)
    assert (np.unique(ends, axis=0, return_counts=True)[1] == 2).all()


@pytest.mark.parametrize("middle", [-0.4, 0.4])
def test_a_saddle_is_joined_by_its_middle(middle: float) -> None:
    """Four crossings; the low corners are cut off if the middle is high, and the other way."""
    z = np.array(((1 + middle, -1 + middle), (-1 + middle, 1 + middle)))
    lines = contours(sample(lambda x, y: z, (0, 1), (0, 1), 1), 0.0)
    assert len(lines.starts) == 2
    corners = {(0, 0), (1, 1)} if middle < 0 else {(0, 1), (1, 0)}
    halves = (lines.starts + lines.ends)[:, :2] / 2
    assert {tuple(np.round(half).astype(int).tolist()) for half in halves} == corners


def test_no_contour_in_a_hole() -> None:
    grid = sample(lambda x, y: np.where(x > 0, np.nan, y), (-1, 1), (-1, 1), 20)
    assert contours(grid, 0.05).starts[:, 0].max() <= 0
    assert len(contours(grid, 7.0).starts) == 0


@pytest.mark.parametrize("holes", [False, True])
def test_hidden_contours_are_not_drawn(holes: bool) -> None:
    """Of the circle round a steep hill only the front half is seen."""

    def hill(x: Any, y: Any) -> Any:
        z = np.exp(-6 * (x * x + y * y))
        return np.where(x + y > 1.8, np.nan, z) if holes else z

    canvas = Canvas(320, 240)
    plot = surface(hill, **SQUARE, n=80, contours=[0.3], lines=15, zfrac=0.7, on=canvas)
    assert isinstance(plot.picture, HeightPicture)
    assert plot.picture.swept != holes
    rows, columns = np.nonzero(canvas.array == 15)
    seen = np.array([plot.pick(x, y) for x, y in zip(columns, rows, strict=True)], np.float64)
    assert np.hypot(seen[:, 0], seen[:, 1]) == pytest.approx(sqrt(-np.log(0.3) / 6), abs=0.08)
    assert 60 < len(rows) < 220


# Numbers, box and axes ---------------------------------------------------------------------------


@pytest.mark.parametrize("turn", [0, 1, 2.5, 4])
def test_the_far_corner_is_hidden_by_the_box(turn: float) -> None:
    mapping = Mapping()
    view = View.of(rotation((1, 2, 3), turn), mapping)
    low, high = np.array((-1.0, -2.0, -3.0)), np.array((1.0, 2.0, 3.0))
    far = Frame(Pen(Canvas(9, 9)), view, low, high, np.zeros(3)).far
    corners = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1).T
    assert far @ view.eye == pytest.approx((corners @ view.eye).min())


def test_axes_are_numbered_and_named() -> None:
    page = Writer()
    surface(lambda x, y: x * y, (0, 4), (-1, 1), axes=("s", "Hz", "dB"), title="A title", on=page)
    texts = [text for _, _, text in page.texts]
    assert {"s", "Hz", "dB", "A title", "4", "-1"} <= set(texts)
    assert all(0 <= x <= 320 - 8 * len(text) and 0 <= y <= 232 for x, y, text in page.texts)


@pytest.mark.parametrize("turn", range(6))
def test_writing_stays_on_the_screen(turn: int) -> None:
    page = Writer()
    T = rotation((1, 2, 3), turn)
    surface(lambda x, y: x * y, **SQUARE, n=8, transform=T, axes=True, colorbar=True, on=page)
    assert all(0 <= x <= 320 - 8 * len(text) and 0 <= y <= 232 for x, y, text in page.texts)


@pytest.mark.parametrize("turn", range(6))
@pytest.mark.parametrize("size", [1, 3])
def test_no_number_is_written_over_another(turn: int, size: float) -> None:
    """Nor do those whose places are off the screen pile up at its edge."""
    page = Writer()
    T = compose(rotation("z", turn), rotation("x", 0.3), scaling(size, size, size))
    surface(lambda x, y: x * y, **SQUARE, n=8, transform=T, axes=True, on=page)
    boxes = [(x, y, x + 8 * len(t), y + 8) for x, y, t in page.texts if t not in "xyz"]
    assert boxes or size > 1
    for (l1, t1, r1, b1), (l2, t2, r2, b2) in combinations(boxes, 2):
        assert r1 <= l2 or r2 <= l1 or b1 <= t2 or b2 <= t1


def test_the_bar_of_colors_has_them_all() -> None:
    page = Writer()
    surface(lambda x, y: x, **SQUARE, n=4, colorbar=True, on=page)
    assert len({*np.unique(page.array[:, 240:]).tolist()} & {*UPPER.tolist()}) > 100


# Several surfaces --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "turn", [None, rotation("z", 2), rotation((1, 2, 3), 3), scaling(1, 1, -1)]
)
@pytest.mark.parametrize("mode", ["fill", "facets", "mesh", "fill+mesh"])
def test_two_sheets_hide_each_other(turn: Any, mode: str) -> None:
    """Two planes, one above the other: of both, the nearer is seen."""
    canvas = Canvas(160, 120)
    planes = [lambda x, y: 0 * x, lambda x, y: 0 * x + 1]
    plot = surface(planes, **SQUARE, n=10, mode=mode, transform=turn, lines=14, on=canvas)
    if mode in ("fill", "facets"):
        rows, columns = np.nonzero(canvas.array)
        right = 0
        for x, y in zip(columns[::37], rows[::37], strict=True):
            point = plot.pick(x, y)
            lower = canvas.array[y, x] in (UPPER[0], UNDER[0])
            right += point is None or (point[2] < 0.5) == lower
        assert right >= 0.97 * len(rows[::37])
    assert canvas.array.any()


def test_crossing_surfaces_are_right_in_every_pixel() -> None:
    canvas = Canvas(200, 150)
    plot = surface([lambda x, y: x, lambda x, y: -x], **SQUARE, n=7, on=canvas)
    rows, columns = np.nonzero(canvas.array)
    for x, y in zip(columns[::53], rows[::53], strict=True):
        point = plot.pick(x, y)
        if point is not None:
            under = canvas.array[y, x] >= UNDER[0]
            first, many = (UNDER[0], len(UNDER)) if under else (UPPER[0], len(UPPER))
            shown = (canvas.array[y, x] - first + 0.5) / many * 2 - 1
            assert shown == pytest.approx(point[2], abs=0.05)


def test_several_surfaces_share_their_axes() -> None:
    one = sample(lambda x, y: x, (0, 1), (0, 1), 3)
    two = sample(lambda x, y: x, (0, 2), (0, 1), 3)
    with pytest.raises(ValueError, match="several surfaces must have the same x and y"):
        surface([one, two], on=Canvas(20, 20))


# Parametric surfaces -----------------------------------------------------------------------------


def ball(u: Any, v: Any) -> Any:
    return np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)


ROUND: dict[str, Any] = {"u": (0, 2 * pi), "v": (-pi / 2, pi / 2)}


@pytest.mark.parametrize("turn", [None, rotation((1, 2, 3), 2)])
def test_a_ball_shows_its_near_half(turn: Any) -> None:
    canvas = Canvas(160, 120)
    plot = parametric(ball, **ROUND, n=60, transform=turn, projection="isometric", on=canvas)
    rows, columns = np.nonzero(canvas.array)
    for x, y in zip(columns[::201], rows[::201], strict=True):
        point = plot.pick(x, y)
        if point is not None:
            assert plot.project(point)[:2] == pytest.approx((x, y), abs=1e-6)
            assert np.linalg.norm(point) == pytest.approx(1, abs=0.01)
            assert float(plot.depth(point)) > -0.1
            shown = (canvas.array[y, x] - UPPER[0] + 0.5) / len(UPPER) * 2 - 1
            assert shown == pytest.approx(point[2], abs=0.06)
    assert plot.pick(0, 0) is None


@pytest.mark.parametrize("mode", ["mesh", "fill+mesh", "wire", "facets"])
def test_every_mode_of_a_ball(mode: str) -> None:
    canvas = Canvas(160, 120)
    parametric(ball, **ROUND, n=20, mode=mode, lines=14, box=True, axes=True, on=canvas)
    assert canvas.array.any()


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"mode": "waterfall"}, "mode must be one of 'fill', .*, not 'waterfall'"),
        ({"u": (1, 0)}, r"u must be \(a, b\)"),
        ({"n": 0}, "n must be at least 1"),
        ({"f": lambda u, v: (u, v)}, "f must return x, y and z, not 2 values"),
        ({"f": lambda u, v: (u * np.nan, v, v)}, "f has no finite point"),
        ({"color": "slope"}, 'color must be "z" or an array or a function of u and v'),
        ({"every": 0}, "every must be at least 1"),
    ],
)
def test_bad_parametric_surfaces(wrong: Any, message: str) -> None:
    canvas = Canvas(20, 20)
    with pytest.raises(ValueError, match=message):
        parametric(**{"f": ball, **ROUND, **wrong}, on=canvas)
    assert not canvas.array.any()


# What a plot knows -------------------------------------------------------------------------------


def test_the_scales_make_the_same_picture() -> None:
    """The paper's map with the reported scales, and nothing else, puts every point in place."""
    canvas = Canvas(320, 240)
    plot = surface(lambda x, y: np.sin(x + y), (0, 6), (-2, 3), n=30, theta=0.9, on=canvas)
    assert isinstance(plot.mapping, Mapping)
    origin = plot.project((0, 0, 0))[:2]
    again = Mapping(plot.mapping.theta, origin=tuple(origin), scale=plot.scales)
    points = np.random.default_rng(3).normal(size=(50, 3))
    assert again.project(points)[:, :2] == pytest.approx(plot.project(points)[:, :2])
    assert plot.unproject(plot.project(points)) == pytest.approx(points)
    fresh = Canvas(320, 240)
    surface(lambda x, y: np.sin(x + y), (0, 6), (-2, 3), n=30, mapping=again, on=fresh)
    assert (fresh.array != canvas.array).mean() < 0.001


@given(points, st.floats(0.01, 3))
def test_depth_grows_toward_the_eye(point: Any, step: float) -> None:
    plot = surface(
        lambda x, y: x, **SQUARE, n=1, transform=rotation((1, 2, 3), 1), on=Canvas(40, 30)
    )
    eye = plot.view.eye / np.linalg.norm(plot.view.eye)
    nearer = np.array(point) + step * eye
    assert plot.project(nearer)[:2] == pytest.approx(plot.project(point)[:2], abs=1e-9)
    assert plot.depth(nearer) > plot.depth(point)


def test_seen_on_its_edge_a_surface_is_still_drawn() -> None:
    """A turn that puts the eye into a plane: a line is left, and no error."""
    mapping = Mapping(origin=(80, 60), scale=(30, 30, 30))
    c, s = np.sqrt(0.5), np.sqrt(0.5)
    exchange = np.eye(4)
    exchange[:3, :3] = np.array(((1, c, s), (0, 1, 0), (0, 0, 1)))
    squash = scaling(1, 1e-9, 1)
    for mode in ("fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"):
        canvas = Canvas(160, 120)
        plot = surface(
            lambda x, y: 0 * x,
            **SQUARE,
            n=8,
            mode=mode,
            lines=14,
            mapping=mapping,
            transform=squash @ exchange,
            on=canvas,
        )
        assert plot.pick(80, 60) is None or mode
        assert canvas.array.sum() >= 0
