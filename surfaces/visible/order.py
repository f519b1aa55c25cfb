"""Which cell hides which: the painter's order, without sorting where that can be.

The cells of z = f(x, y) stand between vertical planes x = x[i]. A ray of light on its way to the
eye crosses all these planes in one direction, the one in which the eye lies; so drawing the cells
plane by plane toward the eye, what comes later may hide what came before, and never the reverse.
The same holds for y. That is exact, needs no depths, and needs no sorting.

It stays true when the surface is turned, reflected or sheared, with the direction of the eye as
seen from the surface (see `surfaces.space.view`).

Several surfaces over the same grid take turns cell by cell, in each the one farthest from the eye
first: right as long as they do not cross inside a cell. Cells anywhere in space are sorted by the
depth of their middles, which is right to within a cell.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape.cells import every_nth, quads, with_three_corners
from surfaces.shape.fields import Field
from surfaces.shape.grid import Grid
from surfaces.shape.rim import Rim
from surfaces.space.transforms import apply
from surfaces.space.view import View

Item = TypeVar("Item", bound=np.generic)


def back_to_front(field: NDArray[Item], eye: Doubles) -> NDArray[Item]:
    """A view of a field over the grid, shape (nx, ny, ...), whose last entry is the nearest.

    `eye` is the direction of the eye as seen from the surface. A component of zero leaves a free
    choice, for then the cells on that axis do not hide one another.
    """
    return field[:: 1 if eye[0] >= 0 else -1, :: 1 if eye[1] >= 0 else -1]


def painting_order(view: View, x: Doubles, y: Doubles) -> tuple[Any, Any]:
    """The index that brings the cells between lines of x and y into order, the nearest last."""
    if view.parallel:
        ways = (slice(None, None, 1 if eye >= 0 else -1) for eye in view.eye[:2])
        return next(ways), next(ways)
    return _approach(x, view.eye[0])[:, np.newaxis], _approach(y, view.eye[1])


def _approach(lines: Doubles, eye: float) -> Ints:
    """The strips between lines, from both sides toward the one in which the eye is.

    Whichever way a ray leads from an eye near by, it meets them in the opposite order.
    """
    away = np.maximum(lines[:-1] - eye, eye - lines[1:])
    strips: Ints = np.argsort(-away, kind="stable")
    return strips


@dataclass(frozen=True)
class Cells:
    """Cells of surfaces, in painting order: the nearest last."""

    nodes: Doubles
    """(k, 3): the nodes in space."""
    values: Doubles
    """(k,): the field there, 0 to 1."""
    corners: Ints
    """(m, 4): for each cell its nodes, counterclockwise as seen from the upper side."""
    view: View

    @property
    def screen(self) -> Doubles:
        """(m, 4, 2): where the corners appear."""
        return apply(self.nodes, self.view.screen)[:, :2][self.corners]

    def under(self, screen: Doubles) -> Bools:
        """(m,): whether the under side is seen, where the corners appear as in `screen`."""
        (ax, ay), (bx, by) = (screen[:, 2] - screen[:, 0]).T, (screen[:, 3] - screen[:, 1]).T
        # Counterclockwise in space is clockwise on the screen, or not: as the axes are drawn.
        right, down = self.view.arrows.T
        return np.asarray((ax * by - ay * bx) * (np.cross(right, down) @ self.view.eye) < 0)


def cells_of_grids(grids: Sequence[Grid], fields: Sequence[Field], view: View, every: int) -> Cells:
    """The cells of surfaces over the same x and y; holes left out.

    `fields` are over the nodes, one for each surface. Cells are `every` by `every` cells of the
    grid in one.
    """
    thin = [grid.thinned(every) for grid in grids]
    i, j = grids[0].lines(every)
    nodes = np.stack([grid.points for grid in thin])
    index = np.arange(nodes[..., 0].size).reshape(nodes.shape[:3])
    corners = np.stack([quads(one[..., None])[..., 0] for one in index], axis=2)
    whole = np.stack([grid.whole for grid in thin], axis=2)
    if len(grids) > 1:
        # Of two surfaces one above the other, the one on the eye's side is the nearer.
        height = np.nan_to_num(nodes[..., 2].ravel()[corners].mean(axis=3))
        eye = view.eye[2]
        near = height * np.sign(eye) if view.parallel else -np.abs(height - eye)
        order = np.argsort(near, axis=2)
        whole = np.take_along_axis(whole, order, axis=2)
        corners = np.take_along_axis(corners, order[..., None], axis=2)
    sequence = painting_order(view, thin[0].x, thin[0].y)
    there = whole[sequence]
    values = np.stack([field.value[np.ix_(i, j)] for field in fields])
    cells = Cells(nodes.reshape(-1, 3), values.ravel(), corners[sequence][there], view)
    if any(grid.rim is not None for grid in thin):
        cells = _with_rims(cells, thin, fields, index, there)
    return cells


def _with_rims(
    cells: Cells, grids: Sequence[Grid], fields: Sequence[Field], index: Ints, there: Bools
) -> Cells:
    """Add the parts of cells at the rims of holes, each where its cell is in the painter's order.

    `index` are the numbers of each grid's nodes, (grids, nx+1, ny+1); `there` says which cells, in
    painting order, are among the others, (nx, ny, grids).
    """
    order = np.ravel_multi_index(np.nonzero(there)[:2], there.shape[:2])
    ranks = np.empty(there.shape[:2], dtype=np.int64)
    ranks[painting_order(cells.view, grids[0].x, grids[0].y)] = np.arange(ranks.size).reshape(
        ranks.shape
    )
    for grid, field, nodes in zip(grids, fields, index, strict=True):
        if grid.rim is not None:
            own = range(nodes[0, 0], nodes[-1, -1] + 1)
            cells, order = _with_rim(cells, grid.rim, field, own, order, ranks.ravel())
    return cells


def _with_rim(
    cells: Cells, rim: Rim, field: Field, nodes: range, order: Ints, ranks: Ints
) -> tuple[Cells, Ints]:
    """Add the parts of cells at the rims of one grid's holes, and their places in the order.

    `nodes` are the grid's among those of the cells; `order`, (m,), is where in the painter's order
    the cells are, `ranks`, (nx * ny,), where any cell would be.
    """
    on_rim = rim.corners >= len(nodes)
    corners = rim.corners + np.where(on_rim, len(cells.nodes) - len(nodes), nodes.start)
    orders = np.concatenate((order, ranks[rim.cell]))
    sequence = np.argsort(orders, kind="stable")
    values = field.at(rim.points, cells.values[rim.beside + nodes.start])
    more = Cells(
        np.concatenate((cells.nodes, rim.points)),
        np.concatenate((cells.values, values)),
        np.concatenate((cells.corners, corners))[sequence],
        cells.view,
    )
    return more, orders[sequence]


def cells_of_points(points: Doubles, value: Doubles, view: View, every: int) -> Cells:
    """The cells of a sheet of points, (nu+1, nv+1, 3), by depth, triangles at the rims of holes."""
    i, j = (every_nth(count, every) for count in value.shape)
    nodes = points[np.ix_(i, j)].reshape(-1, 3)
    corners = quads(np.arange(len(nodes)).reshape(len(i), len(j), 1))[..., 0]
    corners = corners.reshape(-1, 4)
    there = np.isfinite(nodes[:, 2])[corners]
    if not there.all():
        _, triangles = with_three_corners(corners, there)
        corners = np.concatenate((corners[there.all(axis=1)], triangles))
    order = np.argsort(view.nearness(nodes)[corners].mean(axis=1), kind="stable")
    return Cells(nodes, value[np.ix_(i, j)].ravel(), corners[order], view)
