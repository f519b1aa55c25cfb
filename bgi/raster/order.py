"""In which order an algorithm sets the pixels of a figure, for those who want to watch it.

Each function takes the pixels' coordinates and returns their order: a permutation, as
`numpy.argsort` does.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[Any]
Point = tuple[int, int]
Points = Sequence[Point]

_ROUNDING = 0.1
"""What pixels of a line may lie farther from it than half of its width."""


def by_rows(x: Ints, y: Ints) -> Ints:
    """From the top row to the bottom one, each from left to right, as areas are filled."""
    return np.lexsort((x, y))


def by_columns(x: Ints, y: Ints) -> Ints:
    """From left to right, as letters are written."""
    return np.lexsort((y, x))


def upwards(x: Ints, y: Ints) -> Ints:
    """From the bottom to the top, as letters are written in direction 1."""
    return np.lexsort((x, -y))


def along(x: Ints, y: Ints, corners: Points, width: int, inside_first: bool = False) -> Ints:
    """Side after side, each from its first end, as Bresenham's algorithm goes.

    What is near to no side comes row by row: before them if `inside_first`, as a polygon is filled
    before its outline is drawn.
    """
    side = np.full(len(x), -1 if inside_first else len(corners), np.int64)
    gone = np.zeros(len(x))
    rest = np.arange(len(x))
    for number, (start, end) in enumerate(pairwise(corners)):
        if not len(rest):
            break
        way, off = _position(x[rest], y[rest], start, end)
        near = off <= width / 2 + _ROUNDING
        side[rest[near]], gone[rest[near]] = number, way[near]
        rest = rest[~near]
    gone[rest] = y[rest]
    return np.lexsort((x, gone, side))


def _position(x: Ints, y: Ints, start: Point, end: Point) -> tuple[Ints, Ints]:
    """How far along a line pixels lie, and how far off it."""
    dx, dy = float(end[0] - start[0]), float(end[1] - start[1])
    length = max(np.hypot(dx, dy), 1.0)
    px, py = x - float(start[0]), y - float(start[1])
    way = (px * dx + py * dy) / length
    beyond = np.maximum(np.maximum(-way, way - length), 0)
    return way, np.hypot((px * dy - py * dx) / length, beyond)


def by_octants(x: Ints, y: Ints, center: Point, rx: float, ry: float) -> Ints:
    """As Bresenham's circle grows: eight pixels at a time, from the axes to the diagonals."""
    across, down = (x - center[0]) / max(rx, 1), (y - center[1]) / max(ry, 1)
    octant = (np.abs(across) > np.abs(down)) + 2 * (across < 0) + 4 * (down > 0)
    step = np.round(np.minimum(np.abs(across), np.abs(down)) * max(rx, ry))
    return np.lexsort((octant, step))


def by_quadrants(x: Ints, y: Ints, center: Point, rx: float, ry: float) -> Ints:
    """As an ellipse grows: four pixels at a time, from its top and bottom to its sides."""
    across, down = np.abs(x - center[0]) / max(rx, 1), np.abs(y - center[1]) / max(ry, 1)
    quadrant = (x < center[0]) + 2 * (y > center[1])
    return np.lexsort((quadrant, np.round(np.arctan2(across, down) * (rx + ry))))


def by_angle(x: Ints, y: Ints, center: Point, rx: float, ry: float, start: int) -> Ints:
    """Against the clock, from an angle in degrees on, as an arc goes from its start to its end."""
    down, across = (center[1] - y) / max(ry, 1), (x - center[0]) / max(rx, 1)
    return np.argsort((np.degrees(np.arctan2(down, across)) - start + 0.5) % 360, kind="stable")


def rim_last(x: Ints, y: Ints, center: Point, rx: float, ry: float, start: int) -> Ints:
    """The inside row by row, then the rim against the clock: as filled ellipses and pies are."""
    out = np.hypot((x - center[0]) / max(rx, 1), (y - center[1]) / max(ry, 1))
    rim = out > 1 - 1.5 / max(min(rx, ry), 1)
    inside, edge = np.flatnonzero(~rim), np.flatnonzero(rim)
    return np.concatenate(
        [
            inside[by_rows(x[inside], y[inside])],
            edge[by_angle(x[edge], y[edge], center, rx, ry, start)],
        ]
    )


def spreading(x: Ints, y: Ints, seed: Point) -> Ints:
    """As a flood goes: from the seed to the neighbours left, right, above and below, and on."""
    left, top = int(x.min()), int(y.min())
    shape = int(y.max()) - top + 3, int(x.max()) - left + 3  # with a rim that stays dry
    dry = np.zeros(shape, bool)
    dry[y - top + 1, x - left + 1] = True
    level = np.full(shape, np.iinfo(np.int64).max)
    front = np.zeros(shape, bool)
    front[
        np.clip(seed[1] - top + 1, 0, shape[0] - 1), np.clip(seed[0] - left + 1, 0, shape[1] - 1)
    ] = True
    number = 0
    while front.any():
        level[front & dry] = number
        dry &= ~front
        number += 1
        near = front.copy()
        near[1:] |= front[:-1]
        near[:-1] |= front[1:]
        near[:, 1:] |= front[:, :-1]
        near[:, :-1] |= front[:, 1:]
        front = near & dry
    return np.lexsort((x, y, level[y - top + 1, x - left + 1]))
