"""Two small pictures, drawn with letters: the window's icon and the mouse driver's arrow."""

from bgi.memory.sdl import pygame

_INKS = {
    "#": (0, 0, 0),
    "o": (255, 255, 255),
    "g": (170, 170, 170),
    "d": (85, 85, 85),
    "b": (0, 0, 170),
    "y": (255, 255, 85),
    "r": (255, 85, 85),
    "c": (85, 255, 255),
}

ICON = """
.gggggggggggggg.
gggggggggggggggg
ggddddddddddddgg
ggdbbbbbbbbbbdgg
ggdbbbbyybbbbdgg
ggdbbyybbyybbdgg
ggdbybbrrbbybdgg
ggdbybrbbrbybdgg
ggdccccccccccdgg
ggdbbbbbbbbbbdgg
ggddddddddddddgg
ggggggggggggrrgg
gggggggggggggggg
.....dddddd.....
...gggggggggg...
..gggggggggggg..
"""

ARROW = """
#
##
#o#
#oo#
#ooo#
#oooo#
#ooooo#
#oooooo#
#ooooooo#
#oooooooo#
#ooooo####
#oo#oo#
#o# #oo#
##  #oo#
     #oo#
     ###
"""


def picture(art: str, size: int = 1) -> pygame.Surface:
    """The drawing as a surface, transparent where nothing is drawn, each letter that wide."""
    rows = art.strip("\n").splitlines()
    surface = pygame.Surface((max(map(len, rows)), len(rows)), pygame.SRCALPHA)
    for y, row in enumerate(rows):
        for x, letter in enumerate(row):
            if letter in _INKS:
                surface.set_at((x, y), _INKS[letter])
    width, height = surface.get_size()
    return pygame.transform.scale(surface, (size * width, size * height))
