"""`Plot`: a surface as it was drawn, to be asked about, and to be added to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from surfaces import checks
from surfaces.arrays import Box, Doubles, middle
from surfaces.shape.sampling import Interval
from surfaces.space.mapping import Projection
from surfaces.space.transforms import Point, apply
from surfaces.space.view import View
from surfaces.visible import marks
from surfaces.visible.painter import Picture


@dataclass(frozen=True)
class Plot:
    """A surface as it was drawn: where its points are on the screen, and back."""

    mapping: Projection
    """From space to the screen."""
    transform: Doubles
    """4x4: from (x, y, z) of the surface to that space, fit and turn in one."""
    scales: Point
    """Pixels for a unit of the surface's x, y and z, along the arrows of the mapping."""
    box: Box
    """The lowest and the highest corner of the surface: (3,) each, in its own x, y and z."""
    limits: Interval
    """The values that the first and the last colour stand for."""
    picture: Picture
    """What was drawn."""

    @property
    def view(self) -> View:
        """The way of points (x, y, z) to the screen in one matrix, and the eye's direction."""
        return View.of(self.transform, self.mapping)

    def project(self, points: ArrayLike) -> Doubles:
        """Where points (x, y, z), shape (..., 3), appear: the paper's triples (x', y', z)."""
        return apply(self._around(points), self.picture.view.screen)

    def unproject(self, triples: ArrayLike) -> Doubles:
        """The points (x, y, z) of triples (x', y', z), shape (..., 3)."""
        return apply(triples, self.picture.view.back) + middle(self.box)

    def depth(self, points: ArrayLike) -> Doubles:
        """How near points (..., 3) are: of two on one pixel, the greater number is the nearer."""
        return self.picture.view.nearness(self._around(points))

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
        marks.points(self.picture, self._listed(points), color, reach)

    def curve(self, points: ArrayLike, color: int | None = None) -> None:
        """Draw straight lines from point to point, (n, 3), where no surface hides them.

        A point that is not finite leaves a gap.

        Args:
            points: The points in the surface's own x, y and z.
            color: The colour of the line. None: white.
        """
        marks.curve(self.picture, self._listed(points), color)

    def _listed(self, points: ArrayLike) -> Doubles:
        """Points as the picture counts them, (n, 3); ValueError if they are no points."""
        found = np.asarray(points, dtype=np.float64)
        if not found.ndim or found.shape[-1] != 3:
            raise ValueError(f"points must have the shape (..., 3), not {found.shape}")
        return self._around(found.reshape(-1, 3))

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
        return np.asarray(points, dtype=np.float64) - middle(self.box)

    def pick(self, px: float, py: float) -> Point | None:
        """The nearest point (x, y, z) of the surface seen at a pixel, or None beside it.

        It maps back to the pixel, to half a pixel at the surface's outline. None, too, for a
        surface seen on its edge, narrower than two pixels.
        """
        point = self.picture.pick(px, py)
        if point is None:
            return None
        x, y, z = (point + middle(self.box)).tolist()
        return x, y, z
