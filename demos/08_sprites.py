"""Figures that move over a picture, and leave it whole.

    python demos/08_sprites.py

What it shows: getimage() takes a figure, putimage() puts it anywhere. XOR_PUT erases what it drew
when it draws it again. AND_PUT with a mask cuts a hole in the shape of the figure, and OR_PUT sets
the figure in: so it covers the picture, and what is around it stays. The aquarium is drawn on the
page that is not shown.
"""

from dataclasses import dataclass

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
    return Image(np.where(image.array == 0, 15, 0).astype(np.uint8), image.colors)


def put(x: int, y: int, image: Image) -> None:
    """Cover the picture with a figure, but not with what is around the figure."""
    putimage(x, y, mask(image), AND_PUT)
    putimage(x, y, image, OR_PUT)


# The operators, one by one


def stripes(left: int, top: int, width: int = 104, height: int = 56) -> None:
    """Something to see a figure on."""
    setfillstyle(SOLID_FILL, BLUE)
    edges = np.arange(0, width, 13)
    bar(left + edges, top, left + edges + 12, top + height - 1, np.where(edges % 26, RED, BLUE))
    rectangle(left - 1, top - 1, left + width, top + height, DARKGRAY)


def caption(x: int, y: int, text: str, color: int = LIGHTGRAY) -> None:
    """A text, its middle at x."""
    setcolor(color)
    outtextxy(x - textwidth(text) // 2, y, text)


def operators() -> None:
    """The same figure put on the same stripes in five ways; then the two that make a sprite."""
    fish = drawn_fish(LIGHTRED, YELLOW, 80)
    names = ("COPY_PUT", "XOR_PUT", "OR_PUT", "AND_PUT", "NOT_PUT")
    for operator, name in enumerate(names):
        left = 20 + 124 * operator
        for twice in (0, 1):
            stripes(left, 44 + 76 * twice)
            for _ in range(1 + twice):
                putimage(left + 12, 45 + 76 * twice, fish, operator)
        caption(left + 52, 22, name, WHITE)
    caption(320, 186, "above: put once      below: put twice, where only XOR_PUT takes it away")
    steps = ((None, "the picture"), (AND_PUT, "mask, AND_PUT"), (OR_PUT, "fish, OR_PUT"))
    for place, (step, name) in enumerate(steps):
        left = 96 + 172 * place
        stripes(left, 320)
        if place > 0:
            putimage(left + 12, 321, mask(fish), AND_PUT)
        if place > 1:
            putimage(left + 12, 321, fish, OR_PUT)
        if step is not None:
            shape = mask(fish) if step == AND_PUT else fish
            putimage(left + 12, 240, shape, COPY_PUT)
            rectangle(left - 1, 239, left + 104, 295, DARKGRAY)
            caption(left + 52, 302, "\x19", WHITE)
        caption(left + 52, 388, name, WHITE)
    caption(320, 416, "A hole in the shape of the figure, then the figure into the hole.")


# XOR: two saucers


@dataclass
class Saucers:
    """Flying figures that need no copy of what they cover: a second XOR takes them away."""

    time: int = 0

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
        self.town()
        self.time = 40
        self.put()

    def town(self) -> None:
        """Houses of many heights, some windows lit."""
        setfillstyle(INTERLEAVE_FILL, BLUE)
        bar(0, 0, WIDTH, HEIGHT)
        chance = np.random.default_rng(7)
        setfillstyle(SOLID_FILL, BLACK)
        for place in range(16):
            left, top = 40 * place, 170 + int(chance.integers(0, 200))
            setfillstyle(SOLID_FILL, (DARKGRAY, BLACK, CYAN, BROWN)[place % 4])
            bar(left, top, left + 39, HEIGHT)
            x, y = np.meshgrid(np.arange(left + 5, left + 35, 8), np.arange(top + 8, HEIGHT, 14))
            lit = chance.random(x.shape) < 0.5
            bar(x, y, x + 3, y + 6, np.where(lit, YELLOW, BLACK))
        caption(320, 12, "putimage(x, y, saucer, XOR_PUT), and the same again to take it away")

    def put(self) -> None:
        """Both saucers, or both away."""
        for start, speed in ((0, 0.021), (2.2, 0.034)):
            turn = start + speed * self.time
            x, y = 280 + 270 * np.sin(turn), 180 + 130 * np.sin(2.3 * turn)
            putimage(x, y, self.image, XOR_PUT)

    def move(self) -> None:
        """Away, on, and there again."""
        self.put()
        self.time += 1
        self.put()


# AND and OR: an aquarium


@dataclass
class Aquarium:
    """Fish of three kinds, each at its own speed."""

    time: int = 0

    def draw(self) -> None:
        """Water, ground and plants; they and the bar are kept as one image."""
        kinds = ((LIGHTRED, YELLOW, 84), (YELLOW, LIGHTMAGENTA, 60), (LIGHTGREEN, GREEN, 44))
        self.fish = []
        for body, stripe, length in kinds:
            fish = drawn_fish(body, stripe, length)
            self.fish.append((fish, mirrored(fish)))
        self.time = 0
        self.water()
        self.picture = getimage(0, -BAR, WIDTH - 1, HEIGHT - 1)
        self.swim()

    def water(self) -> None:
        """Light on the water, then sand, stones and plants."""
        setfillstyle(SOLID_FILL, BLUE)
        bar(0, 0, WIDTH, HEIGHT)
        for top, height in ((0, 8), (12, 4), (22, 2), (32, 1), (44, 0)):
            bar(0, top, WIDTH, top + height, LIGHTBLUE)
        x = np.arange(-20, WIDTH + 40, 20)
        ground = np.stack((x, 400 + 12 * np.sin(x / 90)), axis=1)
        setfillstyle(SOLID_FILL, BROWN)
        setcolor(YELLOW)
        fillpoly(np.concatenate((ground, [(WIDTH + 20, HEIGHT), (-20, HEIGHT)])))
        for left, top, size in ((470, 404, 60), (540, 418, 44), (420, 424, 30), (90, 426, 36)):
            setcolor(LIGHTGRAY)
            setfillstyle(SOLID_FILL, DARKGRAY)
            fillellipse(left, top, size, size * 2 // 3)
            setcolor(LIGHTGRAY)
            arc(left, top, 100, 160, size * 2 // 3)
        setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
        up = np.arange(0, 190, 6)
        for root, height, color in ((200, 180, GREEN), (222, 120, LIGHTGREEN), (184, 100, GREEN)):
            for shift in (0, 400):
                sway = 10 * np.sin(up / 22 + root) * up / 120
                leaf = np.stack((root + shift * 0.96 + sway, 420 - up), axis=1)[: height // 6]
                drawpoly(leaf, color=color)
        setlinestyle(SOLID_LINE, 0, NORM_WIDTH)

    def swim(self) -> None:
        """Every fish at its place: there and back, some in front of others."""
        for number in range(9):
            fish, back = self.fish[number * 2 % 3]
            way = 2 * (WIDTH + 100)
            place = (number * 331 + self.time * (2 + number % 3)) % way
            turned = place >= way // 2
            x = way - place - 100 if turned else place - 100
            y = 60 + 33 * number + 8 * np.sin(self.time / 20 + number)
            put(x, int(y), back if turned else fish)

    def move(self) -> None:
        """The picture, the fish on it, and the page is shown."""
        self.time += 1
        putimage(0, -BAR, self.picture, COPY_PUT)
        self.swim()
        swapbuffers()


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
