"""The rims of holes: a surface ends where its function ends, not at the last line of the grid."""

from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest

from surfaces import data, orthographic, perspective, rotation, sample, sheet, surface
from surfaces.arrays import Doubles
from surfaces.shape.contours import contours
from surfaces.shape.fields import field
from surfaces.shape.rim import PIECES
from tests.surfaces.raycast import Canvas

FLAT: dict[str, Any] = {"x": (-1, 1), "y": (-1, 1)}


def dome(x: Doubles, y: Doubles) -> Doubles:
    return np.sqrt(0.81 - x * x - y * y)


def disk(x: Doubles, y: Doubles) -> Doubles:
    return np.where(x * x + y * y < 0.81, 1.0, np.nan)


def area(triangles: Doubles) -> float:
    """The area of triangles as seen from above."""
    a, b, c = triangles[..., :2].swapaxes(0, 1)
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return float(np.abs(ux * vy - uy * vx).sum() / 2)


@pytest.mark.parametrize("n", [7, 20, 61])
def test_a_disk_is_round(n: int) -> None:
    grid = sample(disk, (-1, 1), (-1, 1), n)
    assert grid.rim is not None
    cell = (2 / n) ** 2
    whole = grid.whole.sum() * cell
    round_one = whole + area(grid.rim.triangles(grid.points.reshape(-1, 3)))
    # What is missing are the bows over chords: of the order of a cell's side squared.
    assert np.pi * 0.81 - 2 * cell < round_one < np.pi * 0.81
    assert np.hypot(*grid.rim.points[:, :2].T) == pytest.approx(0.9, abs=1e-3)


def test_a_dome_stands_on_the_floor() -> None:
    low, high = sample(dome, (-1, 1), (-1, 1), 20).box
    assert (low[2], high[2]) == pytest.approx((0, 0.9), abs=0.03)


@pytest.mark.parametrize(
    "f",
    [
        lambda x, y: 1 / x,  # a pole at a line of the grid
        lambda x, y: np.log(x * x + y * y - 0.531),  # a pole at a ring
        lambda x, y: np.where(x == 0, np.nan, x * y),  # a line that is missing, and repaired
        lambda x, y: np.sin(1 / x),  # undecided at a line
        lambda x, y: x + y,
    ],
)
def test_where_there_is_no_rim(f: Any) -> None:
    with np.errstate(all="ignore"):
        rim = sample(f, (-1, 1), (-1, 1), 20).rim
    assert rim is None or len(rim.corners) == 0


def test_every_case_covers_what_is_there() -> None:
    """The pieces of a cell with ends in the middles of its sides, for each choice of corners."""
    places = np.array(((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)), float)
    areas = {0: 0.0, 1: 0.5, 2: 2.0, 3: 3.5, 4: 0.0}
    for case, pieces in enumerate(PIECES):
        corners = places[np.array(pieces, dtype=int).reshape(-1, 4)]
        a, b, c, d = corners.swapaxes(0, 1)
        covered = area(np.stack((a, b, c), axis=1)) + area(np.stack((a, c, d), axis=1))
        count = case.bit_count()
        assert covered == (1.0 if case in (0b0101, 0b1010) else areas[count]), bin(case)


@pytest.mark.parametrize("mode", ["fill", "facets", "mesh", "fill+mesh"])
@pytest.mark.parametrize("turn", [0.0, 0.4, 2.5])
def test_the_silhouette_of_a_disk_is_an_ellipse(mode: str, turn: float) -> None:
    """Against the same disk with so many cells that the rim is less than a pixel wide."""
    coarse, fine = Canvas(320, 240), Canvas(320, 240)
    T = rotation((1, 2, 3), turn)
    surface(disk, **FLAT, n=24, transform=T, mode=mode, every=1, lines=5, on=coarse)
    surface(disk, **FLAT, n=400, transform=T, on=fine)
    seen, true = coarse.array > 0, fine.array > 0
    if mode != "mesh":  # of which the lines are drawn, and not what is between them
        assert (seen != true).sum() < 0.03 * true.sum()
    assert (seen & ~true).sum() < 0.025 * true.sum()  # outlines are half a pixel larger


@pytest.mark.parametrize("every", [1, 4])
def test_lines_run_to_the_rim(every: int) -> None:
    grid = sample(disk, (-1, 1), (-1, 1), 24)
    pieces, of_x = grid.loose_ends(every)
    assert np.hypot(*pieces[:, 1, :2].T) == pytest.approx(0.9, abs=1e-3)
    assert (pieces[of_x, 0, 0] == pieces[of_x, 1, 0]).all()
    assert (pieces[~of_x, 0, 1] == pieces[~of_x, 1, 1]).all()
    lines = [x for x in grid.x[grid.lines(every)[0]] if abs(x) < 0.9]
    assert sorted(pieces[of_x, 0, 0]) == sorted(2 * lines)


@pytest.mark.parametrize("mode", ["wire", "waterfall"])
def test_drawn_lines_reach_the_rim(mode: str) -> None:
    """As a flat disk is seen from above: its lines end on a circle of 90 pixels' radius."""
    canvas = Canvas(220, 220)
    above = replace(orthographic(-pi / 2, pi / 2), origin=(110, 110), scale=(100, 100, 100))
    surface(disk, **FLAT, n=24, mode=mode, every=1, lines=5, mapping=above, on=canvas)
    drawn = 0
    for x in np.linspace(-1, 1, 25):
        column = round(110 + 100 * x)
        y = np.flatnonzero(canvas.array[:, column])
        if abs(x) < 0.8 and len(y):
            drawn += 1
            half = 100 * np.sqrt(0.81 - x * x)
            assert y[0] == pytest.approx(110 - half, abs=2)
            assert y[-1] == pytest.approx(110 + half, abs=2)
    assert drawn == 19


def test_what_is_seen_at_the_rim_can_be_picked() -> None:
    canvas = Canvas(320, 240)
    plot = surface(dome, **FLAT, n=24, transform=rotation((1, 2, 3), 0.4), on=canvas)
    y, x = np.nonzero(canvas.array)
    found = [plot.pick(px, py) for px, py in zip(x[::7].tolist(), y[::7].tolist(), strict=True)]
    assert sum(point is None for point in found) < 0.01 * len(found)
    for point in found:
        if point is not None:
            assert point[0] ** 2 + point[1] ** 2 + point[2] ** 2 == pytest.approx(0.81, abs=0.15)


def test_two_surfaces_with_holes() -> None:
    """Each covers the other where it is nearer, also at its rim."""
    both, upper = Canvas(320, 240), Canvas(320, 240)
    surface([disk, lambda x, y: disk(x, y) - 1], **FLAT, n=24, mode="facets", on=both)
    surface([disk, lambda x, y: disk(x, y) - 1], **FLAT, n=24, on=upper)
    assert (both.array > 0).sum() == pytest.approx((upper.array > 0).sum(), rel=0.02)


# Data ------------------------------------------------------------------------------------------

NODES = (np.arange(6.0), np.arange(5.0))


def with_holes(*missing: tuple[int, int]) -> Doubles:
    """Heights of a plane at six by five nodes, some of them missing."""
    z: Doubles = np.add.outer(*NODES)
    for node in missing:
        z[node] = np.nan
    return z


def test_data_without_holes_have_no_rim() -> None:
    assert data(with_holes()).rim is None


def test_a_cell_of_data_that_lacks_one_corner_is_a_triangle() -> None:
    grid = data(with_holes((2, 2), (0, 0), (4, 4), (5, 4)))
    assert grid.rim is not None
    # Four around the node inside, one at the corner, and one beside the two at the edge.
    assert grid.rim.cell.tolist() == [0, 5, 6, 9, 10, 15]
    triangles = grid.rim.triangles(grid.points.reshape(-1, 3))
    assert np.isfinite(triangles).all()
    assert area(triangles) == 6 / 2
    assert len(grid.rim.points) == 0


def test_a_triangle_from_end_to_end_of_the_heights_is_a_pole() -> None:
    grid = data([[9, 1, 1], [-9, np.nan, 1], [1, 1, 1]], z=(-2, 2))
    assert grid.rim is not None
    assert grid.rim.cell.tolist() == [1, 2, 3]


MODES = ["fill", "mesh", "fill+mesh", "facets", "waterfall", "wire"]


@pytest.mark.parametrize("view", [{}, {"projection": "top"}, {"projection": perspective(3)}])
@pytest.mark.parametrize("mode", MODES)
def test_triangles_are_drawn_and_picked(mode: str, view: Any) -> None:
    """A plane of two triangles and two cells; pixels away from its outline."""
    canvas = Canvas(120, 90)
    z = np.array([[np.nan, -1, -2], [-1, -2, np.nan]])
    plot = surface(z, (0, 1), (0, 2), mode=mode, lines=14, on=canvas, **view)
    inside, outside = [(0.8, 0.5), (0.4, 1.4)], [(0.2, 0.3), (0.8, 1.8)]
    for shown, places in ((True, inside), (False, outside)):
        for x, y in places:
            px, py = np.rint(plot.project((x, y, -x - y))[:2]).astype(int)
            picked = plot.pick(px, py)
            if mode in ("fill", "fill+mesh", "facets"):
                assert (canvas.array[py, px] > 0) == shown
            assert (picked is not None) == shown
            if picked:
                assert picked[2] == pytest.approx(-picked[0] - picked[1])
    if mode in ("mesh", "fill+mesh"):  # the side that is no line of the grid
        px, py = np.rint(plot.project((0.5, 0.5, -1))[:2]).astype(int)
        assert (canvas.array[py - 1 : py + 2, px - 1 : px + 2] == 14).any()


@pytest.mark.parametrize(("level", "missing"), [(2.9, 0), (3.1, 1), (4.1, 1), (5.1, 0)])
def test_contours_cross_triangles(level: float, missing: float) -> None:
    """Lines at 45 degrees; around the missing node (2, 2) a square of diagonals lacks."""
    lines, whole = (contours(data(z), level) for z in (with_holes((2, 2)), with_holes()))
    ends = np.concatenate((lines.starts, lines.ends))
    assert ends[:, 0] + ends[:, 1] == pytest.approx(level)
    assert length(whole) - length(lines) == pytest.approx(np.sqrt(2) * missing)


def length(lines: Any) -> float:
    return float(np.hypot(*(lines.ends - lines.starts)[:, :2].T).sum())


def test_contours_go_on_to_the_rim_of_a_function() -> None:
    """At half its height a dome over half of a disk has half a circle of contours."""

    def half(x: Doubles, y: Doubles) -> Doubles:
        return np.where(x > 0.013, np.sqrt(np.maximum(1 - x * x - y * y, 0)), np.nan)

    lines = contours(sample(half, (-1, 1), (-1, 1), 60), np.sqrt(3) / 2)
    assert length(lines) == pytest.approx(np.pi / 2 - 2 * 0.013, abs=0.01)


@pytest.mark.parametrize("mode", ["fill", "waterfall"])
def test_triangles_hide_contours_and_lines_behind_them(mode: str) -> None:
    """A wall of one row of triangles before a slope."""
    z = np.array([[0.0, 0, 0], [0.1, 0.1, 0.1], [5, 5, 5], [0, np.nan, 0]])
    pictures = []
    for missing in (False, True):
        canvas = Canvas(160, 120)
        shape = np.where(np.isnan(z), 0.0, z) if not missing else z
        surface(shape, mode=mode, contours=[0.05], lines=14, projection="front", on=canvas)
        pictures.append(canvas.array == 14)
    whole, triangles = pictures
    assert not (triangles & ~whole)[:100].any()


@pytest.mark.parametrize("color", ["slope", "light"])
def test_slopes_beside_a_hole_are_those_of_the_other_side(color: str) -> None:
    grids = (data(with_holes((2, 2), (5, 4))), data(with_holes()))
    with_hole, whole = (field(color, grid, np.eye(4)) for grid in grids)
    there = np.isfinite(grids[0].z)
    assert with_hole.value[there] == pytest.approx(whole.value[there])


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "facets"])
def test_triangles_of_a_sheet(mode: str) -> None:
    """Those of a surface, seen from above."""
    z = with_holes((2, 2), (0, 0))
    how: Any = {"mode": mode, "lines": 14, "projection": "top", "zfrac": 0.3}
    one, two = Canvas(120, 90), Canvas(120, 90)
    surface(z, *NODES, on=one, **how)
    sheet(*np.meshgrid(*NODES, indexing="ij"), z, on=two, **how)
    assert ((one.array > 0) == (two.array > 0)).all()
