"""Balls in a room, without a flicker.

    python demos/13_bounce.py

What it shows: every picture is drawn anew on the page that is not shown; swapbuffers() then shows
it whole and hands over the other page. All balls are one array of polygons, painted by one call
from the farthest to the nearest. Space stops and starts, any other key ends.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bgi import *

MODE = (VGA, VGAHI)
SPACE = ord(" ")
Floats = NDArray[np.float64]

# The room, in metres: x to the right, y up, z away from the eye. Its front is the screen.
LOW, HIGH = np.array((-4, 0, 0)), np.array((4, 6, 8))
EYE_HEIGHT, EYE_DISTANCE, PIXELS_PER_METRE = 3, 8, 80
RADIUS = 0.55
GRAVITY = 0.006  # metres per picture, per picture
TURN = np.linspace(0, 2 * np.pi, 28, endpoint=False)
# A ball is three discs: its size, how far it is shifted to the light, and its colour.
DISCS = ((1.0, 0.0), (0.72, 0.2), (0.2, 0.42))
COLORS = np.array(
    (
        (RED, LIGHTRED, WHITE),
        (BROWN, YELLOW, WHITE),
        (GREEN, LIGHTGREEN, WHITE),
        (CYAN, LIGHTCYAN, WHITE),
        (BLUE, LIGHTBLUE, WHITE),
        (MAGENTA, LIGHTMAGENTA, WHITE),
    )
)

TILES = np.array(
    [
        ((x, 0, z), (x + 1, 0, z), (x + 1, 0, z + 1), (x, 0, z + 1))
        for x in range(-4, 4)
        for z in range(8)
    ]
)
TILE_COLORS = np.array([(DARKGRAY, LIGHTGRAY)[(x + z) % 2] for x in range(8) for z in range(8)])
LINES = np.array(
    [
        *(((x, 0, 8), (x, 6, 8)) for x in range(-4, 5)),
        *(((x, 6, 0), (x, 6, 8)) for x in range(-4, 5)),
        *(((-4, y, 8), (4, y, 8)) for y in range(7)),
        *(((x, y, 0), (x, y, 8)) for x in (-4, 4) for y in range(7)),
        *(((-4, 6, z), (4, 6, z)) for z in range(9)),
        *(((x, 0, z), (x, 6, z)) for x in (-4, 4) for z in range(9)),
    ]
)


def project(points: Floats) -> Floats:
    """Where points (..., 3) of the room appear on the screen (..., 2)."""
    x, y, z = np.moveaxis(points, -1, 0)
    scale = PIXELS_PER_METRE * EYE_DISTANCE / (z + EYE_DISTANCE)
    return np.stack((320 + x * scale, 240 - (y - EYE_HEIGHT) * scale), axis=-1)


def disc(center: Floats, radius: float, across: Floats, up: Floats) -> Floats:
    """Round polygons (n, k, 3) about n centres, in the plane of two directions."""
    rim = np.outer(np.cos(TURN), across) + np.outer(np.sin(TURN), up)
    polygons: Floats = center[:, None] + radius * rim
    return polygons


RIGHT, UP, AWAY = np.eye(3)


@dataclass
class Balls:
    """Where the balls are and how they fly."""

    place: Floats
    speed: Floats

    @classmethod
    def scattered(cls) -> "Balls":
        """Six balls, always the same ones."""
        random = np.random.default_rng(1121)
        return cls(random.uniform(LOW + 1, HIGH - 1, (6, 3)), random.uniform(-0.06, 0.06, (6, 3)))

    def move(self) -> None:
        """One picture's time: fall, fly, and come back from the walls."""
        self.speed[:, 1] -= GRAVITY
        self.place += self.speed
        outside = (self.place < LOW + RADIUS) | (self.place > HIGH - RADIUS)
        inside = np.clip(self.place, LOW + RADIUS, HIGH - RADIUS)
        self.place = np.where(outside, 2 * inside - self.place, self.place)
        self.speed = np.where(outside, -self.speed, self.speed)

    def draw(self) -> None:
        """Shadows first; then the balls, the farthest first."""
        shadows = disc(self.place * (1, 0, 1), RADIUS, RIGHT, AWAY)
        fillpoly(project(shadows), fill=BLACK, color=BLACK)
        order = np.argsort(-self.place[:, 2])
        place, colors = self.place[order], COLORS[order].ravel()
        light = RADIUS * (UP - RIGHT)
        discs = [disc(place + shift * light, size * RADIUS, RIGHT, UP) for size, shift in DISCS]
        balls = np.stack(discs, axis=1).reshape(-1, len(TURN), 3)
        fillpoly(project(balls), fill=colors, color=colors)


def draw_room() -> None:
    """A floor of tiles, and a line every metre on the other walls."""
    fillpoly(project(TILES), fill=TILE_COLORS, color=TILE_COLORS)
    ends = project(LINES)
    line(ends[:, 0, 0], ends[:, 0, 1], ends[:, 1, 0], ends[:, 1, 1], BLUE)


def draw() -> None:
    """One moment of the flight."""
    balls = Balls.scattered()
    for _ in range(30):
        balls.move()
    draw_room()
    balls.draw()


def main() -> None:
    """Fly until a key other than space comes."""
    initgraph(*MODE)
    balls = Balls.scattered()
    flying = True
    while flying:
        balls.move()
        cleardevice()
        draw_room()
        balls.draw()
        setcolor(WHITE)
        outtextxy(8, 8, "space: stop   any other key: end")
        swapbuffers()
        if kbhit():  # a space stops the balls; they wait for the next key
            flying = getch() == SPACE and getch() == SPACE


if __name__ == "__main__":
    main()
