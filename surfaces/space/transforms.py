"""Moving, scaling and turning points of space: 4x4 matrices for row vectors.

The paper writes a point as a row and puts the matrix on its right, P' = P x T. So do we: the last
row of T is the translation, and `A @ B` means "first A, then B". A 3x3 matrix as in the paper
cannot hold a translation; with a fourth coordinate that is always 1, it can (such coordinates are
called homogeneous).
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, hypot, sin

import numpy as np
from numpy.typing import ArrayLike

from surfaces.arrays import Doubles

Point = tuple[float, float, float]

ORIGIN: Point = (0.0, 0.0, 0.0)
AXES: dict[str, Point] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def affine(linear: ArrayLike, shift: ArrayLike = ORIGIN) -> Doubles:
    """The transform p -> p @ linear + shift, as one 4x4 matrix.

    Args:
        linear: 3x3: a shear, a reflection, anything.
        shift: Three numbers.
    """
    T = np.eye(4)
    T[:3, :3] = linear
    T[3, :3] = shift
    return T


def translation(dx: float, dy: float, dz: float) -> Doubles:
    """Move by (dx, dy, dz)."""
    return affine(np.eye(3), (dx, dy, dz))


def scaling(sx: float, sy: float, sz: float, about: Point = ORIGIN) -> Doubles:
    """Stretch by sx, sy, sz along the axes; the point `about` stays where it is.

    A factor below zero reflects; a factor of zero flattens, which nothing can undo.
    """
    return _keeping(np.diag((sx, sy, sz)), about)


def rotation(axis: str | Point, angle: float, about: Point = ORIGIN) -> Doubles:
    """Turn about an axis (Rodrigues' formula).

    Seen from the tip of the axis a positive angle turns counterclockwise: "z" takes +x to +y, "x"
    takes +y to +z, "y" takes +z to +x.

    Args:
        axis: "x", "y", "z" or any vector (x, y, z) except (0, 0, 0).
        angle: In radians.
        about: A point on the axis: it stays where it is.

    Raises:
        ValueError: for another name or a vector without a direction.
    """
    x, y, z = _direction(axis)
    along = np.outer((x, y, z), (x, y, z))
    # The transpose of the textbook's cross-product matrix, because our vectors are rows.
    across = np.array(((0, z, -y), (-z, 0, x), (y, -x, 0)))
    return _keeping(along + cos(angle) * (np.eye(3) - along) + sin(angle) * across, about)


def compose(*transforms: Doubles) -> Doubles:
    """One transform that does all of these, the first one first."""
    T = np.eye(4)
    for step in transforms:
        T = T @ step
    return T


def power(T: Doubles, n: int) -> Doubles:
    """The transform T done n times over; for n below zero, undone.

    By repeated squaring: 11 products for n = 360. A rotation needs none at all, for
    `power(rotation(axis, angle), n)` is `rotation(axis, n * angle)`.

    Raises:
        numpy.linalg.LinAlgError: if n < 0 and T flattens.
    """
    return np.linalg.matrix_power(T, n)


def powers(T: Doubles) -> Iterator[Doubles]:
    """T, then T twice, then T three times, and so on, at one product a step.

    The "incremental multiplication" at the end of the section on transformations: from one
    picture of an animation to the next costs one product, for T as for Mapping.screen_matrix(T).
    """
    done = T
    while True:
        yield done
        done = done @ T


def apply(points: ArrayLike, T: Doubles) -> Doubles:
    """Transform points of shape (..., 3), or screen triples by a screen matrix; floats return.

    A perspective ends with a fourth coordinate w other than 1, and is divided by it.
    """
    before = np.asarray(points, dtype=np.float64)
    after: Doubles = before @ T[:3, :3] + T[3, :3]
    if T[:3, 3].any():
        after /= (before @ T[:3, 3] + T[3, 3])[..., np.newaxis]
    return after


def _keeping(linear: Doubles, fixed: Point) -> Doubles:
    """Apply `linear` so that the point `fixed` stays: the shift is q - q @ linear."""
    return affine(linear, np.asarray(fixed) - np.asarray(fixed) @ linear)


def _direction(axis: str | Point) -> Point:
    if isinstance(axis, str):
        if axis not in AXES:
            raise ValueError(f'axis must be "x", "y", "z" or a vector (x, y, z), not {axis!r}')
        return AXES[axis]
    x, y, z = axis
    length = hypot(x, y, z)
    if not 0.0 < length < float("inf"):
        raise ValueError(f"axis must be a finite vector other than (0, 0, 0), not {axis!r}")
    return x / length, y / length, z / length
