"""The cells between the nodes of a grid, and the nodes that a coarser grid keeps."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Bools, Ints

Item = TypeVar("Item", bound=np.generic)


def four_corners(nodes: NDArray[Item]) -> tuple[NDArray[Item], ...]:
    """The four corners of every cell, in the order of the nodes, going round.

    From nodes of shape (nx+1, ny+1, ...), four views of shape (nx, ny, ...).
    """
    return nodes[:-1, :-1], nodes[1:, :-1], nodes[1:, 1:], nodes[:-1, 1:]


def quads(nodes: NDArray[Item]) -> NDArray[Item]:
    """The same in one array: from nodes of shape (nx+1, ny+1, k), an array (nx, ny, 4, k)."""
    return np.stack(four_corners(nodes), axis=2)


def all_corners(there: Bools) -> Bools:
    """Which cells have all four corners among these nodes."""
    sides = there[:-1] & there[1:]
    return np.asarray(sides[:, :-1] & sides[:, 1:])


def with_three_corners(corners: Ints, there: Bools) -> tuple[Ints, Ints]:
    """Of cells whose corners, (m, 4), are partly there, (m, 4), those that lack only one.

    Which ones they are, (k,), and their corners, (k, 4): what is missing is that before it again,
    so that each is a triangle.
    """
    three = np.flatnonzero(there.sum(axis=1) == 3)
    corners, there = corners[three], there[three]
    return three, np.where(there, corners, np.roll(corners, 1, axis=1))


def every_nth(count: int, n: int) -> Ints:
    """Every n-th of the numbers below `count`, beginning with 0, and always the last."""
    return np.unique(np.append(np.arange(0, count, min(n, count)), count - 1))
