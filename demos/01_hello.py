"""The shortest program that draws something.

    python demos/01_hello.py

What it shows: a program opens the screen, draws, and waits for a key. Where a number goes, a list
of numbers goes too: one call draws all the circles, each in its colour.
"""

from bgi import *

initgraph(VGA, VGAHI)
setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
circle(320, 240, range(80, 230, 10), range(1, 16))
outtextxy(272, 236, "Hello, world")
getch()
