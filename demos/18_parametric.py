"""A ring, a band with one side, a ball: surfaces that two numbers walk over.

    python demos/18_parametric.py

What it shows: `surfaces.parametric` draws (u, v) -> (x, y, z). Filled, each pixel keeps the nearest
depth it was offered; that is right even for the bottle, which passes through itself. 1 to 4 choose
a surface, m the mode, space stops and starts the turn, Esc ends.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from typing import Any

from numpy import cos, sin

from bgi import *
from surfaces import compose, parametric, rotation

MODE = (IBM8514, IBM8514LO)
ESC, SPACE = 27, ord(" ")
ROUND = (0.0, 2 * pi)
MODES = ("fill", "mesh", "fill+mesh", "wire")
HELP = "1-4 surface   m mode   space turn   Esc end"


def torus(u: Any, v: Any) -> Any:
    """A ring: a small circle led round a large one."""
    return (2 + 0.8 * cos(v)) * cos(u), (2 + 0.8 * cos(v)) * sin(u), 0.8 * sin(v)


def moebius(u: Any, v: Any) -> Any:
    """A band that makes half a turn on its way round: it has one side and one edge."""
    radius = 1 + v * cos(u / 2)
    return radius * cos(u), radius * sin(u), v * sin(u / 2)


def sphere(u: Any, v: Any) -> Any:
    """A ball: longitude and latitude."""
    return cos(u) * cos(v), sin(u) * cos(v), sin(v)


def bottle(u: Any, v: Any) -> Any:
    """Klein's bottle, as a figure eight that makes half a turn on its way round."""
    radius = 2.3 + cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v)
    return radius * cos(u), radius * sin(u), sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v)


@dataclass(frozen=True)
class Shape:
    """A surface with its domain and its cells."""

    name: str
    f: Callable[[Any, Any], Any]
    v: tuple[float, float]
    n: tuple[int, int]
    under: str | None = None


SHAPES = (
    Shape("torus", torus, ROUND, (100, 50)),
    Shape("Möbius band", moebius, (-0.45, 0.45), (120, 12), "dusk"),
    Shape("sphere", sphere, (-pi / 2, pi / 2), (72, 36)),
    Shape("Klein bottle", bottle, ROUND, (120, 50), "dusk"),
)


def show(shape: Shape, mode: str, angle: float) -> None:
    """A shape in the viewport, turned about z and tilted."""
    along_u, along_v = shape.n
    if mode != "fill":  # lines are easier to see with fewer cells
        along_u, along_v = along_u // 2, max(8, along_v // 2)
    setcolor(YELLOW)
    parametric(
        shape.f,
        ROUND,
        shape.v,
        n=(along_u, along_v),
        mode=mode,
        transform=compose(rotation("z", angle), rotation((1, -1, 0), angle / 3)),
        projection="isometric",
        under=shape.under,
    )


def draw() -> None:
    """Four of them."""
    width, height = (getmaxx() + 1) // 2, (getmaxy() + 1) // 2
    modes = ("fill", "fill+mesh", "fill+mesh", "fill")
    for place, shape in enumerate(SHAPES):
        left, top = place % 2 * width, place // 2 * height
        setviewport(left, top, left + width - 1, top + height - 1, 1)
        show(shape, modes[place], 0.6)
        setcolor(WHITE)
        outtextxy((width - textwidth(shape.name)) // 2, height - 12, shape.name)
    setviewport(0, 0, getmaxx(), getmaxy(), 1)


def picture(place: int, mode: str, angle: float) -> None:
    """One picture of the turn, on the page that is not shown."""
    cleardevice()
    show(SHAPES[place], mode, angle)
    setcolor(WHITE)
    outtextxy(8, 8, f"{SHAPES[place].name}   {mode}")
    outtextxy(8, getmaxy() - 15, HELP)
    swapbuffers()


def main() -> None:
    """Turn until Esc."""
    initgraph(*MODE)
    place = mode = 0  # in SHAPES and in MODES
    angle = 0.6
    turning = True
    key = 0
    while key != ESC:
        picture(place, MODES[mode], angle)
        if turning:
            angle += pi / 90
        # A surface that turns only looks whether a key waits; one at rest waits for a key.
        if kbhit() or not turning:
            key = getch()
            if ord("1") <= key <= ord("4"):
                place = key - ord("1")
            elif key == ord("m"):
                mode = (mode + 1) % len(MODES)
            elif key == SPACE:
                turning = not turning


if __name__ == "__main__":
    main()
