"""STARS.C: stars that fly towards the eye.

Plus and minus change the speed, Esc ends.
"""

import sys

from bgi import *
from bgi.stdio import printf
from bgi.stdlib import random

STARS = 40
FAR = STARS * 5  # where they begin
ESC = 27


class Star:
    def __init__(self, x=0, y=0, z=0):
        self.x = x  # from the middle
        self.y = y
        self.z = z  # how far away


sky = [Star() for _ in range(STARS)]
speed = 2
middle_x = 0
middle_y = 0


# A new place for a star.
def begin(s):
    s.x = random(400) - 200
    s.y = random(300) - 150
    s.z = FAR


# Where it is seen; 0 if it is out of sight.
def seen(s):
    px = middle_x + int(s.x * 40 / s.z)
    py = middle_y + int(s.y * 40 / s.z)
    return int(px >= 0 and px <= getmaxx() and py >= 0 and py <= getmaxy()), px, py


def draw(s, color):
    answer, x, y = seen(s)

    if answer:
        putpixel(x, y, color)


def move(count):
    for i in range(count):
        draw(sky[i], BLACK)
        sky[i].z -= speed
        if sky[i].z < 1:
            begin(sky[i])  # it flew past us
        draw(sky[i], WHITE if sky[i].z < FAR // 3 else DARKGRAY)


def main():
    global middle_x, middle_y, speed
    gd = DETECT
    gm = 0
    key = 0

    gd, gm = initgraph(gd, gm, "C:\\TC\\BGI")
    if graphresult() != grOk:
        printf("There is no graphics mode.\n")
        sys.exit(1)
    middle_x = getmaxx() // 2
    middle_y = getmaxy() // 2

    for i in range(STARS):
        begin(sky[i])

    while key != ESC:
        move(STARS)
        if kbhit():
            key = getch()
            if key in (ord("+"), ord("=")):
                speed += 1
            elif key == ord("-"):
                if speed > 1:
                    speed -= 1
            elif key == 0:
                getch()  # an arrow, or F1
            text = f"speed {speed}"
            outtextxy(8, 8, text)
        delay(20)
    closegraph()


if __name__ == "__main__":
    main()
