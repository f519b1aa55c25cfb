"""Borland's graphics.h for Python.

    from bgi import *

    initgraph()
    circle(320, 240, 100)
    getch()
    closegraph()

The functions and constants have Borland's names and argument order; what C returned through
pointers, Python returns. The rest of conio.h and dos.h is in `bgi.conio` and `bgi.dos`, the mouse
driver in `bgi.mouse`.
"""

from bgi import bios as bios
from bgi import conio as conio
from bgi import dos as dos
from bgi import keyboard as keyboard
from bgi import mouse as mouse
from bgi import stdlib as stdlib
from bgi.api.clicks import *
from bgi.api.curves import *
from bgi.api.drawing import *
from bgi.api.filling import *
from bgi.api.images import *
from bgi.api.screen import *
from bgi.api.system import *
from bgi.api.text import *
from bgi.api.windows import *
from bgi.conio import getch, kbhit
from bgi.constants import *
from bgi.dos import delay
from bgi.errors import BGIError, BGIWarning, GraphicsError, NobodyThere, WindowClosed
from bgi.graphics import Graphics
from bgi.memory.image import Image
from bgi.settings import (
    arccoordstype,
    fillsettingstype,
    linesettingstype,
    palettetype,
    pointtype,
    textsettingstype,
    viewporttype,
)

__version__ = "0.1.0"

# fmt: off
__all__ = [
    # Opening and closing graphics, errors, drivers and fonts (bgi.api.system)
    "detectgraph", "initgraph", "closegraph", "setgraphmode", "restorecrtmode", "getmoderange",
    "graphresult", "grapherrormsg", "strict", "slow", "magnifier", "installuserdriver",
    "registerbgidriver",
    "registerfarbgidriver", "installuserfont", "registerbgifont", "registerfarbgifont",
    "setgraphbufsize", "_graphgetmem", "_graphfreemem",
    # The screen (bgi.api.screen)
    "getmaxx", "getmaxy", "getmaxcolor", "cleardevice", "setviewport", "getviewsettings",
    "clearviewport", "moveto", "moverel", "getx", "gety", "setactivepage", "setvisualpage",
    "getactivepage", "getvisualpage", "swapbuffers", "setcolor", "getcolor", "setbkcolor",
    "getbkcolor", "setpalette", "setallpalette", "getpalette", "getpalettesize",
    "getdefaultpalette", "setrgbpalette", "getgraphmode", "getmaxmode", "getmodename",
    "getdrivername", "graphdefaults",
    # Points, lines and outlines (bgi.api.drawing)
    "putpixel", "getpixel", "line", "lineto", "linerel", "rectangle", "drawpoly", "setlinestyle",
    "getlinesettings", "setwritemode",
    # Circles and ellipses (bgi.api.curves)
    "circle", "arc", "ellipse", "getarccoords", "fillellipse", "pieslice", "sector",
    "setaspectratio", "getaspectratio",
    # Filled shapes (bgi.api.filling)
    "setfillstyle", "getfillsettings", "setfillpattern", "getfillpattern", "bar", "bar3d",
    "fillpoly", "floodfill",
    # Text (bgi.api.text)
    "settextstyle", "settextjustify", "setusercharsize", "gettextsettings", "outtext", "outtextxy",
    "textwidth", "textheight",
    # Pieces of the screen (bgi.api.images)
    "imagesize", "getimage", "putimage", "readimagefile", "writeimagefile",
    # Windows and colours of any mixture (bgi.api.windows)
    "initwindow", "closewindow", "getcurrentwindow", "setcurrentwindow", "getmaxwidth",
    "getmaxheight", "getwindowwidth", "getwindowheight", "COLOR", "IS_BGI_COLOR", "IS_RGB_COLOR",
    "converttorgb", "RED_VALUE", "GREEN_VALUE", "BLUE_VALUE",
    # The mouse over the window (bgi.api.clicks)
    "mousex", "mousey", "ismouseclick", "getmouseclick", "clearmouseclick", "setmousequeuestatus",
    "registermousehandler",
    # The keyboard and time (bgi.conio, bgi.dos)
    "kbhit", "getch", "delay",
    # Structures, classes and exceptions
    "arccoordstype", "fillsettingstype", "linesettingstype", "palettetype", "pointtype",
    "textsettingstype", "viewporttype",
    "Graphics", "Image", "BGIError", "GraphicsError", "BGIWarning", "NobodyThere", "WindowClosed",
    # Graphics drivers
    "CURRENT_DRIVER", "DETECT", "CGA", "MCGA", "EGA", "EGA64", "EGAMONO", "IBM8514", "HERCMONO",
    "ATT400", "VGA", "PC3270",
    # Graphics modes of each driver
    "CGAC0", "CGAC1", "CGAC2", "CGAC3", "CGAHI", "MCGAC0", "MCGAC1", "MCGAC2", "MCGAC3", "MCGAMED",
    "MCGAHI", "EGALO", "EGAHI", "EGA64LO", "EGA64HI", "EGAMONOHI", "HERCMONOHI", "ATT400C0",
    "ATT400C1", "ATT400C2", "ATT400C3", "ATT400MED", "ATT400HI", "VGALO", "VGAMED", "VGAHI",
    "PC3270HI", "IBM8514LO", "IBM8514HI",
    # What graphresult() returns
    "grOk", "grNoInitGraph", "grNotDetected", "grFileNotFound", "grInvalidDriver", "grNoLoadMem",
    "grNoScanMem", "grNoFloodMem", "grFontNotFound", "grNoFontMem", "grInvalidMode", "grError",
    "grIOerror", "grInvalidFont", "grInvalidFontNum", "grInvalidDeviceNum", "grInvalidVersion",
    # Colours: indices into the palette
    "BLACK", "BLUE", "GREEN", "CYAN", "RED", "MAGENTA", "BROWN", "LIGHTGRAY", "DARKGRAY",
    "LIGHTBLUE", "LIGHTGREEN", "LIGHTCYAN", "LIGHTRED", "LIGHTMAGENTA", "YELLOW", "WHITE",
    "MAXCOLORS", "BLINK",
    # Colours of the CGA's four palettes
    "CGA_LIGHTGREEN", "CGA_LIGHTRED", "CGA_YELLOW", "CGA_LIGHTCYAN", "CGA_LIGHTMAGENTA",
    "CGA_WHITE", "CGA_GREEN", "CGA_RED", "CGA_BROWN", "CGA_CYAN", "CGA_MAGENTA", "CGA_LIGHTGRAY",
    # Hardware colours of the EGA and VGA, for setpalette
    "EGA_BLACK", "EGA_BLUE", "EGA_GREEN", "EGA_CYAN", "EGA_RED", "EGA_MAGENTA", "EGA_BROWN",
    "EGA_LIGHTGRAY", "EGA_DARKGRAY", "EGA_LIGHTBLUE", "EGA_LIGHTGREEN", "EGA_LIGHTCYAN",
    "EGA_LIGHTRED", "EGA_LIGHTMAGENTA", "EGA_YELLOW", "EGA_WHITE",
    # Line styles and widths
    "SOLID_LINE", "DOTTED_LINE", "CENTER_LINE", "DASHED_LINE", "USERBIT_LINE", "NORM_WIDTH",
    "THICK_WIDTH",
    # Fill patterns
    "EMPTY_FILL", "SOLID_FILL", "LINE_FILL", "LTSLASH_FILL", "SLASH_FILL", "BKSLASH_FILL",
    "LTBKSLASH_FILL", "HATCH_FILL", "XHATCH_FILL", "INTERLEAVE_FILL", "WIDE_DOT_FILL",
    "CLOSE_DOT_FILL", "USER_FILL",
    # putimage operators, of which setwritemode knows the first two
    "COPY_PUT", "XOR_PUT", "OR_PUT", "AND_PUT", "NOT_PUT",
    # Text: fonts, directions, justification
    "DEFAULT_FONT", "TRIPLEX_FONT", "SMALL_FONT", "SANS_SERIF_FONT", "GOTHIC_FONT", "SCRIPT_FONT",
    "SIMPLEX_FONT", "TRIPLEX_SCR_FONT", "COMPLEX_FONT", "EUROPEAN_FONT", "BOLD_FONT", "HORIZ_DIR",
    "VERT_DIR", "USER_CHAR_SIZE", "LEFT_TEXT", "CENTER_TEXT", "RIGHT_TEXT", "BOTTOM_TEXT",
    "TOP_TEXT",
    # What registerbgidriver and registerbgifont take: the names of linked-in drivers and fonts
    "CGA_driver", "EGAVGA_driver", "Herc_driver", "ATT_driver", "PC3270_driver", "IBM8514_driver",
    "triplex_font", "small_font", "sansserif_font", "gothic_font",
    # Windows by number
    "CURRENT_WINDOW", "ALL_WINDOWS", "NO_CURRENT_WINDOW",
    # What can happen to the mouse: WinBGIm's kinds of events, which are Windows' messages
    "WM_MOUSEMOVE", "WM_LBUTTONDOWN", "WM_LBUTTONUP", "WM_LBUTTONDBLCLK", "WM_RBUTTONDOWN",
    "WM_RBUTTONUP", "WM_RBUTTONDBLCLK", "WM_MBUTTONDOWN", "WM_MBUTTONUP", "WM_MBUTTONDBLCLK",
    "NO_CLICK",
]
