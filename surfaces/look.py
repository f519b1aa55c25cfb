"""How a surface looks: the options that surfaces of every kind share, and their effect.

A `Look` holds the options as they were given. For a surface of a certain size it makes a `Stage`:
pen, palette and view ready to draw with, and the surroundings ready to be drawn.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from surfaces import checks, frame
from surfaces.arrays import Box, Doubles, corners, keep_freed_memory, middle
from surfaces.frame import Frame, draw_bar, write_title
from surfaces.scene import Plot
from surfaces.shape.rulers import EVEN, Rulers
from surfaces.shape.sampling import HUGE, Interval, real
from surfaces.space.fitting import fit
from surfaces.space.mapping import Mapping, Projection
from surfaces.space.perspective import check_in_front
from surfaces.space.projections import projection
from surfaces.space.transforms import Point, affine, compose, translation
from surfaces.space.view import View
from surfaces.systems.colors import Ramp, palette
from surfaces.systems.pen import BLACK, Pen, System
from surfaces.visible.painter import FILLED, Easel, Picture

BLANK = "nothing of the surface can be seen: no cell has enough corners with a value"
MESH_LINES = 50
"""About how many lines a mesh has in each direction, unless told otherwise."""
CHECKS: dict[str, Callable[[str, Any], Any]] = {
    "theta": checks.number,
    "rho_z": checks.number,
    "zfrac": checks.or_none(checks.number),
    "log": checks.log,
    "dither": checks.flag,
    "lines": checks.or_none(checks.one_or_two),
    "every": checks.or_none(checks.count),
    "box": checks.flag,
    "axes": checks.axes,
    "title": checks.text,
    "colorbar": checks.flag,
    "on": checks.or_none(checks.system),
}
"""What is asked of each option when a `Look` is made."""


@dataclass(frozen=True, kw_only=True)
class Look:
    """The options that surfaces of every kind share; an error for one that cannot be.

    The plain words for each are in `surface`.
    """

    projection: str | Projection | None
    """A name of `PROJECTIONS` or a view, for the fitted picture. None: the paper's view..."""
    theta: float
    """... with this angle of the x axis from straight down, in radians: 0 < theta < pi/2..."""
    rho_z: float
    """... and heights compressed by this: 0 < rho_z <= 1."""
    zfrac: float | None
    """The part of the screen's height that z takes, 0 to 1. None: one scale for all axes."""
    log: str
    """The axes that are logarithmic, such as "xz"."""
    ramp: str | Ramp
    """The colours of the upper side, by a name of `RAMPS` or mixed by hand."""
    under: str | Ramp
    """The colours of the under side."""
    dither: bool
    """Whether to blend bands of colour where the screen has only a few."""
    lines: int | tuple[int, int] | None
    """The colour of lines, or one for each side. None: the current one; in filled modes black."""
    every: int | None
    """How many lines of the grid make one line of the mesh. None: about MESH_LINES in all."""
    box: bool
    """Whether to draw the edges of the box around the surface."""
    axes: bool | Sequence[str]
    """Whether to draw axes with numbers, or what to call the three of them."""
    title: str
    """A line above the picture."""
    colorbar: bool
    """Whether to draw a bar that shows what the colours stand for."""
    on: System | None
    """The graphics system to draw on. None: the BGI's current screen."""

    def __post_init__(self) -> None:
        for name, check in CHECKS.items():
            # What has been checked takes the place of what was given.
            object.__setattr__(self, name, check(name, getattr(self, name)))

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the three axes; none without axes."""
        if isinstance(self.axes, bool):
            return ("x", "y", "z") if self.axes else ()
        return tuple(self.axes)

    def stage(
        self,
        mode: str,
        box: Box,
        nodes: tuple[int, ...],
        transform: Doubles | None,
        mapping: Projection | None,
        rulers: Rulers,
    ) -> "Stage":
        """Make ready to draw a surface.

        Args:
            mode: The mode it will be drawn in.
            box: The box around it. What is drawn on the stage counts from the middle of it.
            nodes: How many nodes it has in each direction.
            transform: 4x4, what moves it before it is mapped. None: nothing.
            mapping: How it is mapped to the screen. None: so that it fits.
            rulers: Those of its axes.
        """
        keep_freed_memory()
        pen = Pen(self.on)
        fitted, mapping = self._fitted(pen, box, mapping, rulers, turning=transform is not None)
        T = fitted if transform is None else compose(fitted, _checked(transform))
        view = View.of(T, mapping)
        check_in_front(corners(box) - middle(box), view.screen)
        ink, under_ink = self._inks(BLACK if mode in FILLED else pen.color)
        easel = Easel(
            pen=pen,
            palette=palette(pen.colors, self.ramp, self.under, self.dither),
            view=view,
            ink=ink,
            under_ink=under_ink,
            every=self.every or max(1, round(max(nodes) / MESH_LINES)),
        )
        return Stage(self, easel, box, mapping, fitted, T, rulers)

    def _fitted(
        self, pen: Pen, box: Box, mapping: Projection | None, rulers: Rulers, turning: bool
    ) -> tuple[Doubles, Projection]:
        """The mapping as given, or one that fits; and the 4x4 transform that goes before it."""
        given = self.projection
        view = Mapping(self.theta, self.rho_z) if given is None else projection(given)
        origin = middle(box)
        if mapping is not None:
            if not isinstance(mapping, Projection):
                raise TypeError(f"mapping must be such as `Mapping` makes, not {mapping!r:.60}")
            return translation(*origin), mapping
        low, high = box
        return fit(
            (low - origin, high - origin),
            pen.width,
            pen.height,
            view,
            zfrac=self.zfrac,
            aspect=pen.aspect,
            turning=turning,
            labels=frame.room(pen, bool(self.names), bool(self.title), self.colorbar, rulers),
        )

    def _inks(self, usual: int) -> tuple[int, int]:
        """The colours of lines on the upper and on the under side."""
        if isinstance(self.lines, tuple):
            return self.lines
        ink = usual if self.lines is None else self.lines
        return ink, ink


@dataclass(frozen=True)
class Stage:
    """A screen made ready for a surface."""

    look: Look
    easel: Easel
    box: Box
    """The box around the surface."""
    mapping: Projection
    """From space to the screen."""
    fitted: Doubles
    """4x4: puts the surface, counted from the origin, into the middle of that space."""
    moved: Doubles
    """4x4: the same, and then what turns it there."""
    rulers: Rulers
    """Those of the surface's axes."""

    @property
    def origin(self) -> Doubles:
        """(3,): the middle of the box, from which the coordinates of all that is drawn count.

        Far from zero the products of a large coordinate with a matrix would lose digits. Times in
        seconds since 1970, say, and the steps between them, differ by nine of sixteen digits.
        """
        return middle(self.box)

    @property
    def transform(self) -> Doubles:
        """4x4: `moved`, for coordinates that count from zero."""
        return compose(translation(*-self.origin), self.moved)

    @property
    def frame(self) -> Frame:
        """The box and the axes around the surface."""
        return Frame(self.easel.pen, self.easel.view, *self.box, self.origin, self.rulers)

    @property
    def heights(self) -> Interval:
        """The least and the greatest z."""
        low, high = self.box
        return float(low[2]), float(high[2])

    def above_origin(self, heights: list[float]) -> list[float]:
        """Heights counted from the origin's."""
        return [height - float(self.origin[2]) for height in heights]

    @property
    def floor(self) -> float:
        """The z of the floor, or the ceiling: the level face away from the eye; from the origin."""
        return float((self.frame.far - self.origin)[2])

    @property
    def scales(self) -> Point:
        """Pixels for a unit of the surface's x, y and z, along the arrows of the mapping."""
        x, y, z = np.array(self.mapping.scale) * np.diag(self.fitted)[:3]
        return float(x), float(y), float(z)

    def plot(self, picture: Picture, limits: Interval) -> Plot:
        """What was drawn on it, to be asked about."""
        return Plot(
            self.mapping, self.transform, self.scales, self.box, limits, picture, self.rulers
        )

    @contextmanager
    def surroundings(self, limits: Interval, color: Any) -> Iterator[None]:
        """What lies behind the surface; then the block draws the surface; then what is before it.

        `limits` are the values that the first and the last colour stand for, if they show `color`.
        """
        look, pen = self.look, self.easel.pen
        if look.names:
            self.frame.walls()
        if look.box or look.names:
            self.frame.back()
        yield
        if look.box:
            self.frame.front()
        if look.names:
            self.frame.axes(look.names, [frame.area_of_bar(pen)] if look.colorbar else [])
        if look.title:
            write_title(pen, look.title)
        if look.colorbar:
            self.easel.load_palette()
            ruler = self.rulers[2] if isinstance(color, str) and color == "z" else EVEN
            draw_bar(pen, self.easel.palette, limits, ruler)


def _checked(transform: Doubles) -> Doubles:
    T = real(transform, "transform")
    if T.shape != (4, 4) or not (np.abs(T) <= HUGE).all():
        raise ValueError(f"transform must be a 4x4 matrix of finite numbers, not {transform!r:.60}")
    return affine(T[:3, :3], T[3, :3])  # the last column of an inverse may not be exactly 0 0 0 1
