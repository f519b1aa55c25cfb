"""`surface` and `parametric`: the pieces put together.

    sample f  ->  fit to the screen  ->  transform  ->  map to the screen  ->  draw what is seen

All that happens to a point between f and the pixel is one product with one 4x4 matrix.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from math import pi
from typing import Any

import numpy as np

from surfaces import checks
from surfaces.arrays import Box, Doubles
from surfaces.formulas import formula
from surfaces.look import Look, Stage
from surfaces.modes import MODES, draw, draw_contours, draw_floor
from surfaces.scene import Plot
from surfaces.shape.fields import Color, fields
from surfaces.shape.grid import Grid, in_order
from surfaces.shape.sampling import Axis, Function, Interval, Table, is_table, real
from surfaces.shape.sheet import Sheet
from surfaces.space.mapping import Projection
from surfaces.systems.colors import Ramp
from surfaces.systems.pen import System
from surfaces.ticks import ticks
from surfaces.visible import painter
from surfaces.visible.painter import Picture
from surfaces.visible.pictures import HeightPicture, SheetPicture

Levels = int | Sequence[float]
"""Contour lines: how many, or at which z."""
BLANK = "nothing of the surface can be seen: each of its cells has a corner without a value"
DOMAIN = (-3.0, 3.0)
"""Where a formula is drawn, unless told otherwise."""


def surface(
    f: Function | str | Grid | Table,
    x: Axis | None = None,
    y: Axis | None = None,
    n: int | tuple[int, int] = 200,
    mode: str = "fill",
    transform: Doubles | None = None,
    mapping: Projection | None = None,
    *,
    projection: str | Projection | None = None,
    theta: float = pi / 4,
    rho_z: float = 1.0,
    zfrac: float | None = 0.3,
    z: Interval | None = None,
    color: Color = "z",
    ramp: str | Ramp = "rainbow",
    under: str | Ramp = "dusk",
    dither: bool = True,
    lines: int | tuple[int, int] | None = None,
    every: int | None = None,
    contours: Levels = 0,
    floor: Levels = 0,
    box: bool = False,
    axes: bool | Sequence[str] = False,
    title: str = "",
    colorbar: bool = False,
    on: System | None = None,
) -> Plot:
    """Draw the surface z = f(x, y), hidden parts removed, and return what was drawn.

    Where f has no finite value there is a hole; it ends where f begins, also inside a cell (data
    have only whole cells). In a mode of 256 colours palette entries 16 to 255 are loaded with the
    ramps. Several surfaces are drawn right as long as they do not cross inside a cell.

    Args:
        f: A function of two numbers or, faster, of two numpy arrays. Or its formula, such as
            "sin(x*y)/2". Or heights, a 2-D array of f[i, j] at x[i], y[j], NaN or masked where
            there is none. Or a list of functions, formulas or arrays over one domain.
        x: The domain, (a, b) with a < b; for a formula -3 to 3, if None. For heights also as many
            numbers, even or uneven, or None to count from 0, or what `numpy.meshgrid` made.
        y: The same for y.
        n: Cells in each direction, or (nx, ny), of 16 million points at most.
        mode: "fill": coloured by height. "mesh": lines of the grid. "fill+mesh": both.
            "waterfall": only lines of constant x. "wire": all lines, even hidden ones, in the
            current line style. "facets": cells of one colour, in the current fill pattern.
        transform: A 4x4 matrix, such as `rotation` makes, applied before the mapping. With it, a
            fitted picture is smaller, so that it stays on the screen when turned.
        mapping: Where the points (x, y, z) go on the screen. None: fit the picture to the screen,
            with the centre of the surface's box at (0, 0, 0) and x and y from -1 to 1, so that
            `transform` turns the surface about its centre and keeps its shape.
        projection: How a fitted picture is seen: a name of `PROJECTIONS`, or a view such as
            `orthographic` makes. None: the paper's view, with the next two.
        theta: How far the x axis leans from straight down, in radians, between 0 and pi/2.
        rho_z: By how much heights are compressed, above 0 and at most 1.
        zfrac: The part of the screen's height that z takes in a fitted picture, between 0 and 1.
            None: one scale on all axes.
        z: (low, high): cut heights off there, infinities too; poles become holes.
        color: What the colours show: "z", "slope", "light", an array like f, a function of x and y.
        ramp: The colours of the upper side, a name of `RAMPS`.
        under: The colours of the under side.
        dither: Blend the bands of colour where a screen has only 2, 4 or 16 colours. False leaves
            bands.
        lines: The colour of lines, or two, for the upper and the under side. None: the current
            colour; in filled modes black.
        every: Draw every n-th line of the grid in a mesh. None: about fifty in all.
        contours: Contour lines on the surface: how many, at most 1000, or at which z.
        floor: Contour lines on the floor below it: how many, at most 1000, or at which z.
        box: Draw a box around the surface.
        axes: Draw axes with numbers; axes=("time", "Hz", "dB") names them, too.
        title: A line of text above the picture.
        colorbar: Draw a bar that shows what the colours stand for.
        on: The graphics system to draw on, such as `Svg` or `Text`. None: the BGI's screen.

    Returns:
        A `Plot`, which knows where on the screen a point is, and which point is at a pixel.

    Raises:
        ValueError: for arguments out of range, and where there is nothing to be seen.
        TypeError: for arguments of another kind. In both cases nothing is drawn.
    """
    _check(mode, MODES)
    look = Look(
        projection=projection,
        theta=theta,
        rho_z=rho_z,
        zfrac=zfrac,
        ramp=ramp,
        under=under,
        dither=dither,
        lines=lines,
        every=every,
        box=box,
        axes=axes,
        title=title,
        colorbar=colorbar,
        on=on,
    )
    on_surface, on_floor = checks.levels("contours", contours), checks.levels("floor", floor)
    grids = _grids(f, x, y, n, z)
    color = _in_order(color, f, x, y)
    _check_seen(mode, grids)
    stage = look.stage(mode, _around(grids), grids[0].z.shape, transform, mapping)
    shown = fields(color, grids, stage.moved)
    picture = HeightPicture(
        stage.easel,
        tuple(grid.around(stage.origin) for grid in grids),
        tuple(one.around(stage.origin) for one in shown),
    )
    with stage.surroundings(shown[0].limits):
        draw_floor(picture, stage.above_origin(_levels(on_floor, stage.heights)), stage.floor)
        draw(picture, mode)
        draw_contours(picture, stage.above_origin(_levels(on_surface, stage.heights)))
    return _plot(stage, picture, shown[0].limits)


def parametric(
    f: Callable[[Any, Any], Any],
    u: Interval,
    v: Interval,
    n: int | tuple[int, int] = 100,
    mode: str = "fill",
    transform: Doubles | None = None,
    mapping: Projection | None = None,
    *,
    projection: str | Projection | None = None,
    theta: float = pi / 4,
    rho_z: float = 1.0,
    zfrac: float | None = None,
    color: str | Function = "z",
    ramp: str | Ramp = "rainbow",
    under: str | Ramp | None = None,
    dither: bool = True,
    lines: int | None = None,
    every: int | None = None,
    box: bool = False,
    axes: bool | Sequence[str] = False,
    title: str = "",
    colorbar: bool = False,
    on: System | None = None,
) -> Plot:
    """Draw the surface (x, y, z) = f(u, v), hidden parts removed, and return what was drawn.

    Args:
        f: A function of two arrays that returns three: x, y and z.
        u: The domain, (a, b) with a < b.
        v: The same for v.
        n: Cells in each direction, or (nu, nv).
        mode: "fill": each pixel by its depth, always right. "mesh", "fill+mesh", "facets": whole
            cells by the depth of their middles, right to within a cell. "wire": all lines.
        transform: As for `surface`, like all that is not described here.
        mapping: As for `surface`.
        projection: As for `surface`.
        theta: As for `surface`.
        rho_z: As for `surface`.
        zfrac: As for `surface`; None keeps the shape, so that a sphere is round.
        color: What the colours show: "z", or a function of u and v.
        ramp: As for `surface`.
        under: The colours of the under side, the one from which u to v turns clockwise. None: the
            same as the other's, for a body closed in itself shows only one.
        dither: As for `surface`.
        lines: The colour of lines. None: the current colour; in filled modes black.
        every: As for `surface`.
        box: As for `surface`.
        axes: As for `surface`.
        title: As for `surface`.
        colorbar: As for `surface`.
        on: As for `surface`.

    Returns:
        A `Plot`, as `surface` does.

    Raises:
        ValueError: for arguments out of range, and where there is nothing to be seen.
        TypeError: for arguments of another kind. In both cases nothing is drawn.
    """
    _check(mode, painter.MODES)
    look = Look(
        projection=projection,
        theta=theta,
        rho_z=rho_z,
        zfrac=zfrac,
        ramp=ramp,
        under=ramp if under is None else under,
        dither=dither,
        lines=lines,
        every=every,
        box=box,
        axes=axes,
        title=title,
        colorbar=colorbar,
        on=on,
    )
    sheet = Sheet.sample(f, u, v, n)
    stage = look.stage(mode, sheet.box, sheet.points.shape[:2], transform, mapping)
    if not sheet.whole.any() and mode != "wire":
        raise ValueError(BLANK)
    shown = sheet.field(color)
    picture = SheetPicture(stage.easel, sheet.around(stage.origin), shown)
    with stage.surroundings(shown.limits):
        painter.MODES[mode](picture)
    return _plot(stage, picture, shown.limits)


def _check(mode: str, modes: Collection[str]) -> None:
    if not isinstance(mode, str) or mode not in modes:
        raise ValueError(f"mode must be one of {', '.join(map(repr, modes))}, not {mode!r}")


def _plot(stage: Stage, picture: Picture, limits: Interval) -> Plot:
    return Plot(stage.mapping, stage.transform, stage.scales, stage.box, limits, picture)


def _grids(
    f: Any, x: Axis | None, y: Axis | None, n: int | tuple[int, int], z: Interval | None
) -> tuple[Grid, ...]:
    """The surfaces to draw, over one domain."""
    if isinstance(f, (list, tuple)) and f and all(map(_is_surface, f)):
        grids = tuple(grid for one in f for grid in _grids(one, x, y, n, z))
        same = all(
            np.array_equal(grid.x, grids[0].x) and np.array_equal(grid.y, grids[0].y)
            for grid in grids
        )
        if not same:
            raise ValueError("several surfaces must have the same x and y")
        return grids
    if isinstance(f, Grid):
        return (f,)
    if isinstance(f, str):
        x, y = (DOMAIN if axis is None else axis for axis in (x, y))
        f = formula(f)
    return (Grid.sample(f, x, y, n, z) if callable(f) else Grid.of(f, x, y, z),)


def _is_surface(f: Any) -> bool:
    return callable(f) or isinstance(f, (str, Grid)) or is_table(f)


def _in_order(color: Color, f: Any, x: Axis | None, y: Axis | None) -> Color:
    """Colours in an array of the same shape as heights are in the same order, too."""
    if isinstance(color, str) or callable(color):
        return color
    values = real(color, "color")
    first = f[0] if isinstance(f, (list, tuple)) and is_table(f[0]) else f
    if is_table(first) and np.shape(first) == values.shape:
        return in_order(x, y, values)[2]
    return values


def _check_seen(mode: str, grids: Sequence[Grid]) -> None:
    lines = mode in ("wire", "waterfall") and any(
        joined.any() for grid in grids for joined in grid.joined
    )
    if all(grid.blank for grid in grids) and not lines:
        raise ValueError(BLANK)


def _around(grids: Sequence[Grid]) -> Box:
    """The box around all of them."""
    boxes = np.array([grid.box for grid in grids])
    return boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)


def _levels(levels: int | list[float], heights: Interval) -> list[float]:
    """Heights for contours: about as many round ones as asked for, or those given."""
    low, high = heights
    if isinstance(levels, list):
        return levels
    found = ticks(low, high, levels, least=1) if levels else []
    return [level for level in found if low < level < high]
