"""``surface``: the pieces put together.

    sample f  ->  fit to the screen  ->  transform  ->  map to the screen  ->  draw back to front

All that happens to a point between f and the pixel is one product with one 4x4 matrix.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from surfaces import pen
from surfaces.colours import shades
from surfaces.grid import Function, Interval, fit, sample
from surfaces.hidden import back_to_front, eye_from_surface, quads
from surfaces.mapping import Mapping
from surfaces.transforms import FloatArray, apply, compose

BACKGROUND = 0


@dataclass(frozen=True)
class View:
    """A surface as the screen sees it: fields over the grid, the nearest node last."""

    nodes: FloatArray
    """Where each node appears: (nx+1, ny+1, 2), NaN where f has no value."""
    part: FloatArray
    """How high f is there: 0 at its lowest, 1 at its highest."""
    dither: bool
    """Whether to blend the bands of colour."""

    def cells(self) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
        """The corners of the cells that have all four, (n, 4, 2), and which cells those are."""
        corners = quads(self.nodes)
        whole = np.asarray(np.isfinite(corners).all(axis=(2, 3)))
        return pen.pixels(corners[whole]), whole


def surface(
    f: Function,
    x: Interval,
    y: Interval,
    n: int | tuple[int, int] = 50,
    mode: str = "fill",
    transform: FloatArray | None = None,
    mapping: Mapping | None = None,
    *,
    theta: float = pi / 4,
    rho_z: float = 1.0,
    zfrac: float = 0.3,
    dither: bool = False,
) -> None:
    """Draw the surface z = f(x, y) on the current screen.

    f          a function of two numbers or, faster, of two numpy arrays
    x, y       its domain, (a, b) with a < b
    n          cells in each direction, or (nx, ny)
    mode       "wire": both families of lines.  "mesh": the same, hidden lines removed.  Both are
               drawn in the current colour and line style.  "fill": cells coloured by height, in
               the current fill pattern
    transform  a 4x4 matrix from ``surfaces.transforms``, applied before the mapping; with it, a
               fitted picture is smaller, so that it stays on the screen when turned
    mapping    where the points (x, y, z) go on the screen.  None: fit the picture to the screen,
               with the centre of the surface's box at (0, 0, 0) and x and y from -1 to 1, so that
               ``transform`` turns the surface about its centre and keeps its shape
    theta, rho_z, zfrac   for the fitted picture: the paper's angle and compression (see Mapping),
               and the part of the screen's height that z takes
    dither     blend the bands of colour where a screen has only a few

    Cells where f has no finite value stay empty.  In a mode of 256 colours "fill" loads palette
    entries 16 to 255 with its ramp.  ValueError, and nothing drawn, for arguments out of range.
    """
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(map(repr, MODES))}, not {mode!r}")
    grid = sample(f, x, y, n)
    T = np.eye(4)
    if mapping is None:
        T, mapping = fit(
            grid.box,
            *pen.size(),
            theta=theta,
            rho_z=rho_z,
            zfrac=zfrac,
            aspect=pen.aspect(),
            turning=transform is not None,
        )
    if transform is not None:
        T = compose(T, _checked(transform))
    eye = eye_from_surface(mapping.eye, T)
    points = apply(grid.points, T @ mapping.M4)
    low, high = grid.box[0][2], grid.box[1][2]
    part = (grid.z - low) / (high - low or 1.0)
    nodes = back_to_front(points[..., :2], eye)
    MODES[mode](View(nodes, back_to_front(part, eye), dither))


def _checked(transform: FloatArray) -> FloatArray:
    T = np.asarray(transform, dtype=np.float64)
    if T.shape != (4, 4) or not np.isfinite(T).all():
        raise ValueError(f"transform must be a 4x4 matrix of finite numbers, not {transform!r}")
    return T


def _wire(view: View) -> None:
    nodes = view.nodes
    starts = np.concatenate((nodes[:-1].reshape(-1, 2), nodes[:, :-1].reshape(-1, 2)))
    ends = np.concatenate((nodes[1:].reshape(-1, 2), nodes[:, 1:].reshape(-1, 2)))
    whole = np.isfinite(starts + ends).all(axis=1)
    pen.lines(pen.pixels(starts[whole]), pen.pixels(ends[whole]))


def _mesh(view: View) -> None:
    """Each cell covers what lies behind it with the background, and then shows its outline."""
    cells, _ = view.cells()
    pen.polygons(cells, BACKGROUND, pen.colour())


def _fill(view: View) -> None:
    pen.load_ramp()
    cells, whole = view.cells()
    part = quads(view.part[..., np.newaxis]).mean(axis=(2, 3))
    pen.polygons(cells, shades(part, pen.colours(), view.dither)[whole], BACKGROUND)


MODES: dict[str, Callable[[View], None]] = {"wire": _wire, "mesh": _mesh, "fill": _fill}
