"""Type any formula and walk round its surface.

    python -m demos explore

What it shows: `surfaces.formula` makes a function of what you type, `surfaces.surface` draws it,
and `plot.pick` reads back from any pixel the point (x, y, z) that is seen there. Enter begins a
formula and draws it; if it is none, an arrow shows where it goes wrong.

    Enter     type a formula: Enter draws it, Esc forgets it, ↑ ↓ bring earlier ones
    arrows    turn and tilt                  Space    spin        Home   as at the beginning
    + -       larger, smaller                , .      less or more of the plane
    [ ]       the paper's theta              ; '      its rho_z
    Tab       fill, mesh, ...                PgUp PgDn  finer, coarser
    p r c x   projection, ramp, what the colours tell, axes
    z         cut off heights larger than x and y, as near a pole
    w a s d   move the cross-hair; in capitals pixel by pixel
    F2        save the picture as explore-001.png       Esc    end
"""

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count
from math import inf, radians
from pathlib import Path
from textwrap import wrap

import numpy as np

from bgi import (
    BLACK,
    BLUE,
    DARKGRAY,
    IBM8514,
    IBM8514LO,
    LIGHTCYAN,
    LIGHTGRAY,
    LIGHTGREEN,
    LIGHTRED,
    NORM_WIDTH,
    SOLID_FILL,
    SOLID_LINE,
    THICK_WIDTH,
    WHITE,
    YELLOW,
    bar,
    cleardevice,
    getch,
    getmaxcolor,
    getmaxx,
    getmaxy,
    initgraph,
    kbhit,
    line,
    outtextxy,
    setactivepage,
    setcolor,
    setfillstyle,
    setlinestyle,
    setviewport,
    swapbuffers,
    writeimagefile,
)
from surfaces import MODES, PROJECTIONS, RAMPS, Mapping, Plot, compose, rotation, scaling, surface
from surfaces.fields import FIELDS
from surfaces.formula import FUNCTIONS, LONGEST, NAMES, FormulaError, formula

MODE = (IBM8514, IBM8514LO)
ENTER, ESC, TAB, BACKSPACE, SPACE = 13, 27, 9, 8, 32
# What getch() gives as 0 and a second code, we count from 256 on.
EXTENDED = 256
HOME, UP, PAGE_UP, LEFT, RIGHT, END, DOWN, PAGE_DOWN, DELETE, F2 = (
    EXTENDED + code for code in (71, 72, 73, 75, 77, 79, 80, 81, 83, 60)
)
EXAMPLES = (
    "sin(x*y)/2",
    "sinc(4*r)",
    "(x^3 - 3*x*y^2)/9",
    "cos(3*theta)*r",
    "sin(3*x)*cos(3*y)*exp(-r/2)",
    "sqrt(9 - r^2)",
    "where(r < 2, cos(pi*r), 1)",
)
CELLS = (20, 40, 60, 100, 150, 200, 300, 400)
KEYS = (
    "Enter formula  arrows turn  + - zoom  , . range  [ ] theta  ; ' rho_z  Esc end",
    "Tab mode  PgUp/Dn n  p view  r ramp  c color  x axes  z cut  wasd +  F2 save",
)
MARGIN, ROW, ROWS = 8, 12, 5
PANEL = ROWS * ROW + MARGIN
"""The height of what stands below the picture: five lines of text."""
WIDE = 78
"""Characters in a line of it."""


@dataclass
class Dial:
    """A number with a step and two ends."""

    value: float
    step: float
    low: float = -inf
    high: float = inf

    def turn(self, steps: int) -> None:
        """So many steps up or down, as far as it goes."""
        self.value = min(max(self.value + steps * self.step, self.low), self.high)


@dataclass
class Wheel:
    """One of several words, and after the last the first again."""

    words: Sequence[str]
    place: int = 0

    @property
    def word(self) -> str:
        """The one that shows."""
        return self.words[self.place]

    def turn(self) -> None:
        """The next one."""
        self.place = (self.place + 1) % len(self.words)


@dataclass
class View:
    """How the surface is looked at. Angles are in degrees."""

    spin: Dial = field(default_factory=lambda: Dial(0, 5))
    tilt: Dial = field(default_factory=lambda: Dial(0, 5))
    zoom: Dial = field(default_factory=lambda: Dial(2, 1, -10, 20))
    domain: Dial = field(default_factory=lambda: Dial(0, 1, -12, 12))
    theta: Dial = field(default_factory=lambda: Dial(45, 5, 5, 85))
    rho_z: Dial = field(default_factory=lambda: Dial(1, 0.1, 0.1, 1))
    cells: Dial = field(default_factory=lambda: Dial(5, 1, 0, len(CELLS) - 1))
    mode: Wheel = field(default_factory=lambda: Wheel(tuple(MODES)))
    ramp: Wheel = field(default_factory=lambda: Wheel(tuple(RAMPS)))
    color: Wheel = field(default_factory=lambda: Wheel(tuple(FIELDS)))
    axes: Wheel = field(default_factory=lambda: Wheel(("bare", "axes", "axes and scale")))
    projection: Wheel = field(default_factory=lambda: Wheel(tuple(PROJECTIONS)))
    heights: Wheel = field(default_factory=lambda: Wheel(("whole", "cut")))
    spinning: bool = False

    @property
    def n(self) -> int:
        """Cells in each direction."""
        return CELLS[int(self.cells.value)]

    @property
    def half(self) -> float:
        """x and y run from minus this to this: 3, and three steps double it."""
        return float(f"{3 * 2 ** (self.domain.value / 3):.2g}")

    def show(self, text: str) -> Plot:
        """Draw a formula in the viewport; ValueError if it is none, or has no values."""
        arrows = PROJECTIONS[self.projection.word]
        if self.projection.word == "paper":
            arrows = Mapping(radians(self.theta.value), self.rho_z.value)
        (x_right, x_down), (y_right, y_down), _ = arrows.arrows
        # The direction on the floor that is level on the screen, and leads to the right.
        to_right = 1 if x_right * y_down > y_right * x_down else -1
        level = to_right * y_down, -to_right * x_down, 0.0
        size = 1.15**self.zoom.value
        setcolor(YELLOW)
        return surface(
            formula(text),
            x=(-self.half, self.half),
            y=(-self.half, self.half),
            n=self.n,
            z=(-self.half, self.half) if self.heights.word == "cut" else None,
            mode=self.mode.word,
            transform=compose(
                rotation("z", radians(self.spin.value)),
                rotation(level, radians(self.tilt.value)),
                scaling(size, size, size),
            ),
            projection=arrows,
            color=self.color.word,
            ramp=self.ramp.word,
            dither=getmaxcolor() < 255,
            axes=self.axes.word != "bare",
            colorbar=self.axes.word == "axes and scale",
            title=f"z = {text}"[:WIDE],
        )

    def __str__(self) -> str:
        """All of it in a line."""
        view = self.projection.word
        if view == "paper":
            view = f"theta {self.theta.value:.0f} rho_z {self.rho_z.value:.1f}"
        axes = "x, y, z" if self.heights.word == "cut" else "x, y"
        return (
            f"{self.mode.word} {self.n}x{self.n}  {self.ramp.word}: {self.color.word}  "
            f"{view}  {axes} to {self.half:g}  zoom {1.15**self.zoom.value:.2g}"
        )


# What a key does to the view.
VIEW_KEYS: dict[int, Callable[[View], None]] = {
    LEFT: lambda view: view.spin.turn(-1),
    RIGHT: lambda view: view.spin.turn(1),
    UP: lambda view: view.tilt.turn(1),
    DOWN: lambda view: view.tilt.turn(-1),
    PAGE_UP: lambda view: view.cells.turn(1),
    PAGE_DOWN: lambda view: view.cells.turn(-1),
    TAB: lambda view: view.mode.turn(),
    ord("+"): lambda view: view.zoom.turn(1),
    ord("="): lambda view: view.zoom.turn(1),  # + without the Shift key
    ord("-"): lambda view: view.zoom.turn(-1),
    ord(","): lambda view: view.domain.turn(-1),
    ord("."): lambda view: view.domain.turn(1),
    ord("["): lambda view: view.theta.turn(-1),
    ord("]"): lambda view: view.theta.turn(1),
    ord(";"): lambda view: view.rho_z.turn(-1),
    ord("'"): lambda view: view.rho_z.turn(1),
    ord("p"): lambda view: view.projection.turn(),
    ord("r"): lambda view: view.ramp.turn(),
    ord("c"): lambda view: view.color.turn(),
    ord("x"): lambda view: view.axes.turn(),
    ord("z"): lambda view: view.heights.turn(),
}

# How a key moves the cross-hair, in pixels.
CROSS_KEYS = {
    ord(key): (step * dx, step * dy)
    for keys, step in (("wasd", 8), ("WASD", 1))
    for key, (dx, dy) in zip(keys, ((0, -1), (-1, 0), (0, 1), (1, 0)), strict=True)
}


@dataclass
class Editor:
    """A line of text that is being typed."""

    text: str = ""
    cursor: int = 0
    past: list[str] = field(default_factory=lambda: list(EXAMPLES))
    """What Up and Down bring."""
    place: int = 0
    selected: bool = False
    """Whether the first character typed takes the place of all that is there."""
    error: FormulaError | None = None

    def begin(self, text: str, error: FormulaError | None = None) -> None:
        """Edit a text, the cursor at its end or where it goes wrong."""
        self.text, self.error, self.selected = text, error, error is None
        self.cursor = len(text) if error is None else min(error.column, len(text))

    def press(self, key: int) -> None:
        """Obey a key; one that is a character is typed."""
        typed = SPACE <= key < EXTENDED
        if self.selected and (typed or key in (BACKSPACE, DELETE)):
            self.text, self.cursor = "", 0
        self.selected = False
        before, after = self.text[: self.cursor], self.text[self.cursor :]
        if key in (UP, DOWN):
            self.place = (self.place + (1 if key == DOWN else -1)) % len(self.past)
            self.begin(self.past[self.place])
        elif key in (LEFT, RIGHT, HOME, END):
            steps = {LEFT: -1, RIGHT: 1, HOME: -LONGEST, END: LONGEST}
            self.cursor = min(max(self.cursor + steps[key], 0), len(self.text))
        elif key == BACKSPACE:
            self.text, self.cursor = before[:-1] + after, max(self.cursor - 1, 0)
        elif key == DELETE:
            self.text = before + after[1:]
        elif typed and len(self.text) < LONGEST:
            self.text = before + bytes([key]).decode("cp437") + after
            self.cursor += 1

    def keep(self) -> None:
        """Remember the text for Up and Down."""
        self.past = [text for text in self.past if text != self.text] + [self.text]
        self.place = 0

    def draw(self) -> None:
        """The line with its cursor; below it what is wrong, or what may be written."""
        room = WIDE - 5
        start = max(0, self.cursor - room)
        shown = self.text[start : start + room + 1]
        left, top = MARGIN + 8 * 4, _row(0)
        if self.selected and shown:
            setfillstyle(SOLID_FILL, BLUE)
            bar(left, top - 2, left + 8 * len(shown) - 1, top + 8)
        _write(0, f"z = {shown}", WHITE)
        left += 8 * (self.cursor - start)
        setfillstyle(SOLID_FILL, YELLOW)
        bar(left, top + 8, left + 7, top + 9)
        if self.error is None:
            words = " ".join(("Enter draws it, Esc leaves, ↑ ↓ examples:", *NAMES, *FUNCTIONS))
            _paragraph(2, words, LIGHTGRAY)
        else:
            caret = self.error.caret[start:][: room + 1]
            _write(1, f"    {caret}", LIGHTRED)
            _paragraph(2, self.error.problem, LIGHTRED)


class Explorer:
    """What is on the screen, and what the keys do to it."""

    def __init__(self, text: str = EXAMPLES[0]) -> None:
        self.text = text
        self.view = View()
        self.editor = Editor()
        self.editing = False
        self.running = True
        self.saving = False
        self.note = ""
        self.width, self.height = getmaxx() + 1, getmaxy() + 1 - PANEL
        self.cross = self.width // 2, self.height // 2
        self.enter(text)

    def enter(self, text: str) -> None:
        """Take a text as the formula; if it is none, say so and go on editing."""
        try:
            formula(text)
        except FormulaError as error:
            self.editing = True
            self.editor.begin(error.text, error)
        else:
            self.editing = False
            self.text = self.editor.text = " ".join(text.split())
            self.editor.keep()

    def press(self, key: int) -> None:
        """Obey one key."""
        self.note = ""
        if self.editing and key == ENTER:
            self.enter(self.editor.text)
        elif self.editing and key == ESC:
            self.editing = False
        elif self.editing:
            self.editor.press(key)
        elif key in VIEW_KEYS:
            VIEW_KEYS[key](self.view)
        elif key in CROSS_KEYS:
            (x, y), (dx, dy) = self.cross, CROSS_KEYS[key]
            self.cross = min(max(x + dx, 0), self.width - 1), min(max(y + dy, 0), self.height - 1)
        elif key == ENTER:
            self.editing = True
            self.editor.begin(self.text)
        elif key == SPACE:
            self.view.spinning = not self.view.spinning
        elif key == HOME:
            self.view = View()
        elif key == F2:
            self.saving = True
        elif key == ESC:
            self.running = False

    @np.errstate(all="ignore")  # formulas may be as wild as they like
    def draw(self) -> None:
        """One picture, on the page that is not shown."""
        cleardevice()
        setviewport(0, 0, self.width - 1, self.height - 1, 1)
        plot: Plot | None = None
        problem = ""
        try:
            plot = self.view.show(self.text)
        except ValueError as error:
            problem = str(error).splitlines()[0]
        if self.saving:
            self.save()
        self._cross()
        setviewport(0, 0, getmaxx(), getmaxy(), 1)
        line(0, self.height, getmaxx(), self.height, DARKGRAY)
        if self.editing:
            self.editor.draw()
            return
        point = plot.pick(*self.cross) if plot is not None else None
        read = "x {:9.4f}   y {:9.4f}   z {:9.4f}".format(*point) if point else "beside the surface"
        _write(0, problem[:WIDE] or read, LIGHTRED if problem else YELLOW)
        _write(1, self.note or str(self.view), LIGHTGREEN if self.note else LIGHTCYAN)
        setfillstyle(SOLID_FILL, LIGHTGRAY)
        bar(0, _row(3) - 5, getmaxx(), getmaxy())
        for row, text in enumerate(KEYS, 3):
            _write(row, text, BLACK)

    def save(self) -> None:
        """Write the picture, without what stands below it, to a new file."""
        self.saving = False
        try:
            file = next(file for file in _names() if not file.exists())
            writeimagefile(file, 0, 0, self.width - 1, self.height - 1)
            self.note = f"saved as {file}"
        except OSError as error:
            self.note = f"not saved: {error.strerror}"

    def _cross(self) -> None:
        """The cross-hair: white on black, to be seen on any colour."""
        x, y = self.cross
        for color, width in ((BLACK, THICK_WIDTH), (WHITE, NORM_WIDTH)):
            setlinestyle(SOLID_LINE, 0, width)
            for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                line(x + 3 * dx, y + 3 * dy, x + 10 * dx, y + 10 * dy, color)


def _names() -> Iterator[Path]:
    return (Path(f"explore-{number:03}.png") for number in count(1))


def _row(number: int) -> int:
    """The top of a line of text below the picture."""
    return getmaxy() + 1 - PANEL + MARGIN + ROW * number


def _write(row: int, text: str, color: int) -> None:
    setcolor(color)
    outtextxy(MARGIN, _row(row), text)


def _paragraph(row: int, text: str, color: int) -> None:
    for number, part in enumerate(wrap(text, WIDE)[: ROWS - row]):
        _write(row + number, part, color)


def read_key() -> int:
    """The next key, those without a character from EXTENDED on."""
    return getch() or EXTENDED + getch()


def draw() -> None:
    """A surface with the cross-hair on it."""
    Explorer("sin(2*r)*cos(theta*2)").draw()


def main(formula: str = EXAMPLES[0]) -> None:
    """Explore until Esc, beginning with a formula."""
    initgraph(*MODE)
    setactivepage(1)
    explorer = Explorer(formula)
    while explorer.running:
        explorer.draw()
        swapbuffers()
        if explorer.view.spinning:
            explorer.view.spin.value += 1
        # A spinning surface only looks whether a key waits; one at rest waits for a key.
        if kbhit() or not explorer.view.spinning:
            explorer.press(read_key())


if __name__ == "__main__":
    main(*sys.argv[1:2])
