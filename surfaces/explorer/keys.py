"""The keys of the explorer: what getch() gives for them, and what they do."""

from collections.abc import Mapping

from bgi import getch
from surfaces.explorer.dials import (
    AXES,
    BOX,
    CELLS,
    COLOR,
    COLORBAR,
    CONTOURS,
    CUT,
    FLOOR,
    MODE,
    RAMP,
    RHO_Z,
    THETA,
    TILT,
    TURN,
    VIEW,
    WIDER,
    ZOOM,
    Dial,
    Switch,
)

ENTER, ESC, TAB, BACKSPACE, SPACE = 13, 27, 9, 8, 32
EXTENDED = 256
"""What getch() gives as 0 and a second code, we count from here on."""
HOME, UP, PAGE_UP, LEFT, RIGHT, END, DOWN, PAGE_DOWN, DELETE = (
    EXTENDED + code for code in (71, 72, 73, 75, 77, 79, 80, 81, 83)
)
F1, F2, F3 = (EXTENDED + code for code in (59, 60, 61))


def read_key() -> int:
    """The next key, those without a character from EXTENDED on."""
    return getch() or EXTENDED + getch()


Turn = tuple[Dial | Switch, int]
"""What is turned, and by how many steps."""

DIALS: Mapping[int, Turn] = {
    LEFT: (TURN, -1),
    RIGHT: (TURN, 1),
    UP: (TILT, 1),
    DOWN: (TILT, -1),
    ord("+"): (ZOOM, 1),
    ord("="): (ZOOM, 1),  # + without the Shift key
    ord("-"): (ZOOM, -1),
    ord(","): (WIDER, -1),
    ord("."): (WIDER, 1),
    ord("["): (THETA, -1),
    ord("]"): (THETA, 1),
    ord(";"): (RHO_Z, -1),
    ord("'"): (RHO_Z, 1),
    PAGE_UP: (CELLS, 1),
    PAGE_DOWN: (CELLS, -1),
    TAB: (MODE, 1),
    ord("p"): (VIEW, 1),
    ord("r"): (RAMP, 1),
    ord("c"): (COLOR, 1),
    ord("x"): (AXES, 1),
    ord("b"): (BOX, 1),
    ord("k"): (COLORBAR, 1),
    ord("l"): (CONTOURS, 1),
    ord("f"): (FLOOR, 1),
    ord("z"): (CUT, 1),
}
"""What a key turns."""

CROSS: Mapping[int, tuple[int, int]] = {
    ord(key): (step * dx, step * dy)
    for keys, step in (("wasd", 8), ("WASD", 1))
    for key, (dx, dy) in zip(keys, ((0, -1), (-1, 0), (0, 1), (1, 0)), strict=True)
}
"""How a key moves the cross-hair, in pixels."""

HELP = (
    ("Enter", "type a formula; ↑ ↓ bring others"),
    ("mouse", "cross-hair; left turns, right or wheel zooms"),
    ("w a s d", "the cross-hair; in capitals pixel by pixel"),
    ("← → ↑ ↓", "turn and tilt"),
    ("Space", "spin, and stop"),
    ("Home", "as at the beginning"),
    ("+ -", "larger, smaller"),
    (", .", "less or more of the plane"),
    ("z", "cut off great heights, as near a pole"),
    ("p", "the view: paper, cabinet, ..."),
    ("[ ] ; '", "the paper's theta and rho_z"),
    ("Tab", "fill, mesh, ..."),
    ("PgUp PgDn", "finer, coarser"),
    ("r c", "the colours; what they show"),
    ("x b k", "axes; box; bar of colours"),
    ("l f", "contour lines on the surface; on the floor"),
    ("F2 F3", "save the picture; a full turn as a GIF"),
    ("F1 Esc", "this page, and back; end"),
)
"""All the keys, for the help page."""

HINTS = (
    *("Enter formula", "arrows, mouse turn", "+ - zoom", ", . range", "F1 all keys", "Esc end"),
    *("Tab mode", "PgUp/Dn n", "p view", "r c colours", "x axes", "b box", "l lines", "f floor"),
)
"""Some of the keys, for the line below the picture: of a narrow window the last are left out."""
