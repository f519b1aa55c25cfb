"""Turn a picture without going back to space: the paper's M'.

    python demos/19_turn.py

What it shows: only the triples (x', y', z) of a picture are kept. One matrix M' turns them on the
screen, a step of one degree at a time (left), and the picture stays the same as one mapped anew
from the points in space (right). Below, how far the two have come apart, and how far if the
triples are rounded to pixels at each step. Space stops and starts, Esc ends.
"""

from math import pi

import numpy as np
from numpy.typing import NDArray

from bgi import *
from surfaces import FIGURES, Mapping, apply, rotation, sample, scaling

MODE = (IBM8514, IBM8514LO)
ESC, SPACE = 27, ord(" ")
STEP = pi / 180
AXIS = (1.0, 2.0, 3.0)
EGG_CRATE = FIGURES[3]
SHAPE = 1 / EGG_CRATE.x[1], 1 / EGG_CRATE.y[1], 0.35
"""What brings it to a size of one along each axis, and a little less upward."""
Triples = NDArray[np.float64]


class Turning:
    """A picture as triples, and what is needed to compare it with."""

    def __init__(self, width: int, height: int) -> None:
        unit = 0.27 * min(width / 2, height)
        self.mapping = Mapping(origin=(width / 4, 0.46 * height), scale=(unit, unit, unit))
        grid = sample(EGG_CRATE.f, EGG_CRATE.x, EGG_CRATE.y, 28)
        self.points = apply(grid.points, scaling(*SHAPE))
        self.matrix = self.mapping.screen_matrix(rotation(AXIS, STEP))
        self.steps = 0
        self.triples = self.mapping.project(self.points)
        self.rounded = self.triples.copy()

    def turn(self) -> None:
        """One step: one product for all the triples, and not a look at the points."""
        self.steps += 1
        self.triples = apply(self.triples, self.matrix)
        self.rounded = apply(self.rounded, self.matrix)
        self.rounded[:, :, :2] = np.rint(self.rounded[:, :, :2])  # x' and y'

    def anew(self) -> Triples:
        """The long way: the points turned in space by the whole angle, then mapped."""
        return self.mapping.project(apply(self.points, rotation(AXIS, self.steps * STEP)))

    def draw(self) -> None:
        """Both pictures, and how they compare."""
        half, bottom = (getmaxx() + 1) // 2, getmaxy()
        right = self.anew()
        lines(self.triples, YELLOW)
        lines(right + np.array((half, 0, 0)), LIGHTCYAN)
        setcolor(WHITE)
        outtextxy(8, 8, "triples times M'")
        outtextxy(half + 8, 8, "points turned and mapped anew")
        outtextxy(8, bottom - 38, f"{self.steps:5} steps of one degree about (1, 2, 3)")
        apart = np.abs(self.triples - right).max()
        outtextxy(8, bottom - 24, f"apart by   {apart:8.1e} pixels, triples kept as they are")
        setcolor(LIGHTRED)
        across, down, _ = np.abs(self.rounded - right).max(axis=(0, 1))
        apart = max(across, down)
        outtextxy(8, bottom - 10, f"           {apart:8.1f} pixels, triples rounded at every step")


def lines(triples: Triples, color: int) -> None:
    """Both families of lines: x' and y' of the triples are all that is needed."""
    x = np.floor(triples[:, :, 0] + 0.5)
    y = np.floor(triples[:, :, 1] + 0.5)
    line(x[:-1], y[:-1], x[1:], y[1:], color)
    line(x[:, :-1], y[:, :-1], x[:, 1:], y[:, 1:], color)


def draw() -> None:
    """After a quarter of a turn."""
    turning = Turning(getmaxx() + 1, getmaxy() + 1)
    for _ in range(90):
        turning.turn()
    turning.draw()


def main() -> None:
    """Turn until Esc."""
    initgraph(*MODE)
    turning = Turning(getmaxx() + 1, getmaxy() + 1)
    moving = True
    key = 0
    while key != ESC:
        cleardevice()
        turning.draw()
        swapbuffers()
        if moving:
            turning.turn()
        # A picture that turns only looks whether a key waits; one at rest waits for a key.
        if kbhit() or not moving:
            key = getch()
            if key == SPACE:
                moving = not moving


if __name__ == "__main__":
    main()
