"""The page of a text mode: the only place where a character's cell is set."""

import numpy as np
from numpy.typing import NDArray

from bgi.memory.scrolling import scroll
from bgi.raster.lines import Box

BLANK = 32
"""The code of the character in an empty cell."""


class CellPage:
    """Cells of a character and its attribute.

    Columns and rows are counted from 0; boxes are left, top, right, bottom, both corners included,
    and lie within the page.
    """

    def __init__(self, memory: memoryview, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.flat: NDArray[np.uint16] = np.frombuffer(memory, "<u2")
        self.array = self.flat.reshape(rows, columns)

    def write(self, x: int, y: int, codes: bytes, attribute: int) -> None:
        """Write some characters into the cells of one row."""
        at = y * self.columns + x
        self.flat[at : at + len(codes)] = np.frombuffer(codes, np.uint8) | np.uint16(attribute << 8)

    def rewrite(self, x: int, y: int, codes: bytes, color: int = 0) -> None:
        """The same in the attributes that the cells have, as the BIOS does: no colour counts."""
        at = y * self.columns + x
        cells = self.flat[at : at + len(codes)]
        cells[:] = cells & 0xFF00 | np.frombuffer(codes, np.uint8)

    def fill(self, box: Box, attribute: int) -> None:
        """Empty a box."""
        left, top, right, bottom = box
        self.array[top : bottom + 1, left : right + 1] = attribute << 8 | BLANK

    def scroll(self, box: Box, lines: int, attribute: int) -> None:
        """Move a box up by so many lines (less than 0: down), with empty lines behind."""
        left, top, right, bottom = box
        part = self.array[top : bottom + 1, left : right + 1]
        scroll(part, lines, attribute << 8 | BLANK)

    def cell(self, x: int, y: int) -> int:
        """What a cell holds: 256 * its attribute + its character."""
        return int(self.array[y, x])

    def copy(self, box: Box) -> bytes:
        """The cells of a box, row by row."""
        left, top, right, bottom = box
        return self.array[top : bottom + 1, left : right + 1].tobytes()

    def put(self, box: Box, cells: bytes) -> None:
        """Fill a box with as many cells as it has."""
        left, top, right, bottom = box
        part = self.array[top : bottom + 1, left : right + 1]
        part[:] = np.frombuffer(cells, "<u2").reshape(part.shape)
