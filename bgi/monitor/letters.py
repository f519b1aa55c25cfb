"""From the cells of a text mode to pixels: characters in the ROM's font, blinking, the cursor."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bgi.fonts.codepage import decode
from bgi.kernel.textmodes import CELL_WIDTH
from bgi.memory.card import BRIGHT, MONOCHROME, Frame, TextFrame

# numpy, and what needs it, is imported late: most windows open without it, in half of the time.
if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# Seconds: the VGA counts 70 pictures a second, and the cursor is seen for eight, dark for eight;
# characters take twice as long.
CURSOR_SECONDS = 8 / 70

_MONO_COLORS = bytes([0] + 7 * [7] + [8] + 7 * [15])


def phase(seconds: float) -> int:
    """What is dark at a moment of all that blinks, as `TextFrame.phase` has it."""
    return int(seconds / CURSOR_SECONDS) & 3


def at_moment(frame: Frame, seconds: float) -> Frame:
    """The frame as it is to be seen then: blinking, if anything in it blinks."""
    text = frame.text
    if text is None:
        return frame
    dark = phase(seconds)
    if not _has_cursor(text):
        dark &= 2
    if text.attributes == BRIGHT or frame.pixels[1::2].isascii():
        dark &= 1
    return frame._replace(text=text._replace(phase=dark))


def spoken(frame: Frame | None) -> str:
    """What stands in a text mode, as lines of a terminal; "" if that is nothing, or a picture."""
    if frame is None or frame.text is None:
        return ""
    codes, width = frame.pixels[::2], frame.text.columns
    rows = [decode(codes[at : at + width]).rstrip() for at in range(0, len(codes), width)]
    text = "\n".join(rows).rstrip("\n")
    return f"{text}\n" if text else ""


def drawn(frame: Frame, text: TextFrame) -> NDArray[np.uint8]:
    """The palette indices of a text mode's picture, shape (height, width)."""
    import numpy as np

    from bgi.fonts.rom import glyphs

    cells = np.frombuffer(frame.pixels, np.uint8).reshape(text.rows, text.columns, 2)
    codes, attributes = cells[..., 0], cells[..., 1]
    ink, paper = attributes & 15, attributes >> 4
    if text.attributes != BRIGHT:
        paper = paper & 7
        if text.phase & 2:
            ink = np.where(attributes & 128, paper, ink)
    bits = glyphs(text.cell_height)[codes]
    if text.attributes == MONOCHROME:
        bits[(attributes & 7) == 1, text.cell_height - 2] = True  # underlined
        reverse = paper == 7
        ink = np.where(reverse & (ink & 7 == 0), 0, np.frombuffer(_MONO_COLORS, np.uint8)[ink])
        paper = np.where(reverse, np.uint8(7), np.uint8(0))
    if _has_cursor(text) and not text.phase & 1:
        rows = slice(text.shape >> 8, (text.shape & 0xFF) + 1)
        bits[divmod(text.cursor, text.columns)][rows] = True
    pixels = np.where(bits, ink[..., None, None], paper[..., None, None])
    return pixels.transpose(0, 2, 1, 3).reshape(-1, text.columns * CELL_WIDTH)


def _has_cursor(text: TextFrame) -> bool:
    """Whether a cursor is on the screen, and its shape one that can be seen."""
    first, last = text.shape >> 8, text.shape & 0xFF
    return text.cursor < text.columns * text.rows and first <= last and first < text.cell_height
