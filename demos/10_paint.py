"""Paint with the mouse.

    python demos/10_paint.py

What it shows: the mouse driver's functions in `bgi.mouse`. A loop asks where the mouse is and which
buttons are held, and joins the places by lines. The pointer is no part of the picture: it need not
be hidden while something is drawn. The right button rubs out, + and - change the brush, c clears,
Esc ends.
"""

from math import cos, pi, sin

from bgi import *
from bgi import mouse

MODE = (VGA, VGAHI)
ESC = 27
BAR = 40  # rows of the palette, above the canvas
BOX = 28  # pixels of a colour's box, across and down
LARGEST = 24
LEFT_HELD = 1  # in the sum that mouse.buttons() returns


class Brush:
    """What the mouse paints with, and where it has been."""

    def __init__(self) -> None:
        self.color = WHITE
        self.size = 3
        self.last: tuple[int, int] | None = None

    def stroke(self, x: int, y: int, color: int) -> None:
        """Paint from the last place to this one, below the palette."""
        setviewport(0, BAR, getmaxx(), getmaxy(), 1)
        setcolor(color)
        setfillstyle(SOLID_FILL, color)
        from_x, from_y = self.last or (x, y)
        if self.size == 1:
            line(from_x, from_y - BAR, x, y - BAR)
        else:
            radius = self.size // 2
            steps = 1 + max(abs(x - from_x), abs(y - from_y)) // radius
            for step in range(steps + 1):  # discs so near to each other that they join
                across = from_x + (x - from_x) * step / steps
                down = from_y + (y - from_y) * step / steps
                fillellipse(across, down - BAR, radius, radius)
        setviewport(0, 0, getmaxx(), getmaxy(), 1)
        self.last = x, y


def palette(brush: Brush) -> None:
    """Sixteen boxes, the chosen one framed, and the brush."""
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    bar(0, 0, getmaxx(), BAR - 1)
    for color in range(16):
        left = 6 + (BOX + 2) * color
        setfillstyle(SOLID_FILL, color)
        bar(left, 6, left + BOX - 1, 5 + BOX)
        setcolor(WHITE if color == brush.color else DARKGRAY)
        rectangle(left - 2, 4, left + BOX + 1, 7 + BOX)
    setcolor(BLACK)
    outtextxy(500, 8, f"brush {brush.size}")
    outtextxy(500, 24, "+ - c Esc")
    setfillstyle(SOLID_FILL, brush.color)
    setcolor(brush.color)
    fillellipse(612, 20, brush.size // 2, brush.size // 2)


def choose(brush: Brush, x: int) -> None:
    """Take the colour at x of the palette."""
    color = (x - 6) // (BOX + 2)
    if 0 <= color < 16:
        brush.color = color
        palette(brush)


def follow(brush: Brush) -> None:
    """Do what the mouse says: left paints and chooses, right rubs out."""
    times, left, top = mouse.presses(mouse.LEFT)
    if times > 0 and top < BAR:  # however short the click was
        choose(brush, left)
    x, y = mouse.position()
    held = mouse.buttons()
    if held == 0:
        brush.last = None
    elif y >= BAR or brush.last is not None:
        brush.stroke(x, y, brush.color if held & LEFT_HELD else BLACK)


def obey(brush: Brush, key: str) -> None:
    """Do what a key says."""
    if key == "c":
        setfillstyle(SOLID_FILL, BLACK)
        bar(0, BAR, getmaxx(), getmaxy())
    elif key == "+":
        brush.size = min(brush.size + 2, LARGEST)
    elif key == "-":
        brush.size = max(brush.size - 2, 1)
    palette(brush)


def draw() -> None:
    """A spiral in all colours, painted as the mouse would."""
    brush = Brush()
    for step in range(400):
        angle = 8 * pi * step / 400  # four turns
        brush.color = BLUE + 15 * step // 400
        brush.size = 3 + 2 * int(angle / 3)
        x, y = 320 + 10.5 * angle * cos(angle), 260 + 7 * angle * sin(angle)
        brush.stroke(int(x), int(y), brush.color)
    palette(brush)


def main() -> None:
    """Paint until Esc comes."""
    initgraph(*MODE)
    brush = Brush()
    palette(brush)
    mouse.reset()
    mouse.show()
    key = 0
    while key != ESC:
        while not kbhit():
            follow(brush)
            delay(5)
        key = getch()
        obey(brush, chr(key))
    mouse.reset()


if __name__ == "__main__":
    main()
