"""Record the programs of the course while they run: moving pictures for slides.

    python -m tools.slides [folder]

Each program becomes a GIF, such as 05_filling.gif, in which the keys are pressed that draw its
picture, with time to look between them. Needs Pillow.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from tools import pictures

HELD = re.compile(r"Wait|[+-].")
"""A word that has a time of its own: a wait, or a key that is held or let go."""
PAUSE = "Wait700ms"
"""Before each key that is pressed and let go at once."""
END = "Wait2s"
"""Before the last one."""


def keys(program: Path) -> str:
    """What is pressed, and when."""
    *words, last = pictures.LESSON_KEYS.get(program.stem, "x").split()
    paused = [w if HELD.match(w) else f"{PAUSE} {w}" for w in words]
    return " ".join([*paused, END, last])


def record(program: Path, folder: Path) -> Path:
    """Record a program; returns the GIF."""
    file = folder / f"{program.stem}.gif"
    options = ["--monitor", "none", "--keys", keys(program), "--record", str(file)]
    command = [sys.executable, "-m", "bgi", *options, str(program)]
    path = {"PYTHONPATH": str(pictures.ROOT)}
    subprocess.run(command, env=os.environ | path, check=True, stderr=subprocess.DEVNULL)
    return file


def main(folder: Path = Path("slides")) -> None:
    """Record all of them."""
    folder.mkdir(parents=True, exist_ok=True)
    for program in pictures.LESSONS:
        file = record(program, folder)
        print(f"{file}: {file.stat().st_size:,} bytes")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
