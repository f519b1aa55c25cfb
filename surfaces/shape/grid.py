"""A surface as a grid of points: a function sampled, or data given; missing points repaired.

sin(x+y)/(x+y) has no value where x+y = 0, yet the surface has no hole there.  ``sample`` looks
beside such a node: if the neighbourhood agrees on a value, the node gets it.  Where it does not
agree, as along the cliff of 1/(x+y), the hole is real and the node stays NaN.

With a range of heights stated, what exceeds it is cut off at its ends, infinities too.  A cell that
leads from one end straight to the other is a pole, not a wall: it becomes a hole.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints
from surfaces.shape import rim
from surfaces.shape.cells import every_nth
from surfaces.shape.rim import Rim

Function = Callable[[Any, Any], Any]
Interval = tuple[float, float]
Axis = Interval | Sequence[float] | Doubles

# Where to look beside a node, in units of the domain's width and depth: once in every quadrant, off
# the diagonals, and at four distances, so that 1/x**2 and log(x**2) are seen to grow.
BESIDE = 1e-6 * np.array(((1.0, 1.37), (1.7, -2.3), (-2.6, 3.5), (-3.9, -5.3)))
AGREEMENT = 1e-3
LARGEST = 1e30
"""Beyond it a number counts as infinite."""


@dataclass(frozen=True)
class Grid:
    """f on a rectangle: z[i, j] = f(x[i], y[j]), NaN where f has no value; x and y ascend."""

    x: Doubles
    y: Doubles
    z: Doubles
    limits: Interval | None = None
    """The range that the heights were cut to, if any."""
    value: rim.Value | None = None
    """The function whose heights they are, cut like them; None if there is none."""

    @cached_property
    def rim(self) -> Rim | None:
        """What there is of cells at the edge of a hole, if a function can tell."""
        if self.value is None or np.isfinite(self.z).all():
            return None
        return rim.find(self.value, self.x, self.y, self.z)

    @property
    def points(self) -> Doubles:
        """The nodes (x, y, z) as an array of shape (len(x), len(y), 3)."""
        x, y = np.meshgrid(self.x, self.y, indexing="ij")
        return np.stack((x, y, self.z), axis=-1)

    @property
    def box(self) -> tuple[Doubles, Doubles]:
        """The lowest and the highest corner of the box around the surface."""
        heights = self.z if self.rim is None else np.append(self.z, self.rim.points[:, 2])
        low = np.array((self.x[0], self.y[0], np.nanmin(heights)))
        high = np.array((self.x[-1], self.y[-1], np.nanmax(heights)))
        return low, high

    @property
    def whole(self) -> Bools:
        """Which cells, (nx, ny), are part of the surface: the others are holes."""
        whole = _all_corners(np.isfinite(self.z))
        if self.limits is not None:
            low, high = (~_all_corners(self.z != limit) for limit in self.limits)
            whole &= ~(low & high)
        return whole

    @property
    def joined(self) -> tuple[Bools, Bools]:
        """Which neighbours along x, and along y, a line may join: not both sides of a pole."""
        return self._joined(self.z[:-1], self.z[1:]), self._joined(self.z[:, :-1], self.z[:, 1:])

    def _joined(self, z1: Doubles, z2: Doubles) -> Bools:
        joined = np.isfinite(z1) & np.isfinite(z2)
        if self.limits is not None:
            low, high = self.limits
            joined &= ~((np.minimum(z1, z2) == low) & (np.maximum(z1, z2) == high))
        return joined

    def loose_ends(self, every: int) -> tuple[Doubles, Bools]:
        """Where lines of a mesh go on from their last node to the rim of a hole.

        Both ends of each piece, (m, 2, 3), and whether it belongs to a line of constant x.
        """
        if self.rim is None:
            return np.zeros((0, 2, 3)), np.zeros(0, dtype=bool)
        i, j = self.lines(every)
        pieces = np.stack((self.points.reshape(-1, 3)[self.rim.beside], self.rim.points), axis=1)
        of_x = pieces[:, 0, 0] == pieces[:, 1, 0]
        x, y = pieces[:, 0, :2].T
        chosen = np.where(of_x, np.isin(x, self.x[i]), np.isin(y, self.y[j]))
        return pieces[chosen], of_x[chosen]

    def lines(self, every: int) -> tuple[Ints, Ints]:
        """Every so many nodes of x and of y, where a mesh has its lines; always the last."""
        return every_nth(len(self.x), every), every_nth(len(self.y), every)

    def thinned(self, every: int) -> "Grid":
        """The same surface with every so many nodes of each axis, and always the last."""
        if every == 1:
            return self
        i, j = self.lines(every)
        return Grid(self.x[i], self.y[j], self.z[np.ix_(i, j)], self.limits, self.value)


def _all_corners(nodes: Bools) -> Bools:
    """Which cells have all four corners among these nodes."""
    sides = nodes[:-1] & nodes[1:]
    return np.asarray(sides[:, :-1] & sides[:, 1:])


def sample(
    f: Function,
    x: Axis | None,
    y: Axis | None,
    n: int | tuple[int, int] = 50,
    z: Interval | None = None,
) -> Grid:
    """Evaluate f(x, y) on a grid of n by n cells, or nx by ny for n = (nx, ny).

    f is called once with two arrays of nx+1 by ny+1 numbers; a function that cannot take arrays is
    called point by point instead.  Points without a value become NaN, and so do infinities, unless
    z = (low, high) says where to cut heights off.
    ValueError unless a < b in x = (a, b) and y = (c, d), n is 1 or more, and f is finite somewhere.
    """
    nx, ny = n if isinstance(n, tuple) else (n, n)
    if nx < 1 or ny < 1:
        raise ValueError(f"n must be at least 1 in each direction, not {n!r}")
    limits = None if z is None else _interval("z", z)
    xs = np.linspace(*_interval("x", x), nx + 1)
    ys = np.linspace(*_interval("y", y), ny + 1)
    across, along = np.meshgrid(xs, ys, indexing="ij")
    values = evaluate(f, across, along)
    missing = ~np.isfinite(values)
    if missing.any():
        width, depth = xs[-1] - xs[0], ys[-1] - ys[0]
        found = _beside(f, across[missing], along[missing], width, depth)
        values = values.copy()
        values[missing] = np.where(np.isnan(found), values[missing], found)
    values = _cut(values, limits)
    if np.isnan(values).all():
        raise ValueError(f"f has no finite value on x = {x!r}, y = {y!r}")
    return Grid(xs, ys, values, limits, lambda x, y: _cut(evaluate(f, x, y), limits))


def data(
    values: Any, x: Axis | None = None, y: Axis | None = None, z: Interval | None = None
) -> Grid:
    """A grid from heights that are known: values[i, j] at x[i], y[j].

    x and y are (a, b) for even steps from a to b, or as many numbers as there are, in even or
    uneven steps, ascending or descending; None counts from 0.  z = (low, high) cuts heights off;
    without it infinities count as missing.
    ValueError if the shapes do not match, an axis turns back, or nothing is finite.
    """
    heights = _real(values)
    if heights.ndim != 2 or min(heights.shape) < 2:
        raise ValueError(f"f must be a function or 2 x 2 numbers or more, not {heights.shape}")
    limits = None if z is None else _interval("z", z)
    xs, ys = _axis("x", x, heights.shape[0]), _axis("y", y, heights.shape[1])
    heights = heights[:: 1 if xs[0] < xs[-1] else -1, :: 1 if ys[0] < ys[-1] else -1]
    heights = _cut(heights, limits)
    if np.isnan(heights).all():
        raise ValueError("the data have no finite value")
    return Grid(np.sort(xs), np.sort(ys), heights, limits)


def _axis(name: str, axis: Axis | None, count: int) -> Doubles:
    if axis is None:
        return np.arange(count, dtype=np.float64)
    nodes = np.asarray(axis, dtype=np.float64)
    if nodes.shape == (2,) and np.isfinite(nodes).all():
        nodes = np.linspace(nodes[0], nodes[1], count)
    steps = np.diff(nodes)
    even_sign = nodes.shape == (count,) and ((steps > 0).all() or (steps < 0).all())
    if not even_sign or not np.isfinite(nodes).all():
        raise ValueError(f"{name} must be (a, b) or {count} rising or falling numbers")
    return nodes


def _cut(z: Doubles, limits: Interval | None) -> Doubles:
    """Heights within the limits; without limits, infinities become NaN.

    What is larger than LARGEST counts as infinite, and what is smaller than 1 / LARGEST as 0, so
    that no later arithmetic overflows.
    """
    if limits is not None:
        return np.clip(z, *limits)
    z = np.where(np.abs(z) < 1 / LARGEST, 0.0, z)
    return np.where(np.abs(z) > LARGEST, np.nan, z)


def evaluate(f: Function, x: Doubles, y: Doubles) -> Doubles:
    """f at every point of two arrays of one shape, NaN where it has no value."""
    with np.errstate(all="ignore"):
        try:
            z = _real(f(x, y))
            whole = z.shape == x.shape
        except Exception:  # whatever a function of single numbers does when given arrays
            whole = False
        if not whole:
            z = np.vectorize(_or_nan(f), otypes=[np.float64])(x, y)
    return z


def _real(values: Any) -> Doubles:
    if np.iscomplexobj(values):
        raise TypeError("f must return real numbers, not complex ones")
    return np.asarray(values, dtype=np.float64)


def _or_nan(f: Function) -> Callable[[float, float], float]:
    """f for single numbers, with NaN where Python's arithmetic gives up."""

    def value(x: float, y: float) -> float:
        try:
            return float(_real(f(x, y)))
        except (ArithmeticError, ValueError):  # 1/0, math.log(-1), math.exp(1000)
            return float("nan")

    return value


def _beside(f: Function, x: Doubles, y: Doubles, width: float, depth: float) -> Doubles:
    """The value that f has all around each of these points, or NaN where there is no such value."""
    dx, dy = BESIDE[:, :1] * width, BESIDE[:, 1:] * depth
    with np.errstate(all="ignore"):
        around = evaluate(f, x + dx, y + dy)
        value = around.mean(axis=0)
        agreed = np.ptp(around, axis=0) < AGREEMENT * (1 + np.abs(value))
    return np.where(agreed, value, np.nan)


def _interval(name: str, interval: Any) -> Interval:
    try:
        a, b = interval
        ordered = -np.inf < a < b < np.inf
    except (TypeError, ValueError):
        ordered = False
    if not ordered:
        raise ValueError(f"{name} must be (a, b) with finite a < b, not {interval!r}")
    if max(abs(a), abs(b)) > LARGEST or b - a < 1 / LARGEST:
        raise ValueError(f"{name} must be a range of floats' middle size, not {interval!r}")
    return a, b
