"""``surface`` and ``parametric``: the pieces put together.

    sample f  ->  fit to the screen  ->  transform  ->  map to the screen  ->  draw what is seen

All that happens to a point between f and the pixel is one product with one 4x4 matrix.
"""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from surfaces import frame
from surfaces.arrays import Doubles
from surfaces.frame import Frame, Surround
from surfaces.modes import MODES, Picture, draw_contours, draw_floor
from surfaces.shape.fields import field
from surfaces.shape.grid import Axis, Function, Grid, Interval, data, sample
from surfaces.shape.sheet import SHEET_MODES, SheetPicture, walk
from surfaces.space.fitting import Room, fit
from surfaces.space.mapping import Mapping, Projection
from surfaces.space.projections import projection as named
from surfaces.space.transforms import Point, apply, compose
from surfaces.space.view import View
from surfaces.systems.colors import Ramp, palette
from surfaces.systems.pen import Pen, System
from surfaces.ticks import ticks

Levels = int | Sequence[float]
MESH_LINES = 50
"""How many lines a mesh has in each direction, or nearly so, if it is not told."""
KEPT = 31 << 20
"""A block that the C library of Linux still takes for an ordinary one, in bytes."""

# That library hands the memory of a large array back to the system when it is freed, and the next
# frame pays for fresh pages, a fifth of its time; until a block has been freed: from then on it
# keeps twice as much. This block is never written to; elsewhere it changes nothing.
np.empty(KEPT, np.uint8)


@dataclass(frozen=True)
class Plot:
    """A surface as it was drawn: where its points are on the screen, and back."""

    mapping: Projection
    """From space to the screen."""
    transform: Doubles
    """4x4: from (x, y, z) of the surface to that space, fit and turn in one."""
    scales: Point
    """The chosen scales: pixels for a unit of x, y and z along the arrows of the mapping."""
    box: tuple[Doubles, Doubles]
    """The lowest and the highest corner of the surface."""
    limits: Interval
    """The values that the first and the last colour stand for."""
    picture: Picture | SheetPicture
    """What was drawn."""

    def project(self, points: ArrayLike) -> Doubles:
        """Where points (x, y, z), shape (..., 3), appear: the paper's triples (x', y', z)."""
        return apply(points, self.picture.view.screen)

    def unproject(self, triples: ArrayLike) -> Doubles:
        """The points (x, y, z) of triples (x', y', z), shape (..., 3)."""
        return apply(triples, self.picture.view.back)

    def depth(self, points: ArrayLike) -> Doubles:
        """How near points (..., 3) are: of two on one pixel, the greater number is the nearer."""
        near: Doubles = np.asarray(points, dtype=np.float64) @ self.picture.view.eye
        return near

    def pick(self, px: float, py: float) -> Point | None:
        """The nearest point (x, y, z) of the surface seen at a pixel, or None beside it.

        It maps back to the pixel, to half a pixel at the surface's outline. None, too, for a
        surface seen on its edge, narrower than two pixels.
        """
        point = self.picture.pick(px, py)
        return None if point is None else (float(point[0]), float(point[1]), float(point[2]))


def surface(
    f: Function | Grid | Sequence[Any] | Doubles,
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
    color: Any = "z",
    ramp: str | Ramp = "rainbow",
    under: str | Ramp = "dusk",
    dither: bool = False,
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

    f          a function of two numbers or, faster, of two numpy arrays; or heights, a 2-D array of
               f[i, j] at x[i], y[j]; or a list of functions over one domain
    x, y       the domain, (a, b) with a < b; for heights also as many numbers, even or uneven, or
               None to count from 0
    n          cells in each direction, or (nx, ny)
    mode       "fill": coloured by height. "mesh": lines of the grid. "fill+mesh": both.
               "waterfall": only lines of constant x. "wire": all lines, even hidden ones, in the
               current line style. "facets": cells of one colour, in the current fill pattern
    transform  a 4x4 matrix from `space.transforms`, applied before the mapping; with it, a
               fitted picture is smaller, so that it stays on the screen when turned
    mapping    where the points (x, y, z) go on the screen.  None: fit the picture to the screen,
               with the centre of the surface's box at (0, 0, 0) and x and y from -1 to 1, so that
               ``transform`` turns the surface about its centre and keeps its shape
    projection, theta, rho_z, zfrac   for the fitted picture: a name or view of
               ``surfaces.space.projections``, else the paper's with its angle and compression (see
               Mapping); and the part of the screen's height that z takes, or None for one scale on
               all axes
    z          (low, high): cut heights off there, infinities too; poles become holes
    color      what the colours tell: "z", "slope", "light", an array like f, a function of x and y
    ramp, under   the colours of the upper and the under side, names in `systems.colors.RAMPS`
    dither     blend the bands of colour where a screen has only a few
    lines      the colour of lines, or two, for the upper and the under side.  None: the current
               colour; in filled modes black
    every      a mesh line for every so many lines of the grid.  None: about fifty in all
    contours, floor   contour lines on the surface, and below it: how many, or at which z
    box, axes, title, colorbar   what is drawn around it; axes=("time", "Hz", "dB") names them
    on         the graphics system to draw on (see `systems.pen`).  None: the BGI's screen

    Where f has no finite value there is a hole; it ends where f begins, also inside a cell (data
    have only whole cells).  In a mode of 256 colours palette entries 16 to 255 are loaded with the
    ramps.  Several surfaces are drawn right as long as they do not cross inside a cell.
    ValueError, and nothing drawn, for arguments out of range.
    """
    _check(mode, MODES, every)
    pen = Pen(on)
    colors = palette(pen.colors, ramp, under, dither)
    grids = _grids(f, x, y, n, z)
    box_around = _box(grids)
    room = frame.room(pen, _named_axes(axes), bool(title), colorbar)
    arrows = Mapping(theta, rho_z) if projection is None else named(projection)
    normal, view = _placed(pen, box_around, mapping, arrows, zfrac, transform is not None, room)
    T = normal if transform is None else compose(normal, _checked(transform))
    fields = [field(color, grid, T) for grid in grids]
    limits = min(f.limits[0] for f in fields), max(f.limits[1] for f in fields)
    ink, under_ink = _inks(lines, 0 if "fill" in mode or mode == "facets" else pen.color)
    picture = Picture(
        pen=pen,
        grids=grids,
        fields=tuple(one.scaled(limits) for one in fields),
        view=View.of(T, view),
        palette=colors,
        ink=ink,
        under_ink=under_ink,
        every=every or _every(grids[0].z.shape),
    )
    heights = float(box_around[0][2]), float(box_around[1][2])
    on_surface, on_floor = _levels(contours, heights), _levels(floor, heights)
    around = Frame(pen, picture.view, *box_around)
    surround = Surround(around, colors, limits, box, axes, title, colorbar)
    surround.behind()
    draw_floor(picture, on_floor, around.far[2], heights)
    MODES[mode](picture)
    draw_contours(picture, on_surface)
    surround.before()
    return Plot(view, T, _scales(view, normal), box_around, limits, picture)


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
    dither: bool = False,
    lines: int | None = None,
    every: int | None = None,
    box: bool = False,
    axes: bool | Sequence[str] = False,
    title: str = "",
    colorbar: bool = False,
    on: System | None = None,
) -> Plot:
    """Draw the surface (x, y, z) = f(u, v), hidden parts removed, and return what was drawn.

    f          a function of two arrays that returns three: x, y and z
    u, v       the domain, (a, b) with a < b
    n          cells in each direction, or (nu, nv)
    mode       "fill": each pixel by its depth, always right. "mesh", "fill+mesh", "facets": whole
               cells by the depth of their middles, right to within a cell. "wire": all lines
    color      what the colours tell: "z", or a function of u and v
    under      the colours of the under side, the one from which u to v turns clockwise; None: the
               same as the other's, for a body closed in itself shows but one

    The rest as for ``surface``; zfrac None keeps the shape, so that a sphere is round.
    ValueError, and nothing drawn, for arguments out of range.
    """
    _check(mode, SHEET_MODES, every)
    pen = Pen(on)
    colors = palette(pen.colors, ramp, ramp if under is None else under, dither)
    sheet = walk(f, u, v, n)
    room = frame.room(pen, _named_axes(axes), bool(title), colorbar)
    arrows = Mapping(theta, rho_z) if projection is None else named(projection)
    normal, view = _placed(pen, sheet.box, mapping, arrows, zfrac, transform is not None, room)
    T = normal if transform is None else compose(normal, _checked(transform))
    shown = sheet.field(color)
    picture = SheetPicture(
        pen=pen,
        sheet=sheet,
        value=np.nan_to_num(shown.value),
        view=View.of(T, view),
        palette=colors,
        ink=_inks(lines, 0 if "fill" in mode or mode == "facets" else pen.color)[0],
        every=every or _every(shown.value.shape),
    )
    around = Frame(pen, picture.view, *sheet.box)
    surround = Surround(around, colors, shown.limits, box, axes, title, colorbar)
    surround.behind()
    SHEET_MODES[mode](picture)
    surround.before()
    return Plot(view, T, _scales(view, normal), sheet.box, shown.limits, picture)


def _check(mode: str, modes: Collection[str], every: int | None) -> None:
    if mode not in modes:
        raise ValueError(f"mode must be one of {', '.join(map(repr, modes))}, not {mode!r}")
    if every is not None and every < 1:
        raise ValueError(f"every must be at least 1, not {every!r}")


def _placed(
    pen: Pen,
    box: tuple[Doubles, Doubles],
    mapping: Projection | None,
    arrows: Projection,
    zfrac: float | None,
    turning: bool,
    room: Room,
) -> tuple[Doubles, Projection]:
    """The mapping as given, or fitted to the screen; with the transform that goes before it."""
    if mapping is not None:
        return np.eye(4), mapping
    return fit(
        box,
        pen.width,
        pen.height,
        arrows,
        zfrac=zfrac,
        aspect=pen.aspect,
        turning=turning,
        labels=room,
    )


def _scales(view: Projection, normal: Doubles) -> Point:
    x, y, z = np.array(view.scale) * np.diag(normal)[:3]
    return float(x), float(y), float(z)


def _named_axes(axes: bool | Sequence[str]) -> bool:
    """Whether there are axes; ValueError if they have names, and not three."""
    if not isinstance(axes, bool) and len(axes) != 3:
        raise ValueError(f"axes must be True, False or three names, not {axes!r}")
    return bool(axes)


def _every(nodes: tuple[int, ...]) -> int:
    return max(1, round(max(nodes) / MESH_LINES))


def _grids(
    f: Any, x: Axis | None, y: Axis | None, n: int | tuple[int, int], z: Interval | None
) -> tuple[Grid, ...]:
    """The surfaces to draw, over one domain."""
    if isinstance(f, (list, tuple)) and f and all(callable(g) or isinstance(g, Grid) for g in f):
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
    return (sample(f, x, y, n, z),) if callable(f) else (data(f, x, y, z),)


def _box(grids: Sequence[Grid]) -> tuple[Doubles, Doubles]:
    """The box around all of them."""
    boxes = np.array([grid.box for grid in grids])
    return boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)


def _inks(lines: int | tuple[int, int] | None, usual: int) -> tuple[int, int]:
    if isinstance(lines, tuple):
        return lines
    return (usual, usual) if lines is None else (lines, lines)


def _levels(levels: Levels, heights: Interval) -> list[float]:
    """Round heights inside the surface, about so many, or those given."""
    low, high = heights
    if not isinstance(levels, int):
        return [float(level) for level in levels]
    return [level for level in ticks(low, high, levels) if low < level < high] if levels else []


def _checked(transform: Doubles) -> Doubles:
    T = np.asarray(transform, dtype=np.float64)
    if T.shape != (4, 4) or not np.isfinite(T).all():
        raise ValueError(f"transform must be a 4x4 matrix of finite numbers, not {transform!r}")
    return T
