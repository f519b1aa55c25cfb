"""Text, in the built-in font of 8x8 pixels.

Only the strokes are drawn: what lies under the gaps stays. There are no control characters: "\\n"
is a picture like any other. A str is written in code page 437, "?" standing for what it lacks;
bytes are written as they are.
"""

from bgi import current
from bgi.arguments import Number


def outtext(text: str | bytes) -> None:
    """Write at the current position, which moves on to the end of the text.

    Otherwise as outtextxy(). Source: graphics.h.
    """
    current.screen.outtext(text)


def outtextxy(x: Number, y: Number, text: str | bytes) -> None:
    """Write a text.

    Args:
        x, y: the upper left corner of its first character, relative to the viewport.
        text: a str or bytes; a number raises TypeError (write str(number)).

    In the drawing colour; ignores the write mode; leaves the current position. A character that
    does not fit into the viewport whole is left out; with clipping off, the whole text is left out
    if any part of it would leave the screen. Source: graphics.h.
    """
    current.screen.outtextxy(x, y, text)


def textwidth(text: str | bytes) -> int:
    """Return the width of a text in pixels: 8 a character. Source: graphics.h."""
    return current.screen.textwidth(text)


def textheight(text: str | bytes) -> int:
    """Return the height of a text in pixels: 8, whatever the text. Source: graphics.h."""
    return current.screen.textheight(text)
