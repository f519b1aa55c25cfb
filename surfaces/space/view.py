"""How a surface is seen: the way of its points to the screen, and the direction of the eye.

A transform T of the surface can be undone on the eye instead: turn the direction of the eye back by
the inverse of T, and ask where the eye lies as seen from the surface. So what is hidden can be
found on the surface itself, however it is turned.
"""

import contextlib
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
        return self.nearness_of(points[..., 0], points[..., 1], points[..., 2])

    def nearness_of(self, x: Doubles, y: Doubles, z: Doubles) -> Doubles:
        """The same for points given by their coordinates, arrays of one shape."""
        if self.parallel:
            return _combined(x, y, z, self.eye)
        return np.asarray(1 / _combined(x, y, z, self.screen[:, 3]))

    def places(self, x: Doubles, y: Doubles, z: Doubles) -> tuple[Doubles, Doubles]:
        """Where points appear on the screen, x' and y', given by their coordinates."""
        across, down = (_combined(x, y, z, self.screen[:, way]) for way in range(2))
        if not self.parallel:
            w = _combined(x, y, z, self.screen[:, 3])
            across /= w
            down /= w
        return across, down

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


def _combined(x: Doubles, y: Doubles, z: Doubles, factors: Doubles) -> Doubles:
    """x, y and z times three factors, added, and a fourth number if there is one.

    Not a product of matrices: for large ones BLAS wakes threads that cost more than they save.
    """
    total: Doubles = x * factors[0]
    total += y * factors[1]
    total += z * factors[2]
    if len(factors) == 4:
        total += factors[3]
    return total


def eye_from_surface(eye: Doubles, T: Doubles) -> Doubles:
    """The direction of the eye, (3,), before the transform T: eye @ inverse of T's 3x3 part.

    Raises:
        ValueError: if T flattens space: then there is no way back.
    """
    with contextlib.suppress(np.linalg.LinAlgError):
        direction: Doubles = eye @ np.linalg.inv(T[:3, :3])
        if np.isfinite(direction).all():  # WebAssembly raises no error, but computes NaN
            return direction
    raise ValueError("transform must be invertible; this one flattens the surface")
