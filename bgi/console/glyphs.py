"""What the text screen writes on while a graphics mode is set: the picture, or nothing."""

import numpy as np

from bgi.constants import XOR_PUT
from bgi.fonts import rom
from bgi.graphics import Graphics
from bgi.kernel.textmodes import CELL_WIDTH, cell_height_over
from bgi.raster.lines import Box

XOR = 0x80
"""Of an attribute: XOR with what is there."""

DOS_ATTRIBUTE = 7
"""What DOS writes in over a picture: light grey."""


class GlyphPage:
    """A picture as the BIOS writes on it, on the page that is drawn on, whatever the viewport.

    Characters are those of the ROM's font, opaque, or by XOR where bit 7 of an attribute is set and
    no colour needs it; of an attribute the colour of the ink counts, and empty is index 0.
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
        page, most = self._graphics.page, self._graphics.mode.maxcolor
        place, ink = (x * CELL_WIDTH, y * self._high), attribute & most
        if attribute & XOR > most:
            page.combine(*place, line.astype(page.flat.dtype) * ink, XOR_PUT, most)
        else:
            page.print(*place, line, ink)

    def rewrite(self, x: int, y: int, codes: bytes, color: int = DOS_ATTRIBUTE) -> None:
        """The same, in light grey unless another colour is given."""
        self.write(x, y, codes, color)

    def fill(self, box: Box, attribute: int) -> None:
        """Empty a box."""
        self._graphics.page.scroll(self._pixels(box), self._graphics.mode.height)

    def scroll(self, box: Box, lines: int, attribute: int) -> None:
        """Move a box up by so many lines (less than 0: down), with empty lines behind."""
        self._graphics.page.scroll(self._pixels(box), lines * self._high)

    def cell(self, x: int, y: int) -> int:
        """The character whose letter a cell shows, in any colour, as the BIOS finds it; 0: none."""
        shown = self._graphics.page.copy(x * CELL_WIDTH, y * self._high, CELL_WIDTH, self._high)
        alike = (rom.glyphs(self._high) == (shown != 0)).all(axis=(1, 2))
        return DOS_ATTRIBUTE << 8 | int(alike.argmax())

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

    def rewrite(self, x: int, y: int, codes: bytes, color: int = 0) -> None:
        """Nothing."""

    def fill(self, box: Box, attribute: int) -> None:
        """Nothing."""

    def scroll(self, box: Box, lines: int, attribute: int) -> None:
        """Nothing."""

    def cell(self, x: int, y: int) -> int:
        """Nothing, in no colour."""
        return 0
