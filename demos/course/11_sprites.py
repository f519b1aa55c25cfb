"""Lesson 11: figures that move over a picture and leave it whole.

    python demos/course/11_sprites.py

A figure is cut out of the screen once, and put anywhere. COPY_PUT brings its black corners along
and wipes out the town. XOR_PUT, done twice, leaves everything as it was, but lets the town show
through. A mask with AND_PUT, then the figure with OR_PUT, covers just what the figure covers. The
arrows fly, m chooses the way, Esc ends. The page: docs/course/11-sprites.md.
"""

from bgi import *

ESC = 27
WAYS = ["COPY_PUT", "XOR_PUT, twice", "AND_PUT a mask, OR_PUT the figure"]
WIDTH, HEIGHT = 82, 40


def draw_saucer():
    """Draw the figure in the upper left corner, on black, and cut it out."""
    setcolor(LIGHTCYAN)
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    fillellipse(40, 16, 18, 14)
    setcolor(LIGHTMAGENTA)
    setfillstyle(SOLID_FILL, MAGENTA)
    fillellipse(40, 24, 38, 11)
    setfillstyle(SOLID_FILL, YELLOW)
    for x in range(14, 70, 13):
        bar(x, 22, x + 3, 25)
    return getimage(0, 0, WIDTH - 1, HEIGHT - 1)


def draw_mask():
    """White where the figure in the corner is black, and black where it is."""
    for y in range(HEIGHT):
        for x in range(WIDTH):
            putpixel(x, y, WHITE if getpixel(x, y) == BLACK else BLACK)
    return getimage(0, 0, WIDTH - 1, HEIGHT - 1)


def draw_town():
    """Houses before a striped sky: something to fly over."""
    cleardevice()
    setfillstyle(LTSLASH_FILL, BLUE)
    bar(0, 0, getmaxx(), getmaxy())
    for number in range(16):
        left, top = 40 * number, 440 - 40 * (number * 7 % 5) - 13 * (number % 3)
        setfillstyle(SOLID_FILL, [BROWN, CYAN, DARKGRAY, GREEN][number % 4])
        bar(left, top, left + 38, getmaxy())
        setfillstyle(SOLID_FILL, YELLOW)
        for y in range(top + 10, 440, 20):
            bar(left + 6, y, left + 12, y + 8)
            bar(left + 24, y, left + 30, y + 8)


def put(x, y, way):
    """Put the saucer in one of the three ways."""
    if way == 0:
        putimage(x, y, saucer, COPY_PUT)
    elif way == 1:
        putimage(x, y, saucer, XOR_PUT)
    else:
        putimage(x, y, mask, AND_PUT)
        putimage(x, y, saucer, OR_PUT)


def begin(way):
    """The town anew, with the name of the way."""
    putimage(0, 0, town, COPY_PUT)
    setcolor(WHITE)
    outtextxy(8, 8, f"{WAYS[way]}: arrows fly   m another way   Esc end")


strict()
initgraph(VGA, VGAHI)
saucer = draw_saucer()
mask = draw_mask()
draw_town()
town = getimage(0, 0, getmaxx(), getmaxy())
x, y = 200, 240
way = 0
key = 0
begin(way)
put(x, y, way)
while key != ESC:
    key = getch()
    if key == 0:
        scan = getch()
        if way == 1:
            put(x, y, way)  # the second XOR takes the figure away
        if way == 2:
            begin(way)  # what was covered is gone: the town again
        x = min(getmaxx() - WIDTH, max(0, x + 16 * ((scan == 77) - (scan == 75))))
        y = min(getmaxy() - HEIGHT, max(24, y + 16 * ((scan == 80) - (scan == 72))))
        put(x, y, way)
    elif key == ord("m"):
        way = (way + 1) % 3
        begin(way)
        put(x, y, way)
