"""Every number that `graphics.h` names, spelt as Borland spelt it.

Nothing here computes anything: read it beside the manual.
"""

# A driver, for initgraph (graphics_drivers)
CURRENT_DRIVER = -1
DETECT = 0
CGA = 1
MCGA = 2
EGA = 3
EGA64 = 4
EGAMONO = 5
IBM8514 = 6
HERCMONO = 7
ATT400 = 8
VGA = 9
PC3270 = 10

# A mode of a driver, for initgraph (graphics_modes)
CGAC0 = 0
CGAC1 = 1
CGAC2 = 2
CGAC3 = 3
CGAHI = 4
MCGAC0 = 0
MCGAC1 = 1
MCGAC2 = 2
MCGAC3 = 3
MCGAMED = 4
MCGAHI = 5
EGALO = 0
EGAHI = 1
EGA64LO = 0
EGA64HI = 1
EGAMONOHI = 0
HERCMONOHI = 0
ATT400C0 = 0
ATT400C1 = 1
ATT400C2 = 2
ATT400C3 = 3
ATT400MED = 4
ATT400HI = 5
VGALO = 0
VGAMED = 1
VGAHI = 2
PC3270HI = 0
IBM8514LO = 0
IBM8514HI = 1

# What graphresult() may return (graphics_errors)
grOk = 0
grNoInitGraph = -1
grNotDetected = -2
grFileNotFound = -3
grInvalidDriver = -4
grNoLoadMem = -5
grNoScanMem = -6
grNoFloodMem = -7
grFontNotFound = -8
grNoFontMem = -9
grInvalidMode = -10
grError = -11
grIOerror = -12
grInvalidFont = -13
grInvalidFontNum = -14
grInvalidDeviceNum = -15
grInvalidVersion = -18

# A colour: its index in the palette (COLORS)
BLACK = 0
BLUE = 1
GREEN = 2
CYAN = 3
RED = 4
MAGENTA = 5
BROWN = 6
LIGHTGRAY = 7
DARKGRAY = 8
LIGHTBLUE = 9
LIGHTGREEN = 10
LIGHTCYAN = 11
LIGHTRED = 12
LIGHTMAGENTA = 13
YELLOW = 14
WHITE = 15
MAXCOLORS = 15

# Added to a colour, makes text blink: in text modes only
BLINK = 128

# A text mode (text_modes)
LASTMODE = -1
BW40 = 0
C40 = 1
BW80 = 2
C80 = 3
MONO = 7
C4350 = 64

# A shape of the text cursor, for _setcursortype
_NOCURSOR = 0
_SOLIDCURSOR = 1
_NORMALCURSOR = 2

# A colour in one of the CGA's four palettes (CGA_COLORS)
CGA_LIGHTGREEN = 1
CGA_LIGHTRED = 2
CGA_YELLOW = 3
CGA_LIGHTCYAN = 1
CGA_LIGHTMAGENTA = 2
CGA_WHITE = 3
CGA_GREEN = 1
CGA_RED = 2
CGA_BROWN = 3
CGA_CYAN = 1
CGA_MAGENTA = 2
CGA_LIGHTGRAY = 3

# A hardware colour of the EGA and VGA, for setpalette (EGA_COLORS)
EGA_BLACK = 0
EGA_BLUE = 1
EGA_GREEN = 2
EGA_CYAN = 3
EGA_RED = 4
EGA_MAGENTA = 5
EGA_BROWN = 20
EGA_LIGHTGRAY = 7
EGA_DARKGRAY = 56
EGA_LIGHTBLUE = 57
EGA_LIGHTGREEN = 58
EGA_LIGHTCYAN = 59
EGA_LIGHTRED = 60
EGA_LIGHTMAGENTA = 61
EGA_YELLOW = 62
EGA_WHITE = 63

# A style or width of lines, for setlinestyle (line_styles, line_widths)
SOLID_LINE = 0
DOTTED_LINE = 1
CENTER_LINE = 2
DASHED_LINE = 3
USERBIT_LINE = 4
NORM_WIDTH = 1
THICK_WIDTH = 3

# A fill pattern, for setfillstyle (fill_patterns)
EMPTY_FILL = 0
SOLID_FILL = 1
LINE_FILL = 2
LTSLASH_FILL = 3
SLASH_FILL = 4
BKSLASH_FILL = 5
LTBKSLASH_FILL = 6
HATCH_FILL = 7
XHATCH_FILL = 8
INTERLEAVE_FILL = 9
WIDE_DOT_FILL = 10
CLOSE_DOT_FILL = 11
USER_FILL = 12

# How putimage meets what is there; setwritemode takes the first two (putimage_ops)
COPY_PUT = 0
XOR_PUT = 1
OR_PUT = 2
AND_PUT = 3
NOT_PUT = 4

# A font, direction, size or justification of text (font_names, text_just)
DEFAULT_FONT = 0
TRIPLEX_FONT = 1
SMALL_FONT = 2
SANS_SERIF_FONT = 3
GOTHIC_FONT = 4
SCRIPT_FONT = 5
SIMPLEX_FONT = 6
TRIPLEX_SCR_FONT = 7
COMPLEX_FONT = 8
EUROPEAN_FONT = 9
BOLD_FONT = 10
HORIZ_DIR = 0
VERT_DIR = 1
USER_CHAR_SIZE = 0
LEFT_TEXT = 0
CENTER_TEXT = 1
RIGHT_TEXT = 2
BOTTOM_TEXT = 0
TOP_TEXT = 2

# A linked-in driver or font, for registerbgidriver and registerbgifont
CGA_driver = "CGA"
EGAVGA_driver = "EGAVGA"
Herc_driver = "HERC"
ATT_driver = "ATT"
PC3270_driver = "PC3270"
IBM8514_driver = "IBM8514"
triplex_font = "TRIP"
small_font = "LITT"
sansserif_font = "SANS"
gothic_font = "GOTH"

# A window by number, for closewindow (WinBGIm)
CURRENT_WINDOW = -1
ALL_WINDOWS = -2
NO_CURRENT_WINDOW = -3

# A kind of event of the mouse: WinBGIm's, which are Windows' messages
WM_MOUSEMOVE = 512
WM_LBUTTONDOWN = 513
WM_LBUTTONUP = 514
WM_LBUTTONDBLCLK = 515
WM_RBUTTONDOWN = 516
WM_RBUTTONUP = 517
WM_RBUTTONDBLCLK = 518
WM_MBUTTONDOWN = 519
WM_MBUTTONUP = 520
WM_MBUTTONDBLCLK = 521
NO_CLICK = -1
