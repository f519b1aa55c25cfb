"""Opening and closing graphics, what went wrong, and the tables of drivers and fonts.

Source: graphics.h, unless a function says otherwise.
"""

from __future__ import annotations

import os
import warnings
from contextlib import ExitStack

from bgi import current
from bgi.constants import (
    CURRENT_DRIVER,
    DETECT,
    VGA,
    VGAHI,
    grFileNotFound,
    grInvalidMode,
    grNotDetected,
    grOk,
)
from bgi.errors import BGIWarning, brief
from bgi.kernel.arguments import Number, check_function, check_text, flag, octets, whole
from bgi.kernel.drivers import Detect
from bgi.kernel.state import KERNEL

# fmt: off
__all__ = [
    "detectgraph", "initgraph", "closegraph", "setgraphmode", "restorecrtmode", "getmoderange",
    "graphresult", "grapherrormsg", "strict", "slow", "magnifier",
    "installuserdriver", "registerbgidriver", "registerfarbgidriver",
    "installuserfont", "registerbgifont", "registerfarbgifont",
    "setgraphbufsize", "_graphgetmem", "_graphfreemem",
]
# fmt: on


def detectgraph() -> tuple[int, int]:
    """Tell the adapter and its best mode: (VGA, VGAHI), here as on nearly every PC.

    Returns driver and mode; changes nothing.
    """
    return VGA, VGAHI


def initgraph(
    gd: Number = DETECT, gm: Number = 0, path: str | os.PathLike[str] | None = ""
) -> tuple[int, int]:
    """Open the graphics screen: the window appears, black, with all settings at their defaults.

    Args:
        gd: the driver, VGA for one; DETECT (0) takes the best, and then `gm` is ignored.
        gm: one of the driver's modes, VGAHI for one (640x480 in 16 colours).
        path: where Borland's drivers and fonts used to lie, such as "C:\\\\TC\\\\BGI"; any will do,
            and so will None, C's NULL.

    Returns the driver and mode in use. An unknown driver returns (-3, gm), a negative one (-2, gm),
    and graphresult() says the same; an unknown mode returns (gd, gm) and graphresult() says -10; no
    screen opens then, and a BGIWarning says why. A second initgraph goes on in the same window.
    Raises BGIError if the window cannot be opened.
    """
    driver, number = whole("gd", gd), whole("gm", gm)
    folder = "" if path is None else path
    if not isinstance(folder, (str, os.PathLike)):
        raise TypeError(f"path must be a str, not {type(path).__name__}: {brief(path)}")
    if driver == DETECT:
        driver, number = KERNEL.drivers.autodetect() or detectgraph()
    mode = KERNEL.drivers.find(driver, number)
    name = KERNEL.drivers.name(driver)
    if name is not None:
        KERNEL.result.driver_file = f"{name}.BGI"
    if mode is not None:
        current.open_screen(mode).path = os.fsdecode(folder)
        KERNEL.result.set(grOk)
        return driver, number
    KERNEL.why_no_screen = why = _why_no_screen(driver, number)
    known = KERNEL.drivers.mode_range(driver) != (-1, -1)
    code = grInvalidMode if known else grFileNotFound if driver > 0 else grNotDetected
    KERNEL.result.set(code, why)
    warnings.warn(why, BGIWarning, stacklevel=2)
    return driver if known else code, number


def _why_no_screen(driver: int, number: int) -> str:
    """What is wrong with a driver or mode that initgraph() was given."""
    low, high = KERNEL.drivers.mode_range(driver)
    name = KERNEL.drivers.name(driver)
    if low >= 0:
        return f"driver {driver} ({name}) has no mode {brief(number)}, only {low} to {high}"
    if name is not None:
        return f"driver {driver} ({name}) has no file: there is nothing to open"
    size, named = min(driver, number) >= SMALLEST, brief(driver)
    hint = f"; for a window of that size: initwindow({named}, {brief(number)})" if size else ""
    return f"driver {named} does not exist{hint}"


SMALLEST = 64
"""The smallest window that somebody may have meant who gives its size in place of a driver."""


def closegraph() -> None:
    """Close the graphics screen, and its window unless the program has written text there.

    A program that has used conio.h or stdio.h goes back to its text screen, which is empty, in the
    same window; that stays until the program ends. Never fails: without a screen, or after the user
    has closed the window, it does nothing. Drawing afterwards raises BGIError until the next
    initgraph.
    """
    current.close_graphics()


def setgraphmode(mode: Number) -> None:
    """Change to another mode of the same driver: clears the screen, resets every setting.

    Args:
        mode: a mode number of the driver in use.

    graphresult() says -10, and nothing changes, for a mode that the driver does not have. Also
    leads back from restorecrtmode().
    """
    number = whole("mode", mode)
    wanted = KERNEL.drivers.find(current.reachable().mode.driver, number)
    if wanted is None:
        KERNEL.result.set(grInvalidMode)
    else:
        current.open_screen(wanted)


def restorecrtmode() -> None:
    """Go back to the text screen, which is empty; graphics stays loaded.

    Drawing now raises BGIError("BGI Error: Not in graphics mode"), until setgraphmode() leads
    back.
    """
    current.leave_graphics()


def getmoderange(driver: Number) -> tuple[int, int]:
    """Return the lowest and the highest mode number of a driver.

    Args:
        driver: CGA ... PC3270, or CURRENT_DRIVER (-1) for the one in use.

    (-1, -1) for an unknown driver. Works before initgraph.
    """
    number = whole("driver", driver)
    if number == CURRENT_DRIVER:
        number = current.reachable().mode.driver
    return KERNEL.drivers.mode_range(number)


def graphresult() -> int:
    """Return the error code of the last call that failed, and clear it: 0 means all is well.

    Ask once and keep the answer: the second question is answered with 0.
    """
    return KERNEL.result.take()


def strict(on: bool = True) -> ExitStack:
    """Make an exception of every error that graphresult() would report, from now on.

    Args:
        on: False ends it.

    In `with strict():` only the block is strict. The GraphicsError says which call it was, what was
    given, Borland's code and message. Strict mode also refuses what Borland's functions took in
    silence: a colour that the mode does not have, and a flood that reaches all four sides of the
    viewport. A refused call changes nothing. Source: this package.
    """
    before = KERNEL.result.strict
    current.be_strict(flag("on", on))
    after = ExitStack()
    after.callback(current.be_strict, before)
    return after


def slow(pixels_a_second: Number = 1000, step: bool = False) -> ExitStack:
    """Set everything pixel by pixel from now on, slowly enough to watch.

    Args:
        pixels_a_second: how fast; 0 for full speed again.
        step: whether each call that draws waits for a key when it is done, and says which line of
            the program it was, on the terminal and in the window's title. Escape goes on without.

    Pixels come in the order in which the algorithm sets them: lines from their first end, circles
    by octants, areas row by row, floods as they spread. What a call does not change is not seen
    again, and drawing on a hidden page is not slowed. In `with slow(500):` only the block is slow.
    `BGI_SLOW=500`, or `python -m bgi --slow 500 PROGRAM.py`, does it for a whole program.
    ValueError for a negative number. Source: this package.
    """
    rate = whole("pixels_a_second", pixels_a_second)
    if rate < 0:
        raise ValueError(f"pixels_a_second must be 0 or more, not {brief(rate)}")
    before = current.be_slow(rate, flag("step", step))
    after = ExitStack()
    after.callback(current.be_slow, *before)
    return after


def magnifier(times: Number = 16, follow: str = "mouse") -> None:
    """Show a part of the picture enlarged, in a corner of the window, with a grid and colours.

    Args:
        times: how wide a pixel becomes, 1 to 64; 0 closes it.
        follow: "mouse" for the pixel under the mouse, "pixels" for the one that was set last.

    A line tells the pixel's x, y and colour. Ctrl-F6 does the same while a program runs, Ctrl-F8
    changes what it follows, and Ctrl-F7 shows the palette, the pages and the viewport. It is no
    part of the picture: getpixel(), saved files and recordings do not see it. ValueError for other
    numbers and words. Source: this package.
    """
    number = whole("times", times)
    if not 0 <= number <= 64:
        raise ValueError(f"times must be 0 to 64, not {brief(number)}")
    check_text("follow", follow)
    if follow not in ("mouse", "pixels"):
        raise ValueError(f'follow must be "mouse" or "pixels", not {brief(follow)}')
    current.screen.monitor.magnify(number, follow)


def grapherrormsg(code: Number) -> str:
    """Return Borland's message for an error code.

    Args:
        code: what graphresult() returned, 0 or negative.

    An unknown code gives "Graphics error (code)". Leaves the error code alone.
    """
    return KERNEL.result.message(whole("code", code))


def installuserdriver(name: str, detect: Detect | None = None) -> int:
    """Add a driver to the kernel's table; initgraph() can then open it by its number.

    Args:
        name: its file name without .BGI. "SVGA256" brings five modes of 256 colours, from 320x200
            to 1024x768; there are no files behind other names.
        detect: called by initgraph(DETECT); it returns the mode to use, or a negative number.

    Returns the driver's number, 16 or more, or -11 when the ten places are taken.
    """
    check_text("name", name)
    check_function("detect", detect)
    number = KERNEL.drivers.install(name.upper().removesuffix(".BGI"), detect)
    if number < 0:
        KERNEL.result.set(number)
    return number


def registerbgidriver(driver: str | bytes) -> int:
    """Register a driver that was linked into the program; here every driver is there already.

    Args:
        driver: EGAVGA_driver and its like, or the bytes of a .BGI file.

    Returns the number of its first driver, or -4 (and graphresult() says so) if it is none of
    Borland's.
    """
    if not isinstance(driver, (str, bytes)):
        raise TypeError(f"driver must be a str or bytes, not {type(driver).__name__}")
    number = KERNEL.drivers.register(driver)
    if number < 0:
        KERNEL.result.set(number)
    return number


def registerfarbgidriver(driver: str | bytes) -> int:
    """Register a driver, as registerbgidriver() does."""
    return registerbgidriver(driver)


def installuserfont(name: str) -> int:
    """Add a .CHR file to the table of fonts; settextstyle() loads it by the number returned.

    Args:
        name: a file name of at most 8 characters, or a path, with or without .CHR.

    Returns 11 or more, the number it has if it is there already, or -11 when the 20 places are
    taken.
    """
    check_text("name", name)
    number = KERNEL.fonts.install(name)
    if number < 0:
        KERNEL.result.set(number)
    return number


def registerbgifont(font: str | bytes) -> int:
    """Register a font that was linked into the program, or loaded into memory.

    Args:
        font: triplex_font and its like, or the bytes of a .CHR file.

    Returns its number for settextstyle(); -13 if it is not a font, -11 when the table is full, and
    graphresult() says so too.
    """
    if not isinstance(font, (str, bytes, bytearray, memoryview)):
        raise TypeError(f"font must be a str or bytes, not {type(font).__name__}")
    number = KERNEL.fonts.install(font) if isinstance(font, str) else KERNEL.fonts.register(font)
    if number < 0:
        KERNEL.result.set(number)
    return number


def registerfarbgifont(font: str | bytes) -> int:
    """Register a font, as registerbgifont() does."""
    return registerbgifont(font)


def setgraphbufsize(size: Number) -> int:
    """Set the size of the buffer for filling and return the one before, at first 4096.

    Args:
        size: bytes, 0..65535. Nothing here runs out of it.
    """
    before, KERNEL.bufsize = KERNEL.bufsize, whole("size", size) & 0xFFFF
    return before


def _graphgetmem(size: Number) -> bytearray:
    """Return a block of memory, as the kernel's own hook does.

    Args:
        size: bytes, 0..65535.
    """
    return bytearray(whole("size", size) & 0xFFFF)


def _graphfreemem(block: bytearray, size: Number) -> None:
    """Give back a block of memory from _graphgetmem().

    Args:
        block: what _graphgetmem() returned.
        size: its size; Python frees it when nobody holds it any more.
    """
    octets("block", block)
    whole("size", size)
