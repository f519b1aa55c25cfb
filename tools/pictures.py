"""Draw every picture of the documentation.

    python -m tools.pictures [folder]

A picture on a page belongs to the block of code just before it, and is what that block leaves on
the screen: so a page cannot show what its code does not draw. A demo's picture is the one in the
gallery; one is recorded while it moves; that of a lesson's program is kept for its test only.
tests/test_docs.py and tests/course/ draw them all again and compare.
"""

import importlib
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

import bgi
import demos  # noqa: F401  (with it, its helpers are found)
from bgi import current
from bgi.monitor.picture import shot
from gallery.catalogue import C_NAMES, NAMES, load

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PICTURES = DOCS / "pictures"
COURSE = ROOT / "demos" / "course"
LESSONS = sorted(COURSE.glob("[0-9][0-9]_*.py"))
LESSONS_PICTURES = ROOT / "tests" / "course" / "pictures"
# What is pressed for each block that asks for keys, and a number for one that scans.
KEYS = "a Left Up Space Wait1s +Esc Wait9s -Esc 7 Enter"
TYPED = "7 Space 6 Enter 3 Space 4 Enter"  # the same where words are typed
LEAST_WIDTH, MARGIN = 400, 12
# What is pressed in a lesson's program, where it is more than the key that ends it.
LESSON_KEYS = {
    "02_lines": "Up Up Up Up Up Up Up Up Left Left x Esc",
    "03_circles": "Up Up Space Esc",
    "04_polygons": "x x x x x x x x x x x x x x x Esc x",
    "05_filling": "1 2 3 Esc",
    "06_clipping": "Left Left Left Left - Down Down Down Esc",
    "07_transformations": "Right Right Right R + r m Esc",
    "08_curves": "+ 2 Right Up b - b + Esc",
    "09_colours": "4 p Esc",
    "10_animation": "Wait1s d w Wait1s t Wait500ms Esc",
    "11_sprites": "Right m Right Right Down m Left Esc",
    "12_space": "Right Right Right + p Down p Right Down - Esc",
    "13_hidden": "2 3 4 Esc",
    "14_fractals": "+ 2 + 3 - 4 Esc",
    "15_game": "+Space Wait100ms -Space Wait2s +Right Wait300ms -Right Wait2s +Esc",
}
MOVING = "bounce"
SECONDS = "2.4s"  # as much as fits into half a megabyte

# What a page says of its code, and so how its blocks are run.
ON_A_SCREEN = "follows `from bgi import *` and `initgraph(VGA, VGAHI)`"
ON_TEXT = re.compile(r"follows\s+`from bgi\.(conio|stdio|stdlib) import \*`")
IN_ORDER = "type them one after the other"
NAMES_STAY = re.compile(r"what an earlier piece\s+defines, a later one knows")

_BLOCK = re.compile(
    r"^```python\n(?P<code>.*?)^```\n"  # a block of code
    r"(?:\n!\[[^]]*\]\((?:\.\./)?pictures/(?P<picture>[\w-]+\.png)\))?",  # perhaps its picture
    re.DOTALL | re.MULTILINE,
)

sys.path.append(str(COURSE))  # the code of a lesson's page finds squares.py as its programs do


def texts() -> list[Path]:
    """The pages, and those of the course."""
    return [*sorted(DOCS.glob("*.md")), *sorted(DOCS.glob("course/*.md"))]


def pages() -> list[Path]:
    """The pages that hold code."""
    return [page for page in texts() if "```python" in page.read_text("utf-8")]


def blocks(page: Path) -> Iterator[tuple[str, str | None]]:
    """The blocks of code of a page, each with the name of its picture if it has one.

    Empty lines stand before the code, so that an error names the line of the page.
    """
    text = page.read_text("utf-8")
    for found in _BLOCK.finditer(text):
        above = text.count("\n", 0, found.start("code"))
        yield "\n" * above + found["code"], found["picture"]


def draw_page(page: Path, folder: Path) -> list[str]:
    """Run all code of a page and save the pictures it draws; returns their names.

    Blocks begin anew with what the page says they follow, or go on from the block before. Files
    that they write are left in a folder of their own, which goes.
    """
    text = page.read_text("utf-8")
    names: dict[str, Any] = {}
    drawn = []
    os.environ["BGI_KEYS"] = TYPED if ON_TEXT.search(text) else KEYS
    for code, picture in blocks(page):
        if IN_ORDER not in text:
            current.close_screen()
            names = names if NAMES_STAY.search(text) else {}
        if header := ON_TEXT.search(text):
            names = star(header[1])
        if ON_A_SCREEN in text:
            names |= {name: getattr(bgi, name) for name in bgi.__all__}
            bgi.initgraph(bgi.VGA, bgi.VGAHI)
        with TemporaryDirectory() as elsewhere, chdir(elsewhere):
            exec(compile(code, page, "exec"), names)
        if picture is not None:
            _save(folder / picture, whole=IN_ORDER in text)
            drawn.append(picture)
    current.close_screen()
    return drawn


def star(name: str) -> dict[str, Any]:
    """What `from bgi.NAME import *` brings."""
    module = importlib.import_module(f"bgi.{name}")
    return {word: getattr(module, word) for word in module.__all__}


def draw_demo(name: str, folder: Path) -> list[str]:
    """Save a demo's picture; returns its name."""
    demo = load(name)
    bgi.initgraph(*demo.mode)
    demo.draw()
    _save(folder / f"{name}.png", whole=True)
    bgi.closegraph()
    return [f"{name}.png"]


def shoot_program(name: str, folder: Path) -> list[str]:
    """Save the picture of a program in C; returns its name."""
    load(name).save(folder / f"{name}.png")
    return [f"{name}.png"]


def shoot_lesson(program: Path, folder: Path) -> str:
    """Save what the program of a lesson leaves on the screen; returns what it said by mistake."""
    own = {name: value for name, value in os.environ.items() if not name.startswith("BGI_")}
    shot = folder / f"{program.stem}.png"
    plan = {"BGI_MONITOR": "none", "BGI_KEYS": LESSON_KEYS.get(program.stem, "x")}
    command = [sys.executable, "-m", "bgi", "--shot", str(shot), str(program)]
    path = {"PYTHONPATH": str(ROOT)}
    ran = subprocess.run(command, env=own | plan | path, capture_output=True, text=True)
    return ran.stdout + ran.stderr.replace(f"bgi: {shot} was written\n", "")


def record_demo(folder: Path) -> list[str]:
    """Record the demo that the README shows moving; needs Pillow. Returns the recording's name."""
    name = f"{MOVING}.gif"
    options = ["--monitor", "none", "--keys", "", "--after", SECONDS]
    program = str(load(MOVING).file)
    command = [sys.executable, "-m", "bgi", *options, "--record", str(folder / name), program]
    subprocess.run(command, cwd=ROOT, check=True)
    return [name]


def _save(file: Path, whole: bool) -> None:
    """Save the page that is shown: the whole of it, or as far as something is drawn."""
    if current.crt is not None and current.crt.is_text:
        frame = current.crt.card.frame()
        assert frame is not None
        file.write_bytes(shot(frame, current.crt.card.palette.tobytes()))
        return
    bgi.setactivepage(bgi.getvisualpage())
    if whole:
        bgi.writeimagefile(file)
        return
    down, across = np.nonzero(current.screen.page.array)
    right = max(LEAST_WIDTH - 1, int(across.max()) + MARGIN)
    bgi.writeimagefile(file, 0, 0, right, int(down.max()) + MARGIN)


def main(folder: Path = PICTURES) -> None:
    """Draw all pictures."""
    os.environ.update(BGI_MONITOR="none", BGI_KEYS=KEYS)
    drawn = [name for page in pages() for name in draw_page(page, folder)]
    drawn += [name for demo in NAMES for name in draw_demo(demo, folder)]
    drawn += [name for program in C_NAMES for name in shoot_program(program, folder)]
    drawn += record_demo(folder)
    if folder == PICTURES:
        for program in LESSONS:
            shoot_lesson(program, LESSONS_PICTURES)
    print(f"{len(drawn)} pictures")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
