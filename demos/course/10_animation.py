"""Lesson 10: a film is finished pictures, one after the other.

    python demos/course/10_animation.py

A film is still pictures, one after the other. Drawn on the page that is shown, one sees them being
made: they flicker. Drawn on the other page and then shown, they do not. And a ball that is moved by
the time that went by is as fast on a slow computer. d changes where it is drawn, w makes the
computer slow, t moves it by the clock or by the picture, Esc ends. The page:
docs/course/10-animation.md.
"""

from bgi import *
from bgi import dos

ESC = 27
FLOOR = 430
RADIUS = 30
GRAVITY = 900  # pixels per second, per second
SPEED = 200.0  # pixels per second


def seconds():
    """The time of day."""
    now = dos.gettime()
    return now.ti_hour * 3600 + now.ti_min * 60 + now.ti_sec + now.ti_hund / 100


def draw(x, y, texts, pause):
    """One picture: a wall of bricks, a floor and a ball; a slow computer needs its time for it."""
    cleardevice()
    delay(pause)
    for row in range(8):
        for column in range(17):
            left = 40 * column - 20 * (row % 2)
            rectangle(left, 110 + 40 * row, left + 40, 150 + 40 * row, DARKGRAY)
    setfillstyle(SOLID_FILL, BROWN)
    bar(0, FLOOR, getmaxx(), getmaxy())
    delay(pause)
    setcolor(YELLOW)
    setfillstyle(SOLID_FILL, RED)
    fillellipse(round(x), round(y), RADIUS, RADIUS)
    setcolor(WHITE)
    for place, text in enumerate(texts):
        outtextxy(8, 8 + 16 * place, text)


def say(switch, on, off):
    """One of two texts."""
    return on if switch else off


strict()
initgraph(VGA, VGAHI)
x, y = 100.0, 200.0
dx, dy = SPEED, 0.0
double = True  # drawn on the page that is not shown?
timed = True  # moved by the clock?
busy = False
key = 0
before = seconds()
while key != ESC:
    now = seconds()
    step = now - before if timed else 1 / 60
    before = now

    dy = dy + GRAVITY * step
    x = x + dx * step
    y = y + dy * step
    if y > FLOOR - RADIUS:
        y = FLOOR - RADIUS
        dy = -abs(dy)
    if x < RADIUS:
        dx = abs(dx)
    if x > getmaxx() - RADIUS:
        dx = -abs(dx)

    texts = [
        say(double, "d  drawn on the hidden page", "d  drawn on the page that is shown"),
        say(timed, "t  moved by the clock", "t  moved 1/60 second for each picture"),
        say(busy, "w  a slow computer", "w  a fast computer"),
        "Esc end",
    ]
    draw(x, y, texts, 50 if busy else 0)
    if double:
        swapbuffers()
    else:
        delay(15)
    if kbhit():
        key = getch()
        if key == ord("d"):
            double = not double
            setactivepage(1 - getvisualpage() if double else getvisualpage())
        if key == ord("t"):
            timed = not timed
        if key == ord("w"):
            busy = not busy
