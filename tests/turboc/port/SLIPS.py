"""SLIPS.CPP: two gotos, a < for a <<, a number that overflows on its way to an int.

Where int16() stands, C may have cut a number off at 32,767.
"""

from bgi import DETECT, circle, getch, initgraph
from bgi.stdio import printf, scanf


def int16(number):
    """A number as an int of 16 bits holds it: 32,768 is -32,768."""
    return (number + 0x8000) % 0x10000 - 0x8000


tries = 0
choice = 0


def again():
    global tries
    tries += 1
    return int(tries < 4)


def main():
    global choice, tries
    gd = DETECT
    gm = 0

    gd, gm = initgraph(gd, gm, "")
    while True:
        choice = scanf("%d")
        if choice > 100:
            tries += 1
            continue
        a, b = scanf("%d%d")
        p = int16(int((a + 0.5) * (a + 0.5) * b))
        printf("%d\n", p)
        if p > 0:
            circle(a, b, choice)
        if not again():
            break
    getch()


if __name__ == "__main__":
    main()
