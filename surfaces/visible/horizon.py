"""What is seen of a height field, by the floating horizon: pixels, and parts of lines on it.

`visible.sweep` finds the horizon. Here every strip that rises above it, or falls below it, is
turned into pixels: each visible pixel once, the hidden ones never. A strip that rises above the
horizon shows its upper side, one that falls below it the under side; so the two can have colours of
their own.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from surfaces.arrays import Bools, Doubles, Ints, Ints32, Singles, repeat
from surfaces.shape.cells import every_nth
from surfaces.systems import trace
from surfaces.visible.sweep import Block, Sweep

# How far, in pixels, a line's pixel may lie behind the horizon and still be seen.
SLACK = np.float32(0.5)
# Lines traced at a time: the arrays that are made of them stay in the cache.
CHUNK = 4096


class Pixels(NamedTuple):
    """Visible pixels of one side of the surface."""

    x: Ints
    """(n,)"""
    y: Ints
    """(n,)"""
    value: Singles
    """(n,): the value of the field there: it runs evenly from line to line."""
    under: bool
    """Whether the under side is seen."""


def fill(sweep: Sweep, field: Doubles) -> Iterator[Pixels]:
    """Every visible pixel with the value of a field over the grid's nodes, some at a time."""
    values = sweep.oriented(field).ravel()
    for phase in range(sweep.phases):
        rows, shifts = sweep.rows(phase)
        # How many of the rows lie above each row of the screen.
        passed = np.searchsorted(rows, np.arange(sweep.size[1] + 1)).astype(np.int32)
        for block in sweep.blocks(phase):
            value = block.crossings.values(values)
            for rising, edge in _edges(block, passed):
                place, u, run = _gained(edge)
                if not rising:
                    place = -1 - place
                v = place
                if sweep.shear:  # only then are the rows not all rows, and shifted
                    v = rows.take(place)
                    u += shifts.take(place)
                u += sweep.first + block.columns.start
                x, y = (v, u) if sweep.lying else (u, v)
                shade = _shade(block.v, value, run, v)
                yield Pixels(x, y, shade, rising != sweep.rising_is_upper)


def _edges(block: Block, passed: Ints32) -> Iterator[tuple[bool, Ints32]]:
    """How far the horizon has moved after each line, as the number of rows above it.

    For each way that it moves, up first: whether that is up, and an array of (columns, lines).
    Where it moves down, the number has its sign reversed: either way it never grows.
    """
    height = len(passed) - 1
    if (block.upper[:, -1] < block.v[:, 0]).any():
        upper = np.ceil(np.clip(block.upper, 0, height)).astype(np.int32)
        yield True, passed.take(upper)
    if (block.lower[:, -1] > block.v[:, 0]).any():
        lower = np.floor(np.clip(block.lower, -1, height - 1)).astype(np.int32)
        yield False, -passed.take(lower + 1)


class Runs(NamedTuple):
    """Pixels of one column that one strip gains."""

    line: Ints
    """(r,): the strip's farther line, in the flattened array of columns and lines; its nearer line
    precedes it there."""
    pixels: Ints32
    """(r,): how many pixels."""


def _gained(edge: Ints32) -> tuple[Ints, Ints, Runs]:
    """The pixels by which strips move the horizon, one column after another.

    Each pixel's row, counted among those of the phase, and its column, (n,) each; and the runs of
    pixels that come from one strip.
    """
    counts = np.zeros_like(edge)
    np.subtract(edge[:, :-1], edge[:, 1:], out=counts[:, 1:])
    line = np.flatnonzero(counts > 0)
    # In one column the rows follow one another, away from the nearest line.
    total = edge[:, 0] - edge[:, -1]
    u = repeat(np.arange(len(total)), total)
    ends = np.cumsum(total)
    place = repeat(edge[:, 0] - 1 + ends - total, total) - np.arange(len(u))
    return place, u, Runs(line, counts.ravel().take(line))


def _shade(v: Singles, value: Singles, runs: Runs, rows: Ints) -> Singles:
    """The value at every pixel: from line to line it is an even slope."""
    flat_v, flat_value = v.ravel(), value.ravel()
    v1, value1 = flat_v.take(runs.line - 1), flat_value.take(runs.line - 1)
    slope = (flat_value.take(runs.line) - value1) / (flat_v.take(runs.line) - v1)
    shade = repeat(slope, runs.pixels) * rows.astype(np.float32)
    shade += repeat(value1 - slope * v1, runs.pixels)
    return shade


class Horizon:
    """The horizon after every line: what hides lines that lie on the surface."""

    def __init__(self, sweep: Sweep) -> None:
        """Sweep once, and remember."""
        self._sweep = sweep
        self._shifts = sweep.shifts(1)
        shape = max(0, sweep.last + 1 - sweep.first), len(sweep.s)
        self._upper, self._lower = np.empty(shape, np.float32), np.empty(shape, np.float32)
        for block in sweep.blocks():
            self._upper[block.columns] = block.upper
            self._lower[block.columns] = block.lower

    def seen(self, x: Ints, y: Ints, line: Ints) -> tuple[Bools, Bools]:
        """Which pixels on the screen, (n,), are above and which below what hides them.

        `line`, (n,), is the nearer line of the strip that each lies in: the lines up to that one
        hide it where it is between their horizons. Pixels lie up to half a pixel beside their line,
        and are seen up to half a pixel behind the horizon.
        """
        row, column = (x, y) if self._sweep.lying else (y, x)
        column = column - self._shifts.take(row) - self._sweep.first
        columns, lines = self._upper.shape
        place = np.clip(column, 0, columns - 1) * lines + line
        return row <= self._upper.take(place) + SLACK, row >= self._lower.take(place) - SLACK


class Segments(NamedTuple):
    """Short straight lines on the surface, as the screen sees them."""

    starts: Doubles
    """(n, 2)"""
    ends: Doubles
    """(n, 2)"""
    line: Ints
    """(n,): the nearer line of the strip that each lies in."""
    joined: bool = False
    """Whether another one begins where each ends, so that their last pixels can be left out."""


def mesh(sweep: Sweep, x_every: int | None, y_every: int | None) -> Iterator[Segments]:
    """The lines of the grid: every n-th line of constant x, and of constant y; None for none."""
    across, along = (y_every, x_every) if sweep.of_y else (x_every, y_every)
    lines, nodes = sweep.shape
    if across:
        chosen = every_nth(lines, across)
        if sweep.reversed:  # the same lines, whichever is the nearest
            chosen = lines - 1 - chosen
        points = sweep.points(chosen, np.arange(nodes))
        yield from _chains(np.moveaxis(points, 1, 0), np.maximum(chosen - 1, 0)[None])
    if along:
        points = sweep.points(np.arange(lines), every_nth(nodes, along))
        yield from _chains(points, np.arange(lines - 1)[:, None])


def _chains(points: Doubles, line: Ints) -> Iterator[Segments]:
    """The segments of lines from point to point, and then the points where they end.

    `points` are (points, lines, 2), `line` the nearer line of the strip of each segment.
    """
    starts, ends = points[:-1].reshape(-1, 2), points[1:].reshape(-1, 2)
    owners = np.broadcast_to(line, (len(points) - 1, points.shape[1]))
    yield Segments(starts, ends, owners.ravel(), joined=True)
    yield Segments(points[-1], points[-1], owners[-1])


def visible(
    sweep: Sweep, horizon: Horizon, segments: Segments
) -> Iterator[tuple[Ints, Ints, Bools]]:
    """The visible pixels of lines on the surface: x, y, and whether the under side is seen."""
    width, height = sweep.size[::-1] if sweep.lying else sweep.size
    for start in range(0, len(segments.line), CHUNK):
        part = slice(start, start + CHUNK)
        first, last, kept = trace.clip(segments.starts[part], segments.ends[part], width, height)
        x, y, owner = trace.line_pixels(first, last, segments.joined)
        above, below = horizon.seen(x, y, segments.line[part].take(kept).take(owner))
        seen = np.flatnonzero(above | below)
        upper = above if sweep.rising_is_upper else below
        yield x.take(seen), y.take(seen), ~upper.take(seen)
