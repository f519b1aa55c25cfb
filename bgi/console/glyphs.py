"""What the text screen writes on while a graphics mode is set: the picture, or nothing."""

import numpy as np

from bgi.fonts import rom
from bgi.graphics import Graphics
from bgi.kernel.textmodes import CELL_WIDTH, cell_height_over
from bgi.raster.lines import Box

DOS_ATTRIBUTE = 7
"""What DOS writes in over a picture: light grey."""


class GlyphPage:
    """A picture as the BIOS writes on it, on the page that is drawn on, whatever the viewport.

    Characters are those of the ROM's font, opaque; of an attribute the colour of the ink counts,
    and empty is index 0.
    """

    def __init__(self, graphics: Graphics) -> None:
        self._graphics = graphics
        self._high = cell_height_over(graphics.mode.height)
        self.columns = max(graphics.mode.width // CELL_WIDTH, 1)
        self.rows = max(graphics.mode.height // self._high, 1)

    def write(self, x: int, y: int, codes: bytes, attribute: int) -> None:
        """Write some characters into the cells of one row; what is off the page is cut."""
        letters = rom.glyphs(self._high)[np.frombuffer(codes, np.uint8)]
        line = letters.transpose(1, 0, 2).reshape(self._high, -1)
        ink = min(attribute & 15, self._graphics.mode.maxcolor)
        self._graphics.page.print(x * CELL_WIDTH, y * self._high, line, ink)

    def rewrite(self, x: int, y: int, codes: bytes) -> None:
        """The same in light grey."""
        self.write(x, y, codes, DOS_ATTRIBUTE)

    def fill(self, box: Box, attribute: int) -> None:
        """Empty a box."""
        self._graphics.page.scroll(self._pixels(box), self._graphics.mode.height)

    def scroll(self, box: Box, lines: int, attribute: int) -> None:
        """Move a box up by so many lines (less than 0: down), with empty lines behind."""
        self._graphics.page.scroll(self._pixels(box), lines * self._high)

    def attribute(self, x: int, y: int) -> int:
        """Light grey."""
        return DOS_ATTRIBUTE

    def _pixels(self, box: Box) -> Box:
        """The pixels of a box of cells."""
        left, top, right, bottom = box
        high = self._high
        return left * CELL_WIDTH, top * high, (right + 1) * CELL_WIDTH - 1, (bottom + 1) * high - 1


class HiddenPage:
    """The cells of the text mode while the picture is shown: nobody sees what is written there."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows

    def write(self, x: int, y: int, codes: bytes, attribute: int) -> None:
        """Nothing."""

    def rewrite(self, x: int, y: int, codes: bytes) -> None:
        """Nothing."""

    def fill(self, box: Box, attribute: int) -> None:
        """Nothing."""

    def scroll(self, box: Box, lines: int, attribute: int) -> None:
        """Nothing."""

    def attribute(self, x: int, y: int) -> int:
        """No colour."""
        return 0
