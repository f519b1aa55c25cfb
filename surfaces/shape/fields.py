"""What a surface's colours show: its height, its slope, the light on it, or any other quantity.

A field is one number for every node of the grid, brought to the range from 0 to 1 that ramps take.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from surfaces.arrays import Doubles
from surfaces.shape.grid import Grid
from surfaces.shape.sampling import Function, Interval, Table, cut, evaluate, real

Color = str | Function | Table
"""What colours can show: a name of `FIELDS`, a function of x and y, a number for every node."""

# Where the light comes from, in the viewed space: over the viewer's left shoulder.
LIGHT = np.array((0.55, -0.35, 0.76))


@dataclass(frozen=True)
class Field:
    """Values over the grid, from 0 to 1, and what 0 and 1 stand for."""

    value: Doubles
    """(nx+1, ny+1): one for every node, NaN where there is none."""
    limits: Interval
    quantity: Callable[[Doubles], Doubles] | None = None
    """The number itself at any points (m, 3) of the surface, if they are all it depends on."""

    def scaled(self, limits: Interval) -> "Field":
        """The same as part of wider limits; what has no value counts as the lowest."""
        (low, high), (lowest, highest) = self.limits, limits
        value = self.value
        if self.limits != limits:
            value = (value * (high - low) + (low - lowest)) / ((highest - lowest) or 1.0)
        return Field(np.nan_to_num(value), limits, self.quantity)

    def around(self, origin: Doubles) -> "Field":
        """The same for a surface whose coordinates are counted from a point, (3,)."""
        quantity = self.quantity
        if quantity is None:
            return self
        return replace(self, quantity=lambda points: quantity(points + origin))

    def at(self, points: Doubles, beside: Doubles) -> Doubles:
        """The values at points (m, 3); where only the grid knows them, those of nodes beside, (m,).

        A quantity that is not finite at a point counts as the node's, too.
        """
        if self.quantity is None or not len(points):
            return beside
        low, high = self.limits
        value = (self.quantity(points) - low) / ((high - low) or 1.0)
        return np.where(np.isfinite(value), np.clip(value, 0, 1), beside)


def fields(color: Color, grids: Sequence[Grid], T: Doubles) -> tuple[Field, ...]:
    """The fields of several surfaces, all with the same limits; ValueError as for `field`."""
    found = [field(color, grid, T) for grid in grids]
    limits = min(one.limits[0] for one in found), max(one.limits[1] for one in found)
    return tuple(one.scaled(limits) for one in found)


def field(color: Color, grid: Grid, T: Doubles) -> Field:
    """The field that `color` asks for.

    Args:
        color: "z", "slope" (how much z changes per unit, steepest way), "light" (half of it is
            shade), an array like grid.z, or a function of x and y.
        grid: The surface.
        T: 4x4: takes the surface to where the light is.

    Raises:
        ValueError: for another name or an array of another shape.
    """
    if isinstance(color, str):
        if color not in FIELDS:
            names = ", ".join(map(repr, FIELDS))
            raise ValueError(f"color must be {names}, an array or a function, not {color!r}")
        return FIELDS[color](grid, T)
    if callable(color):
        nodes = evaluate(color, *np.meshgrid(grid.x, grid.y, indexing="ij"), name="color")
        return replace(spread(nodes), quantity=lambda at: evaluate(color, at[:, 0], at[:, 1]))
    values = real(color, "color")
    if values.shape != grid.z.shape:
        raise ValueError(f"color must have the shape {grid.z.shape}, not {values.shape}")
    return spread(values)


def spread(values: Doubles) -> Field:
    """Values as a field; what is not finite, or too large to count with, is missing."""
    values = cut(values, None)
    if np.isnan(values).all():
        raise ValueError("color has no finite value")
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    return Field((values - low) / ((high - low) or 1.0), (low, high))


def _gradient(grid: Grid) -> tuple[Doubles, Doubles]:
    """How much z changes per unit of x and of y; beside a hole, toward the other side."""
    along_x, along_y = map(np.asarray, np.gradient(grid.z, grid.x, grid.y))
    if grid.rim is not None:
        along_x = _one_sided(along_x, np.diff(grid.z, axis=0) / np.diff(grid.x)[:, None])
        along_y = _one_sided(along_y.T, (np.diff(grid.z, axis=1) / np.diff(grid.y)).T).T
    return along_x, along_y


def _one_sided(slopes: Doubles, steps: Doubles) -> Doubles:
    """Slopes at lines of nodes, (n, m); missing ones are those of a step (n - 1, m) beside."""
    none = np.full((1, steps.shape[1]), np.nan)
    after, before = np.concatenate((steps, none)), np.concatenate((none, steps))
    beside = np.where(np.isnan(after), before, after)
    return np.where(np.isnan(slopes), beside, slopes)


def _height(grid: Grid, T: Doubles) -> Field:
    low, high = (float(corner[2]) for corner in grid.box)
    value = (grid.z - low) / ((high - low) or 1.0)
    return Field(value, (low, high), lambda points: points[:, 2])


def _slope(grid: Grid, T: Doubles) -> Field:
    return spread(np.hypot(*_gradient(grid)))


def _light(grid: Grid, T: Doubles) -> Field:
    """1 where the light falls straight on the upper side, 0 where it does so on the other.

    Lambert's cosine, brought from -1..1 to 0..1 and squared: so there is shape in the shade, too
    ("half Lambert": Mitchell, McTaggart and Green, "Shading in Valve's Source Engine", 2006).
    """
    along_x, along_y = _gradient(grid)
    normal = np.stack((-along_x, -along_y, np.ones_like(along_x)), axis=-1)
    # Normals go with the inverse transpose; a reflection turns no side over.
    turned = normal @ np.linalg.inv(T[:3, :3]).T
    turned /= np.linalg.norm(turned, axis=-1, keepdims=True)
    lit = (1 + turned @ (LIGHT / np.linalg.norm(LIGHT))) / 2
    return Field(lit**2, (0.0, 1.0))


FIELDS: dict[str, Callable[[Grid, Doubles], Field]] = {
    "z": _height,
    "slope": _slope,
    "light": _light,
}
