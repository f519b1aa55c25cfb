"""The surface as rays of light see it: every pixel on its own, without any of the plotter's ideas.

From a pixel a ray goes through the box around the surface, from the eye's side to the far one, in
small steps. Where it changes from above the surface to below it or back, it has met the surface;
between these two steps the place is found by halving.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Bools, Doubles

Array = Doubles


class Cast(NamedTuple):
    """What every pixel sees, arrays of shape (height, width)."""

    hit: Bools
    point: Array
    """(height, width, 3)"""
    under: Bools


def cast(
    f: Callable[[Any, Any], Any],
    x: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    screen: Array,
    eye: Array,
    width: int,
    height: int,
    steps: int = 500,
) -> Cast:
    """Send a ray through the middle of every pixel, to the eye: a direction, or a place near by."""
    px, py = np.meshgrid(np.arange(width), np.arange(height))
    start = np.stack((px, py, 0 * px, 0 * px + 1), axis=-1).reshape(-1, 4) @ np.linalg.inv(screen)
    start = start[:, :3] / start[:, 3:]
    direction = eye - start if screen[:3, 3].any() else np.broadcast_to(eye, start.shape)
    low, high = np.array((x, y, z)).T
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (low - start) / direction, (high - start) / direction
    far = np.nanmax(np.minimum(a, b), axis=1)
    near = np.nanmin(np.maximum(a, b), axis=1)
    inside = np.flatnonzero(far < near)
    start, far, near = start[inside], far[inside], near[inside]
    direction = direction[inside]

    def above(t: Array) -> Array:
        p = start + t[:, None] * direction
        return np.asarray(p[:, 2] - f(p[:, 0], p[:, 1]))

    before, t0 = above(near), near.copy()
    found = np.zeros(len(near), dtype=bool)
    nearer, farther = near.copy(), near.copy()
    for step in range(1, steps + 1):
        t = near + (far - near) * step / steps
        here = above(t)
        crossed = ~found & ((here > 0) != (before > 0))
        nearer[crossed], farther[crossed] = t0[crossed], t[crossed]
        found |= crossed
        before, t0 = np.where(found, before, here), np.where(found, t0, t)
    for _ in range(30):
        middle = (nearer + farther) / 2
        same = (above(middle) > 0) == (before > 0)
        nearer, farther = np.where(same, middle, nearer), np.where(same, farther, middle)
    hit = np.zeros(width * height, dtype=bool)
    under = hit.copy()
    point = np.zeros((width * height, 3))
    hit[inside] = found
    under[inside] = found & (before <= 0)
    point[inside] = start + nearer[:, None] * direction
    shape = height, width
    return Cast(hit.reshape(shape), point.reshape(*shape, 3), under.reshape(shape))


class Canvas:
    """A graphics system of 256 colours in an array."""

    arrays = True

    def __init__(self, width: int, height: int) -> None:
        self.array = np.zeros((height, width), dtype=np.int64)

    def getmaxx(self) -> int:
        return self.array.shape[1] - 1

    def getmaxy(self) -> int:
        return self.array.shape[0] - 1

    def getmaxcolor(self) -> int:
        return 255

    def putpixel(self, x: Any, y: Any, color: Any) -> None:
        height, width = self.array.shape
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        self.array[y[inside], x[inside]] = np.broadcast_to(color, x.shape)[inside]


def edges(field: NDArray[Any]) -> Bools:
    """Pixels whose neighbours, all eight, are not all like them."""
    padded = np.pad(field, 1, mode="edge")
    different = np.zeros(field.shape, dtype=bool)
    rows, columns = field.shape
    for down in range(3):
        for right in range(3):
            different |= padded[down : down + rows, right : right + columns] != field
    return different
