"""Text, in the built-in font of 8x8 pixels or in stroked fonts.

Only the strokes are drawn: what lies under the gaps stays. There are no control characters: "\\n"
is a picture like any other. A str is written in code page 437, "?" standing for what it lacks;
bytes are written as they are.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

from bgi import current
from bgi.kernel.arguments import Number
from bgi.settings import textsettingstype

# fmt: off
__all__ = [
    "settextstyle", "settextjustify", "setusercharsize", "gettextsettings",
    "outtext", "outtextxy", "textwidth", "textheight",
]
# fmt: on


def settextstyle(font: Number, direction: Number, charsize: Number) -> None:
    """Choose font, direction and size of text.

    Args:
        font: DEFAULT_FONT (0), TRIPLEX_FONT (1) ... BOLD_FONT (10), or a number from
            installuserfont() or registerbgifont().
        direction: HORIZ_DIR (0) or VERT_DIR (1), which reads upwards. Any other one lays the
            characters of the built-in font on their backs.
        charsize: 1..10. The built-in font is enlarged by that factor (up to 31, of a larger number
            its low five bits count); the stroked fonts have their own size at 4. USER_CHAR_SIZE
            (0) takes setusercharsize()'s factors.

    A font file is looked for in initgraph's path, in the current folder, then among those that come
    with this package; a font that is in use already is not looked for again. If it cannot be had,
    graphresult() says why (-8 not found, -13 not a font, -14 no such number, -12 not readable) and
    the built-in font is used.
    """
    current.screen.settextstyle(font, direction, charsize)


def settextjustify(horiz: Number, vert: Number) -> None:
    """Choose which point of a text its coordinates mean.

    Args:
        horiz: LEFT_TEXT (0), CENTER_TEXT (1) or RIGHT_TEXT (2).
        vert: BOTTOM_TEXT (0), CENTER_TEXT (1) or TOP_TEXT (2).

    graphresult() says -11, and nothing changes, for anything else.
    """
    current.screen.settextjustify(horiz, vert)


def setusercharsize(multx: Number, divx: Number, multy: Number, divy: Number) -> None:
    """Stretch stroked fonts freely, at once; graphdefaults() and initgraph() leave it so.

    Args:
        multx, divx: width, times multx / divx of size 4.
        multy, divy: height likewise.

    graphresult() says -11, and nothing changes, for a divisor of 0 or a number beyond 16 bits.
    """
    current.screen.setusercharsize(multx, divx, multy, divy)


def gettextsettings() -> textsettingstype:
    """Return font, direction and size as given (0 after setusercharsize), and justification."""
    return current.screen.gettextsettings()


def outtext(text: str | bytes) -> None:
    """Write at the current position.

    It moves on by the width of the text if that is level and LEFT_TEXT. Otherwise as outtextxy();
    it takes the same `text`, with the same limit.
    """
    current.screen.outtext(text)


def outtextxy(x: Number, y: Number, text: str | bytes) -> None:
    """Write a text.

    Args:
        x, y: the point of the text that settextjustify() chose, at first its upper left corner,
            relative to the viewport.
        text: a str or bytes; a number raises TypeError (write str(number)).

    In the drawing colour; leaves the current position. In the built-in font a character that does
    not fit into the viewport whole (with clipping off, on the screen) is left out, and all of a
    level text that begins left of the screen. Stroked text is drawn by thin solid lines, each
    clipped; it has at most 65,536 characters, ValueError for more.
    """
    current.screen.outtextxy(x, y, text)


def textwidth(text: str | bytes) -> int:
    """Return the width of a text in pixels, in the font and size in use.

    Drawn stroked text can be a little narrower, as in the original. A stroked text has at most
    65,536 characters; ValueError for more.
    """
    return current.screen.textwidth(text)


def textheight(text: str | bytes) -> int:
    """Return the height of a text in pixels, the same for every text.

    It depends on the font and size in use, and so may be asked of a text of any length.
    """
    return current.screen.textheight(text)
