"""The ways to draw a surface, each by the floating horizon where it can, else by the painter.

    fill       every pixel in the colour of its value
    mesh       the lines of the grid, hidden ones removed
    fill+mesh  both
    waterfall  only the lines of constant x, hidden ones removed
    wire       the lines of the grid, all of them
    facets     every cell in one colour

The horizon needs one surface without holes that is not seen on its edge, and a system of pixels.
Everything else is drawn cell by cell: holes, several surfaces, drawings made of polygons.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from surfaces.arrays import Doubles
from surfaces.shape.contours import contours
from surfaces.shape.fields import Field
from surfaces.shape.grid import Grid, Interval
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import Pen
from surfaces.visible import horizon, painter, sight
from surfaces.visible.horizon import Horizon, Segments
from surfaces.visible.order import back_to_front
from surfaces.visible.picking import Triangles, pick
from surfaces.visible.sweep import Sweep


@dataclass(frozen=True)
class Picture:
    """Surfaces over the same x and y, and how they are to be drawn."""

    pen: Pen
    grids: tuple[Grid, ...]
    fields: tuple[Field, ...]
    """For each surface the field that its colours show."""
    view: View
    palette: Palette
    ink: int
    """The colour of lines..."""
    under_ink: int
    """... and where the under side is seen."""
    every: int
    """How many lines of the grid make one line of the mesh."""

    @cached_property
    def sweeps(self) -> list[Sweep]:
        """The columns of each surface."""
        return [Sweep(grid, self.view, self.pen.width, self.pen.height) for grid in self.grids]

    @cached_property
    def swept(self) -> bool:
        """Whether the floating horizon can do it."""
        alone = len(self.grids) == 1 and not self.pen.vector
        return alone and bool(self.grids[0].whole.all()) and not self.sweeps[0].edge_on

    @cached_property
    def horizon(self) -> Horizon:
        """The horizon of a surface that is swept."""
        return Horizon(self.sweeps[0])

    @cached_property
    def rims(self) -> Triangles:
        """Parts of cells at the rims of holes."""
        found = [g.rim.triangles(g.points.reshape(-1, 3)) for g in self.grids if g.rim is not None]
        space = np.concatenate([np.zeros((0, 3, 3)), *found])
        return Triangles(space, apply(space, self.view.screen)[..., :2])

    def cells(self, every: int = 1) -> painter.Cells:
        """The cells in painting order; with ``every``, each as large as that many by as many."""
        return painter.of_grids(self.grids, self.fields, self.view, every)

    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point (x, y, z) at a pixel, or None."""
        holes = [~grid.whole for grid in self.grids]
        return pick(self.sweeps, holes, self.rims, self.view, px, py)


def _fill(picture: Picture) -> None:
    picture.palette.load(picture.pen)
    if not picture.swept:
        painter.shade(picture.pen, picture.palette, picture.cells())
        return
    for part in horizon.fill(picture.sweeps[0], picture.fields[0].value):
        shades = picture.palette.shade(part.value, part.x, part.y, part.under)
        picture.pen.pixels(part.x, part.y, shades)


def _facets(picture: Picture) -> None:
    picture.palette.load(picture.pen)
    painter.paint(picture.pen, picture.palette, picture.cells())


def _wire(picture: Picture) -> None:
    for grid in picture.grids:
        painter.wire(
            picture.pen, grid.points, picture.view, picture.every, picture.ink, grid.joined
        )
        pieces, _ = grid.loose_ends(picture.every)
        starts, ends = apply(pieces, picture.view.screen)[..., :2].swapaxes(0, 1)
        picture.pen.lines(starts, ends, picture.ink)


def _mesh(picture: Picture) -> None:
    if picture.swept:
        for segments in horizon.mesh(picture.sweeps[0], picture.every, picture.every):
            _draw(picture, segments)
    else:
        painter.paint_mesh(picture.pen, picture.cells(picture.every), picture.ink)


def _fill_and_mesh(picture: Picture) -> None:
    if picture.swept:
        _fill(picture)
        _mesh(picture)
    else:
        picture.palette.load(picture.pen)
        cells = picture.cells(picture.every)
        painter.paint(picture.pen, picture.palette, cells, picture.ink or painter.DARK)


def _waterfall(picture: Picture) -> None:
    if picture.swept:
        for segments in horizon.mesh(picture.sweeps[0], picture.every, None):
            _draw(picture, segments)
        return
    # Strip by strip toward the eye: each covers what is behind it, and shows its far line.
    for grid in picture.grids:
        i, _ = grid.lines(picture.every)
        pieces, of_x = grid.loose_ends(picture.every)
        loose = apply(pieces, picture.view.screen)[..., :2]
        nodes = apply(grid.points[i], picture.view.screen)[..., :2]
        rows = back_to_front(nodes, picture.view.eye)
        lines = back_to_front(grid.x[i][:, None], picture.view.eye)[:, 0]
        joined = back_to_front(grid.joined[1][i], picture.view.eye)
        for k in range(len(rows)):
            behind, front = rows[k], rows[min(k + 1, len(rows) - 1)]
            corners = np.stack((behind[:-1], behind[1:], front[1:], front[:-1]), axis=1)
            there = joined[k] & joined[min(k + 1, len(rows) - 1)]
            picture.pen.polygons(corners[there], painter.BACKGROUND, painter.BACKGROUND)
            picture.pen.lines(behind[:-1][joined[k]], behind[1:][joined[k]], picture.ink)
            ends = loose[of_x & (pieces[:, 0, 0] == lines[k])]
            picture.pen.lines(ends[:, 0], ends[:, 1], picture.ink)


def _draw(picture: Picture, segments: Segments) -> None:
    """The visible pixels of lines on the surface."""
    inks = np.array((picture.ink, picture.under_ink))
    for x, y, under in horizon.visible(picture.sweeps[0], picture.horizon, segments):
        picture.pen.pixels(x, y, inks.take(under.astype(np.int64)))


def draw_contours(picture: Picture, levels: list[float]) -> None:
    """Contour lines on the surfaces, where they are seen."""
    for grid in picture.grids:
        for level in levels:
            lines = contours(grid, level)
            starts, ends = (
                apply(p, picture.view.screen)[:, :2] for p in (lines.starts, lines.ends)
            )
            if picture.swept:
                owner = picture.sweeps[0].nearer_line(lines.cell)
                _draw(picture, Segments(starts, ends, owner))
            else:
                middle = (lines.starts + lines.ends) / 2
                seen = sight.seen(picture.sweeps, middle)
                picture.pen.lines(starts[seen], ends[seen], picture.ink)


def draw_floor(picture: Picture, levels: list[float], floor: float, limits: Interval) -> None:
    """Contour lines on the box's floor (or ceiling), each in the colour of its level."""
    low, high = limits
    for level in levels:
        part = np.array([(level - low) / ((high - low) or 1.0)])
        color = int(picture.palette.bands(part)[0])
        for grid in picture.grids:
            lines = contours(grid, level)
            ends = np.stack((lines.starts, lines.ends))
            ends[..., 2] = floor
            starts, stops = apply(ends, picture.view.screen)[..., :2]
            picture.pen.lines(starts, stops, color)


MODES: dict[str, Callable[[Picture], None]] = {
    "fill": _fill,
    "mesh": _mesh,
    "fill+mesh": _fill_and_mesh,
    "waterfall": _waterfall,
    "wire": _wire,
    "facets": _facets,
}
