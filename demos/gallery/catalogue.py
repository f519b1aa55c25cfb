"""The demos in this folder: what each is called, what it says of itself, how it runs and looks."""

import ast
import os
import runpy
import subprocess
import sys
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

from bgi import VGA, VGAHI, readimagefile
from bgi.memory import imagefile

FOLDER = Path(__file__).parents[1]
MOMENT = "0.6s"
"""How long a plain program runs until its picture is taken."""


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

    def _draw_what_it_shows(self) -> None:
        """Let it run for a moment where nobody looks, and show what it has drawn by then."""
        own = {name: value for name, value in os.environ.items() if not name.startswith("BGI_")}
        with TemporaryDirectory() as folder:
            picture = Path(folder) / "picture.png"
            plan = {"BGI_MONITOR": "none", "BGI_AFTER": MOMENT, "BGI_SHOT": str(picture)}
            command = [sys.executable, "-m", "bgi", str(self.file)]
            subprocess.run(command, env=own | plan, check=True)
            height, width = imagefile.load(picture).pixels.shape[:2]
            readimagefile(picture, 0, 0, width - 1, height - 1)

    def _paragraph(self, number: int) -> str:
        docstring = ast.get_docstring(ast.parse(self._text)) or ""
        return " ".join(docstring.split("\n\n")[number].split())

    @property
    def _text(self) -> str:
        return self.file.read_text("utf-8")


_DEMOS = {demo.name: demo for demo in map(Demo, sorted(FOLDER.glob("[0-9][0-9]_*.py")))}
NAMES = tuple(_DEMOS)
"""What the demos are called, in the order in which to learn from them."""


def load(name: str) -> Demo:
    """The demo of that name."""
    return _DEMOS[name]
