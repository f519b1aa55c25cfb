"""The two kinds of picture: of height fields over a grid, and of a sheet anywhere in space."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from surfaces.arrays import Doubles
from surfaces.shape.fields import Field
from surfaces.shape.grid import Grid
from surfaces.shape.sheet import Sheet
from surfaces.space.transforms import apply
from surfaces.visible.horizon import Horizon
from surfaces.visible.lattice import Cells, Lattice
from surfaces.visible.order import by_depth, in_any_order, in_strips
from surfaces.visible.painter import Picture, mesh_lines
from surfaces.visible.picking import Tiles, Triangles, nearest, pick, pick_triangle
from surfaces.visible.sweep import Sweep


@dataclass(frozen=True)
class HeightPicture(Picture):
    """Surfaces z = f(x, y) over the same x and y."""

    grids: tuple[Grid, ...]
    fields: tuple[Field, ...]
    """For each surface the field that its colours show, all with the same limits."""

    @cached_property
    def sweeps(self) -> list[Sweep]:
        """The columns of each surface."""
        pen = self.easel.pen
        return [Sweep(grid, self.view, pen.width, pen.height) for grid in self.grids]

    @cached_property
    def swept(self) -> bool:
        """Whether the floating horizon can draw it: one surface, without holes, not on its edge.

        In a perspective the columns would have to fan out; and where a system is made of polygons,
        cells are better than the horizon's pixels.
        """
        alone = len(self.grids) == 1 and not self.easel.pen.vector and self.view.parallel
        return alone and bool(self.grids[0].whole.all()) and not self.sweeps[0].edge_on

    @cached_property
    def horizon(self) -> Horizon:
        """The horizon of a surface that is swept."""
        return Horizon(self.sweeps[0])

    @cached_property
    def rims(self) -> Triangles:
        """Parts of cells at the rims of holes."""
        found = [g.rim.triangles(g.points.reshape(-1, 3)) for g in self.grids if g.rim is not None]
        return Triangles.of(np.concatenate([np.zeros((0, 3, 3)), *found]), self.view)

    @cached_property
    def tiles(self) -> list[Tiles]:
        """Those of each surface, for a perspective, in which there are no columns."""
        return [Tiles(lattice, self.view) for lattice in self._lattices()]

    def _lattices(self, every: int = 1) -> list[Lattice]:
        return [
            Lattice.of_grid(grid, field, every)
            for grid, field in zip(self.grids, self.fields, strict=True)
        ]

    def cells(self) -> Iterator[Cells]:
        """The cells, some at a time, in any order."""
        return in_any_order(self._lattices(), self.view)

    def painted(self, every: int = 1) -> Iterator[Cells]:
        """Cells in painting order, some at a time, each `every` by `every` cells of the grid."""
        return in_strips(self._lattices(every), self.view)

    def wires(self) -> Iterator[tuple[Doubles, Doubles]]:
        """All lines of the mesh on the screen, and then those that lead on to the rim of a hole."""
        every = self.easel.every
        for grid, lattice in zip(self.grids, self._lattices(), strict=True):
            yield from mesh_lines(lattice, self.view, every, grid.joined)
            pieces, _ = grid.loose_ends(every)
            starts, ends = apply(pieces, self.view.screen)[..., :2].swapaxes(0, 1)
            yield starts, ends

    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point (x, y, z) at a pixel, or None."""
        if not self.view.parallel:
            near = Triangles.joined([tiles.near(px, py) for tiles in self.tiles])
            return pick_triangle(near, self.view, px, py)
        holes = [~grid.whole for grid in self.grids]
        return pick(self.sweeps, holes, self.rims, self.view, px, py)


@dataclass(frozen=True)
class SheetPicture(Picture):
    """A surface (x, y, z) = f(u, v).

    There are no columns and no grid order here, for a ring may hide itself in any view.
    """

    sheet: Sheet
    field: Field
    """The field that its colours show."""

    def cells(self) -> Iterator[Cells]:
        """The cells, some at a time, in any order."""
        return in_any_order([Lattice.of_sheet(self.sheet, self.field)], self.view)

    def painted(self, every: int = 1) -> Iterator[Cells]:
        """Cells in painting order, some at a time, each `every` by `every` cells of the grid."""
        return by_depth(Lattice.of_sheet(self.sheet, self.field, every), self.view)

    def wires(self) -> Iterator[tuple[Doubles, Doubles]]:
        """All lines of the mesh on the screen."""
        there = np.isfinite(self.sheet.points[..., 2])
        joined = there[:-1] & there[1:], there[:, :-1] & there[:, 1:]
        lattice = Lattice.of_sheet(self.sheet, self.field)
        yield from mesh_lines(lattice, self.view, self.easel.every, joined)

    @cached_property
    def _tiles(self) -> Tiles:
        return Tiles(Lattice.of_sheet(self.sheet, self.field), self.view)

    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point (x, y, z) at a pixel, or None."""
        return nearest(self._tiles.near(px, py).points_at(px, py), self.view)


@dataclass(frozen=True)
class Scene(Picture):
    """A picture to which another surface has been added."""

    parts: tuple[Picture, Picture]

    def cells(self) -> Iterator[Cells]:
        """The cells of both, some at a time, in any order."""
        for part in self.parts:
            yield from part.cells()

    def painted(self, every: int = 1) -> Iterator[Cells]:
        """Those of one after those of the other."""
        for part in self.parts:
            yield from part.painted(every)

    def wires(self) -> Iterator[tuple[Doubles, Doubles]]:
        """All lines of both meshes on the screen."""
        for part in self.parts:
            yield from part.wires()

    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point (x, y, z) of both at a pixel, or None."""
        found = [part.pick(px, py) for part in self.parts]
        return nearest([point for point in found if point is not None], self.view)
