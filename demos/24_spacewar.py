"""Spacewar: two ships duel round a sun, two players at one keyboard.

    python demos/24_spacewar.py

What it shows: pressed() of `bgi.keyboard` tells whether a key is down now, and several can be down
at once; getch() hears one key after the other. The sun's pull and the engines change each ship's
speed, and the speed its place. The left ship is steered by a d w, s fires; the right one by the
arrows. Esc ends.
"""

from math import cos, hypot, radians, sin
from random import Random

from bgi import *
from bgi.keyboard import pressed

MODE = (VGA, VGAHI)
WIDTH, HEIGHT = 640, 456  # of space; the score is below
SUN_X, SUN_Y, SUN_RADIUS = 320, 228, 22
PULL = 640  # of the sun at a distance of 1; it grows weaker with the distance's square
THRUST, TURN = 0.05, 4  # per picture: pixels per picture, and degrees
TORPEDO_SPEED, TORPEDO_LIFE, RELOAD = 5, 80, 15
SIZE = 14  # of a ship, from its middle to its nose
BLAST = 40  # pictures that an explosion takes
ESC = 27

random = Random(1962)
STAR_X = [random.randrange(WIDTH) for _ in range(150)]
STAR_Y = [random.randrange(HEIGHT) for _ in range(150)]
STAR_COLORS = [random.choice([DARKGRAY, LIGHTGRAY, WHITE, LIGHTBLUE]) for _ in range(150)]


class Flying:
    """Whatever flies: its place and its speed."""

    def __init__(self, x: float, y: float, dx: float, dy: float) -> None:
        self.x, self.y, self.dx, self.dy = x, y, dx, dy

    def fly(self) -> None:
        """One picture's time: be pulled by the sun, and move on."""
        distance = max(self.distance(SUN_X, SUN_Y), SUN_RADIUS)
        self.dx += PULL * (SUN_X - self.x) / distance**3
        self.dy += PULL * (SUN_Y - self.y) / distance**3
        self.x = (self.x + self.dx) % WIDTH
        self.y = (self.y + self.dy) % HEIGHT

    def distance(self, x: float, y: float) -> float:
        """How far a point is."""
        return hypot(x - self.x, y - self.y)


class Torpedo(Flying):
    """It flies for a while, and falls like everything else."""

    life = TORPEDO_LIFE


class Ship(Flying):
    """A ship: its colours, its four keys, and where it starts, on its way round the sun."""

    def __init__(self, dark: int, light: int, keys: list[str], x: int, dy: float, angle: int):
        self.dark, self.light, self.keys = dark, light, keys
        self.start = x, SUN_Y, 0, dy
        self.start_angle = angle
        self.score = 0
        self.begin()

    def begin(self) -> None:
        """Be as new."""
        super().__init__(*self.start)
        self.angle = self.start_angle
        self.burning = False
        self.reload = self.blast = 0

    def steer(self, torpedoes: list[Torpedo]) -> None:
        """Do what the keys say that are down now."""
        left, right, forward, fire = map(pressed, self.keys)
        self.angle += TURN * (left - right)
        self.burning = forward
        if forward:
            self.dx += THRUST * cos(radians(self.angle))
            self.dy -= THRUST * sin(radians(self.angle))
        self.reload -= 1
        if fire and self.reload <= 0:
            self.reload = RELOAD
            dx = self.dx + TORPEDO_SPEED * cos(radians(self.angle))
            dy = self.dy - TORPEDO_SPEED * sin(radians(self.angle))
            torpedoes.append(Torpedo(*self.point(1.5, 0), dx, dy))

    def point(self, length: float, turn: int) -> tuple[int, int]:
        """The point so many sizes away, in a direction counted from the nose."""
        angle = radians(self.angle + turn)
        x, y = self.x + length * SIZE * cos(angle), self.y - length * SIZE * sin(angle)
        return round(x), round(y)

    def draw(self) -> None:
        """A hull with a bright outline, and a flame behind it; or the explosion."""
        if self.blast:
            for radius, color in (
                (BLAST - self.blast, LIGHTRED),
                (BLAST - self.blast // 2, YELLOW),
            ):
                circle(round(self.x), round(self.y), radius, color)
            return
        if self.burning:
            flame = [self.point(0.7, 155), self.point(1.8, 180), self.point(0.7, 205)]
            fillpoly(flame, fill=YELLOW, color=LIGHTRED)
        hull = [self.point(1, 0), self.point(1, 140), self.point(0.4, 180), self.point(1, 220)]
        fillpoly(hull, fill=self.dark, color=self.light)


def two_ships() -> list[Ship]:
    """One on each side of the sun."""
    return [
        Ship(BLUE, LIGHTCYAN, ["a", "d", "w", "s"], 120, 1.8, 270),
        Ship(GREEN, LIGHTGREEN, ["Left", "Right", "Up", "Down"], 520, -1.8, 90),
    ]


def play(ships: list[Ship], torpedoes: list[Torpedo]) -> None:
    """One picture's time: steer, fly, and see who is hit."""
    for ship, other in (ships, ships[::-1]):
        if ship.blast:
            ship.blast -= 1
            if ship.blast == 0:
                ship.begin()
            continue
        ship.steer(torpedoes)
        ship.fly()
        hits = [torpedo for torpedo in torpedoes if torpedo.distance(ship.x, ship.y) < SIZE]
        if hits or ship.distance(SUN_X, SUN_Y) < SUN_RADIUS + SIZE / 2:
            ship.blast = BLAST
            other.score += 1
        for torpedo in hits:
            torpedo.life = 0
    for torpedo in torpedoes:
        torpedo.fly()
        torpedo.life -= 1
    torpedoes[:] = [torpedo for torpedo in torpedoes if torpedo.life > 0]


def show(ships: list[Ship], torpedoes: list[Torpedo]) -> None:
    """Stars, sun, torpedoes, ships, and the score below."""
    cleardevice()
    setviewport(0, 0, WIDTH - 1, HEIGHT - 1, 1)
    putpixel(STAR_X, STAR_Y, STAR_COLORS)
    for radius, color in ((22, RED), (18, LIGHTRED), (14, YELLOW), (7, WHITE)):
        setcolor(color)
        setfillstyle(SOLID_FILL, color)
        fillellipse(SUN_X, SUN_Y, radius, radius)
    for torpedo in torpedoes:
        circle(round(torpedo.x), round(torpedo.y), 2, WHITE)
    for ship in ships:
        ship.draw()

    setviewport(0, HEIGHT, WIDTH - 1, getmaxy(), 1)
    setfillstyle(SOLID_FILL, DARKGRAY)
    bar(0, 0, WIDTH - 1, getmaxy())
    setcolor(WHITE)
    outtextxy(228, 8, "Spacewar        Esc ends")
    setcolor(ships[0].light)
    outtextxy(8, 8, f"{ships[0].score:3}  a d w s")
    setcolor(ships[1].light)
    outtextxy(520, 8, f"{ships[1].score:3}  arrows")
    setviewport(0, 0, WIDTH - 1, getmaxy(), 1)


def draw() -> None:
    """A moment of a battle."""
    ships, torpedoes = two_ships(), [Torpedo(262, 92, 4, 1), Torpedo(340, 110, 4, 2)]
    ships[0].x, ships[0].y, ships[0].angle, ships[0].burning = 196, 84, 345, True
    ships[1].x, ships[1].y, ships[1].angle, ships[1].burning = 468, 310, 120, True
    show(ships, torpedoes)


def wants_to_end() -> bool:
    """Whether Esc has been typed: what is held is typed as well, and read away here."""
    typed = []
    while kbhit():
        typed.append(getch())
    return ESC in typed


def main() -> None:
    """Two players, until Esc."""
    initgraph(*MODE)
    ships: list[Ship] = two_ships()
    torpedoes: list[Torpedo] = []
    while not wants_to_end():
        play(ships, torpedoes)
        show(ships, torpedoes)
        swapbuffers()


if __name__ == "__main__":
    main()
