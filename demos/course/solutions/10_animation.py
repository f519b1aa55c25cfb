"""Lesson 10: one way to solve its exercises.

python demos/course/solutions/10_animation.py
"""

from math import cos, pi, sin

from bgi import *
from bgi import dos

FLOOR, RADIUS, GRAVITY = 440, 20, 600


def move(ball, seconds):
    """Exercise 1: fly for a while; ball is [x, y, dx, dy]."""
    x, y, dx, dy = ball
    dy = dy + GRAVITY * seconds
    x = x + dx * seconds
    y = y + dy * seconds
    if y > FLOOR - RADIUS:
        y, dy = FLOOR - RADIUS, -0.9 * dy
    if x < RADIUS:
        x, dx = RADIUS, -0.9 * dx
    if x > getmaxx() - RADIUS:
        x, dx = getmaxx() - RADIUS, -0.9 * dx
    ball[:] = [x, y, dx, dy]


def two_balls():
    """Three seconds of flight."""
    balls = [[100, 100, 150, 0], [500, 200, -250, -200]]
    begin = before = now()
    while before - begin < 3:
        time = now()
        cleardevice()
        outtextxy(8, 8, "1: two balls")
        line(0, FLOOR, getmaxx(), FLOOR, DARKGRAY)
        for ball, color in zip(balls, (LIGHTRED, YELLOW), strict=True):
            move(ball, time - before)
            setcolor(color)
            setfillstyle(SOLID_FILL, color)
            fillellipse(round(ball[0]), round(ball[1]), RADIUS, RADIUS)
        setcolor(WHITE)
        swapbuffers()
        before = time


def now():
    """The time of day, in seconds."""
    t = dos.gettime()
    return t.ti_hour * 3600 + t.ti_min * 60 + t.ti_sec + t.ti_hund / 100


def hand(length, part, color):
    """Exercise 2: a hand that has gone part of its round; up is 0, and y grows downward."""
    angle = 2 * pi * part
    line(320, 240, round(320 + length * sin(angle)), round(240 - length * cos(angle)), color)


def draw_clock(time):
    """A dial and three hands. A part of a round may be more than 1: it goes round again."""
    cleardevice()
    outtextxy(8, 8, "2: a clock")
    circle(320, 240, 200)
    hand(110, time / 43200, LIGHTCYAN)
    hand(170, time / 3600, LIGHTGREEN)
    hand(185, time / 60, LIGHTRED)
    swapbuffers()


STEP = 0.01


def advance(planet, seconds):
    """Exercise 3: as many steps as fit into the time; what is left over is kept for the next call.

    planet is [x, y, dx, dy, rest].
    """
    planet[4] = planet[4] + seconds
    while planet[4] >= STEP:
        step(planet)
        planet[4] = planet[4] - STEP


def step(planet):
    """By the new speed the place: by the old one, the orbit becomes a spiral."""
    x, y, dx, dy, rest = planet
    cube = (x * x + y * y) ** 1.5
    dx = dx - x / cube * STEP
    dy = dy - y / cube * STEP
    planet[:] = [x + dx * STEP, y + dy * STEP, dx, dy, rest]


def draw_orbit(seconds, size, color):
    """A round of 2 pi seconds, in calls of so many seconds; returns the planet at its end."""
    planet = [1, 0, 0, 1, 0]
    calls = round(2 * pi / seconds)
    for _ in range(calls):
        circle(round(320 + 180 * planet[0]), round(240 - 180 * planet[1]), size, color)
        advance(planet, seconds)
    advance(planet, 2 * pi - calls * seconds)
    return planet


strict()
initgraph(VGA, VGAHI)
two_balls()
getch()

while not kbhit():
    draw_clock(now())
getch()

cleardevice()
setactivepage(getvisualpage())
cleardevice()
outtextxy(8, 8, "3: a planet, in calls of 1/60 and of 1/7 second")
circle(320, 240, 4, YELLOW)
often = draw_orbit(1 / 60, 1, LIGHTBLUE)
seldom = draw_orbit(1 / 7, 4, WHITE)
assert abs(often[0] - seldom[0]) < 0.02 and abs(often[1] - seldom[1]) < 0.02
getch()
closegraph()
