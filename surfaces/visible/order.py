"""Which part of a surface hides which: the painter's order, without sorting.

The cells of z = f(x, y) stand between vertical planes x = x[i].  A ray of light on its way to the
eye crosses all these planes in one direction, the one in which the eye lies; so drawing the cells
plane by plane toward the eye, what comes later may hide what came before, and never the reverse.
The same holds for y.  That is exact, needs no depths, and needs no sorting.

It stays true when the surface is turned, reflected or sheared by T: turn the direction of the eye
back by the inverse of T, and ask where the eye lies as seen from the surface.
"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from surfaces.space.mapping import Projection
from surfaces.space.transforms import FloatArray

Item = TypeVar("Item", bound=np.generic)


@dataclass(frozen=True)
class View:
    """How a surface is seen: all that its hidden parts depend on."""

    screen: FloatArray
    """4x4: from (x, y, z, 1) on the surface to (x', y', z) on the screen."""
    eye: FloatArray
    """The direction of the eye, as seen from the surface."""

    @property
    def back(self) -> FloatArray:
        """4x4: from (x', y', z) on the screen to the surface, the paper's (14)."""
        return np.asarray(np.linalg.inv(self.screen), dtype=np.float64)

    @classmethod
    def of(cls, T: FloatArray, mapping: Projection) -> "View":
        """The view of a surface that is first transformed, then mapped.

        ValueError if T flattens space: then there is no way back.
        """
        return cls(T @ mapping.M4, eye_from_surface(mapping.eye, T))


def eye_from_surface(eye: FloatArray, T: FloatArray) -> FloatArray:
    """The direction of the eye before the transform T: eye @ inverse of T's 3x3 part.

    ValueError if T flattens space: then there is no way back.
    """
    try:
        direction: FloatArray = eye @ np.linalg.inv(T[:3, :3])
    except np.linalg.LinAlgError:
        raise ValueError("transform must be invertible; this one flattens the surface") from None
    return direction


def back_to_front(field: NDArray[Item], eye: FloatArray) -> NDArray[Item]:
    """A view of a field over the grid, shape (nx, ny, ...), whose last entry is the nearest.

    ``eye`` is the direction of the eye as seen from the surface.  A component of zero leaves a free
    choice, for then the cells on that axis do not hide one another.
    """
    return field[:: 1 if eye[0] >= 0 else -1, :: 1 if eye[1] >= 0 else -1]


def quads(nodes: NDArray[Item]) -> NDArray[Item]:
    """The four corners of every cell, in the order of the nodes.

    From nodes of shape (nx+1, ny+1, k), an array of shape (nx, ny, 4, k); the corners go round.
    """
    return np.stack((nodes[:-1, :-1], nodes[1:, :-1], nodes[1:, 1:], nodes[:-1, 1:]), axis=2)
