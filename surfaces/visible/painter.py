"""Surfaces made of cells: painted back to front, or each pixel by its depth.

The painter's algorithm (Newell, Newell and Sancha, 1972): paint what is farthest first, and let
what is nearer cover it. `visible.order` gives the order. Where cells pass through one another there
is none; a depth for every pixel (`visible.depth`) is right even there, so "fill" takes that.

Holes, facets, several surfaces, parametric ones, and drawings made of polygons are drawn this way.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape.cells import every_nth
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import BLACK, DARKGRAY, Pen
from surfaces.visible.depth import DepthBuffer
from surfaces.visible.lattice import BLOCK, Cells, Lattice

BACKGROUND = BLACK


@dataclass(frozen=True)
class Easel:
    """What a picture is painted with, and how it is seen."""

    pen: Pen
    palette: Palette
    view: View
    ink: int
    """The colour of lines..."""
    under_ink: int
    """... and where the under side is seen."""
    every: int
    """How many lines of the grid make one line of the mesh."""

    def load_palette(self) -> None:
        """Load the ramps' colours, where the screen has a palette for them."""
        self.palette.load(self.pen)


@dataclass(frozen=True)
class Picture(ABC):
    """A surface made of cells, and what it is painted with."""

    easel: Easel

    @property
    def view(self) -> View:
        """How it is seen."""
        return self.easel.view

    @cached_property
    def depths(self) -> DepthBuffer:
        """How near to the eye it is at every pixel."""
        easel = self.easel
        return DepthBuffer(easel.pen, easel.palette, easel.view, self.cells())

    @abstractmethod
    def cells(self) -> Iterator[Cells]:
        """The cells, some at a time, in any order."""

    @abstractmethod
    def painted(self, every: int = 1) -> Iterator[Cells]:
        """Cells in painting order, some at a time, each `every` by `every` cells of the grid."""

    @abstractmethod
    def wires(self) -> Iterator[tuple[Doubles, Doubles]]:
        """All lines of the mesh on the screen, some at a time: where they start and end, (n, 2)."""

    @abstractmethod
    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point (x, y, z) at a pixel, or None."""


def fill(picture: Picture) -> None:
    """Colour smoothly, each pixel by its depth; whole cells where a system is made of polygons."""
    easel = picture.easel
    easel.load_palette()
    if easel.pen.vector:
        _paint(easel, picture.painted(), BACKGROUND)
    else:
        picture.depths.draw()


def add(picture: Picture, drawn: Picture) -> None:
    """Fill one surface into the picture of another, each hidden where the other is nearer."""
    easel = picture.easel
    easel.load_palette()
    if easel.pen.vector:  # whole cells, by their middles
        shown = (cells.subset(drawn.depths.shows(cells.middles)) for cells in picture.painted())
        _paint(easel, shown, BACKGROUND)
    else:
        drawn_cells = drawn.cells()
        DepthBuffer(easel.pen, easel.palette, easel.view, picture.cells(), drawn_cells).draw()


def mesh(picture: Picture) -> None:
    """Each cell covers what lies behind it with the background, and then shows its outline."""
    easel = picture.easel
    for cells in picture.painted(easel.every):
        easel.pen.polygons(cells.polygons, BACKGROUND, easel.ink)


def fill_and_mesh(picture: Picture) -> None:
    """The cells of the mesh in one colour each, and their outlines."""
    easel = picture.easel
    easel.load_palette()
    # fillpoly draws no outline in the background's colour: dark gray stands in.
    _paint(easel, picture.painted(easel.every), easel.ink or DARKGRAY)


def wire(picture: Picture) -> None:
    """The lines of the mesh, all of them."""
    for starts, ends in picture.wires():
        picture.easel.pen.lines(starts, ends, picture.easel.ink)


def facets(picture: Picture) -> None:
    """Every cell in one colour, without an outline."""
    picture.easel.load_palette()
    _paint(picture.easel, picture.painted(), BACKGROUND)


MODES: dict[str, Callable[[Picture], None]] = {
    "fill": fill,
    "mesh": mesh,
    "fill+mesh": fill_and_mesh,
    "wire": wire,
    "facets": facets,
}
FILLED = ("fill", "fill+mesh", "facets")
"""The modes whose lines are black unless told otherwise."""


def _paint(easel: Easel, blocks: Iterator[Cells], outline: int) -> None:
    for cells in blocks:
        value = cells.values.take(cells.corners).sum(axis=0) / 4
        easel.pen.polygons(cells.polygons, easel.palette.bands(value, cells.under), outline)


def mesh_lines(
    lattice: Lattice, view: View, every: int, joined: tuple[Bools, Bools]
) -> Iterator[tuple[Doubles, Doubles]]:
    """The lines of a lattice's mesh on the screen, some at a time: both ends, (n, 2).

    `joined` says which neighbours in a column, and in a row, a line joins.
    """
    ways = lattice.x, lattice.y, lattice.z
    rows, columns = (every_nth(count, every) for count in lattice.z.shape)
    in_column, in_row = joined
    yield from _chains(list(ways), rows, view, in_row)
    yield from _chains([way.T for way in ways], columns, view, in_column.T)


def _chains(
    ways: list[Doubles], chosen: Ints, view: View, joined: Bools
) -> Iterator[tuple[Doubles, Doubles]]:
    """Some of the lines along the rows of three arrays, x, y and z of their nodes."""
    step = max(1, BLOCK // ways[0].shape[1])
    for start in range(0, len(chosen), step):
        lines = chosen[start : start + step]
        nodes = np.stack(view.places(*(way[lines] for way in ways)), axis=-1)
        starts, ends, there = nodes[:, :-1], nodes[:, 1:], joined[lines]
        if there.all():
            yield starts.reshape(-1, 2), ends.reshape(-1, 2)
        else:
            yield starts[there], ends[there]
