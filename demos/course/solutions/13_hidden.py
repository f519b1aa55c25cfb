"""Lesson 13: one way to solve its exercises.

python demos/course/solutions/13_hidden.py
"""

from math import cos, exp, pi, sin

from bgi import *

N = 32


def on_screen(x, y, z):
    """The paper's map, rounded to a pixel."""
    return round(320 + y - x * sin(pi / 4)), round(240 - z + x * cos(pi / 4))


def nearness(box):
    """Exercise 1: of boxes with a floor of one size, the nearer one has the larger x + y."""
    x, y, _, _ = box
    return x + y


def town(boxes):
    """The boxes of a town, the farthest first."""
    for x, y, height, color in sorted(boxes, key=nearness):
        near_x, right = x + 40, y + 40
        front = [(near_x, y, 0), (near_x, right, 0), (near_x, right, height), (near_x, y, height)]
        side = [(near_x, right, 0), (x, right, 0), (x, right, height), (near_x, right, height)]
        top = [(near_x, y, height), (near_x, right, height), (x, right, height), (x, y, height)]
        for area, fill in ((front, color), (side, color - 8), (top, WHITE)):
            fillpoly([on_screen(*corner) for corner in area], fill=fill, color=DARKGRAY)


def thirty_boxes():
    """Five rows of six, mixed up."""
    boxes = []
    for number in range(30):
        mixed = number * 7 % 30
        x, y = 70 * (mixed // 6) - 175, 70 * (mixed % 6) - 190
        boxes.append((x, y, 20 + 17 * mixed % 90, LIGHTBLUE + mixed % 6))
    return boxes


def height(x, y):
    """The hill."""
    far = x * x + y * y
    return cos(far / 2) * exp(-far / 10)


def place(i, j, z):
    """Point i, j of a mesh at a height: where it is on the screen, and how near."""
    x = 7 * i / N - 3.5
    y = 7 * j / N - 3.5
    across = 320 + 45 * (y - x * sin(pi / 4))
    down = 240 + 45 * x * cos(pi / 4) - 90 * z
    return across, down, x


def pixels(a, b):
    """The pixels of a line, both ends included: as many as its longer side has."""
    steps = max(1, round(max(abs(b[0] - a[0]), abs(b[1] - a[1]))))
    line_of = []
    for step in range(steps + 1):
        part = step / steps
        line_of.append((round(a[0] + part * (b[0] - a[0])), round(a[1] + part * (b[1] - a[1]))))
    return line_of


def both_families(points):
    """Exercise 2: the pieces of the other family come before the line that they lead to."""
    highest = [1000] * 640
    lowest = [-1] * 640
    for i in range(N, -1, -1):
        for j in range(N + 1) if i < N else ():
            for x, y in pixels(points[i + 1][j], points[i][j]):
                if y < highest[x] or y > lowest[x]:
                    putpixel(x, y, GREEN)
        # The horizons change when the line is done: it may not hide itself.
        mine = pixels(points[i][0], points[i][1])
        for j in range(1, N):
            mine = mine + pixels(points[i][j], points[i][j + 1])
        for x, y in mine:
            if y < highest[x] or y > lowest[x]:
                putpixel(x, y, LIGHTGREEN)
        for x, y in mine:
            highest[x] = min(highest[x], y)
            lowest[x] = max(lowest[x], y)


def triangle(a, b, c, color, nearest):
    """Set those pixels of a triangle that are nearer than what is there."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    if area == 0:
        return
    for y in range(round(min(a[1], b[1], c[1])), round(max(a[1], b[1], c[1])) + 1):
        for x in range(round(min(a[0], b[0], c[0])), round(max(a[0], b[0], c[0])) + 1):
            part_b = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area
            part_c = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area
            part_a = 1 - part_b - part_c
            if min(part_a, part_b, part_c) < 0:
                continue
            near = part_a * a[2] + part_b * b[2] + part_c * c[2]
            if near > nearest[y][x]:
                nearest[y][x] = near
                putpixel(x, y, color)


def crossing(hill, plane):
    """Exercise 3: two surfaces in one picture; returns how near each pixel is."""
    nearest = [[-1000.0] * 640 for _ in range(480)]
    for points, colors in ((hill, (LIGHTGREEN, GREEN)), (plane, (LIGHTBLUE, BLUE))):
        for i in range(N):
            for j in range(N):
                a, b = points[i][j], points[i][j + 1]
                c, d = points[i + 1][j + 1], points[i + 1][j]
                triangle(a, b, c, colors[(i + j) % 2], nearest)
                triangle(a, c, d, colors[(i + j) % 2], nearest)
    return nearest


def depth_map(nearest):
    """The nearness as greys: 1 to 15 from the farthest to the nearest."""
    registers = getpalette().colors
    for number in range(16):
        setrgbpalette(registers[number], 4 * number, 4 * number, 4 * number)
    for y in range(480):
        for x in range(640):
            if nearest[y][x] > -1000:
                putpixel(x, y, 1 + round(14 * (nearest[y][x] + 3.5) / 7))


def mesh(z_of):
    """All points of a surface."""
    points = []
    for i in range(N + 1):
        row = []
        for j in range(N + 1):
            row.append(place(i, j, z_of(7 * i / N - 3.5, 7 * j / N - 3.5)))
        points.append(row)
    return points


def flat(x, y):
    """The plane z = 0.2."""
    return 0.2


strict()
initgraph(VGA, VGAHI)
town(thirty_boxes())
getch()

cleardevice()
both_families(mesh(height))
getch()

cleardevice()
nearest = crossing(mesh(height), mesh(flat))
delay(3000)
cleardevice()
depth_map(nearest)
getch()
closegraph()
