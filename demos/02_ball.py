"""A ball that bounces.

    python demos/02_ball.py

What it shows: a picture is drawn where it is not seen, and swapbuffers() shows it whole; so nothing
flickers. The ball has a place (x, y) and a speed (dx, dy). Gravity adds to the speed, the speed to
the place, and floor and walls turn the speed around. Any key ends.
"""

from bgi import *

FLOOR = 440
RADIUS = 30

initgraph(VGA, VGAHI)
x, y = 100, 100
dx, dy = 4, 0
while not kbhit():
    dy = dy + 1  # gravity
    x = x + dx
    y = y + dy
    if y > FLOOR - RADIUS:
        y = FLOOR - RADIUS
        dy = -dy
    if x < RADIUS or x > getmaxx() - RADIUS:
        dx = -dx

    cleardevice()
    setfillstyle(SOLID_FILL, GREEN)
    bar(0, FLOOR, getmaxx(), getmaxy())
    setcolor(YELLOW)
    setfillstyle(SOLID_FILL, RED)
    fillellipse(x, y, RADIUS, RADIUS)
    setcolor(WHITE)
    outtextxy(8, 8, "any key: end")
    swapbuffers()
getch()
