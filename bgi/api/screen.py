"""The screen: its mode, size, viewport, pages, colours and palette.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

from collections.abc import Sequence

from bgi import current
from bgi.kernel.arguments import Number, Numbers
from bgi.settings import palettetype, viewporttype

# fmt: off
__all__ = [
    "getmaxx", "getmaxy", "getmaxcolor", "cleardevice",
    "setviewport", "getviewsettings", "clearviewport", "moveto", "moverel", "getx", "gety",
    "setactivepage", "setvisualpage", "getactivepage", "getvisualpage", "swapbuffers",
    "setcolor", "getcolor", "setbkcolor", "getbkcolor",
    "setpalette", "setallpalette", "getpalette", "getpalettesize", "getdefaultpalette",
    "setrgbpalette",
    "getgraphmode", "getmaxmode", "getmodename", "getdrivername", "graphdefaults",
]
# fmt: on


def getmaxx() -> int:
    """Return the largest x of the screen, 639 in VGAHI, whatever the viewport."""
    return current.screen.getmaxx()


def getmaxy() -> int:
    """Return the largest y of the screen, 479 in VGAHI, whatever the viewport."""
    return current.screen.getmaxy()


def getmaxcolor() -> int:
    """Return the largest colour: 15 on EGA and VGA, 3 or 1 on CGA, 255 on the 8514.

    Source: graphics.h; Borland's 8514 table says 15, the screen has 256.
    """
    return current.screen.getmaxcolor()


def cleardevice() -> None:
    """Clear the active page to the background colour (index 0), whatever the viewport.

    The current position goes to 0, 0; viewport and settings stay.
    """
    current.screen.cleardevice()


def setviewport(left: Number, top: Number, right: Number, bottom: Number, clip: Number) -> None:
    """Choose the part of the screen that drawing is relative to.

    Args:
        left, top, right, bottom: its corners in screen coordinates, all inside it.
        clip: 1 to cut drawing off at its edges, 0 to cut only at the edges of the screen.

    The current position goes to 0, 0. graphresult() says -11, and nothing changes, unless
    0 <= left <= right <= getmaxx() and likewise for top and bottom.
    """
    current.screen.setviewport(left, top, right, bottom, clip)


def getviewsettings() -> viewporttype:
    """Return the viewport: its corners in screen coordinates, and whether clipping is on."""
    return current.screen.getviewsettings()


def clearviewport() -> None:
    """Clear the viewport to the background colour (index 0), even with clipping off.

    The current position goes to 0, 0.
    """
    current.screen.clearviewport()


def moveto(x: Number, y: Number) -> None:
    """Move the current position to x, y, which may lie anywhere; draws nothing."""
    current.screen.moveto(x, y)


def moverel(dx: Number, dy: Number) -> None:
    """Move the current position by dx to the right and dy down; draws nothing."""
    current.screen.moverel(dx, dy)


def getx() -> int:
    """Return the current position's x, relative to the viewport."""
    return current.screen.getx()


def gety() -> int:
    """Return the current position's y, relative to the viewport."""
    return current.screen.gety()


def setactivepage(page: Number) -> None:
    """Choose the page that drawing, reading and clearing go to.

    Args:
        page: 0 or 1, in modes with four pages up to 3; any other is ignored.

    Source: graphics.h; chosen: every mode has two pages here at least.
    """
    current.screen.setactivepage(page)


def setvisualpage(page: Number) -> None:
    """Choose the page that is shown, at once and without copying.

    Args:
        page: as for setactivepage().
    """
    current.screen.setvisualpage(page)


def getactivepage() -> int:
    """Return the page that drawing goes to, 0 at first. Source: WinBGIm."""
    return current.screen.getactivepage()


def getvisualpage() -> int:
    """Return the page that is shown, 0 at first. Source: WinBGIm."""
    return current.screen.getvisualpage()


def swapbuffers() -> None:
    """Show the page just drawn and draw on the other one: smooth animation in one call.

    Returns when the page is on the glass, so nothing tears and a loop runs at the window's rate;
    without a window it returns at once. The page to draw on holds an older picture: begin with
    cleardevice(). Raises WindowClosed if the user closes the window. Source: WinBGIm.
    """
    current.screen.swapbuffers()


def setcolor(color: Number) -> None:
    """Set the colour of lines, outlines and text.

    Args:
        color: 0..getmaxcolor(); more bits than the mode has are cut off, on CGA and Hercules a
            larger one means the largest. 0 is the background.
    """
    current.screen.setcolor(color)


def getcolor() -> int:
    """Return the drawing colour as given (the low byte), getmaxcolor() at first."""
    return current.screen.getcolor()


def setbkcolor(color: Number) -> None:
    """Change how the background (index 0) looks, at once and everywhere; nothing is redrawn.

    Args:
        color: a colour whose look index 0 takes; 0 is black. On CGA any of the 16; in CGA's
            two-colour mode it is the foreground that changes, as on the hardware. An unknown one is
            ignored.

    Pixels of index 0 stay index 0.
    """
    current.screen.setbkcolor(color)


def getbkcolor() -> int:
    """Return the number last given to setbkcolor(), 0 at first."""
    return current.screen.getbkcolor()


def setpalette(index: Number, color: Number) -> None:
    """Change the look of one colour, at once, wherever it is on the screen.

    Args:
        index: the colour, 0..15.
        color: a hardware colour: 0..63 on EGA and VGA (EGA_RED, EGA_YELLOW, ...; not YELLOW), and
            0..15 on CGA, where only index 0 can change.

    An index that is not there, and -1, change nothing; of a hardware colour the low byte counts.
    graphresult() says -11 on the 8514, which takes setrgbpalette() only.
    """
    current.screen.setpalette(index, color)


def setallpalette(palette: palettetype | Sequence[Number]) -> None:
    """Change the look of several colours at once.

    Args:
        palette: a palettetype, or hardware colours for colour 0, 1, ...; -1 leaves one as it is.
            All of them may stand behind their number, as in C's struct: 16, then 16 colours.

    Each is set as by setpalette(). ValueError, and nothing changes, for more than 256 colours.
    """
    current.screen.setallpalette(palette)


def getpalette() -> palettetype:
    """Return the palette: 16 hardware colours, of which CGA shows only the first."""
    return current.screen.getpalette()


def getpalettesize() -> int:
    """Return how many colours can be changed: 16 on EGA and VGA, 1 on CGA, 256 on the 8514."""
    return current.screen.getpalettesize()


def getdefaultpalette() -> palettetype:
    """Return the hardware colours that the mode begins with."""
    return current.screen.getdefaultpalette()


def setrgbpalette(index: Numbers, red: Numbers, green: Numbers, blue: Numbers) -> None:
    """Mix colours of your own on the VGA or the 8514.

    Args:
        index: on the VGA a *register* 0..255: colour i shows register getpalette().colors[i],
            which is 20 for BROWN and 56..63 for DARKGRAY..WHITE; on the 8514 the colour itself.
        red, green, blue: 0..63 on the VGA, 0..255 (upper six bits) on the 8514.

    Of an index the low byte counts. Arrays mix many. graphresult() says -11, and nothing changes,
    on other adapters.
    """
    current.screen.setrgbpalette(index, red, green, blue)


def getgraphmode() -> int:
    """Return the number of the mode, for setgraphmode() to come back to it.

    Works after restorecrtmode() too.
    """
    return current.reachable().getgraphmode()


def getmaxmode() -> int:
    """Return the largest mode number of the driver in use: 2 for VGA."""
    return current.reachable().getmaxmode()


def getmodename(mode: Number) -> str | None:
    """Return the driver's name for one of its modes, such as "640 x 480 VGA".

    Args:
        mode: a mode number of the driver in use; None is returned for any other.
    """
    return current.reachable().getmodename(mode)


def getdrivername() -> str:
    """Return the name of the driver in use: "EGAVGA" for EGA and VGA."""
    return current.reachable().getdrivername()


def graphdefaults() -> None:
    """Put colours, styles, palette, viewport and current position back to their defaults.

    Clears nothing; pages, aspect ratio, arc coordinates and the registers of the VGA's DAC, which
    setrgbpalette() loads, stay.
    """
    current.screen.graphdefaults()
