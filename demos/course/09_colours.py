"""Lesson 9: where colours are lacking, dots mix them.

    python demos/course/09_colours.py

The same picture with only a few brightnesses. Rounded to the nearest one it falls into bands; with
dots in an even pattern, or with each pixel's error handed on, the eye mixes what is not there. 2 to
9 say how many brightnesses there are, p changes the palette, Esc ends. The page:
docs/course/09-colours.md.
"""

from math import sqrt

from bgi import *

ESC = 27
WIDTH, HEIGHT = 300, 200  # of each picture
PATTERN = [
    [0, 8, 2, 10],
    [12, 4, 14, 6],
    [3, 11, 1, 9],
    [15, 7, 13, 5],
]
# Palettes: red, green and blue of the darkest colour and of the brightest, 0 to 63.
PALETTES = [
    [(0, 0, 0), (63, 63, 63)],
    [(8, 0, 24), (63, 56, 20)],
    [(0, 12, 0), (20, 63, 20)],
]


def brightness(x, y):
    """How bright the picture is at a place, from 0 to 1: a ball before a wall."""
    across = (x - 150) / 80
    down = (y - 100) / 80
    inside = 1 - across * across - down * down
    if inside < 0:
        return x / WIDTH
    toward = sqrt(inside)  # how far the ball comes toward us here
    light = 0.6 * toward - 0.5 * across - 0.6 * down
    return min(1, max(0, light))


def put(x, y, level, levels):
    """Set a pixel to one of the levels, 0 to levels - 1; colour 15 is the brightest."""
    putpixel(x, y, level * 15 // (levels - 1))


def draw_exact(left, top, levels):
    """As many levels as there are colours."""
    for y in range(HEIGHT):
        for x in range(WIDTH):
            put(left + x, top + y, int(brightness(x, y) * 15 + 0.5), 16)


def draw_nearest(left, top, levels):
    """The nearest level."""
    for y in range(HEIGHT):
        for x in range(WIDTH):
            level = int(brightness(x, y) * (levels - 1) + 0.5)
            put(left + x, top + y, level, levels)


def draw_ordered(left, top, levels):
    """Ordered dithering: a pattern says which pixels are rounded up sooner."""
    for y in range(HEIGHT):
        for x in range(WIDTH):
            sooner = (PATTERN[y % 4][x % 4] + 0.5) / 16
            level = int(brightness(x, y) * (levels - 1) + sooner)
            put(left + x, top + y, level, levels)


def draw_diffused(left, top, levels):
    """Floyd and Steinberg: what is too dark or too bright here is made good next door."""
    below = [0] * (WIDTH + 2)
    for y in range(HEIGHT):
        here, below = below, [0] * (WIDTH + 2)
        for x in range(WIDTH):
            wanted = brightness(x, y) * (levels - 1) + here[x + 1]
            level = min(levels - 1, max(0, int(wanted + 0.5)))
            put(left + x, top + y, level, levels)
            error = wanted - level
            here[x + 2] += error * 7 / 16
            below[x] += error * 3 / 16
            below[x + 1] += error * 5 / 16
            below[x + 2] += error * 1 / 16


def mix_palette(number):
    """Give all sixteen colours their look, from dark to bright. Nothing is drawn."""
    dark, bright = PALETTES[number]
    registers = getpalette().colors
    for color in range(16):
        red, green, blue = (dark[i] + (bright[i] - dark[i]) * color // 15 for i in range(3))
        setrgbpalette(registers[color], red, green, blue)


def draw(levels):
    """The picture four times."""
    cleardevice()
    setcolor(15)
    places = [
        (10, 20, draw_exact, "16 brightnesses"),
        (330, 20, draw_nearest, f"{levels}: the nearest"),
        (10, 248, draw_ordered, f"{levels}: ordered dots"),
        (330, 248, draw_diffused, f"{levels}: errors handed on"),
    ]
    for left, top, method, name in places:
        outtextxy(left, top - 12, name)
        method(left, top, levels)
    outtextxy(10, 464, "2 to 9 brightnesses   p other palette   Esc end")


strict()
initgraph(VGA, VGAHI)
palette = 0
mix_palette(palette)
draw(2)
while (key := getch()) != ESC:
    if key == ord("p"):
        palette = (palette + 1) % len(PALETTES)
        mix_palette(palette)
    elif ord("2") <= key <= ord("9"):
        draw(key - ord("0"))
