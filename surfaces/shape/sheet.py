"""Surfaces (u, v) -> (x, y, z): spheres, rings, bands, whatever two numbers can walk over.

Points that are known lie in rows and columns: their numbers i and j are the two.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from surfaces.arrays import Box, Doubles
from surfaces.shape.cells import quads
from surfaces.shape.fields import Field, spread
from surfaces.shape.rulers import PLAIN, Rulers
from surfaces.shape.sampling import Function, Interval, Table, cut, evaluate, nodes, real


@dataclass(frozen=True)
class Sheet:
    """A surface as points over u and v."""

    points: Doubles
    """(nu+1, nv+1, 3): points (x, y, z), NaN where there is a hole."""
    parameters: tuple[Doubles, Doubles] | None = None
    """(nu+1,) and (nv+1,): the u and the v of the points, if a function made them."""
    rulers: Rulers = PLAIN
    """Those that the points were laid out by."""

    @classmethod
    def sample(
        cls,
        f: Callable[[Any, Any], Any],
        u: Interval,
        v: Interval,
        n: int | tuple[int, int],
        choose: Callable[[Any, Any], Rulers] = lambda x, y: PLAIN,
    ) -> "Sheet":
        """Evaluate f(u, v) -> (x, y, z) on n by n cells, or nu by nv for n = (nu, nv).

        f is called once, with two arrays of (nu+1, nv+1) numbers. `choose` tells the rulers for the
        x and the y that it gives.

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
        laid_out = choose(*parts[:2])
        points = _stacked(
            [np.broadcast_to(part, across.shape) for part in _placed(parts, laid_out)]
        )
        if np.isnan(points).all():
            raise ValueError(f"f has no finite point on u = {u!r}, v = {v!r}")
        return cls(points, (us, vs), laid_out)

    @classmethod
    def of(cls, x: Table, y: Table, z: Table, laid_out: Rulers = PLAIN) -> "Sheet":
        """A sheet from points that are known: (x[i, j], y[i, j], z[i, j]).

        Raises:
            ValueError: unless the three are 2-D and of one shape, of 2 by 2 numbers or more, and a
                point is finite.
        """
        parts = _placed((x, y, z), laid_out)
        shapes = [part.shape for part in parts]
        if len(set(shapes)) > 1:
            told = "x, y and z must have one shape, not {}, {} and {}; of axes meshgrid makes such"
            raise ValueError(told.format(*shapes))
        if len(shapes[0]) != 2 or min(shapes[0]) < 2:
            raise ValueError(f"x, y and z must be 2 x 2 numbers or more, not {shapes[0]}")
        points = _stacked(parts)
        if np.isnan(points).all():
            raise ValueError("x, y and z have no finite point")
        return cls(points, rulers=laid_out)

    def around(self, origin: Doubles) -> "Sheet":
        """The same surface with its coordinates counted from a point, (3,)."""
        return replace(self, points=self.points - origin)

    def field(self, color: str | Function | Table) -> Field:
        """The field that `color` asks for: "z", a number for each point, or a function of u and v.

        What has no value counts as the lowest.
        """
        found = spread(self._values(color))
        return found.scaled(found.limits)

    def _values(self, color: str | Function | Table) -> Doubles:
        if isinstance(color, str) and color == "z":
            return self.points[..., 2]
        if callable(color) and self.parameters is not None:
            return evaluate(color, *np.meshgrid(*self.parameters, indexing="ij"), name="color")
        if isinstance(color, str) or callable(color):
            function = "" if self.parameters is None else " or a function of u and v"
            raise ValueError(f'color must be "z" or an array{function}, not {color!r:.60}')
        values, shape = real(color, "color"), self.points.shape[:2]
        if values.shape != shape:
            raise ValueError(f"color must have the shape {shape}, not {values.shape}")
        return values

    @property
    def blank(self) -> bool:
        """Whether there is nothing to fill: no cell has three of its corners."""
        there = np.isfinite(self.points[..., 2:])
        return bool(quads(there).sum(axis=2).max() < 3)

    @property
    def box(self) -> Box:
        """The box around it."""
        return np.nanmin(self.points, axis=(0, 1)), np.nanmax(self.points, axis=(0, 1))


def _placed(parts: Sequence[Any], laid_out: Rulers) -> list[Doubles]:
    """x, y and z where their rulers put them."""
    return [
        ruler.place(part, name) for ruler, part, name in zip(laid_out, parts, "xyz", strict=True)
    ]


def _stacked(parts: list[Doubles]) -> Doubles:
    """Points from their x, y and z; one without all three is NaN.

    In memory all x come first, then all y, then all z: each is quick to take from.
    """
    planes = np.stack([cut(part, None) for part in parts])
    planes[:, ~np.isfinite(planes).all(axis=0)] = np.nan
    return np.moveaxis(planes, 0, -1)
