"""Balls in a room, without a flicker.

    python demos/13_bounce.py

What it shows: a room of three dimensions needs only one idea: what is twice as far from the eye
appears half as large. The room stands still, so it is drawn once and kept as an image. Each picture
is made on the page that is not shown: first the room, then the shadows, then the balls from the
farthest to the nearest. Space stops and starts, any other key ends.
"""

from bgi import *

MODE = (VGA, VGAHI)
SPACE = ord(" ")

# The room, in metres: x to the right, y up, z away from the eye. Its front is the screen.
LEFT, RIGHT, FLOOR, CEILING, FRONT, BACK = -4, 4, 0, 6, 0, 8
EYE_HEIGHT, EYE_DISTANCE = 3, 8
PIXELS_PER_METRE = 80
RADIUS = 0.55
GRAVITY = 0.006  # metres per picture, per picture


def scale(z: float) -> float:
    """How many pixels a metre has at a distance."""
    return PIXELS_PER_METRE * EYE_DISTANCE / (z + EYE_DISTANCE)


def project(x: float, y: float, z: float) -> tuple[int, int]:
    """Where a point of the room appears on the screen."""
    return round(320 + x * scale(z)), round(240 - (y - EYE_HEIGHT) * scale(z))


class Ball:
    """A ball: its colours, where it is and how it flies."""

    def __init__(self, dark: int, light: int, place: list[float], speed: list[float]) -> None:
        self.dark, self.light = dark, light
        self.x, self.y, self.z = place
        self.dx, self.dy, self.dz = speed

    def move(self) -> None:
        """One picture's time: fall, fly, and come back from the walls."""
        self.dy -= GRAVITY
        self.x += self.dx
        self.y += self.dy
        self.z += self.dz
        if self.x < LEFT + RADIUS or self.x > RIGHT - RADIUS:
            self.dx = -self.dx
            self.x += self.dx
        if self.y < FLOOR + RADIUS or self.y > CEILING - RADIUS:
            self.dy = -self.dy
            self.y += self.dy
        if self.z < FRONT + RADIUS or self.z > BACK - RADIUS:
            self.dz = -self.dz
            self.z += self.dz

    def draw_shadow(self) -> None:
        """A black ellipse on the floor, below the ball."""
        x, y = project(self.x, FLOOR, self.z)
        _, near = project(self.x, FLOOR, self.z - RADIUS)
        setcolor(BLACK)
        setfillstyle(SOLID_FILL, BLACK)
        fillellipse(x, y, round(RADIUS * scale(self.z)), near - y)

    def draw(self) -> None:
        """Three discs: the ball, its lit side, and the reflection of the lamp."""
        self.disc(1.0, 0.0, self.dark)
        self.disc(0.72, 0.2, self.light)
        self.disc(0.2, 0.42, WHITE)

    def disc(self, size: float, shift: float, color: int) -> None:
        """A disc, of a part of the ball's size and shifted towards the lamp, upper left."""
        x, y = project(self.x - shift * RADIUS, self.y + shift * RADIUS, self.z)
        radius = round(size * RADIUS * scale(self.z))
        setcolor(color)
        setfillstyle(SOLID_FILL, color)
        fillellipse(x, y, radius, radius)


def six_balls() -> list[Ball]:
    """Always the same ones."""
    return [
        Ball(RED, LIGHTRED, [-1.4, 4.4, 7.2], [-0.04, 0.02, -0.03]),
        Ball(BROWN, YELLOW, [1.2, 4.5, 5.4], [-0.04, 0.03, 0.02]),
        Ball(GREEN, LIGHTGREEN, [-2.0, 3.5, 3.1], [-0.03, 0.0, -0.05]),
        Ball(CYAN, LIGHTCYAN, [2.2, 5.1, 1.2], [0.02, -0.02, 0.04]),
        Ball(BLUE, LIGHTBLUE, [2.1, 4.2, 2.8], [-0.05, 0.01, -0.04]),
        Ball(MAGENTA, LIGHTMAGENTA, [-0.2, 4.7, 2.5], [0.04, 0.04, 0.03]),
    ]


def draw_room() -> None:
    """A floor of tiles, and a line every metre on the other walls."""
    for z in range(FRONT, BACK):
        for x in range(LEFT, RIGHT):
            color = LIGHTGRAY if (x + z) % 2 else DARKGRAY
            corners = ((x, z), (x + 1, z), (x + 1, z + 1), (x, z + 1))
            fillpoly([project(x, FLOOR, z) for x, z in corners], fill=color, color=color)
    setcolor(BLUE)
    for x in range(LEFT, RIGHT + 1):
        segment((x, FLOOR, BACK), (x, CEILING, BACK))
        segment((x, CEILING, FRONT), (x, CEILING, BACK))
    for y in range(FLOOR, CEILING + 1):
        segment((LEFT, y, BACK), (RIGHT, y, BACK))
        segment((LEFT, y, FRONT), (LEFT, y, BACK))
        segment((RIGHT, y, FRONT), (RIGHT, y, BACK))
    for z in range(FRONT, BACK + 1):
        segment((LEFT, CEILING, z), (RIGHT, CEILING, z))
        segment((LEFT, FLOOR, z), (LEFT, CEILING, z))
        segment((RIGHT, FLOOR, z), (RIGHT, CEILING, z))


def segment(start: tuple[int, int, int], end: tuple[int, int, int]) -> None:
    """A line in the room."""
    line(*project(*start), *project(*end))


def distance(ball: Ball) -> float:
    """How far a ball is: what the balls are sorted by."""
    return ball.z


def draw_balls(balls: list[Ball]) -> None:
    """Shadows first; then the balls, the farthest first."""
    for ball in balls:
        ball.draw_shadow()
    for ball in sorted(balls, key=distance, reverse=True):
        ball.draw()


def draw() -> None:
    """One moment of the flight."""
    balls = six_balls()
    for _ in range(30):
        for ball in balls:
            ball.move()
    draw_room()
    draw_balls(balls)


def main() -> None:
    """Fly until a key other than space comes."""
    initgraph(*MODE)
    draw_room()
    room = getimage(0, 0, getmaxx(), getmaxy())
    balls = six_balls()
    key = SPACE
    flying = True
    while key == SPACE:
        if flying:
            for ball in balls:
                ball.move()
        putimage(0, 0, room, COPY_PUT)
        draw_balls(balls)
        setcolor(WHITE)
        outtextxy(8, 8, "space: stop   any other key: end")
        swapbuffers()
        if kbhit():
            key = getch()
            flying = not flying


if __name__ == "__main__":
    main()
