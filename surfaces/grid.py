"""A function as a grid of points: sampled, repaired where a point is missing, fitted to the screen.

sin(x+y)/(x+y) has no value where x+y = 0, yet the surface has no hole there.  ``sample`` looks
beside such a node: if the neighbourhood agrees on a value, the node gets it.  Where it does not
agree, as along the cliff of 1/(x+y), the hole is real and the node stays NaN.

``fit`` is the "proper scaling" of the paper's figures.  x may run over 20 units and z over one, so
it first puts the surface into a box of pleasing shape, -1 to 1 along x and y, and then chooses how
many pixels a unit of that box gets.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import Any

import numpy as np

from surfaces.mapping import Mapping
from surfaces.transforms import FloatArray, compose, scaling, translation

Function = Callable[[Any, Any], Any]
Interval = tuple[float, float]

# Where to look beside a node, in units of the domain's width and depth: once in every quadrant, off
# the diagonals, and at four distances, so that 1/x**2 and log(x**2) are seen to grow.
BESIDE = 1e-6 * np.array(((1.0, 1.37), (1.7, -2.3), (-2.6, 3.5), (-3.9, -5.3)))
AGREEMENT = 1e-3

# What stays free around the picture, as a part of the shorter side: 24 pixels of 480.
MARGIN = 0.05


@dataclass(frozen=True)
class Grid:
    """f on a rectangle: z[i, j] = f(x[i], y[j]), NaN where f has no value; x and y ascend."""

    x: FloatArray
    y: FloatArray
    z: FloatArray

    @property
    def points(self) -> FloatArray:
        """The nodes (x, y, z) as an array of shape (len(x), len(y), 3)."""
        x, y = np.meshgrid(self.x, self.y, indexing="ij")
        return np.stack((x, y, self.z), axis=-1)

    @property
    def box(self) -> tuple[FloatArray, FloatArray]:
        """The lowest and the highest corner of the box around the surface."""
        low = np.array((self.x[0], self.y[0], np.nanmin(self.z)))
        high = np.array((self.x[-1], self.y[-1], np.nanmax(self.z)))
        return low, high


def sample(f: Function, x: Interval, y: Interval, n: int | tuple[int, int] = 50) -> Grid:
    """Evaluate f(x, y) on a grid of n by n cells, or nx by ny for n = (nx, ny).

    f is called once with two arrays of nx+1 by ny+1 numbers; a function that cannot take arrays is
    called point by point instead.  Infinities and points without a value become NaN.
    ValueError unless a < b in x = (a, b) and y = (c, d), n is 1 or more, and f is finite somewhere.
    """
    nx, ny = n if isinstance(n, tuple) else (n, n)
    if nx < 1 or ny < 1:
        raise ValueError(f"n must be at least 1 in each direction, not {n!r}")
    xs, ys = _nodes("x", x, nx), _nodes("y", y, ny)
    across, along = np.meshgrid(xs, ys, indexing="ij")
    z = evaluate(f, across, along)
    missing = np.isnan(z)
    if missing.any():
        z[missing] = _beside(f, across[missing], along[missing], xs[-1] - xs[0], ys[-1] - ys[0])
        if np.isnan(z).all():
            raise ValueError(f"f has no finite value on x = {x!r}, y = {y!r}")
    return Grid(xs, ys, z)


def evaluate(f: Function, x: FloatArray, y: FloatArray) -> FloatArray:
    """f at every point of two arrays of one shape; NaN where it is infinite or undefined."""
    with np.errstate(all="ignore"):
        try:
            z = _real(f(x, y))
            whole = z.shape == x.shape
        except Exception:  # whatever a function of single numbers does when given arrays
            whole = False
        if not whole:
            z = np.vectorize(_or_nan(f), otypes=[np.float64])(x, y)
    return np.where(np.isfinite(z), z, np.nan)


def _real(values: Any) -> FloatArray:
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


def _beside(f: Function, x: FloatArray, y: FloatArray, width: float, depth: float) -> FloatArray:
    """The value that f has all around each of these points, or NaN where there is no such value."""
    dx, dy = BESIDE[:, :1] * width, BESIDE[:, 1:] * depth
    around = evaluate(f, x + dx, y + dy)
    with np.errstate(all="ignore"):
        value = around.mean(axis=0)
        agreed = np.ptp(around, axis=0) < AGREEMENT * (1 + np.abs(value))
    return np.where(agreed, value, np.nan)


def _nodes(name: str, interval: Interval, n: int) -> FloatArray:
    a, b = interval
    if not -np.inf < a < b < np.inf:
        raise ValueError(f"{name} must be (a, b) with finite a < b, not {interval!r}")
    return np.linspace(a, b, n + 1)


def fit(
    box: tuple[FloatArray, FloatArray],
    width: int,
    height: int,
    *,
    theta: float = pi / 4,
    rho_z: float = 1.0,
    zfrac: float = 0.3,
    aspect: float = 1.0,
    turning: bool = False,
) -> tuple[FloatArray, Mapping]:
    """Scale a box to fill a screen of width x height pixels, its centre in the middle.

    Returns a transform and a mapping.  The transform puts the box around (0, 0, 0), with x and y
    from -1 to 1 and z so high that it takes the part ``zfrac`` of the height; turn the surface
    there, and its shape is kept.  The mapping brings that to the screen.  ``aspect`` is the width
    of a pixel divided by its height.  With ``turning`` the picture is small enough to stay on the
    screen however it is turned.

    ValueError if theta, rho_z or zfrac is outside its range.
    """
    Mapping(theta, rho_z)  # for its checks: below, other numbers take their place
    if not 0.0 < zfrac < 1.0:
        raise ValueError(f"zfrac must be between 0 and 1, not {zfrac!r}")
    s, c = sin(theta), cos(theta)
    # From the centre of the first pixel to that of the last, in widths of a pixel.
    across, down = width - 1, (height - 1) / aspect
    margin = MARGIN * min(width, height)
    wide, high = across - 2 * margin, down - 2 * margin / aspect
    side, tall = min(wide / (1 + s), high * (1 - zfrac) / c), high * zfrac
    unit = side / 2
    if turning:
        # The ball around the box, as seen; a corner comes near the screen's edge only in passing.
        ball = hypot(side, side, tall)
        unit *= min(1.0, across / (ball * hypot(1, s)), down / (ball * hypot(c, rho_z)))
    lowest, highest = box
    extent = highest - lowest
    extent[extent == 0] = 1.0  # a flat surface stays flat
    normal = compose(
        translation(*-(lowest / 2 + highest / 2)),
        scaling(*np.array((2, 2, 2 * tall / side)) / extent),
    )
    # Pixels that are higher than wide: fewer of them go into a height, so x leans more.
    lean = hypot(s, aspect * c)
    mapping = Mapping(
        theta=atan2(s, aspect * c),
        rho_z=rho_z,
        origin=((width - 1) / 2, (height - 1) / 2),
        scale=(unit * lean, unit, unit * aspect),
    )
    return normal, mapping
