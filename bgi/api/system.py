"""Drivers and modes: opening and closing graphics, and what went wrong."""

from bgi import current
from bgi.arguments import Number, whole
from bgi.constants import (
    CURRENT_DRIVER,
    DETECT,
    VGA,
    VGAHI,
    grInvalidDriver,
    grInvalidMode,
    grOk,
)
from bgi.errors import message, result
from bgi.modes import find, mode_range


def detectgraph() -> tuple[int, int]:
    """Tell the adapter and its best mode: (VGA, VGAHI), here as on nearly every PC.

    Returns driver and mode; changes nothing. Source: graphics.h.
    """
    return VGA, VGAHI


def initgraph(gd: Number = DETECT, gm: Number = 0, path: str = "") -> tuple[int, int]:
    """Open the graphics screen: the window appears, black, with all settings at their defaults.

    Args:
        gd: the driver, VGA for one; DETECT (0) takes the best, and then `gm` is ignored.
        gm: one of the driver's modes, VGAHI for one (640x480 in 16 colours).
        path: where Borland's drivers and fonts used to lie, such as "C:\\\\TC\\\\BGI"; any will do.

    Returns the driver and mode in use. An unknown driver returns (-4, gm) and graphresult() says
    -4; an unknown mode returns (gd, gm) and graphresult() says -10; no screen opens then. A second
    initgraph goes on in the same window. Raises BGIError if the window cannot be opened. Source:
    graphics.h.
    """
    driver, number = whole("gd", gd), whole("gm", gm)
    if not isinstance(path, str):
        raise TypeError(f"path must be a str, not {type(path).__name__}: {path!r:.60}")
    if driver == DETECT:
        driver, number = detectgraph()
    mode = find(driver, number)
    if mode is not None:
        current.open_screen(mode)
        current.screen.path = path
        result.set(grOk)
    elif mode_range(driver) == (-1, -1):
        result.set(grInvalidDriver)
        driver = grInvalidDriver
    else:
        result.set(grInvalidMode)
    return driver, number


def closegraph() -> None:
    """Close the graphics screen and its window.

    Never fails: without a screen, or after the user has closed the window, it does nothing.
    Drawing afterwards raises BGIError until the next initgraph. Source: graphics.h.
    """
    current.close_screen()


def setgraphmode(mode: Number) -> None:
    """Change to another mode of the same driver: clears the screen, resets every setting.

    Args:
        mode: a mode number of the driver in use.

    graphresult() says -10, and nothing changes, for a mode that the driver does not have. Also
    leads back from restorecrtmode(). Source: graphics.h.
    """
    number = whole("mode", mode)
    wanted = find(current.reachable().mode.driver, number)
    if wanted is None:
        result.set(grInvalidMode)
    else:
        current.open_screen(wanted)


def restorecrtmode() -> None:
    """Go back to the text screen, which is dark here; graphics stays loaded.

    Drawing now raises BGIError("BGI Error: Not in graphics mode"), until setgraphmode() leads
    back. Source: graphics.h.
    """
    current.leave_graphics()


def getgraphmode() -> int:
    """Return the number of the mode, for setgraphmode() to come back to it.

    Works after restorecrtmode() too. Source: graphics.h.
    """
    return current.reachable().getgraphmode()


def getmaxmode() -> int:
    """Return the largest mode number of the driver in use: 2 for VGA. Source: graphics.h."""
    return current.reachable().getmaxmode()


def getmodename(mode: Number) -> str | None:
    """Return the driver's name for one of its modes, such as "640 x 480 VGA".

    Args:
        mode: a mode number of the driver in use; None is returned for any other.

    Source: graphics.h.
    """
    return current.reachable().getmodename(mode)


def getdrivername() -> str:
    """Return the name of the driver in use: "EGAVGA" for EGA and VGA. Source: graphics.h."""
    return current.reachable().getdrivername()


def getmoderange(driver: Number) -> tuple[int, int]:
    """Return the lowest and the highest mode number of a driver.

    Args:
        driver: CGA ... PC3270, or CURRENT_DRIVER (-1) for the one in use.

    (-1, -1) for an unknown driver, and graphresult() says -4. Works before initgraph. Source:
    graphics.h.
    """
    number = whole("driver", driver)
    if number == CURRENT_DRIVER:
        number = current.reachable().mode.driver
    found = mode_range(number)
    if found == (-1, -1):
        result.set(grInvalidDriver)
    return found


def graphdefaults() -> None:
    """Put colours, styles, palette, viewport and current position back to their defaults.

    Clears nothing; pages, aspect ratio and arc coordinates stay. Source: graphics.h.
    """
    current.screen.graphdefaults()


def graphresult() -> int:
    """Return the error code of the last call that failed, and clear it: 0 means all is well.

    Ask once and keep the answer: the second question is answered with 0. Source: graphics.h.
    """
    return result.take()


def grapherrormsg(code: Number) -> str:
    """Return Borland's message for an error code.

    Args:
        code: what graphresult() returned, 0 or negative.

    An unknown code gives "Graphics error (code)". Leaves the error code alone. Source: graphics.h.
    """
    return message(whole("code", code))
