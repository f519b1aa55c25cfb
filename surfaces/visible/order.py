"""Which part of a height field hides which: the painter's order, without sorting.

The cells of z = f(x, y) stand between vertical planes x = x[i]. A ray of light on its way to the
eye crosses all these planes in one direction, the one in which the eye lies; so drawing the cells
plane by plane toward the eye, what comes later may hide what came before, and never the reverse.
The same holds for y. That is exact, needs no depths, and needs no sorting.

It stays true when the surface is turned, reflected or sheared, with the direction of the eye as
seen from the surface (see `surfaces.space.view`).
"""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Doubles

Item = TypeVar("Item", bound=np.generic)


def back_to_front(field: NDArray[Item], eye: Doubles) -> NDArray[Item]:
    """A view of a field over the grid, shape (nx, ny, ...), whose last entry is the nearest.

    `eye` is the direction of the eye as seen from the surface. A component of zero leaves a free
    choice, for then the cells on that axis do not hide one another.
    """
    return field[:: 1 if eye[0] >= 0 else -1, :: 1 if eye[1] >= 0 else -1]
