"""The ways to draw height fields: by the floating horizon where it can, else by the painter.

    fill       every pixel in the colour of its value
    mesh       the lines of the grid, hidden ones removed
    fill+mesh  both
    waterfall  only the lines of constant x, hidden ones removed
    wire       the lines of the grid, all of them
    facets     every cell in one colour

The horizon needs one surface without holes that is not seen on its edge, and a system of pixels.
Everything else is drawn cell by cell: holes, several surfaces, drawings made of polygons.
"""

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from surfaces.arrays import Bools, Doubles
from surfaces.shape.cells import quads, with_three_corners
from surfaces.shape.contours import contours
from surfaces.shape.grid import Grid
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.systems.trace import rounded
from surfaces.visible import horizon, painter
from surfaces.visible.horizon import Segments
from surfaces.visible.order import back_to_front
from surfaces.visible.painter import BACKGROUND, Easel
from surfaces.visible.picking import seen
from surfaces.visible.pictures import HeightPicture


def draw(picture: HeightPicture, mode: str) -> None:
    """Draw height fields in one of the `MODES`."""
    modes = SWEPT_MODES if mode in SWEPT_MODES and picture.swept else MODES
    modes[mode](picture)


# By the painter ------------------------------------------------------------------------------


class Row(NamedTuple):
    """One line of constant x, as the screen sees it."""

    x: float
    nodes: Doubles
    """(ny+1, 2)"""
    joined: Bools
    """(ny,): which neighbours a line joins."""
    loose: Doubles
    """(m, 2, 2): both ends of the pieces that lead on to the rim of a hole."""


def _waterfall(picture: HeightPicture) -> None:
    """Strip by strip toward the eye: each covers what is behind it, and shows its far line."""
    easel = picture.easel
    for grid in picture.grids:
        for rows in _toward_eye(list(_rows(grid, easel)), easel.view):
            for far, near in pairwise([*rows, rows[-1]]):
                _cover(easel, far, near)
                _draw_row(easel, far)


def _toward_eye(rows: list[Row], view: View) -> list[list[Row]]:
    """The lines as they are, or, with an eye near by above them, from both sides and the middle."""
    before = [row for row in rows if (row.x < view.eye[0]) == (rows[0].x < view.eye[0])]
    beyond = rows[len(before) :]
    if view.parallel or not beyond:
        return [rows]
    return [before, beyond[::-1], [before[-1], beyond[0]]]


def _rows(grid: Grid, easel: Easel) -> Iterator[Row]:
    """The lines of constant x of a mesh, the nearest last."""
    view = easel.view
    i, _ = grid.lines(easel.every)
    pieces, of_x = grid.loose_ends(easel.every)
    loose = apply(pieces, view.screen)[..., :2]
    x = back_to_front(grid.x[i][:, None], view.eye)[:, 0]
    nodes = back_to_front(apply(grid.points[i], view.screen)[..., :2], view.eye)
    joined = back_to_front(grid.joined[1][i], view.eye)
    for k in range(len(x)):
        yield Row(float(x[k]), nodes[k], joined[k], loose[of_x & (pieces[:, 0, 0] == x[k])])


def _cover(easel: Easel, far: Row, near: Row) -> None:
    """Hide with the background what lies behind the strip between two lines."""
    count = len(far.nodes)
    nodes = np.concatenate((far.nodes, near.nodes))
    corners = quads(np.arange(2 * count).reshape(2, count, 1))[0, ..., 0]
    _, triangles = with_three_corners(corners, np.isfinite(nodes[:, 0])[corners])
    corners = np.concatenate((corners[far.joined & near.joined], triangles))
    easel.pen.polygons(rounded(nodes[corners]), BACKGROUND, BACKGROUND)


def _draw_row(easel: Easel, row: Row) -> None:
    easel.pen.lines(row.nodes[:-1][row.joined], row.nodes[1:][row.joined], easel.ink)
    easel.pen.lines(row.loose[:, 0], row.loose[:, 1], easel.ink)


MODES: dict[str, Callable[[HeightPicture], None]] = {
    "fill": painter.fill,
    "mesh": painter.mesh,
    "fill+mesh": painter.fill_and_mesh,
    "waterfall": _waterfall,
    "wire": painter.wire,
    "facets": painter.facets,
}


# By the floating horizon -----------------------------------------------------------------------


def _swept_fill(picture: HeightPicture) -> None:
    easel = picture.easel
    easel.load_palette()
    for part in horizon.fill(picture.sweeps[0], picture.fields[0].value):
        shades = easel.palette.shade(part.value, part.x, part.y, part.under)
        easel.pen.pixels(part.x, part.y, shades)


def _swept_mesh(picture: HeightPicture) -> None:
    _draw_mesh(picture, picture.easel.every, picture.easel.every)


def _swept_fill_and_mesh(picture: HeightPicture) -> None:
    _swept_fill(picture)
    _swept_mesh(picture)


def _swept_waterfall(picture: HeightPicture) -> None:
    _draw_mesh(picture, picture.easel.every, None)


def _draw_mesh(picture: HeightPicture, x_every: int | None, y_every: int | None) -> None:
    for segments in horizon.mesh(picture.sweeps[0], x_every, y_every):
        _draw_segments(picture, segments)


def _draw_segments(picture: HeightPicture, segments: Segments) -> None:
    """The visible pixels of lines on the surface."""
    inks = np.array((picture.easel.ink, picture.easel.under_ink))
    for x, y, under in horizon.visible(picture.sweeps[0], picture.horizon, segments):
        picture.easel.pen.pixels(x, y, inks.take(under.astype(np.int64)))


SWEPT_MODES: dict[str, Callable[[HeightPicture], None]] = {
    "fill": _swept_fill,
    "mesh": _swept_mesh,
    "fill+mesh": _swept_fill_and_mesh,
    "waterfall": _swept_waterfall,
}


# Contours, in every mode ---------------------------------------------------------------------


def draw_contours(picture: HeightPicture, levels: list[float]) -> None:
    """Contour lines on the surfaces, where they are seen."""
    easel = picture.easel
    for grid in picture.grids:
        for level in levels:
            lines = contours(grid, level)
            starts, ends = (apply(p, easel.view.screen)[:, :2] for p in (lines.starts, lines.ends))
            middles = (lines.starts + lines.ends) / 2
            if not easel.view.parallel or grid.rim is not None:
                shown = ~picture.depths.hides(middles, _nearest(lines.corners, easel.view))
                easel.pen.lines(starts[shown], ends[shown], easel.ink)
            elif picture.swept:
                owner = picture.sweeps[0].nearer_line(lines.cell)
                _draw_segments(picture, Segments(starts, ends, owner))
            else:
                shown = seen(picture.sweeps, middles)
                easel.pen.lines(starts[shown], ends[shown], easel.ink)


def _nearest(corners: Doubles, view: View) -> Doubles:
    """How near the nearest corner of each of some cells, (m, 4, 3), is, and a cell's depth more."""
    near = view.nearness(corners)
    nearest: Doubles = 2 * near.max(axis=1) - near.min(axis=1)
    return nearest


def draw_floor(picture: HeightPicture, levels: list[float], floor: float) -> None:
    """Contour lines on the floor of the surface's box, or on its ceiling.

    Args:
        picture: The surfaces.
        levels: Heights, each drawn in the colour that stands for it: the first colour for the
            lowest point of the surfaces, the last for the highest.
        floor: The z of the floor.
    """
    easel = picture.easel
    boxes = [grid.box for grid in picture.grids]
    low, high = min(a[2] for a, _ in boxes), max(b[2] for _, b in boxes)
    if levels:
        easel.load_palette()
    for level in levels:
        part = np.array([(level - low) / ((high - low) or 1.0)])
        color = int(easel.palette.bands(part)[0])
        for grid in picture.grids:
            lines = contours(grid, level)
            ends = np.stack((lines.starts, lines.ends))
            ends[..., 2] = floor
            starts, stops = apply(ends, easel.view.screen)[..., :2]
            easel.pen.lines(starts, stops, color)
