"""How a surface is seen: the way of its points to the screen, and the direction of the eye.

A transform T of the surface can be undone on the eye instead: turn the direction of the eye back by
the inverse of T, and ask where the eye lies as seen from the surface. So what is hidden can be
found on the surface itself, however it is turned.
"""

from dataclasses import dataclass

import numpy as np

from surfaces.arrays import Doubles
from surfaces.space.mapping import Projection
from surfaces.space.transforms import affine, apply


@dataclass(frozen=True)
class View:
    """How a surface is seen: everything that its hidden parts depend on."""

    screen: Doubles
    """4x4: from (x, y, z, 1) on the surface to (x', y', z, 1) on the screen; in a perspective to
    w times (x', y', z / w, 1)."""
    eye: Doubles
    """(3,): the direction of the eye, as seen from the surface; in a perspective, its place."""

    @property
    def parallel(self) -> bool:
        """Whether the eye is far away, so that all lines of sight are parallel."""
        return not self.screen[:3, 3].any()

    @property
    def back(self) -> Doubles:
        """4x4: from (x', y', z, 1) on the screen to the surface, the paper's (14)."""
        inverse = np.asarray(np.linalg.inv(self.screen), dtype=np.float64)
        return affine(inverse[:3, :3], inverse[3, :3]) if self.parallel else inverse

    @property
    def arrows(self) -> Doubles:
        """(3, 2): where a unit of x, y and z leads on the screen, beside (0, 0, 0)."""
        w = self.screen[3, 3]
        aside = np.outer(self.screen[:3, 3], self.screen[3, :2] / w)
        beside: Doubles = (self.screen[:3, :2] - aside) / w
        return beside

    def nearness(self, points: Doubles) -> Doubles:
        """How near points (..., 3) are: of two on one pixel, the greater number is the nearer.

        Along a line of the screen it runs evenly, also in a perspective, where it is 1 / w.
        """
        if self.parallel:
            far: Doubles = points @ self.eye
            return far
        near: Doubles = 1 / (points @ self.screen[:3, 3] + self.screen[3, 3])
        return near

    @classmethod
    def of(cls, T: Doubles, mapping: Projection) -> "View":
        """The view of a surface that is first transformed by T, 4x4, then mapped.

        Raises:
            ValueError: if T flattens space: then there is no way back.
        """
        screen = T @ mapping.M4
        eye = eye_from_surface(mapping.eye, T)
        if screen[:3, 3].any():  # a place, not only a direction
            eye = apply(mapping.eye, np.asarray(np.linalg.inv(T), dtype=np.float64))
        return cls(screen, eye)


def eye_from_surface(eye: Doubles, T: Doubles) -> Doubles:
    """The direction of the eye, (3,), before the transform T: eye @ inverse of T's 3x3 part.

    Raises:
        ValueError: if T flattens space: then there is no way back.
    """
    try:
        direction: Doubles = eye @ np.linalg.inv(T[:3, :3])
    except np.linalg.LinAlgError:
        raise ValueError("transform must be invertible; this one flattens the surface") from None
    return direction
