"""A graphics system of characters: a surface in a terminal, in an e-mail, on a line printer.

    page = Text(78, 40)
    surface(f, x=(-3, 3), y=(-3, 3), on=page)
    print(page)

It has nothing but putpixel and outtextxy: lines and polygons come out of pixels, as on any system.
"""

from __future__ import annotations

# Characters for colours: 16 to 175 are the upper side's ramp, 176 to 255 the under side's.
UPPER = ".:-=+*o#%@"
UNDER = "'`,;"
FIRST, MIDDLE, COLORS = 16, 176, 256


class Text:
    """A page of columns x rows characters, each twice as high as wide."""

    aspect = 0.5
    """The width of a character divided by its height."""
    character = 1
    """A character is a pixel here."""

    def __init__(self, columns: int = 78, rows: int = 40) -> None:
        self._rows = [[" "] * columns for _ in range(rows)]

    def getmaxx(self) -> int:
        """The last column."""
        return len(self._rows[0]) - 1

    def getmaxy(self) -> int:
        """The last row."""
        return len(self._rows) - 1

    def getmaxcolor(self) -> int:
        """The largest colour, 255."""
        return COLORS - 1

    def putpixel(self, x: int, y: int, color: int) -> None:
        """A character for a colour: a space for 0, a star for the everyday colours."""
        if color >= MIDDLE:
            shown = UNDER[(color - MIDDLE) * len(UNDER) // (COLORS - MIDDLE)]
        elif color >= FIRST:
            shown = UPPER[(color - FIRST) * len(UPPER) // (MIDDLE - FIRST)]
        else:
            shown = "*" if color else " "
        self._rows[y][x] = shown

    def setcolor(self, color: int) -> None:
        """Characters have no colours."""

    def outtextxy(self, x: int, y: int, text: str) -> None:
        """Write at x, y, as far as there is room."""
        row = self._rows[min(max(y, 0), self.getmaxy())]
        for column, character in enumerate(text, max(x, 0)):
            if column < len(row):
                row[column] = character

    def __str__(self) -> str:
        """The page, line by line."""
        return "\n".join("".join(row).rstrip() for row in self._rows)
