"""The demos in this folder: what each is called, what it says of itself, how it runs and looks."""

import ast
import os
import re
import runpy
import subprocess
import sys
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

from bgi import VGA, VGAHI, initgraph, readimagefile, writeimagefile
from bgi.memory import imagefile
from bgi.turboc.command import run_c

FOLDER = Path(__file__).parents[1]
NO_KEY = "Wait3600s x"
"""The keys of a program whose picture is taken: it begins at noon, and nobody ends it."""

MOMENTS = {"CLOCK.C": "637s", "SNAKE.C": "2s", "SHAPES.CPP": "1s"}
"""How long plain programs run until their picture is taken, where it is not 0.6 s."""


@dataclass(frozen=True)
class Demo:
    """A program in the folder: 02_ball.py is the demo called ball."""

    file: Path

    @property
    def name(self) -> str:
        """What it is called: its file without the number."""
        return self.file.stem.partition("_")[2]

    @property
    def summary(self) -> str:
        """What it is, in one line."""
        return self._paragraph(0)

    @property
    def lesson(self) -> str:
        """What it shows, in a few sentences."""
        return self._paragraph(2).replace("`", "")

    @property
    def plain(self) -> bool:
        """Whether it is a program from top to bottom, without a draw() to call."""
        return "\ndef draw(" not in self._text

    @property
    def moment(self) -> str:
        """How long it runs until its picture is taken, for a plain program."""
        return MOMENTS.get(self.name, "0.6s")

    @property
    def mode(self) -> tuple[int, int]:
        """The driver and the mode that its picture is made for."""
        return (VGA, VGAHI) if self.plain else self.module().MODE

    def module(self) -> ModuleType:
        """What it defines, without running it; not for plain programs."""
        return import_module(self.file.stem)

    def run(self) -> None:
        """Run it as `python FILE` does."""
        sys.argv = [str(self.file)]
        runpy.run_path(str(self.file), run_name="__main__")

    def draw(self) -> None:
        """Draw its picture on the current page."""
        if self.plain:
            self._draw_what_it_shows()
        else:
            self.module().draw()

    def save(self, picture: Path) -> None:
        """Draw it where nobody looks, and write what it drew."""
        initgraph(*self.mode)
        self.draw()
        writeimagefile(picture)

    def _draw_what_it_shows(self) -> None:
        """Show what it has drawn after a moment."""
        with TemporaryDirectory() as folder:
            picture = Path(folder) / "picture.png"
            self.shoot(picture)
            height, width = imagefile.load(picture).pixels.shape[:2]
            readimagefile(picture, 0, 0, width - 1, height - 1)

    def shoot(self, picture: Path) -> None:
        """Let it run for a moment where nobody looks, and write what is on its screen then."""
        own = {name: value for name, value in os.environ.items() if not name.startswith("BGI_")}
        plan = {"BGI_MONITOR": "none", "BGI_KEYS": NO_KEY, "BGI_SHOT": str(picture)}
        command = [sys.executable, "-m", "bgi", "--after", self.moment, str(self.file)]
        subprocess.run(command, env=own | plan, check=True, stderr=subprocess.DEVNULL)

    def _paragraph(self, number: int) -> str:
        docstring = ast.get_docstring(ast.parse(self._text)) or ""
        return " ".join(docstring.split("\n\n")[number].split())

    @property
    def _text(self) -> str:
        return self.file.read_text("utf-8")


class CProgram(Demo):
    """A program for Turbo C, in the folder c: c/CLOCK.C is called CLOCK.C."""

    @property
    def name(self) -> str:
        """What it is called: its file, as DOS wrote it."""
        return self.file.name

    @property
    def plain(self) -> bool:
        """It is a program from top to bottom."""
        return True

    def run(self) -> None:
        """Run it as `python -m bgi FILE` does."""
        run_c(str(self.file))

    def save(self, picture: Path) -> None:
        """Write what is on its screen after a moment, in the size of its mode."""
        self.shoot(picture)

    @property
    def lesson(self) -> str:
        """What it shows, and its keys."""
        return f"{self._paragraph(1)} {self._paragraph(2)}"

    def _paragraph(self, number: int) -> str:
        """A paragraph of the comment at its head, without its name."""
        head = re.split(r"\*/|\n#", self._text)[0]
        text = re.sub(r"(?m)^(/\*|//)? *", "", head).split("\n\n")[number]
        text = " ".join(text.split()).removeprefix(f"{self.name}: ")
        return text[:1].upper() + text[1:]


_DEMOS = {demo.name: demo for demo in map(Demo, sorted(FOLDER.glob("[0-9][0-9]_*.py")))}
_IN_C = {demo.name: demo for demo in map(CProgram, sorted((FOLDER / "c").glob("*.C*")))}

NAMES = tuple(_DEMOS)
"""What the demos are called, in the order in which to learn from them."""

C_NAMES = tuple(_IN_C)
"""What the programs in C are called."""


def load(name: str) -> Demo:
    """The demo or the program in C of that name."""
    return (_DEMOS | _IN_C)[name]
