"""A clock with hands, and a calendar.

    python demos/09_clock.py

What it shows: gettime() and getdate() of `bgi.dos` return small structures, as in C. An angle goes
to the screen by sine and cosine, and whole arrays of angles do so at once: all sixty marks are one
call. The hands move on the page that is not shown. Any key ends.
"""

import math

import numpy as np

from bgi import *
from bgi import dos

MODE = (VGA, VGAHI)
X, Y, RADIUS = 240, 240, 200
CALENDAR = 545
MONTHS = "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec".split()  # noqa: SIM905

Point = tuple[float, float]


def spot(turn: float, distance: float) -> Point:
    """Where something is after that part of a turn, clockwise from twelve, so far from the axis."""
    angle = 2 * math.pi * turn
    return X + distance * math.sin(angle), Y - distance * math.cos(angle)


def face() -> None:
    """The dial, its marks and its numbers."""
    setcolor(CYAN)
    setfillstyle(SOLID_FILL, BLUE)
    fillellipse(X, Y, RADIUS + 20, RADIUS + 20)
    circle(X, Y, (RADIUS + 17, RADIUS + 19), LIGHTCYAN)
    angle = np.arange(60) * np.pi / 30
    across, up = np.sin(angle), np.cos(angle)
    inner = np.where(np.arange(60) % 5, RADIUS, RADIUS - 10)
    color = np.where(np.arange(60) % 5, LIGHTGRAY, WHITE)
    outer = RADIUS + 8
    line(X + inner * across, Y - inner * up, X + outer * across, Y - outer * up, color)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 3)
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    setcolor(WHITE)
    for hour in range(1, 13):
        x, y = spot(hour / 12, RADIUS - 32)
        outtextxy(round(x), round(y) - 4, str(hour))


def hand(turn: float, length: float, width: float, color: int) -> None:
    """A hand: a narrow kite."""
    back, side = spot(turn, -0.15 * length), 0.25
    left, right = spot(turn - side, width), spot(turn + side, width)
    setcolor(WHITE)
    setfillstyle(SOLID_FILL, color)
    fillpoly([back, left, spot(turn, length), right])


def calendar(day: int, month: int, year: int) -> None:
    """A sheet for today."""
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    setcolor(WHITE)
    left, right = CALENDAR - 60, CALENDAR + 60
    fillpoly([(left, 120), (right, 120), (right, 260), (left, 260)])
    setfillstyle(SOLID_FILL, LIGHTRED)
    fillpoly([(left, 120), (right, 120), (right, 152), (left, 152)])
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 2)
    outtextxy(CALENDAR, 132, f"{MONTHS[month - 1]} {year}")
    setcolor(BLUE)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 6)
    outtextxy(CALENDAR, 196, str(day))


def picture(time: dos.time, date: dos.date) -> None:
    """Everything, at a moment."""
    cleardevice()
    face()
    calendar(date.da_day, date.da_mon, date.da_year)
    minutes = time.ti_min + time.ti_sec / 60
    hand((time.ti_hour % 12 + minutes / 60) / 12, 0.55 * RADIUS, 9, CYAN)
    hand(minutes / 60, 0.85 * RADIUS, 6, LIGHTCYAN)
    setlinestyle(0, 0, THICK_WIDTH)
    tip, end = spot(time.ti_sec / 60, 0.9 * RADIUS), spot(time.ti_sec / 60, -0.2 * RADIUS)
    line(end[0], end[1], tip[0], tip[1], LIGHTRED)
    setlinestyle(0, 0, 1)
    setcolor(LIGHTRED)
    setfillstyle(SOLID_FILL, YELLOW)
    fillellipse(X, Y, 6, 6)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 4)
    setcolor(YELLOW)
    outtextxy(CALENDAR, 320, f"{time.ti_hour}:{time.ti_min:02}:{time.ti_sec:02}")
    settextstyle(0, HORIZ_DIR, 1)
    setcolor(DARKGRAY)
    outtextxy(CALENDAR, 464, "any key: end")
    graphdefaults()


def draw() -> None:
    """Nearly ten past ten, as in every advertisement, on a day in autumn."""
    picture(
        dos.time(ti_min=9, ti_hour=10, ti_hund=0, ti_sec=34),
        dos.date(da_year=1988, da_day=26, da_mon=10),
    )


def main() -> None:
    """Go on until a key comes."""
    initgraph(*MODE)
    while not kbhit():
        time = dos.gettime()
        picture(time, dos.getdate())
        swapbuffers()
        while dos.gettime().ti_sec == time.ti_sec and not kbhit():
            delay(10)
    getch()


if __name__ == "__main__":
    main()
