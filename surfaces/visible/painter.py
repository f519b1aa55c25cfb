"""Surfaces as cells: painted back to front, or each pixel by its depth.

For holes, facets, several surfaces, parametric ones, and drawings made of polygons. Cells of a grid
have an exact order, `visible.order` says which. Several surfaces over the same grid are painted
cell by cell, in each the one farthest from the eye first: right as long as they do not cross inside
a cell. Cells anywhere in space are painted by the depth of their middles, which is right to within
a cell. A depth for every pixel (`visible.depth`) is always right.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape.cells import every_nth, quads
from surfaces.shape.fields import Field
from surfaces.shape.grid import Grid
from surfaces.shape.rim import Rim
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import Pen
from surfaces.visible.depth import DepthBuffer
from surfaces.visible.order import back_to_front

BACKGROUND = 0
# Outlines in the background's colour are not drawn by fillpoly: DARKGRAY stands in.
DARK = 8


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
        right, down = self.view.screen[:3, :2].T
        return np.asarray((ax * by - ay * bx) * (np.cross(right, down) @ self.view.eye) < 0)


def of_grids(grids: Sequence[Grid], fields: Sequence[Field], view: View, every: int) -> Cells:
    """The cells of surfaces over the same x and y; holes left out.

    ``fields`` are over the nodes, one for each surface. With ``every``, cells are as large
    as so many by so many.
    """
    thin = [grid.thinned(every) for grid in grids]
    i, j = grids[0].lines(every)
    nodes = np.stack([grid.points for grid in thin])
    index = np.arange(nodes[..., 0].size).reshape(nodes.shape[:3])
    corners = np.stack([quads(one[..., None])[..., 0] for one in index], axis=2)
    whole = np.stack([grid.whole for grid in thin], axis=2)
    if len(grids) > 1:
        # Of two surfaces one above the other, the one on the eye's side is the nearer.
        height = np.nan_to_num(nodes[..., 2].ravel()[corners].mean(axis=3)) * np.sign(view.eye[2])
        order = np.argsort(height, axis=2)
        whole = np.take_along_axis(whole, order, axis=2)
        corners = np.take_along_axis(corners, order[..., None], axis=2)
    there = back_to_front(whole, view.eye)
    shades = np.stack([field.value[np.ix_(i, j)] for field in fields])
    cells = Cells(
        nodes.reshape(-1, 3), shades.ravel(), back_to_front(corners, view.eye)[there], view
    )
    if any(grid.rim is not None for grid in thin):
        cells = _with_rims(cells, thin, fields, index, there)
    return cells


def _with_rims(
    cells: Cells,
    grids: Sequence[Grid],
    fields: Sequence[Field],
    index: Ints,
    there: Bools,
) -> Cells:
    """Add the parts of cells at the rims of holes, each where its cell is in the painter's order.

    `index` are the numbers of each grid's nodes, `there` says which cells, in painting order, are
    among the others.
    """
    order = np.ravel_multi_index(np.nonzero(there)[:2], there.shape[:2])
    ranks = np.empty(there.shape[:2], dtype=np.int64)
    back_to_front(ranks, cells.view.eye)[:] = np.arange(ranks.size).reshape(ranks.shape)
    for grid, field, nodes in zip(grids, fields, index, strict=True):
        if grid.rim is not None:
            own = range(nodes[0, 0], nodes[-1, -1] + 1)
            cells, order = _with_rim(cells, grid.rim, field, own, order, ranks.ravel())
    return cells


def _with_rim(
    cells: Cells, rim: Rim, field: Field, nodes: range, order: Ints, ranks: Ints
) -> tuple[Cells, Ints]:
    """Add parts of cells at the rims of holes, each where its cell is in the painter's order.

    `nodes` are the grid's among those of the cells; `order` is where in it the cells are, `ranks`
    where any cell would be.
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


def of_points(points: Doubles, value: Doubles, view: View, every: int) -> Cells:
    """The cells of a sheet of points, (nu+1, nv+1, 3), by depth; those with a hole left out."""
    i, j = (every_nth(count, every) for count in value.shape)
    nodes = points[np.ix_(i, j)].reshape(-1, 3)
    corners = quads(np.arange(len(nodes)).reshape(len(i), len(j), 1))[..., 0]
    near = (nodes @ view.eye)[corners].mean(axis=2)
    there = np.isfinite(near)
    order = np.argsort(near[there], kind="stable")
    return Cells(nodes, value[np.ix_(i, j)].ravel(), corners[there][order], view)


def paint(pen: Pen, palette: Palette, cells: Cells, outline: int = BACKGROUND) -> None:
    """Cells of one colour each; an outline in the background's colour is not drawn."""
    screen = cells.screen
    value = sum(cells.values[corner] for corner in cells.corners.T) / 4
    pen.polygons(screen, palette.bands(value, cells.under(screen)), outline)


def paint_mesh(pen: Pen, cells: Cells, ink: int) -> None:
    """Each cell covers what lies behind it with the background, and then shows its outline."""
    pen.polygons(cells.screen, BACKGROUND, ink)


def shade(pen: Pen, palette: Palette, cells: Cells) -> None:
    """Cells smoothly coloured, each pixel by its depth; polygons where a system is made of them."""
    if pen.vector or not len(cells.corners):
        paint(pen, palette, cells)
        return
    buffer = DepthBuffer(pen, palette)
    screen, near = cells.screen, (cells.nodes @ cells.view.eye)[cells.corners]
    near = (near - near.min()) / (np.ptp(near) or 1.0)
    buffer.add(screen, near, cells.values[cells.corners], cells.under(screen))
    buffer.draw()


def wire(
    pen: Pen,
    points: Doubles,
    view: View,
    every: int,
    ink: int,
    joined: tuple[Bools, Bools] | None = None,
) -> None:
    """All lines of a sheet of points, (nu+1, nv+1, 3), hidden or not.

    `joined` says which neighbours along u, and along v, a line joins: all, if None.
    """
    nodes = apply(points, view.screen)[..., :2]
    i, j = (every_nth(count, every) for count in points.shape[:2])
    across, along = nodes[i], nodes[:, j]
    starts = np.concatenate((across[:, :-1].reshape(-1, 2), along[:-1].reshape(-1, 2)))
    ends = np.concatenate((across[:, 1:].reshape(-1, 2), along[1:].reshape(-1, 2)))
    there = np.isfinite(starts + ends).all(axis=1)
    if joined is not None:
        along_u, along_v = joined
        there &= np.concatenate((along_v[i].ravel(), along_u[:, j].ravel()))
    pen.lines(starts[there], ends[there], ink)
