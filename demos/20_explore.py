"""Type any formula and walk round its surface.

    python demos/20_explore.py

What it shows: `surfaces.formula` makes a function of what you type, `surfaces.surface` draws it,
and `plot.pick` reads back from any pixel the point (x, y, z) that is seen there. Enter begins a
formula and draws it; if it is none, an arrow shows where it goes wrong.

    Enter     type a formula: Enter draws it, Esc forgets it, ↑ ↓ bring earlier ones
    mouse     the cross-hair; dragged with the left button it turns and tilts the surface, with
              the right one, or the wheel, it comes nearer
    arrows    turn and tilt                  Space    spin        Home   as at the beginning
    + -       larger, smaller                , .      less or more of the plane
    [ ]       the paper's theta              ; '      its rho_z
    Tab       fill, mesh, ...                PgUp PgDn  finer, coarser
    p r c x   projection, ramp, what the colours tell, axes
    z         cut off heights larger than x and y, as near a pole
    w a s d   move the cross-hair; in capitals pixel by pixel
    F2 F3     save the picture as explore-001.png, a full turn as explore-001.gif   Esc    end
"""

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count
from math import inf, radians
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from bgi import *
from bgi import mouse
from gallery.panel import (
    DOWN,
    ENTER,
    ESC,
    F2,
    F3,
    HOME,
    LEFT,
    PAGE_DOWN,
    PAGE_UP,
    PANEL,
    RIGHT,
    SPACE,
    TAB,
    UP,
    WIDE,
    Editor,
    read_key,
    row_top,
    write,
)
from surfaces import MODES, PROJECTIONS, RAMPS, Mapping, Plot, compose, rotation, scaling, surface
from surfaces.animation import PillowMissing, save_gif
from surfaces.formulas import FormulaError, formula
from surfaces.shape.fields import FIELDS

MODE = (IBM8514, IBM8514LO)
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
    "Enter formula  arrows, mouse turn  + - zoom  , . range  [ ] theta  ; ' rho_z",
    "Tab mode  PgUp/Dn n  p view  r ramp  c color  x axes  z cut  F2 PNG F3 GIF Esc",
)
FRAMES, MILLISECONDS = 72, 40
"""Pictures of a full turn, and how long each is shown."""
DRAG = 10
"""Pixels that the mouse is dragged for what one key does."""


@dataclass
class Dial:
    """A number with a step and two ends."""

    value: float
    step: float
    low: float = -inf
    high: float = inf

    def turn(self, steps: float) -> None:
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


class Explorer:
    """What is on the screen, and what keys and mouse do to it."""

    def __init__(self, text: str = EXAMPLES[0]) -> None:
        self.text = text
        self.view = View()
        self.editor = Editor(list(EXAMPLES))
        self.editing = False
        self.running = True
        self.plot: Plot | None = None
        self.picture: Image | None = None
        """The surface as it was drawn; None if that has to be done."""
        self.problem = self.note = ""
        self.width, self.height = getmaxx() + 1, getmaxy() + 1 - PANEL
        self.cross = self.width // 2, self.height // 2
        self.place, self.buttons = mouse.position(), 0
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
            self.picture = None

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
            self.picture = None
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
            self.picture = None
        elif key == F2:
            self.save(".png", self._save_picture)
        elif key == F3:
            self.save(".gif", self._save_turn)
        elif key == ESC:
            self.running = False

    def follow(self) -> bool:
        """Do what the mouse says. Returns whether there is something new to draw."""
        (x, y), clicks = mouse.position(), mouse.wheel()
        across, down = x - self.place[0], y - self.place[1]
        # What was held before too: the way to where a button goes down is no dragging.
        held = mouse.buttons() & self.buttons
        self.place, self.buttons = (x, y), mouse.buttons()
        if self.editing or not (across or down or clicks):
            return False
        if held & 1:
            self.view.spin.turn(across / DRAG)
            self.view.tilt.turn(down / DRAG)
        elif held & 2:
            self.view.zoom.turn(-down / DRAG)
        self.view.zoom.turn(-clicks)
        if held or clicks:
            self.picture = None
        if y < self.height:
            self.cross = x, y
        return True

    def wait(self) -> None:
        """Until a key or the mouse asks for a new picture; a spinning surface does not wait."""
        while not (kbhit() or self.follow() or self.view.spinning):
            delay(10)
        if self.view.spinning:
            self.view.spin.value += 1
            self.picture = None
        if kbhit():
            self.press(read_key())

    def draw(self) -> None:
        """All that is to be seen, on the page that is not shown."""
        self.show_surface()
        self._cross()
        line(0, self.height, getmaxx(), self.height, DARKGRAY)
        if self.editing:
            self.editor.draw()
            return
        point = self.plot.pick(*self.cross) if self.plot is not None else None
        read = "x {:9.4f}   y {:9.4f}   z {:9.4f}".format(*point) if point else "beside the surface"
        write(0, self.problem[:WIDE] or read, LIGHTRED if self.problem else YELLOW)
        write(1, self.note or str(self.view), LIGHTGREEN if self.note else LIGHTCYAN)
        setfillstyle(SOLID_FILL, LIGHTGRAY)
        bar(0, row_top(3) - 5, getmaxx(), getmaxy())
        for row, text in enumerate(KEYS, 3):
            write(row, text, BLACK)

    def show_surface(self) -> None:
        """The surface alone; under a moving cross-hair it need not be drawn anew."""
        if self.picture is None:
            self.picture = self._draw_surface()
        cleardevice()
        putimage(0, 0, self.picture, COPY_PUT)

    @np.errstate(all="ignore")  # formulas may be as wild as they like
    def _draw_surface(self) -> Image:
        cleardevice()
        setviewport(0, 0, self.width - 1, self.height - 1, 1)
        self.plot, self.problem = None, ""
        try:
            self.plot = self.view.show(self.text)
        except ValueError as error:
            self.problem = str(error).splitlines()[0]
        setviewport(0, 0, getmaxx(), getmaxy(), 1)
        return getimage(0, 0, self.width - 1, self.height - 1)

    def save(self, ending: str, write_it: Callable[[Path], None]) -> None:
        """Write to a file that is not there yet."""
        file = next(file for file in _names(ending) if not file.exists())
        try:
            write_it(file)
            self.note = f"saved as {file}"
        except OSError as error:
            self.note = f"not saved: {error.strerror}"
        except PillowMissing as error:
            self.note = str(error)

    def _save_picture(self, file: Path) -> None:
        self.show_surface()
        writeimagefile(file, 0, 0, self.width - 1, self.height - 1)

    def _save_turn(self, file: Path) -> None:
        with TemporaryDirectory() as folder:
            save_gif(file, self._turn(Path(folder) / "picture.png"), MILLISECONDS)

    def _turn(self, file: Path) -> Iterator[Path]:
        """The pictures of a turn about z, each written to the same file; a key ends it early."""
        for number in range(1, FRAMES + 1):
            self.view.spin.value += 360 / FRAMES
            self.picture = None
            self._save_picture(file)
            self.note = f"drawing {number} of {FRAMES}; a key ends it"
            self.draw()
            swapbuffers()
            yield file
            if kbhit():
                read_key()
                break

    def _cross(self) -> None:
        """The cross-hair: white on black, to be seen on any colour."""
        x, y = self.cross
        setviewport(0, 0, self.width - 1, self.height - 1, 1)
        for color, width in ((BLACK, THICK_WIDTH), (WHITE, NORM_WIDTH)):
            setlinestyle(SOLID_LINE, 0, width)
            for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                line(x + 3 * dx, y + 3 * dy, x + 10 * dx, y + 10 * dy, color)
        setviewport(0, 0, getmaxx(), getmaxy(), 1)


def _names(ending: str) -> Iterator[Path]:
    return (Path(f"explore-{number:03}{ending}") for number in count(1))


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
        explorer.wait()


if __name__ == "__main__":
    main(*sys.argv[1:2])
