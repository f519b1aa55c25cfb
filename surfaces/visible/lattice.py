"""Surfaces of every kind as lattices, nodes in rows and columns, and some of their cells.

Cells are made some at a time, with copies of their nodes: so these stay in the cache, and a picture
of millions of cells takes little more memory than its nodes do.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape import rim
from surfaces.shape.cells import all_corners, every_nth
from surfaces.shape.fields import Field
from surfaces.shape.grid import Grid
from surfaces.shape.rim import Rim
from surfaces.shape.sheet import Sheet
from surfaces.space.view import View
from surfaces.systems import trace

BLOCK = 1 << 14
"""Nodes of a block, or corners: the arrays that are made of them stay in the cache."""


@dataclass(frozen=True)
class Cells:
    """Some cells of surfaces."""

    nodes: Doubles
    """(3, k): x, y and z of the nodes in space."""
    values: Doubles
    """(k,): the field there, 0 to 1."""
    corners: Ints
    """(4, m): for each cell its nodes, counterclockwise as seen from the upper side."""
    view: View

    @cached_property
    def screen(self) -> tuple[Doubles, Doubles]:
        """Where the nodes appear: x and y, (k,) each."""
        return self.view.places(*self.nodes)

    @cached_property
    def near(self) -> Doubles:
        """(k,): how near the nodes are."""
        return self.view.nearness(self.nodes.T)

    @cached_property
    def under(self) -> Bools:
        """(m,): whether the under side is seen."""
        x, y = (way.take(self.corners) for way in self.screen)
        ax, ay, bx, by = x[2] - x[0], y[2] - y[0], x[3] - x[1], y[3] - y[1]
        # Counterclockwise in space is clockwise on the screen, or not: as the axes are drawn.
        way = np.linalg.det(np.column_stack((self.view.arrows, self.view.eye)))
        return np.asarray((ax * by - ay * bx) * way < 0)

    @property
    def polygons(self) -> Ints:
        """(m, 4, 2): the pixels of the corners."""
        with np.errstate(invalid="ignore"):  # a node in a hole is no cell's corner
            nodes = trace.rounded(np.stack(self.screen, axis=1))
        return nodes.take(self.corners.T, axis=0)

    @property
    def middles(self) -> Doubles:
        """(m, 3): the means of the corners in space."""
        mean: Doubles = self.nodes[:, self.corners].mean(axis=1).T
        return mean

    def subset(self, which: Bools) -> "Cells":
        """Some of them, with the same nodes."""
        return Cells(self.nodes, self.values, self.corners[:, which], self.view)


@dataclass(frozen=True)
class Lattice:
    """The nodes of a surface in rows and columns: arrays of (nx+1, ny+1)."""

    x: Doubles
    y: Doubles
    z: Doubles
    values: Doubles
    """The field at the nodes, 0 to 1."""
    whole: Bools
    """(nx, ny): which cells are part of the surface."""
    rim: tuple[Rim, Doubles] | None = None
    """Parts of cells at the rims of holes, and the field at its points."""

    @classmethod
    def of_grid(cls, grid: Grid, field: Field, every: int = 1) -> "Lattice":
        """The nodes of a height field, or every n-th of them in each direction."""
        thin, values = grid.thinned(every), field.value
        if every > 1:
            values = values[np.ix_(*grid.lines(every))]
        x = np.broadcast_to(thin.x[:, None], thin.z.shape)
        y = np.broadcast_to(thin.y, thin.z.shape)
        if thin.rim is None:
            return cls(x, y, thin.z, values, thin.whole)
        at_rim = field.at(thin.rim.points, values.ravel()[thin.rim.beside])
        return cls(x, y, thin.z, values, thin.whole, (thin.rim, at_rim))

    @classmethod
    def of_sheet(cls, sheet: Sheet, field: Field, every: int = 1) -> "Lattice":
        """The same of a surface anywhere in space."""
        points, values = sheet.points, field.value
        if every > 1:
            chosen = np.ix_(*(every_nth(count, every) for count in values.shape))
            points, values = points[chosen], values[chosen]
        x, y, z = np.moveaxis(points, -1, 0)
        there = np.isfinite(z)
        found = None if there.all() else (rim.of_data(z), np.zeros(0))
        return cls(x, y, z, values, all_corners(there), found)

    @property
    def around(self) -> Ints:
        """From the number of a cell's first corner, nodes counted row by row, to all four."""
        width = self.z.shape[1]
        return np.array((0, width, width + 1, 1))

    def corners(self, cells: Ints) -> Ints:
        """The numbers of the nodes at the corners of cells, (m,), counted row by row: (4, m)."""
        corners: Ints = cells + cells // (self.z.shape[1] - 1) + self.around[:, None]
        return corners

    @property
    def parts(self) -> Ints:
        """The corners of parts of cells, (4, m)."""
        return np.zeros((4, 0), np.int64) if self.rim is None else self.rim[0].corners.T

    def rows(self, rows: slice) -> tuple[Doubles, Doubles]:
        """The nodes of some rows, (3, k), and the field there, (k,)."""
        nodes = np.stack([way[rows] for way in (self.x, self.y, self.z)])
        return nodes.reshape(3, -1), self.values[rows].ravel()
