"""Surfaces (u, v) -> (x, y, z): spheres, rings, bands, whatever two numbers can walk over.

There are no columns and no grid order here, for a ring may hide itself in any view. "fill" keeps a
depth for every pixel (`visible.depth`), which is right even where the surface passes through
itself. Modes with lines paint whole cells, the farthest first by the depth of their middles: that
is right to within a cell.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from surfaces.arrays import Doubles
from surfaces.shape.fields import Field, spread
from surfaces.shape.grid import Function, Interval, evaluate
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import Pen
from surfaces.visible import painter


@dataclass(frozen=True)
class Sheet:
    """A surface as points over u and v, (nu+1, nv+1, 3); points that are not finite are holes."""

    u: Doubles
    v: Doubles
    points: Doubles

    def field(self, color: str | Function) -> Field:
        """The field that ``color`` asks for: "z", or a function of u and v."""
        if color == "z":
            return spread(self.points[..., 2])
        if not callable(color):
            raise ValueError(f'color must be "z" or a function of u and v, not {color!r}')
        return spread(evaluate(color, *np.meshgrid(self.u, self.v, indexing="ij")))

    @property
    def box(self) -> tuple[Doubles, Doubles]:
        """The lowest and the highest corner of the box around it."""
        return np.nanmin(self.points, axis=(0, 1)), np.nanmax(self.points, axis=(0, 1))


def walk(f: Callable[[Any, Any], Any], u: Interval, v: Interval, n: int | tuple[int, int]) -> Sheet:
    """Evaluate f(u, v) -> (x, y, z) for arrays u and v of (nu+1, nv+1) numbers.

    ValueError unless u and v are (a, b) with a < b, n is 1 or more, f gives three coordinates, and
    a point is finite.
    """
    nu, nv = n if isinstance(n, tuple) else (n, n)
    if nu < 1 or nv < 1:
        raise ValueError(f"n must be at least 1 in each direction, not {n!r}")
    for name, interval in (("u", u), ("v", v)):
        if len(interval) != 2 or not -np.inf < interval[0] < interval[1] < np.inf:
            raise ValueError(f"{name} must be (a, b) with finite a < b, not {interval!r}")
    us, vs = np.linspace(*u, nu + 1), np.linspace(*v, nv + 1)
    across, along = np.meshgrid(us, vs, indexing="ij")
    with np.errstate(all="ignore"):
        place = f(across, along)
    if len(place) != 3:
        raise ValueError(f"f must return x, y and z, not {len(place)} values")
    points = np.stack([np.broadcast_to(c, across.shape) for c in place], axis=-1).astype(np.float64)
    points = np.where(np.isfinite(points).all(axis=-1, keepdims=True), points, np.nan)
    if np.isnan(points).all():
        raise ValueError(f"f has no finite point on u = {u!r}, v = {v!r}")
    return Sheet(us, vs, points)


@dataclass(frozen=True)
class SheetPicture:
    """A sheet, and how it is to be drawn."""

    pen: Pen
    sheet: Sheet
    value: Doubles
    """The field that its colours show, 0 to 1: (nu+1, nv+1)."""
    view: View
    palette: Palette
    ink: int
    every: int

    def cells(self, every: int = 1) -> painter.Cells:
        """The cells in painting order; with ``every``, each as large as that many by as many."""
        return painter.of_points(self.sheet.points, self.value, self.view, every)

    @cached_property
    def _cells(self) -> painter.Cells:
        return self.cells()

    @cached_property
    def _corners(self) -> Doubles:
        return self._cells.screen

    def pick(self, px: float, py: float) -> Doubles | None:
        """The nearest point at a pixel, or None."""
        cells = self._cells
        screen = self._corners - (px, py)
        near = (screen.min(axis=1) <= 0).all(axis=1) & (screen.max(axis=1) >= 0).all(axis=1)
        hits: list[Doubles] = []
        for points, at in zip(cells.nodes[cells.corners[near]], screen[near], strict=True):
            for triangle in ([0, 1, 2], [0, 2, 3]):
                # Weights that put the corners' mean at the pixel: none below zero means inside.
                matrix = np.vstack((at[triangle].T, np.ones(3)))
                if abs(np.linalg.det(matrix)) > 1e-12:
                    weights = np.linalg.solve(matrix, (0.0, 0.0, 1.0))
                    if (weights >= -1e-9).all():
                        hits.append(weights @ points[triangle])
        return max(hits, key=lambda point: float(point @ self.view.eye)) if hits else None


def _fill(picture: SheetPicture) -> None:
    picture.palette.load(picture.pen)
    painter.shade(picture.pen, picture.palette, picture.cells())


def _facets(picture: SheetPicture) -> None:
    picture.palette.load(picture.pen)
    painter.paint(picture.pen, picture.palette, picture.cells())


def _mesh(picture: SheetPicture) -> None:
    painter.paint_mesh(picture.pen, picture.cells(picture.every), picture.ink)


def _fill_and_mesh(picture: SheetPicture) -> None:
    picture.palette.load(picture.pen)
    cells, ink = picture.cells(picture.every), picture.ink or painter.DARK
    painter.paint(picture.pen, picture.palette, cells, ink)


def _wire(picture: SheetPicture) -> None:
    painter.wire(picture.pen, picture.sheet.points, picture.view, picture.every, picture.ink)


SHEET_MODES: dict[str, Callable[[SheetPicture], None]] = {
    "fill": _fill,
    "mesh": _mesh,
    "fill+mesh": _fill_and_mesh,
    "wire": _wire,
    "facets": _facets,
}
