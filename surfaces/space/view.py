"""How a surface is seen: the way of its points to the screen, and the direction of the eye.

A transform T of the surface can be undone on the eye instead: turn the direction of the eye back by
the inverse of T, and ask where the eye lies as seen from the surface. So what is hidden can be
found on the surface itself, however it is turned.
"""

from dataclasses import dataclass

import numpy as np

from surfaces.arrays import Doubles
from surfaces.space.mapping import Projection


@dataclass(frozen=True)
class View:
    """How a surface is seen: everything that its hidden parts depend on."""

    screen: Doubles
    """4x4: from (x, y, z, 1) on the surface to (x', y', z, 1) on the screen."""
    eye: Doubles
    """(3,): the direction of the eye, as seen from the surface."""

    @property
    def back(self) -> Doubles:
        """4x4: from (x', y', z, 1) on the screen to the surface, the paper's (14)."""
        return np.asarray(np.linalg.inv(self.screen), dtype=np.float64)

    @classmethod
    def of(cls, T: Doubles, mapping: Projection) -> "View":
        """The view of a surface that is first transformed by T, 4x4, then mapped.

        Raises:
            ValueError: if T flattens space: then there is no way back.
        """
        return cls(T @ mapping.M4, eye_from_surface(mapping.eye, T))


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
