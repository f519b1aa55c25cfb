"""Figures that move over a picture, and leave it whole.

    python demos/08_sprites.py

What it shows: getimage() takes a figure, putimage() puts it anywhere. XOR_PUT erases what it drew
when it draws it again. AND_PUT with a mask cuts a hole in the shape of the figure, and OR_PUT sets
the figure in: so it covers the picture, and what is around it stays. The aquarium is drawn on the
page that is not shown.
"""

from math import sin
from random import Random

import numpy as np

from bgi import *
from gallery.pages import BAR, Page, leaf_through, show

MODE = (VGA, VGAHI)
WIDTH, HEIGHT = 640, 456  # what is left below the bar


# Figures: drawn once, where nobody sees it


def drawn_fish(body: int, stripe: int, length: int) -> Image:
    """A fish that looks to the right, taken from the hidden page; 0 is what is not fish."""
    setactivepage(1)
    cleardevice()
    high = length // 3
    tail, middle, nose = length // 4, length * 5 // 8, length - 1
    setcolor(stripe)
    setfillstyle(SOLID_FILL, stripe)
    fillpoly([(tail + 6, high), (0, high // 2), (tail // 3, high), (0, high * 3 // 2)])
    fillpoly([(middle - 12, high // 2), (middle, 0), (middle + 12, high // 2)])
    setfillstyle(SOLID_FILL, body)
    fillellipse(middle, high, nose - middle, high * 2 // 3)
    setfillstyle(SOLID_FILL, stripe)
    for x in (middle - 10, middle + 2):
        bar(x, high - high * 3 // 5, x + 4, high + high * 3 // 5)
    setcolor(WHITE)
    setfillstyle(SOLID_FILL, WHITE)
    fillellipse(nose - 10, high - 3, 3, 3)
    setfillstyle(SOLID_FILL, BLUE)
    bar(nose - 10, high - 4, nose - 9, high - 3)
    image = getimage(0, 0, nose, 2 * high)
    cleardevice()
    setactivepage(0)
    return image


def mirrored(image: Image) -> Image:
    """The image, looking the other way: its pixels are an array."""
    return Image(image.array[:, ::-1], image.colors)


def mask(image: Image) -> Image:
    """All bits where the image has nothing, none where it has: what AND_PUT keeps, and clears."""
    return Image(np.where(image.array == BLACK, 0b1111, 0), image.colors)


def put(x: int, y: int, image: Image) -> None:
    """Cover the picture with a figure, but not with what is around the figure.

    Of an image that sticks out at a side putimage() puts nothing, so only what is seen is given.
    """
    left, right = max(0, -x), min(image.width, WIDTH - x)
    if left < right:
        seen = Image(image.array[:, left:right], image.colors)
        putimage(x + left, y, mask(seen), AND_PUT)
        putimage(x + left, y, seen, OR_PUT)


# The operators, one by one


def stripes(left: int, top: int) -> None:
    """Something to see a figure on, 104 pixels wide and 56 high."""
    for stripe in range(8):
        setfillstyle(SOLID_FILL, RED if stripe % 2 else BLUE)
        bar(left + 13 * stripe, top, left + 13 * stripe + 12, top + 55)
    rectangle(left - 1, top - 1, left + 104, top + 56, DARKGRAY)


def caption(x: int, y: int, text: str, color: int = LIGHTGRAY) -> None:
    """A text, its middle at x."""
    setcolor(color)
    outtextxy(x - textwidth(text) // 2, y, text)


def operators() -> None:
    """The same figure put on the same stripes in five ways; then the two that make a sprite."""
    fish = drawn_fish(LIGHTRED, YELLOW, 80)
    left = 20
    for operator, name in (
        (COPY_PUT, "COPY_PUT"),
        (XOR_PUT, "XOR_PUT"),
        (OR_PUT, "OR_PUT"),
        (AND_PUT, "AND_PUT"),
        (NOT_PUT, "NOT_PUT"),
    ):
        caption(left + 52, 22, name, WHITE)
        stripes(left, 44)
        putimage(left + 12, 45, fish, operator)
        stripes(left, 120)
        putimage(left + 12, 121, fish, operator)
        putimage(left + 12, 121, fish, operator)
        left = left + 124
    caption(320, 186, "above: put once      below: put twice, where only XOR_PUT takes it away")
    steps(fish)


def steps(fish: Image) -> None:
    """How mask and figure together make a sprite."""
    stripes(96, 320)
    caption(148, 388, "the picture", WHITE)
    stripes(268, 320)
    putimage(280, 321, mask(fish), AND_PUT)
    caption(320, 388, "mask, AND_PUT", WHITE)
    stripes(440, 320)
    putimage(452, 321, mask(fish), AND_PUT)
    putimage(452, 321, fish, OR_PUT)
    caption(492, 388, "fish, OR_PUT", WHITE)
    for left, image in ((268, mask(fish)), (440, fish)):
        putimage(left + 12, 240, image, COPY_PUT)
        rectangle(left - 1, 239, left + 104, 295, DARKGRAY)
        caption(left + 52, 302, "↓", WHITE)
    caption(320, 416, "A hole in the shape of the figure, then the figure into the hole.")


# XOR: two saucers


class Saucers:
    """Flying figures that need no copy of what they cover: a second XOR takes them away."""

    def draw(self) -> None:
        """A town at night, and the saucers above it."""
        setactivepage(1)
        cleardevice()
        setcolor(LIGHTCYAN)
        setfillstyle(SOLID_FILL, LIGHTGRAY)
        fillellipse(40, 20, 20, 16)
        setfillstyle(SOLID_FILL, LIGHTMAGENTA)
        fillellipse(40, 26, 38, 10)
        setfillstyle(SOLID_FILL, YELLOW)
        for x in range(12, 76, 14):
            fillellipse(x, 26, 2, 2)
        self.image = getimage(0, 0, 80, 38)
        cleardevice()
        setactivepage(0)
        town()
        self.time = 40
        self.put()

    def put(self) -> None:
        """Both saucers, or both away."""
        for start, speed in ((0, 0.021), (2.2, 0.034)):
            turn = start + speed * self.time
            putimage(280 + 270 * sin(turn), 180 + 130 * sin(2.3 * turn), self.image, XOR_PUT)

    def move(self) -> None:
        """Away, on, and there again."""
        self.put()
        self.time += 1
        self.put()


def town() -> None:
    """Houses of many heights, some windows lit."""
    setfillstyle(INTERLEAVE_FILL, BLUE)
    bar(0, 0, WIDTH, HEIGHT)
    chance = Random(7)  # with a seed: the same town each time
    for left in range(0, WIDTH, 40):
        top = chance.randrange(170, 370)
        setfillstyle(SOLID_FILL, chance.choice((DARKGRAY, BLACK, CYAN, BROWN)))
        bar(left, top, left + 39, HEIGHT)
        for y in range(top + 8, HEIGHT, 14):
            for x in range(left + 5, left + 35, 8):
                setfillstyle(SOLID_FILL, chance.choice((YELLOW, BLACK)))
                bar(x, y, x + 3, y + 6)
    caption(320, 12, "putimage(x, y, saucer, XOR_PUT), and the same again to take it away")


# AND and OR: an aquarium


class Aquarium:
    """Fish of three kinds, each at its own speed."""

    def draw(self) -> None:
        """Water, ground and plants; they and the bar are kept as one image."""
        self.time = 0
        self.kinds = [
            drawn_fish(LIGHTRED, YELLOW, 84),
            drawn_fish(YELLOW, LIGHTMAGENTA, 60),
            drawn_fish(LIGHTGREEN, GREEN, 44),
        ]
        water()
        self.picture = getimage(0, -BAR, WIDTH - 1, HEIGHT - 1)
        self.swim()

    def swim(self) -> None:
        """Nine fish at their places, each on its way there and back: the last are in front."""
        way = WIDTH + 100  # from beyond one edge of the picture to beyond the other
        for number in range(9):
            fish = self.kinds[2 * number % 3]
            speed = 2 + number % 3
            swum = (331 * number + speed * self.time) % (2 * way)
            y = int(60 + 33 * number + 8 * sin(self.time / 20 + number))
            if swum < way:
                put(swum - 100, y, fish)
            else:
                put(2 * way - swum - 100, y, mirrored(fish))

    def move(self) -> None:
        """The picture, the fish on it, and the page is shown."""
        self.time += 1
        putimage(0, -BAR, self.picture, COPY_PUT)
        self.swim()
        swapbuffers()


def water() -> None:
    """Light on the water, then sand, stones and plants."""
    setfillstyle(SOLID_FILL, BLUE)
    bar(0, 0, WIDTH, HEIGHT)
    setfillstyle(SOLID_FILL, LIGHTBLUE)
    for top, height in ((0, 8), (12, 4), (22, 2), (32, 1), (44, 0)):
        bar(0, top, WIDTH, top + height)
    ground = [(x, 400 + round(12 * sin(x / 90))) for x in range(-20, WIDTH + 40, 20)]
    setfillstyle(SOLID_FILL, BROWN)
    setcolor(YELLOW)
    fillpoly([*ground, (WIDTH + 20, HEIGHT), (-20, HEIGHT)])
    setcolor(LIGHTGRAY)
    setfillstyle(SOLID_FILL, DARKGRAY)
    for left, top, size in ((470, 404, 60), (540, 418, 44), (420, 424, 30), (90, 426, 36)):
        fillellipse(left, top, size, size * 2 // 3)
        arc(left, top, 100, 160, size * 2 // 3)
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
    for left in (0, 384):
        plant(left + 200, 180, GREEN)
        plant(left + 222, 120, LIGHTGREEN)
        plant(left + 184, 96, GREEN)
    setlinestyle(SOLID_LINE, 0, NORM_WIDTH)


def plant(root: int, height: int, color: int) -> None:
    """A stalk that sways more the higher it is."""
    stalk = []
    for up in range(0, height, 6):
        sway = 10 * sin(up / 22 + root) * up / 120
        stalk.append((root + sway, 420 - up))
    drawpoly(stalk, color=color)


SAUCERS, AQUARIUM = Saucers(), Aquarium()
PAGES = (
    Page("The five operators", operators),
    Page("XOR_PUT", SAUCERS.draw, SAUCERS.move),
    Page("AND_PUT and OR_PUT", AQUARIUM.draw, AQUARIUM.move, 0),
)


def draw() -> None:
    """The aquarium."""
    show(PAGES, 2)


def main() -> None:
    """Leaf through the pages until Esc comes."""
    leaf_through(PAGES)


if __name__ == "__main__":
    main()
