"""Lesson 15: one way to solve its exercises.

python demos/course/solutions/15_game.py
"""

from bgi import *
from bgi import keyboard, stdlib

BRICK_WIDTH, BRICK_HEIGHT = 64, 20
BAT_WIDTH, BAT_Y = 90, 450
COLUMNS, ROWS, SIZE = 32, 24, 20  # of the snake's board; a field is so many pixels wide
ARROWS = {72: (0, -1), 80: (0, 1), 75: (-1, 0), 77: (1, 0)}  # what getch() says after a 0


def speed(points):
    """Exercise 1: pixels per picture."""
    return min(9, 4 + points // 50)


def bounce(brick, x, y, dx, dy):
    """Exercise 2: one picture before, the ball was outside: beside the brick, or above or below.

    In both at once it has met the corner, and flies back.
    """
    left, top = brick
    before_x, before_y = x - dx, y - dy
    if not left <= before_x < left + BRICK_WIDTH:
        dx = -dx
    if not top <= before_y < top + BRICK_HEIGHT:
        dy = -dy
    return dx, dy


def brick_at(wall, x, y):
    """The brick that a point lies in, or None."""
    for left, top in wall:
        if left <= x < left + BRICK_WIDTH and top <= y < top + BRICK_HEIGHT:
            return left, top
    return None


def play_bricks():
    """The lesson's game with both; a ball that is lost comes back. Any key but the arrows ends."""
    wall = [(x, y) for y in range(60, 140, BRICK_HEIGHT) for x in range(0, 640, BRICK_WIDTH)]
    bat, points = 275, 0
    x, y, dx, dy = 320, 300, 3, 4
    while not ended():
        bat = bat + 7 * (keyboard.pressed("Right") - keyboard.pressed("Left"))
        bat = min(639 - BAT_WIDTH, max(0, bat))

        x, y = x + dx, y + dy
        if x < 0 or x > 639:
            dx = -dx
        if y < 0:
            dy = -dy
        if dy > 0 and BAT_Y <= y <= BAT_Y + 8 and bat <= x <= bat + BAT_WIDTH:
            dx, dy = (x - bat - BAT_WIDTH // 2) // 8, -speed(points)
        brick = brick_at(wall, x, y)
        if brick is not None:
            wall.remove(brick)
            points = points + 10
            dx, dy = bounce(brick, x, y, dx, dy)
        if y > 480:
            x, y, dx, dy = 320, 300, 3, 4

        cleardevice()
        for left, top in wall:
            bar(left + 1, top + 1, left + BRICK_WIDTH - 2, top + BRICK_HEIGHT - 2, LIGHTRED)
        bar(bat, BAT_Y, bat + BAT_WIDTH, BAT_Y + 8, WHITE)
        bar(x - 4, y - 4, x + 4, y + 4, YELLOW)
        outtextxy(8, 8, f"{points} points, speed {speed(points)}   any letter ends")
        swapbuffers()


def ended():
    """Whether a key has been typed that is no arrow."""
    while kbhit():
        if getch() != 0:
            return True
        getch()  # the arrow's second number
    return False


def step(snake, direction, apple):
    """Exercise 3: a new head; and the tail goes, unless the head is on the apple."""
    column, row = snake[0]
    head = (column + direction[0], row + direction[1])
    if not (0 <= head[0] < COLUMNS and 0 <= head[1] < ROWS) or head in snake[:-1]:
        return "dies"
    snake.insert(0, head)
    if head == apple:
        return "eats"
    snake.pop()
    return "goes on"


def test_rules():
    """Each rule, tried once."""
    assert [speed(points) for points in (0, 40, 50, 900)] == [4, 4, 5, 9]
    brick = (64, 60)  # to 127, 79
    assert bounce(brick, 100, 77, 3, -4) == (3, 4), "from below"
    assert bounce(brick, 66, 70, 5, -4) == (-5, -4), "from the left"
    assert bounce(brick, 66, 77, 5, -4) == (-5, 4), "at the corner"
    snake = [(5, 5), (4, 5), (3, 5)]
    assert step(snake, (1, 0), (9, 9)) == "goes on"
    assert snake == [(6, 5), (5, 5), (4, 5)]
    assert step(snake, (0, 1), (6, 6)) == "eats"
    assert snake == [(6, 6), (6, 5), (5, 5), (4, 5)]
    assert step([(0, 0)], (-1, 0), (9, 9)) == "dies", "the edge"
    ring = [(1, 1), (1, 2), (2, 2), (2, 1)]
    assert step(ring, (1, 0), (9, 9)) == "goes on", "the tail has left when the head comes"
    assert step([*ring, (3, 1)], (0, 1), (9, 9)) == "dies", "its own body"


def draw_field(field, color):
    """A square on the board."""
    column, row = field
    bar(column * SIZE + 1, row * SIZE + 1, column * SIZE + SIZE - 2, row * SIZE + SIZE - 2, color)


def play_snake():
    """Eight steps in a second, until it dies or a key is pressed that is no arrow."""
    snake, direction, apple = [(10, 12), (9, 12), (8, 12)], (1, 0), (20, 12)
    happened = "goes on"
    while happened != "dies":
        cleardevice()
        draw_field(apple, LIGHTRED)
        for field in snake:
            draw_field(field, LIGHTGREEN)
        swapbuffers()
        delay(125)
        if kbhit():
            if getch() != 0:
                return
            wanted = ARROWS.get(getch(), direction)
            if wanted[0] != -direction[0] or wanted[1] != -direction[1]:
                direction = wanted
        happened = step(snake, direction, apple)
        if happened == "eats":
            apple = (stdlib.random(COLUMNS), stdlib.random(ROWS))


strict()
test_rules()
initgraph(VGA, VGAHI)
play_bricks()
play_snake()
closegraph()
