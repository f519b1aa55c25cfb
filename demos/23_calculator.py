"""A parabola whose numbers are typed over the picture.

    python demos/23_calculator.py

What it shows: printf() and scanf() of `bgi.stdio` over a picture, as programs of the time asked
their questions: gotoxy() of `bgi.conio` says where, in rows and columns of text. The rest is a
plot: a function of x, a scale, and a line from point to point. What is no number ends.
"""

from math import sqrt

from bgi import *
from bgi.conio import gotoxy
from bgi.stdio import fflush, printf, scanf, stdin

X, Y = 400, 256  # where 0, 0 is on the screen
UNIT = 24  # pixels
ACROSS, DOWN = 9, 8  # units to the edges


def axes() -> None:
    """A grid, and the axes with their numbers."""
    for step in range(-ACROSS, ACROSS + 1):
        line(X + step * UNIT, Y - DOWN * UNIT, X + step * UNIT, Y + DOWN * UNIT, BLUE)
    for step in range(-DOWN, DOWN + 1):
        line(X - ACROSS * UNIT, Y + step * UNIT, X + ACROSS * UNIT, Y + step * UNIT, BLUE)
    line(X - ACROSS * UNIT, Y, X + ACROSS * UNIT, Y, LIGHTGRAY)
    line(X, Y - DOWN * UNIT, X, Y + DOWN * UNIT, LIGHTGRAY)
    settextjustify(CENTER_TEXT, TOP_TEXT)
    setcolor(LIGHTGRAY)
    for step in range(-8, 9, 4):
        outtextxy(X + step * UNIT, Y + 5, str(step))


def plot(a: float, b: float, c: float) -> None:
    """The curve, as far as it is within the grid."""
    view = X - ACROSS * UNIT, Y - DOWN * UNIT, X + ACROSS * UNIT, Y + DOWN * UNIT
    setviewport(*view, 1)
    setcolor(YELLOW)
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
    for pixel in range(-ACROSS * UNIT, ACROSS * UNIT + 1, 4):
        x = pixel / UNIT
        here = pixel + ACROSS * UNIT, round((DOWN - (a * x * x + b * x + c)) * UNIT)
        if pixel == -ACROSS * UNIT:
            moveto(*here)
        lineto(*here)
    setlinestyle(SOLID_LINE, 0, NORM_WIDTH)
    setviewport(0, 0, getmaxx(), getmaxy(), 1)


def roots(a: float, b: float, c: float) -> str:
    """Where the curve meets the x axis."""
    if a == 0:
        return "not a parabola" if b == 0 else f"x = {-c / b:.4g}"
    inside = b * b - 4 * a * c
    if inside < 0:
        return "no real root"
    low, high = sorted(((-b - sqrt(inside)) / (2 * a), (-b + sqrt(inside)) / (2 * a)))
    return f"x = {low:.4g}" if low == high else f"x = {low:.4g}, {high:.4g}"


def show(a: float, b: float, c: float) -> None:
    """A new picture for these numbers."""
    cleardevice()
    setcolor(WHITE)
    settextjustify(LEFT_TEXT, TOP_TEXT)
    outtextxy(4, 4, "y = a x^2 + b x + c")
    axes()
    plot(a, b, c)
    gotoxy(1, 20)
    printf("a = %g\nb = %g\nc = %g\n%s", a, b, c, roots(a, b, c))


def ask() -> list[float]:
    """The three numbers, as they are typed; none at all if one is no number."""
    numbers = []
    for row, name in (4, "a"), (6, "b"), (8, "c"):
        gotoxy(1, row)
        printf("%s?%10s", name, "")
        gotoxy(4, row)
        number = scanf("%f")
        fflush(stdin)
        if number is None:
            return []
        numbers.append(number)
    return numbers


initgraph(VGA, VGAHI)
numbers = [0.5, -1.0, -4.0]
while numbers:
    show(*numbers)
    numbers = ask()
