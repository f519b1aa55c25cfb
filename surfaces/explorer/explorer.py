"""Walk round the surface of a formula: what is on the screen, and what keys and mouse do to it."""

from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import replace
from functools import partial
from pathlib import Path

from bgi import LIGHTCYAN, LIGHTGREEN, LIGHTRED, YELLOW, kbhit, swapbuffers
from surfaces.animation import save_gif
from surfaces.explorer import motion, panel
from surfaces.explorer.canvas import Canvas
from surfaces.explorer.dials import TILT, TURN, ZOOM, Dial, Switch
from surfaces.explorer.editor import Editor
from surfaces.explorer.helppage import show_help
from surfaces.explorer.keys import (
    CROSS,
    DIALS,
    ENTER,
    ESC,
    F1,
    F2,
    F3,
    HINTS,
    HOME,
    SPACE,
    read_key,
)
from surfaces.explorer.options import Options
from surfaces.explorer.saving import save
from surfaces.explorer.status import read_out, status
from surfaces.formulas import FormulaError, formula

EXAMPLES = (
    "sin(x*y)/2",
    "sinc(4*r)",
    "(x^3 - 3*x*y^2)/9",
    "cos(3*theta)*r",
    "sin(3*x)*cos(3*y)*exp(-r/2)",
    "sqrt(9 - r^2)",
    "where(r < 2, cos(pi*r), 1)",
)
"""Formulas to begin with."""
FRAMES, MILLISECONDS = 72, 40
"""Pictures of a full turn, and how long each is shown."""
DRAG = 10
"""Pixels that the mouse is dragged for what one key does."""
ZOOMED = 2
"""A picture that turns has much room around it; it begins so many steps larger."""


class Explorer:
    """A formula, the options it is drawn with, and what is going on around it."""

    def __init__(self, text: str = EXAMPLES[0], options: Options | None = None) -> None:
        """Begin on the screen that is open; FormulaError if the text is no formula."""
        self.home = replace(options or Options(), turns=True, zoom=ZOOMED)
        self.options = copy(self.home)
        self.canvas, self.tracker = Canvas(), motion.Tracker()
        self.editor = Editor(list(EXAMPLES))
        self.editing = self.helping = self.spinning = False
        self.running = True
        self.note = ""
        self._take(text)
        self.actions: dict[int, Callable[[], None]] = {
            **{key: partial(self.turn, dial, steps) for key, (dial, steps) in DIALS.items()},
            **{key: partial(self.move_cross, dx, dy) for key, (dx, dy) in CROSS.items()},
            ENTER: self.edit,
            SPACE: self.spin,
            HOME: self.go_home,
            F1: self.help,
            F2: self.save_picture,
            F3: self.save_turn,
            ESC: self.end,
        }

    def press(self, key: int) -> None:
        """Obey one key; one that means nothing does nothing."""
        if self.editing:
            self._type(key)
        elif self.helping:
            self.helping = False
        elif key in self.actions:
            self.note = ""
            self.actions[key]()

    def _type(self, key: int) -> None:
        if key == ENTER:
            self.enter(self.editor.text)
        elif key == ESC:
            self.editing = False
        else:
            self.editor.press(key)

    def enter(self, text: str) -> None:
        """Take a text as the formula; if it is none, say so and go on editing."""
        try:
            self._take(text)
            self.options.title = self.home.title = ""  # it was the other formula's
            self.editing = False
        except FormulaError as error:
            self.edit(error)

    def _take(self, text: str) -> None:
        formula(text)
        self.text = self.editor.text = " ".join(text.split())
        self.editor.keep()
        self.canvas.changed()

    def edit(self, error: FormulaError | None = None) -> None:
        """Begin to type a formula."""
        self.editing = True
        self.editor.begin(error.text if error else self.text, error)

    def turn(self, dial: Dial | Switch, steps: float) -> None:
        """Change one of the options."""
        dial.turn(self.options, steps)
        self.canvas.changed()

    def move_cross(self, dx: int, dy: int) -> None:
        """Move the cross-hair by so many pixels."""
        x, y = self.canvas.cross
        self.canvas.move_cross(x + dx, y + dy)

    def spin(self) -> None:
        """Turn on and on, or stop."""
        self.spinning = not self.spinning

    def go_home(self) -> None:
        """Everything as at the beginning, but for the formula."""
        self.options = copy(self.home)
        self.spinning = False
        self.canvas.changed()

    def help(self) -> None:
        """Show all the keys."""
        self.helping = True

    def end(self) -> None:
        """Explore no more."""
        self.running = False

    def follow(self) -> bool:
        """Do what the mouse says. Returns whether there is something new to draw."""
        moved = self.tracker.look()
        if self.editing or self.helping or not moved:
            return False
        if moved.held & motion.LEFT:
            self.turn(TURN, moved.across / DRAG)
            self.turn(TILT, moved.down / DRAG)
        elif moved.held & motion.RIGHT:
            self.turn(ZOOM, -moved.down / DRAG)
        if moved.clicks:
            self.turn(ZOOM, -moved.clicks)
        if moved.y < self.canvas.height:
            self.canvas.move_cross(moved.x, moved.y)
        return True

    def draw(self) -> None:
        """All that is to be seen, on the page that is drawn on."""
        if self.helping:
            show_help()
            return
        self.canvas.show(self.text, self.options)
        self.canvas.show_cross()
        panel.rule()
        if self.editing:
            self.editor.draw()
            return
        problem, (first, second) = self.canvas.problem, status(self.options)
        panel.write(0, problem or read_out(self.canvas.point()), LIGHTRED if problem else YELLOW)
        panel.write(1, first, LIGHTCYAN)
        panel.write(2, self.note or second, LIGHTGREEN if self.note else LIGHTCYAN)
        panel.hints(HINTS)

    def save_picture(self) -> None:
        """Write the surface, without the cross-hair, to a file."""
        self.note = save(".png", self._write_picture)

    def _write_picture(self, file: Path) -> None:
        self.canvas.show(self.text, self.options)
        self.canvas.save(file)

    def save_turn(self) -> None:
        """Write a full turn to a file."""
        self.note = save(".gif", self._write_turn)

    def _write_turn(self, file: Path) -> None:
        from tempfile import TemporaryDirectory  # late, as most users need it never

        with TemporaryDirectory() as folder:
            save_gif(file, self._pictures(Path(folder) / "picture.png"), MILLISECONDS)

    def _pictures(self, file: Path) -> Iterator[Path]:
        """The pictures of a turn about z, each written to the same file; a key ends it early."""
        for number in range(1, FRAMES + 1):
            self.turn(TURN, 360 / FRAMES / TURN.step)
            self._write_picture(file)
            self.note = f"drawing {number} of {FRAMES}; a key ends it"
            self.draw()
            swapbuffers()
            yield file
            if kbhit():
                read_key()
                break
