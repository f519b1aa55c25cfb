"""A clock with hands, and a calendar.

    python demos/09_clock.py

What it shows: gettime() and getdate() of `bgi.dos` return small structures, as in C. An angle goes
to the screen by sine and cosine: one function does so for the marks, the numbers and the hands. The
hands move on the page that is not shown. Any key ends.
"""

from math import cos, pi, sin

from bgi import *
from bgi import dos

MODE = (VGA, VGAHI)
X, Y, RADIUS = 240, 240, 200  # the clock
CALENDAR = 545  # the middle of the calendar
MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")


def spot(turn: float, distance: float) -> tuple[int, int]:
    """A place on the clock: a part of a turn, clockwise from twelve, and how far from the axis."""
    angle = 2 * pi * turn
    return round(X + distance * sin(angle)), round(Y - distance * cos(angle))


def face() -> None:
    """The dial, its marks and its numbers."""
    setcolor(CYAN)
    setfillstyle(SOLID_FILL, BLUE)
    fillellipse(X, Y, RADIUS + 20, RADIUS + 20)
    circle(X, Y, RADIUS + 17, LIGHTCYAN)
    circle(X, Y, RADIUS + 19, LIGHTCYAN)
    for minute in range(60):
        if minute % 5 == 0:
            line(*spot(minute / 60, RADIUS - 10), *spot(minute / 60, RADIUS + 8), WHITE)
        else:
            line(*spot(minute / 60, RADIUS), *spot(minute / 60, RADIUS + 8), LIGHTGRAY)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 3)
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    setcolor(WHITE)
    for hour in range(1, 13):
        x, y = spot(hour / 12, RADIUS - 32)
        outtextxy(x, y - 4, str(hour))


def hand(turn: float, length: float, width: float, color: int) -> None:
    """A hand: a narrow kite."""
    back, tip = spot(turn, -0.15 * length), spot(turn, length)
    left, right = spot(turn - 0.25, width), spot(turn + 0.25, width)
    setcolor(WHITE)
    setfillstyle(SOLID_FILL, color)
    fillpoly([back, left, tip, right])


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
    seconds = time.ti_sec / 60
    setcolor(LIGHTRED)
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
    line(*spot(seconds, -0.2 * RADIUS), *spot(seconds, 0.9 * RADIUS))
    setlinestyle(SOLID_LINE, 0, NORM_WIDTH)
    setfillstyle(SOLID_FILL, YELLOW)
    fillellipse(X, Y, 6, 6)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 4)
    setcolor(YELLOW)
    outtextxy(CALENDAR, 320, f"{time.ti_hour}:{time.ti_min:02}:{time.ti_sec:02}")
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1)
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
