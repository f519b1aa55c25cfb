"""Windows of any size and colours of any mixture: the names that WinBGIm added to graphics.h.

Source: WinBGIm.
"""

from __future__ import annotations

from bgi import current
from bgi.constants import ALL_WINDOWS, grOk
from bgi.errors import brief
from bgi.kernel.arguments import Number, check_text, flag, whole
from bgi.kernel.modes import window
from bgi.kernel.state import KERNEL
from bgi.machine import desktop_size
from bgi.memory import rgb
from bgi.memory.card import MAX_SIDE

# fmt: off
__all__ = [
    "initwindow", "closewindow", "getcurrentwindow", "setcurrentwindow",
    "getmaxwidth", "getmaxheight", "getwindowwidth", "getwindowheight",
    "COLOR", "IS_BGI_COLOR", "IS_RGB_COLOR", "converttorgb", "RED_VALUE", "GREEN_VALUE",
    "BLUE_VALUE",
]
# fmt: on


def initwindow(
    width: Number,
    height: Number,
    title: str = "Windows BGI",
    left: Number = 0,
    top: Number = 0,
    dbflag: bool = False,
    closeflag: bool = True,
) -> int:
    """Open a window of any size, in 16 colours and 16 million, and draw in it from now on.

    Args:
        width, height: its size in pixels, 1..4096.
        title: what its title bar says.
        left, top: where WinBGIm puts it; here the desktop chooses.
        dbflag: True to draw on page 1 while page 0 is shown, for swapbuffers().
        closeflag: True in WinBGIm ends the program when the window is closed; here the next call
            raises WindowClosed either way.

    Returns its number, 0 at first, for setcurrentwindow(). Pixels are square, there are four pages.
    Wherever a colour goes, COLOR(r, g, b) goes too. ValueError for another size, BGIError if the
    window cannot be opened.
    """
    size = whole("width", width), whole("height", height)
    whole("left", left)
    whole("top", top)
    check_text("title", title)
    double = flag("dbflag", dbflag)
    flag("closeflag", closeflag)
    if not all(0 < side <= MAX_SIDE for side in size):
        raise ValueError(f"width and height must be 1..{MAX_SIDE} pixels, not {brief(size)}")
    number = current.open_window(window(*size), title)
    if double:
        current.screen.setactivepage(1)
    KERNEL.result.set(grOk)
    return number


def closewindow(wid: Number = ALL_WINDOWS) -> None:
    """Close a window, CURRENT_WINDOW, or ALL_WINDOWS.

    Args:
        wid: its number; an unknown one is ignored. closegraph() closes all.
    """
    current.close_screen(whole("wid", wid))


def getcurrentwindow() -> int:
    """Return the number of the window that is drawn in, or NO_CURRENT_WINDOW."""
    return current.number


def setcurrentwindow(wid: Number) -> None:
    """Draw in another window from now on.

    Args:
        wid: its number, from initwindow(); an unknown one is ignored.
    """
    current.select(whole("wid", wid))


def getmaxwidth() -> int:
    """Return the width of the desktop in pixels: a window as large as it fills the screen.

    1920 where there is no display. A larger window can be opened, too, up to 4096.
    """
    return min(desktop_size()[0], MAX_SIDE)


def getmaxheight() -> int:
    """Return the height of the desktop in pixels: a window as large as it fills the screen.

    1080 where there is no display. A larger window can be opened, too, up to 4096.
    """
    return min(desktop_size()[1], MAX_SIDE)


def getwindowwidth() -> int:
    """Return the width of the picture in pixels, getmaxx() + 1."""
    return current.screen.getmaxx() + 1


def getwindowheight() -> int:
    """Return the height of the picture in pixels, getmaxy() + 1."""
    return current.screen.getmaxy() + 1


def COLOR(red: Number, green: Number, blue: Number) -> int:
    """Return the number of a colour of your own, for any call that takes a colour in a window.

    Args:
        red, green, blue: 0..255.

    One of the 16 colours is returned as its index. On other screens only its low bits count.
    """
    return rgb.number(whole("red", red), whole("green", green), whole("blue", blue))


def IS_BGI_COLOR(color: Number) -> bool:
    """Tell whether a colour is one of the 16.

    Args:
        color: a colour, as getpixel() or COLOR() return it.
    """
    return 0 <= whole("color", color) < 16


def IS_RGB_COLOR(color: Number) -> bool:
    """Tell whether a colour is one of your own, from COLOR().

    Args:
        color: a colour, as getpixel() or COLOR() return it.
    """
    return rgb.is_rgb(whole("color", color))


def converttorgb(color: Number) -> int:
    """Return a colour as one number, red + 256 * green + 65536 * blue.

    Args:
        color: an index 0..15, as it looks at first, or a colour from COLOR().
    """
    red, green, blue = rgb.components(whole("color", color))
    return blue << 16 | green << 8 | red


def RED_VALUE(color: Number) -> int:
    """Return the red part of a colour, 0..255.

    Args:
        color: as for converttorgb().
    """
    return rgb.components(whole("color", color))[0]


def GREEN_VALUE(color: Number) -> int:
    """Return the green part of a colour, 0..255.

    Args:
        color: as for converttorgb().
    """
    return rgb.components(whole("color", color))[1]


def BLUE_VALUE(color: Number) -> int:
    """Return the blue part of a colour, 0..255.

    Args:
        color: as for converttorgb().
    """
    return rgb.components(whole("color", color))[2]
