"""`python -m bgi`: programs run with keys, pictures and an end that nobody has to wait for."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from bgi.memory.sdl import pygame
from tests.processes import PATIENCE

HOME = Path(__file__).resolve().parents[2]

BOUNCE = """
import sys
from bgi import *
from helper import WORDS
print(WORDS, __name__, sys.argv[1:])
initgraph(VGA, VGAHI)
x = 0
while not kbhit():
    cleardevice()
    bar(x, 0, x + 9, 9)
    swapbuffers()
    x += 1
print("pictures:", x, "key:", getch())
closegraph()
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with two files of a program."""
    (tmp_path / "bounce.py").write_text(BOUNCE)
    (tmp_path / "helper.py").write_text("WORDS = 'a helper'")
    return tmp_path


def run(*arguments: str | Path, cwd: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "bgi", *map(str, arguments)],
        cwd=cwd,
        env=os.environ | {"PYTHONPATH": str(HOME)} | variables,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )


def test_a_program_with_keys(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    done = run(
        *("--monitor", "none", folder / "bounce.py", "one", "--keys", "Esc", "--", "--shot"),
        cwd=elsewhere,
    )
    expected = "a helper __main__ ['one', '--shot']\npictures: 0 key: 27\n"
    assert (done.returncode, done.stdout, done.stderr) == (0, expected, "")


def test_two_seconds_that_are_over_at_once(folder: Path) -> None:
    done = run("bounce.py", "--monitor", "none", "--after", "2s", "--shot", "s.png", cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert "pictures" not in done.stdout
    image = pygame.image.load(str(folder / "s.png"))
    bars = [x for x in range(640) if image.get_at((x, 5))[:3] == (255, 255, 255)]
    assert bars == list(range(bars[0], bars[0] + 10))
    assert 115 <= bars[0] <= 120  # sixty pictures a second


def test_without_after_the_picture_is_of_the_end(folder: Path) -> None:
    (folder / "dot.py").write_text(
        "from bgi import *\ninitgraph()\nputpixel(3, 4, RED)\nclosegraph()\n"
    )
    done = run("dot.py", "--monitor", "none", "--shot", "s.png", cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    image = pygame.image.load(str(folder / "s.png"))
    assert image.get_at((3, 4))[:3] == (0xAA, 0, 0)


@pytest.mark.parametrize("monitor", ["none", "window"])
def test_a_recording(folder: Path, monitor: str) -> None:
    pil = pytest.importorskip("PIL.Image", reason="needs Pillow")
    arguments = ["--monitor", monitor, "--after", "500ms", "--record", "r.gif"]
    done = run("bounce.py", *arguments, cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    with pil.open(folder / "r.gif") as gif:
        assert gif.size == (640, 480)
        assert gif.n_frames >= 3


def test_a_window_with_keys_and_a_picture(folder: Path) -> None:
    done = run(*("bounce.py", "--monitor", "window", "--keys", "x", "--shot", "s.png"), cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert "key: 120" in done.stdout
    assert (folder / "s.png").exists()


def test_a_window_that_ends_as_planned(folder: Path) -> None:
    done = run("bounce.py", "--monitor", "window", "--after", "100ms", cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert "pictures" not in done.stdout


@pytest.mark.parametrize(
    ("arguments", "code", "line"),
    [
        (["nothing.py"], 2, "bgi: there is no program nothing.py"),
        ([], 2, "error: which program? Give its file, or --info"),
        (["bounce.py", "--keys", "Foo"], 2, "'Foo' is no key: write"),
        (["bounce.py", "--after", "soon"], 2, "'soon' is no time: write 2s, 2.5s or 500ms"),
        (["bounce.py", "--after=-1s"], 2, "is no time"),
        (["bounce.py", "--monitor", "vga"], 2, "invalid choice: 'vga'"),
        (["wait.py", "--monitor", "none"], 1, "bgi: there is no window to type in"),
    ],
)
def test_what_goes_wrong_is_one_line(
    folder: Path, arguments: list[str], code: int, line: str
) -> None:
    (folder / "wait.py").write_text("from bgi import *\ninitgraph()\ngetch()\n")
    done = run(*arguments, cwd=folder)
    assert done.returncode == code
    assert line in done.stderr.splitlines()[-1]
    assert "Traceback" not in done.stderr


def test_a_programs_own_errors_are_its_own(folder: Path) -> None:
    (folder / "wrong.py").write_text("1 / 0\n")
    done = run("wrong.py", cwd=folder)
    assert done.returncode == 1
    assert done.stderr.endswith("ZeroDivisionError: division by zero\n")
    (folder / "exit.py").write_text("raise SystemExit(7)\n")
    assert run("exit.py", cwd=folder).returncode == 7


def test_info(tmp_path: Path) -> None:
    done = run("--info", cwd=tmp_path, SDL_AUDIODRIVER="dummy")
    assert (done.returncode, done.stderr) == (0, "")
    lines = dict(line.split(maxsplit=1) for line in done.stdout.splitlines())
    assert set(lines) >= {"bgi", "python", "numpy", "pygame", "pillow", "sound"}
    assert "(driver dummy)" in lines["display"]
    assert "TRIP" in lines["fonts"]


def test_info_without_a_display_or_a_sound_card(tmp_path: Path) -> None:
    variables = {"SDL_VIDEODRIVER": "nonsense", "SDL_AUDIODRIVER": "nonsense"}
    done = run("--info", cwd=tmp_path, **variables)
    assert (done.returncode, done.stderr) == (0, "")
    assert "display   none: nonsense not available" in done.stdout
    assert "sound     none" in done.stdout
