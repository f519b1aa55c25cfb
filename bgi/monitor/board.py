"""The board: the card's palette and pages, and what the program's screen is like, as a picture.

It is laid over the window's picture, and over that of a page in a browser.
"""

import contextlib
from collections.abc import Iterable

import numpy as np

from bgi.memory.card import CELL_BYTES, Card, Frame
from bgi.memory.matching import shown
from bgi.monitor.lens import GRID, INK, SIZE, Colors, Pixels, written
from bgi.monitor.picture import colors, pixels


def board(card: Card, frame: Frame, palette: bytes, facts: Iterable[str]) -> Colors:
    """The board of a card that shows a frame; `facts` are the program's, a line each."""
    pages, visible = [pixels(frame)], 0
    size = f"{frame.width} x {frame.height}"
    if frame.pixel_bytes != CELL_BYTES:
        with contextlib.suppress(ValueError):  # the mode is changing just now
            kind = np.dtype(np.uint8) if frame.pixel_bytes == 1 else np.dtype("<u4")
            shape = frame.height, frame.width
            numbers = range(card.pages)
            pages = [np.frombuffer(card.page(n), kind).reshape(shape) for n in numbers]
            visible = card.visible
        size += f", page {visible} of {len(pages)} is shown"
    many = max((int(page.max()) for page in pages if page.dtype == np.uint8), default=0)
    return laid_out(colors(palette), 256 if many > 15 else 16, pages, visible, [size, *facts])


def laid_out(
    palette: Colors, colors: int, pages: list[Pixels], visible: int, facts: Iterable[str]
) -> Colors:
    """The palette as squares, all pages small, the visible one framed, and lines of text.

    Args:
        palette: the colours of the indices, shape (256, 3).
        colors: how many of them are shown, 16 or 256.
        pages: the pixels of each page.
        visible: the number of the page that is shown.
        facts: what else is to be said, a line each.
    """
    width = SIZE[0]
    side = width // 16
    squares = palette[:colors].reshape(-1, 16, 3).repeat(side, 0).repeat(side, 1)
    squares[::side] = squares[:, ::side] = GRID
    small = [thumbnail(page, palette, width // 2 - 4) for page in pages[:4]]
    parts = [written(fact, width) for fact in facts] + [squares]
    for start in range(0, len(small), 2):
        row = np.tile(GRID, (small[0].shape[0] + 8, width, 1))
        for column, picture in enumerate(small[start : start + 2]):
            left = column * width // 2
            if start + column == visible:
                row[:, left : left + width // 2] = INK
            row[4:-4, left + 4 : left + 4 + picture.shape[1]] = picture
        parts.append(row)
    return np.concatenate(parts)


def thumbnail(page: Pixels, palette: Colors, width: int) -> Colors:
    """A page, small, in the shape of a screen: every so many pixels one."""
    height = width * 3 // 4
    rows = np.arange(height) * page.shape[0] // height
    columns = np.arange(width) * page.shape[1] // width
    return shown(page[rows][:, columns], palette)
