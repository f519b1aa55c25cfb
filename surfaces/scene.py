"""`Plot`: a surface as it was drawn, to be asked about, and to be added to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfaces import checks
from surfaces.arrays import Box, Doubles, corners, middle
from surfaces.shape.rulers import Calendar, Rulers
from surfaces.shape.sampling import Function, Interval, Table
from surfaces.shape.sheet import Sheet
from surfaces.space.mapping import Projection
from surfaces.space.perspective import check_in_front
from surfaces.space.transforms import Point, apply
from surfaces.space.view import View
from surfaces.visible import marks, painter
from surfaces.visible.painter import Picture
from surfaces.visible.pictures import Scene, SheetPicture

Reading = tuple[Any, Any, Any]
"""A point of a surface in its own numbers, or dates."""


@dataclass(frozen=True)
class Plot:
    """A surface as it was drawn: where its points are on the screen, and back."""

    mapping: Projection
    """From space to the screen."""
    transform: Doubles
    """4x4: from (x, y, z) of the surface to that space, fit and turn in one.

    Here, and in what follows, a logarithmic axis counts in powers of ten, and dates in seconds.
    """
    scales: Point
    """Pixels for a unit of the surface's x, y and z, along the arrows of the mapping."""
    box: Box
    """The lowest and the highest corner of the surface: (3,) each, in its own x, y and z."""
    limits: Interval
    """The values that the first and the last colour stand for."""
    picture: Picture
    """What was drawn."""
    rulers: Rulers
    """How its x, y and z are laid out."""

    @property
    def view(self) -> View:
        """The way of points (x, y, z) to the screen in one matrix, and the eye's direction."""
        return View.of(self.transform, self.mapping)

    def project(self, points: ArrayLike) -> Doubles:
        """Where points (x, y, z), shape (..., 3), appear: the paper's triples (x', y', z).

        In a perspective the third number is z / w, as `Perspective` says.
        """
        return apply(self._around(points), self.picture.view.screen)

    def unproject(self, triples: ArrayLike) -> NDArray[Any]:
        """The points (x, y, z) of triples (x', y', z), shape (..., 3); objects, if with dates."""
        places = apply(triples, self.picture.view.back) + middle(self.box)
        parts = zip(self.rulers, np.moveaxis(places, -1, 0), strict=True)
        read = [ruler.read(part) for ruler, part in parts]
        if not self._has_dates:
            return np.stack(read, axis=-1)
        found = np.empty(places.shape, dtype=object)
        for place in np.ndindex(places.shape):
            found[place] = read[place[-1]][place[:-1]]
        return found

    def depth(self, points: ArrayLike) -> Doubles:
        """How near points (..., 3) are: of two on one pixel, the greater number is the nearer."""
        return self.picture.view.nearness(self._around(points))

    def parametric(
        self,
        f: Callable[[Any, Any], Any],
        u: Interval,
        v: Interval,
        n: int | tuple[int, int] = 100,
        color: str | Function | Table = "z",
    ) -> Plot:
        """Add the surface (x, y, z) = f(u, v) to the scene, each hidden where the other is nearer.

        It is filled, each pixel by its depth, in the colours that the plot's numbers have. (In an
        `Svg` whole cells are shown or hidden.) The picture's size was chosen without it.

        Args:
            f: A function of two arrays that returns three: x, y and z.
            u: The domain, (a, b) with a < b.
            v: The same for v.
            n: Cells in each direction, or (nu, nv).
            color: What the colours show: "z", a function of u and v, a number for every node.

        Returns:
            A `Plot` of both, for `pick`, `points` and whatever is added next.

        Raises:
            ValueError: for arguments out of range; nothing is drawn then.
        """
        return self._with(Sheet.sample(f, u, v, n, lambda x, y: self.rulers), color)

    def sheet(self, x: Table, y: Table, z: Table, color: str | Table = "z") -> Plot:
        """Add the surface through points in rows and columns, as `parametric` adds one.

        Args:
            x: The x of the points, a 2-D array...
            y: ... their y, an array of the same shape...
            z: ... and their z.
            color: What the colours show: "z", or an array like x, y and z.

        Returns:
            A `Plot` of both, for `pick`, `points` and whatever is added next.

        Raises:
            ValueError: for shapes that differ, or where there is no point; nothing is drawn then.
        """
        return self._with(Sheet.of(x, y, z, self.rulers), color)

    def _with(self, sheet: Sheet, color: str | Function | Table) -> Plot:
        shown, origin = sheet.field(color).scaled(self.limits), middle(self.box)
        easel = self.picture.easel
        check_in_front(corners(sheet.box) - origin, easel.view.screen)
        added = SheetPicture(easel, sheet.around(origin), shown)
        painter.add(added, self.picture)
        return replace(self, picture=Scene(easel, (self.picture, added)))

    def points(self, points: ArrayLike, color: int | None = None, size: int = 2) -> None:
        """Mark points (x, y, z), shape (..., 3), with small squares, where no surface hides them.

        A point that is not finite is left out. Like all that comes later, marks may lie off the
        surface's box, but the picture's size was chosen without them.

        Args:
            points: The points in the surface's own x, y and z.
            color: The colour of the squares. None: white.
            size: How far each reaches from its middle, in pixels, 1 or more.
        """
        reach = checks.count("size", size)
        marks.points(self.picture, self._around(points).reshape(-1, 3), color, reach)

    def curve(self, points: ArrayLike, color: int | None = None) -> None:
        """Draw straight lines from point to point, (n, 3), where no surface hides them.

        A point that is not finite leaves a gap.

        Args:
            points: The points in the surface's own x, y and z.
            color: The colour of the line. None: white.
        """
        marks.curve(self.picture, self._around(points).reshape(-1, 3), color)

    def _repr_png_(self) -> bytes | None:
        """The screen that it was drawn on as it is now, for notebooks."""
        shown: bytes | None = self.picture.easel.pen.shown_as("png")
        return shown

    def _repr_svg_(self) -> str | None:
        """The drawing that it was drawn on, for notebooks."""
        shown: str | None = self.picture.easel.pen.shown_as("svg")
        return shown

    def _around(self, points: ArrayLike) -> Doubles:
        """Points as the picture counts them, from the middle of the box."""
        found = np.asarray(points, dtype=object if self._has_dates else np.float64)
        if not found.ndim or found.shape[-1] != 3:
            raise ValueError(f"points must have the shape (..., 3), not {found.shape}")
        parts = zip(self.rulers, np.moveaxis(found, -1, 0), "xyz", strict=True)
        placed = [ruler.place(part, name) for ruler, part, name in parts]
        return np.stack(placed, axis=-1) - middle(self.box)

    @property
    def _has_dates(self) -> bool:
        return any(isinstance(ruler, Calendar) for ruler in self.rulers)

    def pick(self, px: float, py: float) -> Reading | None:
        """The nearest point (x, y, z) of the surface seen at a pixel, or None beside it.

        It maps back to the pixel, to half a pixel at the surface's outline. None, too, for a
        surface seen on its edge, narrower than two pixels. Dates are numpy's.
        """
        point = self.picture.pick(px, py)
        if point is None:
            return None
        parts = zip(self.rulers, (point + middle(self.box)).tolist(), strict=True)
        x, y, z = (ruler.read(place) for ruler, place in parts)
        return x, y, z
