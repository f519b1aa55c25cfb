"""Lesson 11: one way to solve its exercises.

python demos/course/solutions/11_sprites.py
"""

from bgi import *


def box(x1, y1, x2, y2):
    """Exercise 1: a rectangle that the same call takes away again."""
    setwritemode(XOR_PUT)
    rectangle(x1, y1, x2, y2, WHITE)
    setwritemode(COPY_PUT)


def cover(left, top, image):
    """Exercise 2: the pixels of an image that are not black.

    Better: it takes one image, no mask. Worse: a call for each pixel, where AND and OR were two.
    """
    for y in range(image.height):
        for x in range(image.width):
            color = image.array[y][x]
            if color != BLACK:
                putpixel(left + x, top + y, color)


def new_sprite(x, y, image):
    """A sprite that is not shown yet: [x, y, image, kept]."""
    return [x, y, image, None]


def show(sprite):
    """Exercise 3: keep what is covered, then put."""
    x, y, image, _ = sprite
    sprite[3] = getimage(x, y, x + image.width - 1, y + image.height - 1)
    cover(x, y, image)


def hide(sprite):
    """Put back what was covered."""
    x, y, _, kept = sprite
    putimage(x, y, kept, COPY_PUT)


def draw_picture():
    """Strips of all colours, and circles."""
    for number in range(16):
        bar(40 * number, 0, 40 * number + 39, 479, number)
    for radius in range(20, 240, 20):
        circle(320, 240, radius, radius // 20)


def whole():
    """The whole screen, to compare it."""
    return bytes(getimage(0, 0, getmaxx(), getmaxy()))


strict()
initgraph(VGA, VGAHI)
setcolor(WHITE)
setfillstyle(SOLID_FILL, LIGHTRED)
fillpoly([(2, 38), (26, 2), (50, 38), (26, 28)])
ship = getimage(0, 0, 52, 40)

draw_picture()
before = whole()
for size in range(20):
    box(100, 100, 120 + 20 * size, 110 + 12 * size)
    delay(40)
    box(100, 100, 120 + 20 * size, 110 + 12 * size)
assert whole() == before, "the picture is as it was"
getch()

for place in range(8):
    cover(30 + 70 * place, 20 + 50 * place, ship)
getch()

draw_picture()
before = whole()
first, second = new_sprite(20, 200, ship), new_sprite(560, 220, ship)
for step in range(50):
    show(first)
    show(second)  # over the first: so it must be hidden first
    delay(20)
    if step < 49:
        hide(second)
        hide(first)
        first[0] = first[0] + 10
        second[0] = second[0] - 10
getch()
hide(second)
hide(first)
assert whole() == before, "the picture is as it was"
closegraph()
