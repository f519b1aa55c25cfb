"""Lesson 9: one way to solve its exercises.

python demos/course/solutions/09_colours.py
"""

from bgi import *


def ramp(first, last):
    """Exercise 1: the looks of colours 0 to 15, in even steps from one mixture to another."""
    registers = getpalette().colors
    for number in range(16):
        red, green, blue = (first[i] + (last[i] - first[i]) * number / 15 for i in range(3))
        setrgbpalette(registers[number], red, green, blue)


def sunset():
    """A sky that is drawn once, and twenty evenings in its palette."""
    for number in range(16):
        bar(0, 30 * number, getmaxx(), 30 * number + 29, number)
    for step in range(21):
        late = step / 20
        above = (10 * (1 - late), 30 * (1 - late), 63 - 43 * late)
        below = (45 + 18 * late, 55 - 20 * late, 63 - 55 * late)
        ramp(above, below)
        delay(50)


def ordered2(brightness, x, y):
    """Exercise 2: 0 or 1, by four thresholds: so there are five greys, of 0 to 4 white pixels."""
    pattern = [[0, 2], [3, 1]]
    threshold = (pattern[y % 2][x % 2] + 0.5) / 4
    return int(brightness + threshold)


def serpentine(left, top, width, height, brightness):
    """Exercise 3: one row to the right, the next one to the left; black and white."""
    below = [0] * (width + 2)
    for y in range(height):
        here, below = below, [0] * (width + 2)
        forward = y % 2 == 0
        step = 1 if forward else -1
        for x in range(width) if forward else range(width - 1, -1, -1):
            wanted = brightness(x, y) + here[x + 1]
            level = 1 if wanted >= 0.5 else 0
            putpixel(left + x, top + y, level * WHITE)
            error = wanted - level
            here[x + 1 + step] += error * 7 / 16
            below[x + 1 - step] += error * 3 / 16
            below[x + 1] += error * 5 / 16
            below[x + 1 + step] += error * 1 / 16


def even(x, y):
    """A brightness that grows to the right."""
    return x / 600


strict()
initgraph(VGA, VGAHI)
sunset()
getch()

initgraph(VGA, VGAHI)  # with the palette as it was
outtextxy(20, 8, "2: thresholds of two by two: five greys")
for y in range(200):
    for x in range(600):
        putpixel(20 + x, 24 + y, ordered2(even(x, y), x, y) * WHITE)
outtextxy(20, 240, "3: there and back")
serpentine(20, 256, 600, 200, even)
white = sum(getpixel(20 + x, 256 + y) == WHITE for x in range(600) for y in range(200))
assert abs(white / (600 * 200) - 0.5) < 0.01, "as many white pixels as it is bright"
getch()
closegraph()
