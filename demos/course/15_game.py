"""Lesson 15: a game is a loop that asks, moves and draws.

    python demos/course/15_game.py

A game is a loop that asks, moves and draws, sixty times a second. It asks which keys are down;
moves the bat and the ball, and looks what the ball has met; and draws all of it on the page that is
not shown. Left and right move the bat, space throws the ball, Esc ends. The page:
docs/course/15-game.md.
"""

from bgi import *
from bgi import keyboard

WIDTH, HEIGHT = 640, 480
BRICK_WIDTH, BRICK_HEIGHT = 64, 20
TOP = 60  # where the wall begins
COLORS = [LIGHTRED, YELLOW, LIGHTGREEN, LIGHTCYAN]  # of its rows
BAT_WIDTH, BAT_Y = 90, 450
RADIUS = 6


def build_wall():
    """All bricks: the place of each one's upper left corner, and its colour."""
    wall = []
    for row in range(len(COLORS)):
        for column in range(WIDTH // BRICK_WIDTH):
            wall.append((column * BRICK_WIDTH, TOP + row * BRICK_HEIGHT, COLORS[row]))
    return wall


def brick_at(wall, x, y):
    """The brick that a point lies in, or None."""
    for brick in wall:
        left, top, _ = brick
        if left <= x < left + BRICK_WIDTH and top <= y < top + BRICK_HEIGHT:
            return brick
    return None


def draw():
    """The whole picture, and show it."""
    cleardevice()
    for left, top, color in wall:
        setfillstyle(SOLID_FILL, color)
        bar(left + 1, top + 1, left + BRICK_WIDTH - 2, top + BRICK_HEIGHT - 2)
    setfillstyle(SOLID_FILL, WHITE)
    bar(bat, BAT_Y, bat + BAT_WIDTH, BAT_Y + 8)
    fillellipse(x, y, RADIUS, RADIUS)
    setcolor(LIGHTGRAY)
    outtextxy(8, 8, f"{points} points   balls {'o' * balls}")
    if not flying:
        outtextxy(200, 300, ANSWERS[balls == 0, not wall])
    swapbuffers()


ANSWERS = {
    (False, False): "space: throw the ball   Esc: end",
    (True, False): "game over   Esc: end",
    (False, True): "all gone!   Esc: end",
}

strict()
initgraph(VGA, VGAHI)
wall = build_wall()
bat = 275  # its left end
x, y = 320, BAT_Y - RADIUS
dx, dy = 3, -4
points, balls = 0, 3
flying = False
while not keyboard.pressed("Esc"):
    # Ask
    bat = bat + 7 * (keyboard.pressed("Right") - keyboard.pressed("Left"))
    bat = min(WIDTH - BAT_WIDTH - 1, max(0, bat))
    if keyboard.pressed("Space") and not flying and balls > 0 and wall:
        flying = True
        dx, dy = 3, -4

    # Move
    if not flying:
        x, y = bat + BAT_WIDTH // 2, BAT_Y - RADIUS
    else:
        x, y = x + dx, y + dy
        if x < RADIUS or x > WIDTH - RADIUS:
            dx = -dx
        if y < RADIUS:
            dy = -dy
        if dy > 0 and BAT_Y - RADIUS <= y <= BAT_Y + 8 and bat <= x <= bat + BAT_WIDTH:
            dy = -dy
            dx = (x - bat - BAT_WIDTH // 2) // 8  # the bat's end sends it off to the side
        met = brick_at(wall, x, y)
        if met:
            wall.remove(met)
            points = points + 10
            dy = -dy
            flying = bool(wall)
        if y > HEIGHT:
            balls = balls - 1
            flying = False

    # Draw
    draw()
