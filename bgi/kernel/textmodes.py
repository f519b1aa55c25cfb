"""The text modes of conio.h: how many characters a screen has, and how high they are."""

from typing import NamedTuple

from bgi.constants import BW40, BW80, C40, C80, C4350, MONO

CELL_WIDTH = 8
"""The width of a character in pixels, in every mode. (The VGA adds a ninth column in most of its
text modes; left out, the screen is as wide as that of graphics: chosen.)"""


class TextMode(NamedTuple):
    """One row of the table."""

    number: int
    columns: int
    rows: int
    cell_height: int
    """Pixels: the height of the ROM font that it uses."""
    monochrome: bool = False
    """Whether attributes mean bright, underlined and reverse in place of colours."""

    @property
    def width(self) -> int:
        """The width of the picture in pixels."""
        return self.columns * CELL_WIDTH

    @property
    def height(self) -> int:
        """The height of the picture in pixels."""
        return self.rows * self.cell_height


TEXT_MODES = {
    mode.number: mode
    for mode in (
        TextMode(BW40, 40, 25, 16),
        TextMode(C40, 40, 25, 16),
        TextMode(BW80, 80, 25, 16),
        TextMode(C80, 80, 25, 16),
        TextMode(MONO, 80, 25, 16, monochrome=True),
        TextMode(C4350, 80, 50, 8),
    )
}
"""The modes by number, on a VGA. A colour monitor shows BW40 and BW80 like C40 and C80."""


def cell_height_over(height: int) -> int:
    """The height of the ROM font that the BIOS writes with in a graphics mode of that height."""
    return 8 if height <= 200 else 14 if height < 400 else 16
