"""The paper's map from space to the screen, the way back, and its relatives.

Sandipan Dey, Ajith Abraham, Sugata Sanyal: "A Very Simple Approach for 3-D to 2-D Mapping".
y goes right and z goes up, both at full length; x comes toward the viewer, drawn down to the left,
theta away from the downward vertical. (Textbooks call this a cavalier projection.) Numbers in
brackets, here and below, are the paper's equations.

From two numbers three cannot be found again, so the map keeps z beside them: (x, y, z) ->
(x', y', z) has an inverse (7)-(15), and a transform of space becomes a transform of the screen
(16).

We add one thing, `scale`: pixels per unit along each axis, the "proper scaling" of the paper's
figures, without which sin() would be two pixels high.

All that is asked of the map is three arrows: where x, y and z go on the screen. Pohlke's theorem
says that any three arrows will do, as long as they are not all on one line; so the same few
matrices give every parallel projection there is: `surfaces.space.projections` has the usual ones.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from math import atan2, cos, hypot, inf, pi, sin, tan

import numpy as np
from numpy.typing import ArrayLike

from surfaces.arrays import Doubles
from surfaces.space.transforms import Point, affine, apply

Arrow = tuple[float, float]


class Projection(ABC):
    """A parallel projection: three arrows, an origin and scales, and all that follows from them.

    `Perspective` adds an eye near by to it.
    """

    origin: Arrow
    """The pixel (x0, y0) where (0, 0, 0) appears."""
    scale: Point
    """Pixels per unit along x, y and z, all above zero."""

    @property
    @abstractmethod
    def arrows(self) -> tuple[Arrow, Arrow, Arrow]:
        """Where a unit of x, y and z leads on the screen: (right, down), before scaling."""

    @abstractmethod
    def placed(self, origin: Arrow, unit: float, aspect: float = 1.0) -> Projection:
        """The same view, in another size at another place.

        Args:
            origin: The pixel where (0, 0, 0) appears.
            unit: How many times as large.
            aspect: The width of a pixel divided by its height: what goes down shrinks by it.
        """

    def _check(self) -> None:
        if len(self.origin) != 2 or not all(-inf < v < inf for v in self.origin):
            raise ValueError(f"origin must be two finite numbers, not {self.origin!r}")
        if len(self.scale) != 3 or not all(0.0 < v < inf for v in self.scale):
            raise ValueError(f"scale must be three finite numbers above 0, not {self.scale!r}")

    @property
    def M32(self) -> Doubles:
        """The 3x2 matrix of (2), with rho_z as in (4): what is seen, without the z kept beside."""
        matrix: Doubles = np.array(self.arrows) * np.array(self.scale)[:, np.newaxis]
        return matrix

    @property
    def M33(self) -> Doubles:
        """The invertible 3x3 matrix of (7): [x y z] @ M33 = [x'-x0  y'-y0  z].

        The paper's has the determinant -ax ay cos(theta), whatever rho_z is. (In (8) the paper
        sets a matrix equal to a number: a "det" is missing in the middle.)
        """
        return np.column_stack((self.M32, (0.0, 0.0, 1.0)))

    @property
    def M33_inverse(self) -> Doubles:
        """The inverse of M33."""
        return np.asarray(np.linalg.inv(self.M33), dtype=np.float64)

    @property
    def M4(self) -> Doubles:
        """M33 and the origin in one matrix: [x y z 1] @ M4 = [x' y' z 1], which is (9)."""
        return affine(self.M33, (*self.origin, 0.0))

    @property
    def M4_inverse(self) -> Doubles:
        """The inverse of M4: [x' y' z 1] @ M4_inverse = [x y z 1], which is (14)."""
        inverse = self.M33_inverse
        return affine(inverse, -np.array((*self.origin, 0.0)) @ inverse)

    @property
    def eye(self) -> Doubles:
        """The direction in space that points at the viewer: (1, s, c) in the paper's view.

        Points P and P + t eye fall on the same pixel, and the one with the larger t is nearer: eye
        spans the kernel of M32. It is the cross product of its columns, taken in the order for
        which x, y and z are right-handed, as in the paper's view. There, all its components are
        above zero, so that of two points on one pixel the nearer has the larger x, y and z.
        """
        right, down = self.M32.T
        eye: Doubles = np.cross(down, right)
        return eye

    def bounds(self, size: Doubles) -> tuple[Doubles, Doubles]:
        """The place of a box of this size around (0, 0, 0): its upper left and lower right corner.

        The box's sizes are (3,), the corners on the screen (2,), from the origin on.
        """
        half: Doubles = size @ np.abs(self.M32) / 2
        return -half, half

    def ball(self, diameter: float) -> Doubles:
        """(2,): how wide and how high a ball of this diameter appears."""
        across: Doubles = diameter * np.linalg.norm(self.M32, axis=0)
        return across

    def project(self, points: ArrayLike) -> Doubles:
        """Map points (x, y, z), shape (..., 3), to triples (x', y', z) of the same shape: (1), (4).

        x' and y' are pixels but stay floats: rounding is for the pen, at the very end.
        """
        return apply(points, self.M4)

    def unproject(self, triples: ArrayLike) -> Doubles:
        """Map triples (x', y', z), shape (..., 3), back to points (x, y, z): (6), (15)."""
        return apply(triples, self.M4_inverse)

    def screen_matrix(self, T: Doubles) -> Doubles:
        """The paper's M' (16): what the transform T of space does to triples (x', y', z).

        A 4x4 matrix for `apply` and `power`; n times T is n times M'. The paper multiplies
        screen points by a 3x3 M' although they contain the origin (x0, y0), which is right only
        where M' leaves the origin alone; a fourth coordinate puts that right, and lets T move.

        Keep the triples as floats between steps: from rounded pixels the error grows step by step.
        It moves points, not pictures: a turned surface shows what was hidden, so draw it anew.
        """
        return self.M4_inverse @ T @ self.M4


@dataclass(frozen=True)
class Mapping(Projection):
    """Where a point of space appears on the screen, in the paper's oblique view.

    Args:
        theta: How far the x axis leans from straight down: radians, 0 < theta < pi/2.
        rho_z: The paper's compression of heights, 0 < rho_z <= 1. (Its text says < 1, but its own
            default is 1.)
        origin: The pixel (x0, y0) where (0, 0, 0) appears.
        scale: Pixels per unit along x, y and z, all above zero.

    Raises:
        ValueError: if a number is outside its range.
    """

    theta: float = pi / 4
    rho_z: float = 1.0
    origin: Arrow = (0.0, 0.0)
    scale: Point = (1.0, 1.0, 1.0)

    def __post_init__(self) -> None:
        if not 0.0 < self.theta < pi / 2:
            raise ValueError(f"theta must be between 0 and pi/2, not {self.theta!r}")
        if not 0.0 < self.rho_z <= 1.0:
            raise ValueError(f"rho_z must be above 0 and at most 1, not {self.rho_z!r}")
        self._check()

    @property
    def arrows(self) -> tuple[Arrow, Arrow, Arrow]:
        """The rows of (2), with rho_z as in (4)."""
        return (-sin(self.theta), cos(self.theta)), (1.0, 0.0), (0.0, -self.rho_z)

    @property
    def M33_inverse(self) -> Doubles:
        """The inverse of M33 in closed form: (12), with the rho_z and scales it leaves out."""
        ax, ay, az = self.scale
        c, t = cos(self.theta), tan(self.theta)
        height = az * self.rho_z
        return np.array(
            (
                (0.0, 1 / ay, 0.0),
                (1 / (ax * c), t / ay, 0.0),
                (height / (ax * c), height * t / ay, 1.0),
            )
        )

    def placed(self, origin: Arrow, unit: float, aspect: float = 1.0) -> Mapping:
        """The same view elsewhere: where pixels are high, fewer go into a height, and x leans."""
        s, c = sin(self.theta), cos(self.theta)
        ax, ay, az = (unit * v for v in self.scale)
        return replace(
            self,
            theta=atan2(s, aspect * c),
            origin=origin,
            scale=(ax * hypot(s, aspect * c), ay, az * aspect),
        )


@dataclass(frozen=True)
class Axonometry(Projection):
    """A view given by three arrows: where a unit of x, y and z leads on the screen.

    Of the two ways to see three arrows, we see the right-handed one.

    Args:
        x: Pixels (right, down) for a unit of x.
        y: The same for y.
        z: The same for z.
        origin: The pixel (x0, y0) where (0, 0, 0) appears.
        scale: By how much each arrow is stretched, all above zero.

    Raises:
        ValueError: if the arrows of x and y are on one line: then the way back from (x', y', z)
            does not exist.
    """

    x: Arrow
    y: Arrow
    z: Arrow
    origin: Arrow = (0.0, 0.0)
    scale: Point = (1.0, 1.0, 1.0)

    def __post_init__(self) -> None:
        for name, arrow in zip("xyz", self.arrows, strict=True):
            if len(arrow) != 2 or not all(-inf < v < inf for v in arrow):
                raise ValueError(f"{name} must be two finite numbers, not {arrow!r}")
        across = self.x[0] * self.y[1] - self.x[1] * self.y[0]
        if abs(across) <= 1e-9 * hypot(*self.x) * hypot(*self.y):
            raise ValueError(f"x and y must not lead along one line: {self.x!r}, {self.y!r}")
        self._check()

    @property
    def arrows(self) -> tuple[Arrow, Arrow, Arrow]:
        """The three arrows as given."""
        return self.x, self.y, self.z

    def placed(self, origin: Arrow, unit: float, aspect: float = 1.0) -> Axonometry:
        """The same view elsewhere: where pixels are high, fewer go down."""
        x, y, z = ((right, down * aspect) for right, down in self.arrows)
        return Axonometry(x, y, z, origin, tuple(unit * v for v in self.scale))  # type: ignore[arg-type]
