"""Two windows at once: draw in one, see it turned in the other.

    python demos/12_two_windows.py

What it shows: initwindow() opens another window, with a monitor of its own, and setcurrentwindow()
says in which one the next calls draw. A pen draws a figure in the first window, and its mirror
image in the second, in colours of its own. Any key ends, in whichever window it is typed.
"""

from math import cos, pi, sin

from bgi import *

MODE = (VGA, VGAHI)
STEPS = 720
"""How many steps the pen takes round its figure."""


def point(step: int) -> tuple[float, float]:
    """Where the pen is, from -1 to 1: a Lissajous figure."""
    angle = 2 * pi * step / STEPS
    return sin(3 * angle), cos(2 * angle)


def ink(step: int) -> int:
    """The colours from LIGHTBLUE to WHITE in turn."""
    return LIGHTBLUE + 7 * (step % STEPS) // STEPS


def mark(x: float, y: float, color: int) -> None:
    """A dot of the pen in the current window."""
    setfillstyle(SOLID_FILL, color)
    setcolor(color)
    width, height = getmaxx() // 2, getmaxy() // 2
    fillellipse(width + int(0.85 * width * x), height + int(0.8 * height * y), 4, 4)


def title(text: str) -> None:
    """A line of text at the top of the current window."""
    setcolor(LIGHTGRAY)
    outtextxy(8, 8, text)


def draw() -> None:
    """The whole figure at once."""
    for step in range(0, STEPS, 2):
        mark(*point(step), ink(step))
    title("the first window")


def main() -> None:
    """Draw in both windows, in turn, until a key is pressed in either."""
    initgraph(*MODE)
    first = getcurrentwindow()
    title("the first window: any key ends")
    second = initwindow(400, 300, "the second window")
    title("the second window")
    step = 0
    setcurrentwindow(first)
    while not kbhit():
        x, y = point(step)
        rubbing_out = step // STEPS % 2 == 1  # every second time round
        mark(x, y, BLACK if rubbing_out else ink(step))
        setcurrentwindow(second)
        mark(-x, -y, COLOR(255 * (step % STEPS) // STEPS, 128, 255))
        setcurrentwindow(first)
        delay(4)
        step += 1
    getch()
    closewindow(second)


if __name__ == "__main__":
    main()
