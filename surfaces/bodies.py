"""`parametric` and `sheet`: surfaces anywhere in space, by a function or by their points.

The pieces are those of `surface`, see `surfaces.plot`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import pi
from typing import Any

from surfaces import checks
from surfaces.arrays import Doubles
from surfaces.look import BLANK, Look
from surfaces.scene import Plot
from surfaces.shape.rulers import rulers
from surfaces.shape.sampling import Function, Interval, Table
from surfaces.shape.sheet import Sheet
from surfaces.space.mapping import Projection
from surfaces.systems.colors import Ramp
from surfaces.systems.pen import System
from surfaces.visible import painter
from surfaces.visible.pictures import SheetPicture


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
    log: str = "",
    color: str | Function | Table = "z",
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
        log: As for `surface`. A point with a number not above 0 there is a hole.
        color: What the colours show: "z", a function of u and v, a number for every node.
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
    checks.choice("mode", mode, painter.MODES)
    look = Look(
        projection=projection,
        theta=theta,
        rho_z=rho_z,
        zfrac=zfrac,
        log=log,
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
    sheet = Sheet.sample(f, u, v, n, partial(rulers, look.log))
    return _draw_sheet(sheet, look, mode, transform, mapping, color)


def sheet(
    x: Table,
    y: Table,
    z: Table,
    mode: str = "fill",
    transform: Doubles | None = None,
    mapping: Projection | None = None,
    *,
    projection: str | Projection | None = None,
    theta: float = pi / 4,
    rho_z: float = 1.0,
    zfrac: float | None = None,
    log: str = "",
    color: str | Table = "z",
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
    """Draw the surface through points in rows and columns, from arrays of their x, y and z.

    Each point is joined to those of the next row and of the next column: so the grid may be bent,
    and the surface may fold back, or close to a ring. A point that is NaN or masked is a hole.

    Args:
        x: The x of the points, a 2-D array of 2 by 2 numbers or more...
        y: ... their y, an array of the same shape...
        z: ... and their z.
        mode: As for `parametric`.
        transform: As for `surface`, like all that is not described here.
        mapping: As for `surface`.
        projection: As for `surface`.
        theta: As for `surface`.
        rho_z: As for `surface`.
        zfrac: As for `surface`; None keeps the shape, so that a ball is round. For a landscape,
            whose z is in other units, give a number.
        log: As for `surface`. A point with a number not above 0 there is a hole.
        color: What the colours show: "z", or an array like x, y and z.
        ramp: As for `surface`.
        under: The colours of the under side, the one from which rows to columns turn clockwise.
            None: the same as the other's.
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
        ValueError: for shapes that differ, arguments out of range, and where there is nothing to be
            seen.
        TypeError: for arguments of another kind. In both cases nothing is drawn.
    """
    checks.choice("mode", mode, painter.MODES)
    look = Look(
        projection=projection,
        theta=theta,
        rho_z=rho_z,
        zfrac=zfrac,
        log=log,
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
    points = Sheet.of(x, y, z, rulers(look.log, x, y))
    return _draw_sheet(points, look, mode, transform, mapping, color)


def _draw_sheet(
    sheet: Sheet,
    look: Look,
    mode: str,
    transform: Doubles | None,
    mapping: Projection | None,
    color: str | Function | Table,
) -> Plot:
    stage = look.stage(mode, sheet.box, sheet.points.shape[:2], transform, mapping, sheet.rulers)
    if sheet.blank and mode != "wire":
        raise ValueError(BLANK)
    shown = sheet.field(color)
    picture = SheetPicture(stage.easel, sheet.around(stage.origin), shown)
    with stage.surroundings(shown.limits, color):
        painter.MODES[mode](picture)
    return stage.plot(picture, shown.limits)
