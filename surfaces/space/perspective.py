"""Space as an eye near by sees it: what is farther away is smaller (central projection).

From far away all lines of sight are parallel, and three arrows say everything. Here they meet in
the eye, at a distance d. What lies n nearer to it than the middle of the picture does appears
larger, divided by w = 1 - n/d. The fourth coordinate, 1 until now, becomes that w, and dividing by
it is all that is new (homogeneous coordinates: Roberts, 1965). Lines stay lines; those that are
parallel in space run into one vanishing point.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, sqrt

import numpy as np

from surfaces.arrays import Doubles, corners
from surfaces.space.mapping import Arrow, Axonometry
from surfaces.space.transforms import apply, translation


@dataclass(frozen=True)
class Perspective(Axonometry):
    """A view given by three arrows, as they are beside (0, 0, 0), and the distance of the eye.

    `project` gives triples (x', y', z / w), and `unproject` takes them.

    Args:
        x: Pixels (right, down) for a unit of x.
        y: The same for y.
        z: The same for z.
        origin: The pixel (x0, y0) where (0, 0, 0) appears.
        scale: By how much each arrow is stretched, all above zero.
        distance: How far the eye is from (0, 0, 0), above zero.

    Raises:
        ValueError: for arrows as in `Axonometry`, or a distance out of range.
    """

    distance: float = 4.0

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 0.0 < self.distance < inf:
            raise ValueError(f"distance must be above 0 and finite, not {self.distance!r}")

    @property
    def M4(self) -> Doubles:
        """[x y z 1] @ M4 = [x'w y'w z w], w being 1 beside (0, 0, 0) and 0 at the eye."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.M33
        matrix[:3, 3] = -self.eye / self.distance**2
        return matrix @ translation(*self.origin, 0.0)

    @property
    def M4_inverse(self) -> Doubles:
        """The inverse of M4."""
        return np.asarray(np.linalg.inv(self.M4), dtype=np.float64)

    @property
    def eye(self) -> Doubles:
        """Where the eye is: not only its direction, as in a parallel projection."""
        direction = super().eye
        place: Doubles = direction * (self.distance / np.linalg.norm(direction))
        return place

    def placed(self, origin: Arrow, unit: float, aspect: float = 1.0) -> Perspective:
        """The same view elsewhere, the eye at the same distance."""
        far = super().placed(origin, unit, aspect)
        return Perspective(far.x, far.y, far.z, far.origin, far.scale, self.distance)

    def bounds(self, size: Doubles) -> tuple[Doubles, Doubles]:
        """The place on the screen of a box of this size around (0, 0, 0).

        Raises:
            ValueError: if the box reaches as far as the eye.
        """
        points = corners((-size / 2, size / 2))
        check_in_front(points, self.M4)
        seen = apply(points, self.M4)[:, :2]
        return seen.min(axis=0), seen.max(axis=0)

    def ball(self, diameter: float) -> Doubles:
        """How wide and how high a ball around (0, 0, 0) appears: a tangent leads to its outline.

        Raises:
            ValueError: if the ball reaches as far as the eye.
        """
        radius = diameter / 2
        if not radius < self.distance:
            raise ValueError(
                f"the eye is too near to turn the surface: its distance must be above {radius:.3g},"
                f" not {self.distance!r}"
            )
        return super().ball(diameter) / sqrt(1 - (radius / self.distance) ** 2)


def check_in_front(points: Doubles, screen: Doubles) -> None:
    """Hold that points (m, 3) lie before the eye; ValueError if one does not.

    `screen` is the 4x4 way to the screen: w is 0 beside the eye, and below that behind it.
    """
    if (points @ screen[:3, 3] + screen[3, 3] <= 0).any():
        raise ValueError(
            "the surface's box reaches behind the eye: the perspective's distance must be greater"
        )
