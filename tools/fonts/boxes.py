"""The line-drawing characters of code page 437, codes 176..223, for a cell of any size.

Lines end on the cell's edges, so that neighbours join; where a double line meets another line, each
of its two rails stops at the rail that it would otherwise cross.
"""

from typing import NamedTuple

from tools.fonts.strokes import Glyph, Path


class Cell(NamedTuple):
    """A character cell: its width, its bottom and top, half the distance of double rails."""

    width: int
    bottom: int
    top: int
    gap: int


# Codes 179..218: how many lines leave the centre to the left, upward, right, downward.
_ARMS = """
0101 1101 2101 1202 1002 2001 2202 0202 2002 2200 1200 2100 1001 0110 1110 1011 0111 1010 1111 0121
0212 0220 0022 2220 2022 0222 2020 2222 2120 1210 2021 1012 0210 0120 0021 0012 1212 2121 1100 0011
"""
_BLOCKS = {  # left, bottom, right, top in halves of the cell
    219: (0, 0, 2, 2),
    220: (0, 0, 2, 1),
    221: (0, 0, 1, 2),
    222: (1, 0, 2, 2),
    223: (0, 1, 2, 2),
}
_SHADES = {176: (6, False), 177: (3, False), 178: (4, True)}  # distance of lines, crossed


def boxes(cell: Cell) -> dict[int, Glyph]:
    """All of them."""
    glyphs = {179 + n: _lines(cell, *map(int, arms)) for n, arms in enumerate(_ARMS.split())}
    glyphs |= {code: _block(cell, part) for code, part in _BLOCKS.items()}
    return glyphs | {code: _shade(cell, *look) for code, look in _SHADES.items()}


def _lines(cell: Cell, left: int, up: int, right: int, down: int) -> Glyph:
    x, y = cell.width // 2, (cell.bottom + cell.top) // 2
    glyph: Glyph = []
    # Each arm's edge, and how its frame (along it toward the centre, across it) lies in the cell.
    for arm, edge, ahead, sides, opposite, level in (
        (left, 0, 1, (down, up), right, True),
        (right, cell.width, -1, (down, up), left, True),
        (up, cell.top, -1, (left, right), down, False),
        (down, cell.bottom, 1, (left, right), up, False),
    ):
        for rail in ((), (0,), (-1, 1))[arm]:
            stop = ahead * cell.gap * _stop(rail, *sides, opposite)
            if level:
                glyph.append([(edge, y + rail * cell.gap), (x + stop, y + rail * cell.gap)])
            else:
                glyph.append([(x + rail * cell.gap, edge), (x + rail * cell.gap, y + stop)])
    return glyph


def _stop(rail: int, low: int, high: int, opposite: int) -> int:
    """Where a rail ends: -1 before the centre, 0 on it, 1 behind it.

    `rail` is -1, 0 or 1 across the arm; `low` and `high` are the arms on those two sides.
    """
    if rail == 0:
        return 0 if opposite else 1 - 2 * (low == high) if 2 in (low, high) else 0
    same, other = (low, high) if rail < 0 else (high, low)
    if same or opposite:
        return -1 if same == 2 else 0
    return 1 if other == 2 else 0


def _block(cell: Cell, part: tuple[int, int, int, int]) -> Glyph:
    left, right = part[0] * cell.width // 2, part[2] * cell.width // 2
    middle = (cell.bottom + cell.top) // 2
    bottom, top = (cell.bottom, middle, cell.top)[part[1]], (cell.bottom, middle, cell.top)[part[3]]
    return [[(left, y), (right, y)] for y in range(bottom, top + 1)]


def _shade(cell: Cell, distance: int, crossed: bool) -> Glyph:
    height = cell.top - cell.bottom
    glyph: Glyph = []
    for start in range(-height + distance, cell.width, distance):
        low, high = max(0, -start), min(height, cell.width - start)
        path: Path = [(start + step, cell.bottom + step) for step in (low, high)]
        glyph.append(path)
        if crossed:
            glyph.append([(cell.width - x, y) for x, y in path])
    return glyph
