"""Two small pictures, drawn with letters: the window's icon and the mouse driver's arrow."""

from __future__ import annotations

from typing import NamedTuple

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


class Look(NamedTuple):
    """What the mouse driver's pointer looks like: a picture, its hot spot, what it inverts."""

    picture: pygame.Surface
    hot: tuple[int, int] = (0, 0)
    inverted: tuple[tuple[int, int], ...] = ()

    def draw(self, page: pygame.Surface, x: int, y: int) -> None:
        """Draw it with its hot spot at x, y."""
        left, top = x - self.hot[0], y - self.hot[1]
        page.blit(self.picture, (left, top))
        for across, down in self.inverted:
            place = left + across, top + down
            if page.get_rect().collidepoint(place):
                red, green, blue, _ = page.get_at(place)
                page.set_at(place, (255 - red, 255 - green, 255 - blue))


def arrow() -> Look:
    """The look that the pointer begins with."""
    return Look(picture(ARROW))


_BLACK, _WHITE, _TRANSPARENT, _INVERTED = "#", "o", ".", "i"
_LOOKS = {(0, 0): _BLACK, (0, 1): _WHITE, (1, 0): _TRANSPARENT, (1, 1): _INVERTED}


def to_masks(art: str) -> tuple[int, ...]:
    """The masks of a drawing of 16x16 in black and white, as `from_masks` has them."""
    bits = {look: masks for masks, look in _LOOKS.items()} | {" ": (1, 0)}
    rows = [row.ljust(16) for row in art.strip("\n").splitlines()]
    return tuple(
        sum(bits[letter][mask] << 15 - x for x, letter in enumerate(row))
        for mask in (0, 1)
        for row in rows
    )


def from_masks(x: int, y: int, *words: int) -> Look:
    """A look as the driver takes it: of what is there, AND the first mask, XOR the second.

    Args:
        x, y: the hot spot.
        words: the sixteen rows of the first mask, then of the second; the highest bit leftmost.
    """
    size = len(words) // 2
    drawing = [
        "".join(_LOOKS[screen >> bit & 1, cursor >> bit & 1] for bit in reversed(range(size)))
        for screen, cursor in zip(words[:size], words[size:], strict=True)
    ]
    inverted = [
        (across, down)
        for down, row in enumerate(drawing)
        for across, letter in enumerate(row)
        if letter == _INVERTED
    ]
    return Look(picture("\n".join(drawing)), (x, y), tuple(inverted))
