"""Surfaces (u, v) -> (x, y, z): spheres, rings, bands, whatever two numbers can walk over."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from surfaces.arrays import Bools, Box, Doubles
from surfaces.shape.cells import all_corners
from surfaces.shape.fields import Field, spread
from surfaces.shape.sampling import Function, Interval, cut, evaluate, nodes, real


@dataclass(frozen=True)
class Sheet:
    """A surface as points over u and v."""

    u: Doubles
    """(nu+1,)"""
    v: Doubles
    """(nv+1,)"""
    points: Doubles
    """(nu+1, nv+1, 3): points (x, y, z), NaN where there is a hole."""

    @classmethod
    def sample(
        cls, f: Callable[[Any, Any], Any], u: Interval, v: Interval, n: int | tuple[int, int]
    ) -> "Sheet":
        """Evaluate f(u, v) -> (x, y, z) on n by n cells, or nu by nv for n = (nu, nv).

        f is called once, with two arrays of (nu+1, nv+1) numbers.

        Raises:
            ValueError: unless u and v are (a, b) with a < b, n is 1 or more, f gives three
                coordinates, and a point is finite.
        """
        us, vs = nodes(n, u=u, v=v)
        across, along = np.meshgrid(us, vs, indexing="ij")
        with np.errstate(all="ignore"):
            place = f(across, along)
        parts = list(place) if np.iterable(place) else [place]
        if len(parts) != 3:
            raise ValueError(f"f must return x, y and z, not {len(parts)} values")
        parts = [cut(np.broadcast_to(real(part), across.shape), None) for part in parts]
        points = np.stack(parts, axis=-1)
        points = np.where(np.isfinite(points).all(axis=-1, keepdims=True), points, np.nan)
        if np.isnan(points).all():
            raise ValueError(f"f has no finite point on u = {u!r}, v = {v!r}")
        return cls(us, vs, points)

    def around(self, origin: Doubles) -> "Sheet":
        """The same surface with its coordinates counted from a point, (3,)."""
        return Sheet(self.u, self.v, self.points - origin)

    def field(self, color: str | Function) -> Field:
        """The field that `color` asks for: "z", or a function of u and v.

        What has no value counts as the lowest.
        """
        if isinstance(color, str) and color == "z":
            values = self.points[..., 2]
        elif callable(color):
            values = evaluate(color, *np.meshgrid(self.u, self.v, indexing="ij"), name="color")
        else:
            raise ValueError(f'color must be "z" or a function of u and v, not {color!r}')
        found = spread(values)
        return found.scaled(found.limits)

    @property
    def whole(self) -> Bools:
        """Which cells, (nu, nv), have all their corners: the others are holes."""
        return all_corners(np.isfinite(self.points[..., 2]))

    @property
    def box(self) -> Box:
        """The box around it."""
        return np.nanmin(self.points, axis=(0, 1)), np.nanmax(self.points, axis=(0, 1))
