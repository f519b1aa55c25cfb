"""`surface`: the pieces put together. (`surfaces.bodies` has `parametric` and `sheet`.)

    sample f  ->  fit to the screen  ->  transform  ->  map to the screen  ->  draw what is seen

All that happens to a point between f and the pixel is one product with one 4x4 matrix.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np

from surfaces import checks
from surfaces.arrays import Box, Doubles
from surfaces.formulas import formula
from surfaces.look import BLANK, Look, Stage
from surfaces.modes import MODES, draw, draw_contours, draw_floor
from surfaces.scene import Plot
from surfaces.shape.fields import Color, fields
from surfaces.shape.grid import Grid, in_order
from surfaces.shape.rulers import PLAIN, Rulers, rulers
from surfaces.shape.sampling import Axis, Function, Interval, Table, is_table, real
from surfaces.space.mapping import Projection
from surfaces.systems.colors import Ramp
from surfaces.systems.pen import System
from surfaces.visible.pictures import HeightPicture

Levels = int | Sequence[float]
"""Contour lines: how many, or at which z."""
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
    log: str = "",
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

    Where f has no finite value there is a hole; it ends where f begins, also inside a cell (of data
    a cell without one corner is a triangle). In a mode of 256 colours palette entries 16 to 255 are
    loaded with the ramps. Several surfaces are drawn right as long as they do not cross inside a
    cell.

    Args:
        f: A function of two numbers or, faster, of two numpy arrays. Or its formula, such as
            "sin(x*y)/2". Or heights, a 2-D array of f[i, j] at x[i], y[j], NaN or masked where
            there is none. Or a list of functions, formulas or arrays over one domain.
        x: The domain, (a, b) with a < b; for a formula -3 to 3, if None. For heights also as many
            numbers, even or uneven, or None to count from 0, or what `numpy.meshgrid` made. All may
            be dates instead, numpy's or Python's.
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
        log: The axes to be logarithmic, such as "x" or "xz". What is not above 0 is a hole there.
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
    checks.choice("mode", mode, MODES)
    look = Look(
        projection=projection,
        theta=theta,
        rho_z=rho_z,
        zfrac=zfrac,
        log=log,
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
    laid_out = rulers(look.log, x, y)
    grids = _grids(f, x, y, n, z, laid_out)
    color = _in_order(color, f, laid_out[0].axis(x, "x"), laid_out[1].axis(y, "y"))
    _check_seen(mode, grids)
    stage = look.stage(mode, _around(grids), grids[0].z.shape, transform, mapping, laid_out)
    shown = fields(_in_places(color, laid_out), grids, stage.moved)
    levels = _levels("contours", on_surface, stage), _levels("floor", on_floor, stage)
    picture = HeightPicture(
        stage.easel,
        tuple(grid.around(stage.origin) for grid in grids),
        tuple(one.around(stage.origin) for one in shown),
    )
    with stage.surroundings(shown[0].limits, color):
        draw_floor(picture, stage.above_origin(levels[1]), stage.floor)
        draw(picture, mode)
        draw_contours(picture, stage.above_origin(levels[0]))
    return stage.plot(picture, shown[0].limits)


def _grids(
    f: Any,
    x: Axis | None,
    y: Axis | None,
    n: int | tuple[int, int],
    z: Interval | None,
    laid_out: Rulers,
) -> tuple[Grid, ...]:
    """The surfaces to draw, over one domain, in places of their rulers."""
    if isinstance(f, (list, tuple)) and f and all(map(_is_surface, f)):
        grids = tuple(grid for one in f for grid in _grids(one, x, y, n, z, laid_out))
        same = all(
            np.array_equal(grid.x, grids[0].x) and np.array_equal(grid.y, grids[0].y)
            for grid in grids
        )
        if not same:
            raise ValueError("several surfaces must have the same x and y")
        return grids
    if isinstance(f, Grid):
        return (_placed(f, laid_out),)
    along_x, along_y, up = laid_out
    if isinstance(f, str):
        x, y = (DOMAIN if axis is None else axis for axis in (x, y))
        f = formula(f)
    if callable(f):
        limits = None if z is None else up.ends(z, "z")
        f = _heights(f, laid_out)
        return (Grid.sample(f, along_x.ends(x, "x"), along_y.ends(y, "y"), n, limits),)
    return (_placed(Grid.of(f, along_x.axis(x, "x"), along_y.axis(y, "y"), z), laid_out),)


def _placed(grid: Grid, laid_out: Rulers) -> Grid:
    """A grid of numbers in places of their rulers."""
    if laid_out == PLAIN:
        return grid  # itself, with all that it knows already
    along_x, along_y, up = laid_out
    heights = up.place(grid.z, "f")
    if np.isnan(heights).all():
        raise ValueError("f must have a value above 0, where z is logarithmic")
    return Grid(
        along_x.along(grid.x, "x"),
        along_y.along(grid.y, "y"),
        heights,
        None if grid.limits is None else up.ends(grid.limits, "z"),
        None if grid.value is None else _heights(grid.value, laid_out),
    )


def _heights(f: Function, laid_out: Rulers) -> Function:
    """A function of places, instead of numbers, with its values in places, too."""
    f = _in_places(f, laid_out)
    return lambda x, y: laid_out[2].place(f(x, y), "f")


def _in_places(f: Any, laid_out: Rulers) -> Any:
    """A function of places, instead of numbers; anything but a function stays what it is."""
    along_x, along_y, _ = laid_out
    return (lambda x, y: f(along_x.read(x), along_y.read(y))) if callable(f) else f


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


def _levels(name: str, levels: int | list[float], stage: Stage) -> list[float]:
    """Heights for contours: about as many round ones as asked for, or those given."""
    (low, high), ruler = stage.heights, stage.rulers[2]
    if isinstance(levels, list):
        found: list[float] = ruler.every(levels, name).tolist()
        return found
    found = ruler.marks(low, high, levels, least=1).places if levels else []
    return [level for level in found if low < level < high]
