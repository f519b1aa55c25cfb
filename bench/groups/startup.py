"""What a fresh Python takes until something is there: how long one waits, for all processes."""

import importlib.util
import os
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from bench.libraries import LIBRARY, libraries
from bench.processes import wall_seconds
from bench.timing import OURS, Row, Task
from bgi.machine import display_exists

DRAWN = "circle(320, 240, 100); swapbuffers(); closegraph()"
HELLO = f"from bgi import *; initgraph(VGA, VGAHI); {DRAWN}"
SDL_HELLO = f"from sdl_bgi import *; initgraph(SDL, SDL_640x480); {DRAWN}"
PLOT = "-m", "surfaces", "sin(x*y)/2", "-o"


def _settings(more: Mapping[str, str]) -> dict[str, str]:
    """The environment of a program that finds its modules compiled, as installed ones are."""
    settings = {**os.environ, **more}
    settings.pop("PYTHONDONTWRITEBYTECODE", None)
    if LIBRARY in os.environ:  # where SDL_bgi's module looks for it
        settings["LD_LIBRARY_PATH"] = str(Path(os.environ[LIBRARY]).resolve().parent)
    return settings


def python(source: str, environment: Mapping[str, str] | None = None) -> Task:
    """Time a fresh interpreter with a program."""
    settings = _settings(environment or {})
    return lambda _: wall_seconds([sys.executable, "-c", source], settings)


def plot(_: int) -> float:
    """Time `python -m surfaces`."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, *PLOT, str(Path(folder) / "picture.png")]
        return wall_seconds(command, _settings({}))


def rows() -> list[Row]:
    """The rows of this group."""
    dummy = {"SDL_VIDEODRIVER": "dummy"}
    window = {"BGI_MONITOR": "window"} | ({} if display_exists() else dummy)
    tasks: dict[str, dict[str, Task]] = {
        "import bgi": {OURS: python("import bgi"), "pygame": python("import numpy, pygame")},
        "first picture, no window": {OURS: python(HELLO, {"BGI_MONITOR": "none"})},
        "first picture in a window": {OURS: python(HELLO, window)},
        "python -m surfaces, to a file": {OURS: plot},
    }
    if libraries()["SDL_bgi"]:
        tasks["import bgi"]["SDL_bgi"] = python("import sdl_bgi")
        tasks["first picture, no window"]["SDL_bgi"] = python(SDL_HELLO, dummy)
        tasks["first picture in a window"]["SDL_bgi"] = python(SDL_HELLO, window)
    if importlib.util.find_spec("matplotlib"):
        tasks["import bgi"]["matplotlib"] = python("import matplotlib.pyplot")
    return [Row("startup", name, each) for name, each in tasks.items()]
