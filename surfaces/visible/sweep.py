"""The floating horizon, column by column, in every affine view.

The programs of the seventies (Williamson's "Hidden-Line Plotting Program", 1972; Wright's "A
Two-Space Solution to the Hidden Line Problem for Plotting Functions of Two Variables", 1973) drew
z = f(x, y) line by line from front to back and remembered, for every column of the paper, the
highest and the lowest point drawn so far: the horizon. What lies between the two is hidden, what
lies beyond is seen and moves the horizon. That needs heights to be vertical on the screen; here
they may point anywhere.

Let g be the direction of the z axis on the screen. Along u = x' - (gx / gy) y' a height makes no
difference, so u is a plain a x + b y + c, and all points with one u form a column parallel to g. In
it, each line of the grid is met in one point, at the height v = y' on the screen; between two
neighbouring lines the surface is the straight strip from point to point. (If g lies flat, x' and y'
change places.) Each row of pixels takes the columns nearest to its pixels, and each pixel one.

The lines are taken from the nearest to the farthest; `visible.order` says why that is right. It
holds for every turn, shear and reflection, from above and from below.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints, Ints32, Singles
from surfaces.shape.grid import Grid
from surfaces.space.transforms import apply
from surfaces.space.view import View

# Crossings of columns and lines at a time: the arrays that are made of them stay in the cache, and
# below the size at which an allocator asks the system for fresh memory each time.
CHUNK = 1 << 14
# Narrower than this many pixels, a surface is seen on its edge, and columns say nothing about it.
EDGE_ON = 1.5
# Flatter than this many pixels on the screen: do not shear.
NO_HEIGHT = 0.1
# A shear that moves no row by more than this many pixels is a rounding error.
NO_SHIFT = 0.01
# Nodes this near to even places, in cells, count as even: so they are when far from zero.
EVEN = 1e-4
# Rows shift sheared columns by parts of a pixel: a column for every third of one is near enough.
PHASES = 3


class Border(NamedTuple):
    """Where columns leave the grid between two lines: they meet one of them, and miss the other.

    The point on the grid's border stands in for the crossing that is missed. Arrays of (b,).
    """

    column: Ints
    """The column..."""
    line: Ints
    """... and the line that it misses."""
    before: Ints
    """The node before the point on the border, in a flattened field..."""
    behind: Ints
    """... and the node behind it."""
    part: Singles
    """How far the point is from the one to the other: 0 to 1."""
    s: Doubles
    """Where it lies between the lines."""


class Crossings(NamedTuple):
    """Where columns meet the lines; arrays of shape (columns, lines), the nearest line first."""

    before: Ints32
    """The node before the crossing, in a flattened field."""
    part: Singles
    """How far it is to the next node: 0 to 1."""
    met: Bools
    """Whether the column meets the line at all, or the border beside it."""
    borders: tuple[Border, Border]

    def values(self, field: Singles) -> Singles:
        """A field of `Sweep.oriented`, flattened, at the crossings."""
        value = field.take(self.before)
        slope = field.take(self.before + 1)
        slope -= value
        slope *= self.part
        value += slope
        for border in self.borders:
            here = field[border.before]
            value[border.column, border.line] = here + border.part * (field[border.behind] - here)
        return value


class Block(NamedTuple):
    """Some columns, side by side, and what is seen in them; arrays of (columns, lines)."""

    columns: slice
    """Which ones: places along u, from 0 for the sweep's first."""
    crossings: Crossings
    v: Singles
    """How far down the screen each crossing is. Where a column misses a line, that of the nearest
    line it meets."""
    upper: Singles
    """The horizon with that line and all nearer ones drawn: the least v so far..."""
    lower: Singles
    """... and the greatest."""


class Sweep:
    """The columns of a height field without holes, on a screen of width x height pixels."""

    def __init__(self, grid: Grid, view: View, width: int, height: int) -> None:
        """Choose columns and lines; `blocks` does the work."""
        self.grid, self.view = grid, view
        screen = view.screen
        low, high = float(np.nanmin(grid.z)), float(np.nanmax(grid.z))
        reach = (high - low) * np.abs(screen[2, :2])
        across = 1 if reach[0] > reach[1] else 0
        self.lying = across == 1
        """Whether heights lie rather flat on the screen, so that columns look like rows."""
        self.size = (height, width) if self.lying else (width, height)
        """Pixels along u and along v."""
        to_v = screen[:, 1 - across]
        shear = float(screen[2, across] / to_v[2]) if reach.max() > NO_HEIGHT else 0.0
        self.shear = shear if abs(shear) * self.size[1] > NO_SHIFT else 0.0
        self.phases = PHASES if self.shear else 1
        """How many sets of columns there are, each between those of the one before."""
        to_u = screen[:, across] - self.shear * to_v

        # Lines run the way along which u changes more: then every column meets many of them.
        extent = np.abs(to_u[:2]) * (np.ptp(grid.x), np.ptp(grid.y))
        self.of_y = bool(extent[0] > extent[1])
        """Whether a line has one y; otherwise it has one x."""
        k, j = (1, 0) if self.of_y else (0, 1)
        # The line next to the eye comes first.
        self.reversed = bool(view.eye[k] > 0)
        """Whether that is the last one of the grid."""
        self._order = slice(None, None, -1 if self.reversed else 1)
        self.s, self.t = (grid.x, grid.y)[k][self._order], (grid.x, grid.y)[j]
        even = np.linspace(self.t[0], self.t[-1], len(self.t))
        self._even = bool(np.abs(self.t - even).max() < EVEN * (even[1] - even[0]))
        # Unsheared, heights move a point less than a pixel along u: take their mean.
        self._u = to_u[3] + to_u[2] * (low + high) / 2, to_u[k], to_u[j]
        # Heights from 0 to 1: what is large about them stays in double precision.
        tall = (high - low) or 1.0
        self._z = self.oriented((grid.z - low) / tall)
        self._v = to_v[3] + to_v[2] * low, to_v[k], to_v[j], to_v[2] * tall
        self._rows = screen[3] + screen[2] * low, screen[k], screen[j], screen[2] * tall
        self._heights = low, tall
        # Too flat on the screen for heights to tell: all strips rise from line to line, or fall.
        flat = view.eye[2] * self._v[1] * (1 if self.reversed else -1)
        up = -self._v[3] if reach.max() > NO_HEIGHT else flat
        self.rising_is_upper = bool(up > 0)
        """Whether a strip that rises above the horizon shows its upper side."""

        corners = self.place_u(self.s[[0, -1]], self.t[[0, -1], None])
        self.edge_on = bool(np.ptp(corners) < EDGE_ON)
        """Whether the surface is seen on its edge: then there is hardly a column."""
        # The columns on the screen: the last row shifts them by `shift` pixels.
        shift = self.shear * (self.size[1] - 1)
        self.first = int(np.ceil(max(corners.min(), min(0.0, -shift) - 1)))
        self.last = int(np.floor(min(corners.max(), self.size[0] + max(0.0, -shift))))

    def place_u(self, s: Doubles, t: Doubles | np.float64) -> Doubles:
        """Where the point t of the line s lies along u."""
        u0, us, ut = self._u
        u: Doubles = u0 + us * s + ut * t
        return u

    @property
    def shape(self) -> tuple[int, int]:
        """How many lines there are, and how many nodes each has."""
        lines, nodes = self._z.shape
        return lines, nodes

    def nearer_line(self, cells: Ints) -> Ints:
        """The nearer line of the strip in which each cell (m, 2) of the grid lies."""
        cell = cells[:, 1 if self.of_y else 0]
        return self.shape[0] - 2 - cell if self.reversed else cell

    def points(self, lines: Ints, nodes: Ints) -> Doubles:
        """Where nodes appear on the screen: (len(lines), len(nodes), 2)."""
        z = self._z[np.ix_(lines, nodes)].astype(np.float64)
        origin, per_s, per_t, per_z = self._rows
        found = np.empty((*z.shape, 2))
        for way in range(2):
            across = origin[way] + per_s[way] * self.s[lines, None] + per_t[way] * self.t[nodes]
            found[..., way] = across + per_z[way] * z
        return found

    def oriented(self, field: Doubles) -> Singles:
        """A field over the grid as (lines, nodes of a line), the nearest line first."""
        lines = (field.T if self.of_y else field)[self._order]
        return np.ascontiguousarray(lines, dtype=np.float32)

    def shifts(self, phases: int) -> Ints:
        """How far each row of the screen shifts the columns, in pixels divided by `phases`."""
        rows = np.arange(self.size[1])
        shifts: Ints = np.floor(phases * self.shear * rows + 0.5).astype(np.int64)
        return shifts

    def rows(self, phase: int) -> tuple[Ints, Ints]:
        """The rows of the screen that columns of a phase serve, and their shifts in pixels."""
        shifts = self.shifts(self.phases)
        rows = np.flatnonzero((shifts + phase) % self.phases == 0)
        return rows, (shifts[rows] + phase) // self.phases

    def blocks(self, phase: int = 0) -> Iterator[Block]:
        """All columns on the screen, some at a time; those of another phase lie between them."""
        step = max(1, CHUNK // len(self.s))
        for start in range(self.first - (phase > 0), self.last + 1, step):
            stop = min(start + step, self.last + 1)
            u = np.arange(start, stop, dtype=np.float64) + phase / self.phases
            crossings = self.crossings(u)
            v = self.heights(u, crossings)
            # A line that the column does not meet must not move the horizon.
            nearest = crossings.met.argmax(axis=1)
            np.copyto(v, v[np.arange(len(u)), nearest][:, None], where=~crossings.met)
            upper, lower = np.minimum.accumulate(v, axis=1), np.maximum.accumulate(v, axis=1)
            yield Block(slice(start - self.first, stop - self.first), crossings, v, upper, lower)

    def crossings(self, u: Doubles) -> Crossings:
        """Where the columns at u (any numbers) meet the lines."""
        lines, nodes = self._z.shape
        along = self._along(u)
        met = (along >= 0) & (along <= nodes - 1)
        np.clip(along, 0, nodes - 1, out=along)
        before = along.astype(np.int32)
        np.minimum(before, nodes - 2, out=before)
        along -= before
        before += np.arange(0, lines * nodes, nodes, dtype=np.int32)
        borders = self._border(u, 0, met), self._border(u, nodes - 1, met)
        for border in borders:
            met[border.column, border.line] = True
        return Crossings(before, along, met, borders)

    def _along(self, u: Doubles) -> Singles:
        """How many cells from its beginning columns meet a line; outside its cells if never."""
        u0, us, ut = self._u
        along: Singles
        if self._even:
            cell = ut * (self.t[1] - self.t[0])
            begins = (self.place_u(self.s, self.t[0]) / cell).astype(np.float32)
            along = (u / cell).astype(np.float32)[:, None] - begins
        else:
            t = (u[:, None] - u0 - us * self.s) / ut
            nodes = np.arange(len(self.t), dtype=np.float64)
            along = np.interp(t, self.t, nodes, left=-1, right=len(nodes)).astype(np.float32)
        return along

    def _border(self, u: Doubles, node: int, met: Bools) -> Border:
        """Where columns pass between the ends of two lines and meet only one of these lines.

        `node` is the end: the first node of each line, 0, or its last.
        """
        nodes = self._z.shape[1]
        ends = self.place_u(self.s, self.t[node])
        rising = 1 if ends[-1] > ends[0] else -1
        line = np.searchsorted(rising * ends, rising * u, side="right") - 1
        between = (line >= 0) & (line < len(ends) - 1)
        column, line = np.flatnonzero(between), line[between]
        one = met[column, line] != met[column, line + 1]
        column, line = column[one], line[one]
        part = (u[column] - ends[line]) / (ends[line + 1] - ends[line])
        missed = np.where(met[column, line], line + 1, line)
        before = line * nodes + node
        s = self.s[line] + part * (self.s[line + 1] - self.s[line])
        return Border(column, missed, before, before + nodes, part.astype(np.float32), s)

    def heights(self, u: Doubles, crossings: Crossings) -> Singles:
        """How far down the screen (v) the crossings are, (columns, lines)."""
        u0, us, ut = self._u
        v0, vs, vt, vz = self._v
        # v = v0 + vs s + vt t + vz z, with t from u = u0 + us s + ut t.
        v = crossings.values(self._z.ravel())
        v *= np.float32(vz)
        per_line = vs - vt / ut * us
        v += (v0 + vt / ut * (u - u0)).astype(np.float32)[:, None]
        v += (per_line * self.s).astype(np.float32)
        for border in crossings.borders:  # which lie beside their line
            v[border.column, border.line] += per_line * (border.s - self.s[border.line])
        return v

    def points_at(self, px: float, py: float) -> Doubles:
        """All points (x, y, z) of the surface at a place of the screen, (m, 3), nearest first.

        There are none if the surface is seen on its edge, and none in a hole.
        """
        if self.edge_on:
            return np.zeros((0, 3))
        u, v = self._column(np.array(((px, py),)))
        points, down, met = (array[0] for array in self._profiles(u))
        down = down - v
        strip = np.flatnonzero(met[:-1] & met[1:] & (down[:-1] * down[1:] <= 0))
        change = down[strip] - down[strip + 1]
        part = (down[strip] / np.where(change == 0, 1.0, change))[:, None]
        found: Doubles = points[strip] + part * (points[strip + 1] - points[strip])
        return found

    def hidden(self, points: Doubles) -> Bools:
        """Which points (m, 3) of space lie behind a strip, by more than a cell is deep."""
        u, v = self._column(apply(points, self.view.screen)[:, :2])
        lines, down, met = self._profiles(u)
        down = down - v[:, None]
        covers = met[:, :-1] & met[:, 1:] & (down[:, :-1] * down[:, 1:] < 0)
        point, strip = np.nonzero(covers)
        here, there = down[point, strip], down[point, strip + 1]
        near = lines @ self.view.eye
        start, end = near[point, strip], near[point, strip + 1]
        hit = start + here / (here - there) * (end - start)
        cell = np.array((np.diff(self.grid.x).max(), np.diff(self.grid.y).max()))
        behind = hit > (points @ self.view.eye)[point] + cell @ np.abs(self.view.eye[:2])
        hidden = np.zeros(len(points), dtype=bool)
        hidden[point[behind]] = True
        return hidden

    def _column(self, pixels: Doubles) -> tuple[Doubles, Doubles]:
        """The u and the v of places (m, 2) on the screen."""
        across, v = pixels.T[::-1] if self.lying else pixels.T
        return across - self.shear * v, v

    def _profiles(self, u: Doubles) -> tuple[Doubles, Doubles, Bools]:
        """The surface along columns at u, (m,), as points where they meet the lines.

        The points (m, lines, 3), their v, and whether they are met at all.
        """
        crossings = self.crossings(u)
        u0, us, ut = self._u
        low, tall = self._heights
        s = np.broadcast_to(self.s, crossings.part.shape).copy()
        for border in crossings.borders:
            s[border.column, border.line] = border.s
        t = (u[:, None] - u0 - us * s) / ut
        z = low + tall * crossings.values(self._z.ravel())
        x, y = (t, s) if self.of_y else (s, t)
        points = np.stack((x, y, z), axis=-1)
        return points, self.heights(u, crossings).astype(np.float64), crossings.met
