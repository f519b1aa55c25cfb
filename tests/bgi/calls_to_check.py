"""Calls for mypy to judge (test_typing.py): an error in each line marked wrong, and no other."""

import numpy as np

import bgi
from bgi import conio, dos, mouse


def numbers(array: np.ndarray[tuple[int], np.dtype[np.float64]]) -> None:
    bgi.line(1, 2, 3, 4)
    bgi.line(1.5, 2, 3, np.int64(4), bgi.RED)
    bgi.line([1, 2], (3, 4), range(2), array)
    bgi.line(True, 2, 3, array[0])
    bgi.line("a", 1, 2, 3)  # wrong
    bgi.line(0, 0, 1, 1, "red")  # wrong
    bgi.line(0, 0, 1, b"")  # wrong
    bgi.line(0, 0, 1)  # wrong
    bgi.line(0, 0, 1, None)  # wrong
    bgi.line((0, 0), (9, 9))  # wrong
    bgi.lineto([1, 2], 3)  # wrong
    bgi.moveto("1", 2)  # wrong
    bgi.putpixel(1, 2, 1j)  # wrong
    bgi.putpixel({1, 2}, 1, 1)  # wrong
    bgi.circle(x=1, y=2, radius=3, color=4)
    bgi.circle(1, 2, 3, colour=4)  # wrong


def shapes() -> None:
    bgi.fillpoly([(1, 2), (3, 4), (5, 6)], fill=bgi.RED)
    bgi.fillpoly([bgi.pointtype(1, 2), bgi.pointtype(3, 4)])
    bgi.drawpoly(2, [1, 2, 3, 4])
    bgi.drawpoly("1 2 3 4")  # wrong
    bgi.setfillpattern([1, 2, 3, 4, 5, 6, 7, 8], bgi.RED)
    bgi.setfillpattern(bytes(8), bgi.RED)
    bgi.setfillpattern("12345678", bgi.RED)  # wrong
    bgi.setcolor("red")  # wrong


def answers() -> None:
    color: int = bgi.getpixel(1, 2)
    colors: np.ndarray[tuple[int], np.dtype[np.uint8]] = bgi.getpixel([1, 2], 3)
    bgi.putpixel(color, colors, colors)
    driver, mode = bgi.initgraph()
    bgi.initgraph(driver, mode, path=1)  # wrong
    bgi.outtextxy(1, 2, "text")
    bgi.outtextxy(1, 2, b"text")
    bgi.outtextxy(1, 2, 3)  # wrong
    name: str = bgi.getmodename(mode)  # wrong
    bgi.outtext(name)
    bgi.circl(1, 2, 3)  # wrong


def machine() -> None:
    dos.delay(20.5)
    dos.delay("20")  # wrong
    conio.ungetch(conio.getch())
    conio.getch().lower()  # wrong
    x, y = mouse.position()
    mouse.set_position(x + 1, y)
    mouse.set_position((x, y))  # wrong
