"""The paper's map from space to the screen, and the way back.

Sandipan Dey, Ajith Abraham, Sugata Sanyal: "A Very Simple Approach for 3-D to 2-D Mapping".
y goes right and z goes up, both at full length; x comes toward the viewer, drawn down to the left,
theta away from the downward vertical.  (Textbooks call this a cavalier projection.)  Numbers in
brackets, here and below, are the paper's equations.

Two numbers do not tell three apart, so the map keeps z beside them: (x, y, z) -> (x', y', z) has an
inverse (7)-(15), and a transform of space becomes a transform of the screen (16).

We add one thing, ``scale``: pixels per unit along each axis, the "proper scaling" of the paper's
figures, without which sin() would be two pixels high.
"""

from dataclasses import dataclass
from math import cos, inf, pi, sin, tan

import numpy as np
from numpy.typing import ArrayLike

from surfaces.transforms import FloatArray, Point, affine, apply


@dataclass(frozen=True)
class Mapping:
    """Where a point of space appears on the screen, in the paper's oblique view.

    theta   radians, 0 < theta < pi/2: how far the x axis leans from straight down.
    rho_z   0 < rho_z <= 1, the paper's compression of heights.  (Its text says < 1, but its own
            default is 1.)
    origin  the pixel (x0, y0) where (0, 0, 0) appears.
    scale   pixels per unit along x, y and z, all above zero.

    ValueError if a number is outside its range.
    """

    theta: float = pi / 4
    rho_z: float = 1.0
    origin: tuple[float, float] = (0.0, 0.0)
    scale: Point = (1.0, 1.0, 1.0)

    def __post_init__(self) -> None:
        if not 0.0 < self.theta < pi / 2:
            raise ValueError(f"theta must be between 0 and pi/2, not {self.theta!r}")
        if not 0.0 < self.rho_z <= 1.0:
            raise ValueError(f"rho_z must be above 0 and at most 1, not {self.rho_z!r}")
        if len(self.origin) != 2 or not all(-inf < v < inf for v in self.origin):
            raise ValueError(f"origin must be two finite numbers, not {self.origin!r}")
        if len(self.scale) != 3 or not all(0.0 < v < inf for v in self.scale):
            raise ValueError(f"scale must be three finite numbers above 0, not {self.scale!r}")

    @property
    def M33(self) -> FloatArray:
        """The invertible 3x3 matrix of (7): [x y z] @ M33 = [x'-x0  y'-y0  z].

        Its determinant is -ax ay cos(theta), whatever rho_z is.  (In (8) the paper sets a matrix
        equal to a number: a "det" is missing in the middle.)
        """
        ax, ay, az = self.scale
        s, c = sin(self.theta), cos(self.theta)
        return np.array(
            (
                (-ax * s, ax * c, 0.0),
                (ay, 0.0, 0.0),
                (0.0, -az * self.rho_z, 1.0),
            )
        )

    @property
    def M32(self) -> FloatArray:
        """The 3x2 matrix of (2), with rho_z as in (4): what is seen, without the z kept beside."""
        return self.M33[:, :2]

    @property
    def M33_inverse(self) -> FloatArray:
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

    @property
    def M4(self) -> FloatArray:
        """M33 and the origin in one matrix: [x y z 1] @ M4 = [x' y' z 1], which is (9)."""
        return affine(self.M33, (*self.origin, 0.0))

    @property
    def M4_inverse(self) -> FloatArray:
        """The inverse of M4: [x' y' z 1] @ M4_inverse = [x y z 1], which is (14)."""
        inverse = self.M33_inverse
        return affine(inverse, -np.array((*self.origin, 0.0)) @ inverse)

    @property
    def eye(self) -> FloatArray:
        """The direction in space that points at the viewer.

        Points P and P + t eye fall on the same pixel, and the one with the larger t is nearer: eye
        spans the kernel of M32.  All three components are above zero, so that of two points on one
        pixel the nearer has the larger x, the larger y and the larger z.
        """
        ax, ay, az = self.scale
        return np.array(
            (
                1.0,
                ax * sin(self.theta) / ay,
                ax * cos(self.theta) / (az * self.rho_z),
            )
        )

    def project(self, points: ArrayLike) -> FloatArray:
        """Map points (x, y, z), shape (..., 3), to triples (x', y', z) of the same shape: (1), (4).

        x' and y' are pixels but stay floats: rounding is for the pen, at the very end.
        """
        return apply(points, self.M4)

    def unproject(self, triples: ArrayLike) -> FloatArray:
        """Map triples (x', y', z), shape (..., 3), back to points (x, y, z): (6), (15)."""
        return apply(triples, self.M4_inverse)

    def screen_matrix(self, T: FloatArray) -> FloatArray:
        """The paper's M' (16): what the transform T of space does to triples (x', y', z).

        A 4x4 matrix for ``apply`` and ``power``; n times T is n times M'.  The paper multiplies
        screen points by a 3x3 M' although they contain the origin (x0, y0), which is right only
        where M' leaves the origin alone; a fourth coordinate puts that right, and lets T move.

        Keep the triples as floats between steps: from rounded pixels the error grows step by step.
        It moves points, not pictures: a turned surface shows what was hidden, so draw it anew.
        """
        return self.M4_inverse @ T @ self.M4
