"""Whole programs as people write them, given an object `g` with the functions of graphics.h."""

import random
from math import cos, pi, sin
from typing import Any

from bench import calls
from bench.calls import Program
from bench.timing import Row, dice

WIDTH, HEIGHT = 640, 480
FERN = (  # Barnsley's: a, b, c, d, e, f and how often
    (0.0, 0.0, 0.0, 0.16, 0.0, 0.0, 0.01),
    (0.85, 0.04, -0.04, 0.85, 0.0, 1.6, 0.85),
    (0.2, -0.26, 0.23, 0.22, 0.0, 1.6, 0.07),
    (-0.15, 0.28, 0.26, 0.24, 0.0, 0.44, 0.07),
)


def fern_points(count: int = 10_000) -> list[tuple[float, float]]:
    """The points of Barnsley's fern, on the screen."""
    chance = dice(1)
    leaves = chance.choices(FERN, [leaf[6] for leaf in FERN], k=count)
    x = y = 0.0
    points = []
    for a, b, c, d, e, f, _ in leaves:
        x, y = a * x + b * y + e, c * x + d * y + f
        points.append((320 + 45 * x, 470 - 45 * y))
    return points


POINTS = fern_points()


def fern(g: Any) -> None:
    """A fern, its coordinates rounded by the program."""
    for x, y in POINTS:
        g.putpixel(int(x), int(y), 2)


def fern_of_floats(g: Any) -> None:
    """The same without rounding."""
    for x, y in POINTS:
        g.putpixel(x, y, 2)


def moire(g: Any) -> None:
    """Lines from a corner to two sides."""
    for x in range(0, WIDTH, 4):
        g.line(0, 0, x, HEIGHT - 1)
        g.line(WIDTH - 1, 0, x, HEIGHT - 1)


def life(g: Any) -> None:
    """Two generations of Conway's game on 80x60 cells, read from the screen and drawn as bars."""
    size, columns, lines = 8, WIDTH // 8, HEIGHT // 8
    for _ in range(2):
        alive = [[g.getpixel(x * size, y * size) > 0 for x in range(columns)] for y in range(lines)]
        for y in range(lines):
            above, here, below = alive[y - 1], alive[y], alive[(y + 1) % lines]
            for x in range(columns):
                right = (x + 1) % columns
                count = (
                    above[x - 1] + above[x] + above[right] + here[x - 1] + here[right]
                    + below[x - 1] + below[x] + below[right]
                )  # fmt: skip
                lives = count == 3 or (count == 2 and here[x])
                if lives != here[x]:
                    g.setfillstyle(1, 14 if lives else 0)
                    g.bar(x * size, y * size, x * size + size - 2, y * size + size - 2)


def cells(g: Any) -> None:
    """The first generation."""
    chance = random.Random(1)
    g.setfillstyle(1, 14)
    for y in range(0, HEIGHT, 8):
        for x in range(0, WIDTH, 8):
            if chance.random() < 0.3:
                g.bar(x, y, x + 6, y + 6)


def mandelbrot(g: Any) -> None:
    """The set, 100x75 pixels of it."""
    for py in range(75):
        for px in range(100):
            c = complex(px / 40 - 2, py / 30 - 1.25)
            z, count = c, 0
            while count < 15 and z.real * z.real + z.imag * z.imag < 4:
                z = z * z + c
                count += 1
            g.putpixel(px, py, count)


def chart(g: Any) -> None:
    """Hatched bars with labels, and a pie beside them."""
    g.settextstyle(0, 0, 1)
    for row in range(9):
        g.line(40, 440 - row * 40, 340, 440 - row * 40)
        g.outtextxy(5, 436 - row * 40, str(row * 10))
    for number in range(9):
        g.setfillstyle(3 + number, 1 + number)
        left, top = 50 + number * 32, 400 - number * number * 4
        g.bar(left, top, left + 24, 439)
        g.rectangle(left, top, left + 24, 439)
        g.pieslice(490, 200, number * 40, number * 40 + 40, 100)
    g.settextstyle(1, 0, 3)
    g.outtextxy(150, 20, "Sales")


def clock(g: Any) -> None:
    """Five seconds of a clock: the face, hands, and the time in figures."""
    for second in range(5):
        g.cleardevice()
        g.circle(320, 240, 200)
        for hour in range(12):
            x, y = sin(hour * pi / 6), cos(hour * pi / 6)
            g.line(int(320 + 180 * x), int(240 - 180 * y), int(320 + 195 * x), int(240 - 195 * y))
        for width, length, turn in ((3, 100, 1.9), (3, 150, 4.4), (1, 170, second * pi / 30)):
            g.setlinestyle(0, 0, width)
            g.line(320, 240, int(320 + length * sin(turn)), int(240 - length * cos(turn)))
        g.outtextxy(290, 300, f"10:08:{second:02}")


def ball(g: Any) -> None:
    """Ten pictures of a ball in a box."""
    x, y, dx, dy = 100, 100, 7, 5
    g.setfillstyle(1, 12)
    for _ in range(10):
        g.cleardevice()
        g.rectangle(0, 0, WIDTH - 1, HEIGHT - 1)
        g.fillellipse(x, y, 20, 20)
        x, y = x + dx, y + dy


def house(g: Any) -> None:
    """A house whose walls, roof, door and sky are flooded."""
    g.rectangle(200, 240, 440, 420)
    g.rectangle(290, 320, 350, 420)
    g.line(200, 240, 320, 140)
    g.line(320, 140, 440, 240)
    for x, y, pattern, color in (
        (210, 250, 1, 6), (300, 330, 1, 4), (320, 200, 4, 12), (10, 10, 1, 9),
    ):  # fmt: skip
        g.setfillstyle(pattern, color)
        g.floodfill(x, y, 15)


def maze(g: Any) -> None:
    """Paths between walls at every eighth pixel, all of them flooded."""
    g.setfillstyle(1, 10)
    g.floodfill(4, 4, 15)


def walls(g: Any) -> None:
    """A labyrinth with one way between any two cells, by chance: each cell opens one wall."""
    chance = random.Random(1)
    g.rectangle(0, 0, WIDTH - 1, HEIGHT - 1)
    for y in range(0, HEIGHT, 8):
        for x in range(0, WIDTH, 8):
            if (x and chance.random() < 0.5) or not y:
                g.line(x, y, x + 8, y)
            else:
                g.line(x, y, x, y + 8)


def frame(g: Any) -> None:
    """Clear, a hundred lines, show."""
    g.cleardevice()
    for number in range(100):
        g.line(number * 6, 0, WIDTH - 1 - number * 6, HEIGHT - 1)
    g.swapbuffers()


TABLE = [
    Program("fern", fern),
    Program("fern, floats", fern_of_floats),
    Program("moire", moire),
    Program("moire by XOR", moire, lambda g: g.setwritemode(1)),
    Program("life", life, cells),
    Program("mandelbrot", mandelbrot),
    Program("chart", chart),
    Program("clock", clock),
    Program("bouncing ball", ball),
    Program("house, flooded", house),
    Program("maze, flooded", maze, walls),
    Program("clear, 100 lines, show", frame),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("programs", TABLE)
