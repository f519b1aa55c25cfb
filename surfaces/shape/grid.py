"""A height field as a grid of points: a function sampled, or data; missing points repaired.

sin(x+y)/(x+y) has no value where x+y = 0, yet the surface has no hole there. `Grid.sample` looks
beside such a node: if the neighbourhood agrees on a value, the node gets it. Where it does not
agree, as along the cliff of 1/(x+y), the hole is real and the node stays NaN.

With a range of heights stated, what exceeds it is cut off at its ends, infinities too. A cell that
leads from one end straight to the other is a pole, not a wall: it becomes a hole.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from surfaces.arrays import Bools, Box, Doubles, Ints
from surfaces.shape import rim
from surfaces.shape.cells import all_corners, every_nth
from surfaces.shape.rim import Rim
from surfaces.shape.sampling import (
    Axis,
    Function,
    Interval,
    Table,
    cut,
    evaluate,
    interval,
    is_table,
    nodes,
    real,
)

# Where to look beside a node, in units of the domain's width and depth: once in every quadrant, off
# the diagonals, and at four distances, so that 1/x**2 and log(x**2) are seen to grow.
BESIDE = 1e-6 * np.array(((1.0, 1.37), (1.7, -2.3), (-2.6, 3.5), (-3.9, -5.3)))
# Values this near to one another, relative to their size, agree.
AGREEMENT = 1e-3


@dataclass(frozen=True)
class Grid:
    """f on a rectangle: z[i, j] = f(x[i], y[j]), NaN where f has no value; x and y ascend."""

    x: Doubles
    """(nx+1,)"""
    y: Doubles
    """(ny+1,)"""
    z: Doubles
    """(nx+1, ny+1)"""
    limits: Interval | None = None
    """The range that the heights were cut to, if any."""
    value: rim.Value | None = None
    """The function whose heights they are, cut like them; None if there is none."""
    known_rim: Rim | None = None
    """Its `rim`, if that has been found already."""

    @classmethod
    def sample(
        cls,
        f: Function,
        x: Axis | None,
        y: Axis | None,
        n: int | tuple[int, int] = 50,
        z: Interval | None = None,
    ) -> Grid:
        """Evaluate f(x, y) on a grid of n by n cells, or nx by ny for n = (nx, ny).

        Points without a value become NaN.

        Args:
            f: A function. It is called once with two arrays of nx+1 by ny+1 numbers; one that
                cannot take arrays is called point by point instead.
            x: The domain, (a, b) with a < b.
            y: The same for y.
            n: Cells in each direction.
            z: (low, high): where to cut heights off, infinities too. Without it these become NaN.

        Raises:
            ValueError: unless a < b, n is 1 or more, and f is finite somewhere.
        """
        limits = None if z is None else interval("z", z)
        xs, ys = nodes(n, x=x, y=y)
        across, along = np.meshgrid(xs, ys, indexing="ij")
        values = evaluate(f, across, along)
        missing = ~np.isfinite(values)
        if missing.any():
            size = np.ptp(xs), np.ptp(ys)
            found = _beside(f, across[missing], along[missing], *size)
            values = values.copy()
            values[missing] = np.where(np.isnan(found), values[missing], found)
        values = cut(values, limits)
        if np.isnan(values).all():
            raise ValueError("f has no finite value there, or none above 0 where z is logarithmic")
        return cls(xs, ys, values, limits, lambda x, y: cut(evaluate(f, x, y), limits))

    @classmethod
    def of(
        cls,
        values: Table,
        x: Axis | None = None,
        y: Axis | None = None,
        z: Interval | None = None,
    ) -> Grid:
        """A grid from heights that are known: values[i, j] at x[i], y[j].

        Args:
            values: A 2-D array of 2 by 2 numbers or more; NaN or masked where there is none.
            x: (a, b) for even steps from a to b, or as many numbers as there are, in even or uneven
                steps, ascending or descending. None counts from 0. x and y may also be those that
                `numpy.meshgrid` makes, with either indexing.
            y: The same for y.
            z: (low, high): where to cut heights off, infinities too. Without it these are missing.

        Raises:
            ValueError: if the shapes do not match, an axis turns back, or nothing is finite.
        """
        heights = real(values)
        if heights.ndim != 2 or min(heights.shape) < 2:
            raise ValueError(f"f must be a function or 2 x 2 numbers or more, not {heights.shape}")
        limits = None if z is None else interval("z", z)
        xs, ys, heights = in_order(x, y, heights)
        heights = cut(heights, limits)
        if np.isnan(heights).all():
            raise ValueError("the data have no finite value")
        return cls(xs, ys, heights, limits)

    @cached_property
    def rim(self) -> Rim | None:
        """What there is of cells at the edge of a hole; None where there are no holes."""
        if self.known_rim is not None:
            return self.known_rim
        if np.isfinite(self.z).all():
            return None
        if self.value is not None:
            return rim.find(self.value, self.x, self.y, self.z)
        found = rim.of_data(self.z)
        if self.limits is None:
            return found
        low, high = ((self.z.ravel()[found.corners] == end).any(axis=1) for end in self.limits)
        part = ~(low & high)  # a pole is a gap, not a wall
        return replace(found, corners=found.corners[part], cell=found.cell[part])

    @property
    def points(self) -> Doubles:
        """The nodes (x, y, z) as an array of shape (nx+1, ny+1, 3)."""
        x, y = np.meshgrid(self.x, self.y, indexing="ij")
        return np.stack((x, y, self.z), axis=-1)

    @property
    def box(self) -> Box:
        """The box around the surface."""
        heights = self.z if self.rim is None else np.append(self.z, self.rim.points[:, 2])
        low = np.array((self.x[0], self.y[0], np.nanmin(heights)))
        high = np.array((self.x[-1], self.y[-1], np.nanmax(heights)))
        return low, high

    @property
    def whole(self) -> Bools:
        """Which cells, (nx, ny), are part of the surface: the others are holes."""
        whole = all_corners(np.isfinite(self.z))
        if self.limits is not None:
            low, high = (~all_corners(self.z != limit) for limit in self.limits)
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

    def around(self, origin: Doubles) -> Grid:
        """The same surface with its coordinates counted from a point, (3,)."""
        x, y, z = origin.tolist()
        limits, value = self.limits, self.value
        return Grid(
            self.x - x,
            self.y - y,
            self.z - z,
            None if limits is None else (limits[0] - z, limits[1] - z),
            None if value is None else lambda across, along: value(across + x, along + y) - z,
            None if self.rim is None else self.rim.around(origin),
        )

    @property
    def blank(self) -> bool:
        """Whether there is no part of it that could be filled: each cell is next to a hole."""
        return not self.whole.any() and (self.rim is None or not len(self.rim.corners))

    def loose_ends(self, every: int) -> tuple[Doubles, Bools]:
        """Where lines of a mesh go on from their last node to the rim of a hole.

        Both ends of each piece, (m, 2, 3), and whether it belongs to a line of constant x, (m,).
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
        """The nodes of x and of y where a mesh has its lines: every n-th one, and the last."""
        return every_nth(len(self.x), every), every_nth(len(self.y), every)

    def thinned(self, every: int) -> Grid:
        """The same surface with every n-th node of each axis, and always the last."""
        if every == 1:
            return self
        i, j = self.lines(every)
        return Grid(self.x[i], self.y[j], self.z[np.ix_(i, j)], self.limits, self.value)


sample, data = Grid.sample, Grid.of


def in_order(x: Axis | None, y: Axis | None, values: Doubles) -> tuple[Doubles, Doubles, Doubles]:
    """Ascending x and y, and values[i, j] at x[i], y[j]; the arguments are those of `Grid.of`."""
    if is_table(x) or is_table(y):
        x, y, values = _axes_of_meshgrid(real(x, "x"), real(y, "y"), values)
    xs, ys = _axis("x", x, values.shape[0]), _axis("y", y, values.shape[1])
    values = values[:: 1 if xs[0] < xs[-1] else -1, :: 1 if ys[0] < ys[-1] else -1]
    return np.sort(xs), np.sort(ys), values


def _axes_of_meshgrid(x: Doubles, y: Doubles, values: Doubles) -> tuple[Doubles, Doubles, Doubles]:
    """The axes that were given to `numpy.meshgrid`, and values[i, j] at x[i], y[j]."""
    with suppress(ValueError):  # shapes that do not match
        x, y = np.broadcast_to(x, values.shape), np.broadcast_to(y, values.shape)
        if (x == x[:, :1]).all() and (y == y[:1]).all():  # indexing="ij"
            return x[:, 0], y[0], values
        if (x == x[:1]).all() and (y == y[:, :1]).all():  # indexing="xy"
            return x[0], y[:, 0], values.T
    raise ValueError(
        f"x and y must be axes, or what meshgrid makes of them, for {values.shape}; "
        "for points in bent rows there is sheet(x, y, z)"
    )


def _axis(name: str, axis: Axis | None, count: int) -> Doubles:
    if axis is None:
        return np.arange(count, dtype=np.float64)
    places = np.atleast_1d(real(axis, name))
    if places.shape == (2,) and np.isfinite(places).all():
        places = np.linspace(places[0], places[1], count)
    steps = np.diff(places)
    even_sign = places.shape == (count,) and ((steps > 0).all() or (steps < 0).all())
    if not even_sign or not np.isfinite(places).all():
        raise ValueError(f"{name} must be (a, b) or {count} rising or falling numbers")
    return places


def _beside(f: Function, x: Doubles, y: Doubles, width: float, depth: float) -> Doubles:
    """The value that f has all around each of these points, or NaN where there is no such value."""
    dx, dy = BESIDE[:, :1] * width, BESIDE[:, 1:] * depth
    with np.errstate(all="ignore"):
        around = evaluate(f, x + dx, y + dy)
        value = around.mean(axis=0)
        agreed = np.ptp(around, axis=0) < AGREEMENT * (1 + np.abs(value))
    return np.where(agreed, value, np.nan)
