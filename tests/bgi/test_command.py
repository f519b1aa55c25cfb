"""`python -m bgi`: programs run with keys, pictures and an end that nobody has to wait for."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import bgi
from bgi.memory.sdl import pygame
from tests.processes import KILL, PATIENCE, posix
from tests.skips import needs_pygame

pytestmark = needs_pygame  # most of it is about windows

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


def written(file: Path) -> str:
    """What the command says at the end."""
    return f"bgi: {file} was written\n"


def test_a_program_with_keys(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    program = [folder / "bounce.py", "one", "--shot", "--", "-x"]
    done = run("--monitor", "none", "--keys", "Esc", *program, cwd=elsewhere)
    expected = "a helper __main__ ['one', '--shot', '--', '-x']\npictures: 0 key: 27\n"
    assert (done.returncode, done.stdout, done.stderr) == (0, expected, "")


def test_two_seconds_that_are_over_at_once(folder: Path) -> None:
    done = run("--monitor", "none", "--after", "2s", "--shot", "s.png", "bounce.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, written(folder / "s.png"))
    assert "pictures" not in done.stdout
    image = pygame.image.load(str(folder / "s.png"))
    bars = [x for x in range(640) if image.get_at((x, 5))[:3] == (255, 255, 255)]
    assert bars == list(range(bars[0], bars[0] + 10))
    assert 115 <= bars[0] <= 120  # sixty pictures a second


@pytest.mark.parametrize("monitor", ["none", "window"])
def test_a_key_that_comes_later(folder: Path, monitor: str) -> None:
    done = run("--monitor", monitor, "--keys", "Wait300ms x", "bounce.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert "key: 120" in done.stdout
    assert "pictures: 0 " not in done.stdout


def test_without_after_the_picture_is_of_the_end(folder: Path) -> None:
    (folder / "dot.py").write_text(
        "from bgi import *\ninitgraph()\nputpixel(3, 4, RED)\nclosegraph()\n"
    )
    done = run("--monitor", "none", "--shot", "s.png", "dot.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, written(folder / "s.png"))
    image = pygame.image.load(str(folder / "s.png"))
    assert image.get_at((3, 4))[:3] == (0xAA, 0, 0)


@pytest.mark.parametrize("monitor", ["none", "window"])
def test_a_recording(folder: Path, monitor: str) -> None:
    pil = pytest.importorskip("PIL.Image", reason="needs Pillow")
    options = ["--monitor", monitor, "--after", "500ms", "--record", "r.gif"]
    done = run(*options, "bounce.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, written(folder / "r.gif"))
    with pil.open(folder / "r.gif") as gif:
        assert gif.size == (640, 480)
        assert gif.n_frames >= 3


def test_a_window_with_keys_and_a_picture(folder: Path) -> None:
    done = run("--monitor", "window", "--keys", "x", "--shot", "s.png", "bounce.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, written(folder / "s.png"))
    assert "key: 120" in done.stdout
    assert (folder / "s.png").exists()


def test_a_window_that_ends_as_planned(folder: Path) -> None:
    done = run("--monitor", "window", "--after", "100ms", "bounce.py", cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert "pictures" not in done.stdout


@pytest.mark.parametrize(
    ("arguments", "code", "line"),
    [
        (["nothing.py"], 2, "bgi: there is no program nothing.py"),
        ([], 2, "error: which program? Give its file, or --info"),
        (["--keys", "Foo", "bounce.py"], 2, "'Foo' is not a key: write"),
        (["--after", "soon", "bounce.py"], 2, "'soon' is not a time: write 2s, 2.5s or 500ms"),
        (["--after=-1s", "bounce.py"], 2, "is not a time"),
        (["--monitor", "vga", "bounce.py"], 2, "invalid choice: 'vga'"),
        (["--nonsense", "bounce.py"], 2, "unrecognized arguments: --nonsense"),
        (["--monitor", "none", "wait.py"], 0, "bgi: nobody can press a key here"),
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


@pytest.mark.parametrize("monitor", ["none", "window"])
@pytest.mark.parametrize("option", ["--shot", "--record"])
def test_what_cannot_be_written_is_one_line_and_status_1(
    folder: Path, option: str, monitor: str
) -> None:
    pytest.importorskip("PIL", reason="needs Pillow")
    file = Path("nowhere", "x.gif")
    done = run("--monitor", monitor, "--keys", "x", option, file, "bounce.py", cwd=folder)
    line = f"bgi: {folder / file} was not written: No such file or directory\n"
    assert (done.returncode, done.stderr) == (1, line)
    assert "key: 120" in done.stdout


def test_a_recording_that_goes_with_its_window_is_told(folder: Path) -> None:
    (folder / "lost.py").write_text(
        "import os\nfrom bgi import *\nfrom bgi import current\ninitgraph()\n"
        f"os.kill(current.screen.monitor.pid, {int(KILL)})\ngetch()\n"
    )
    done = run("--monitor", "window", "--record", "x.gif", "lost.py", cwd=folder)
    line = f"{folder / 'x.gif'} was not written: the window's process had ended before"
    assert done.returncode == 1
    assert done.stderr.count("was not written") == done.stderr.count(line) == 1


def test_without_a_screen_there_is_no_picture(folder: Path) -> None:
    (folder / "exit.py").write_text("raise SystemExit(7)\n")
    done = run("--shot", "s.png", "exit.py", cwd=folder)
    line = f"bgi: {folder / 's.png'} was not written: the program opened no screen\n"
    assert (done.returncode, done.stderr) == (7, line)
    (folder / "exit.py").write_text("raise SystemExit\n")
    done = run("--shot", "s.png", "exit.py", cwd=folder)
    assert (done.returncode, done.stderr) == (1, line)


def test_options_that_all_stand_behind_the_program(folder: Path) -> None:
    (folder / "arguments.py").write_text("import sys; print(sys.argv[1:])\n")
    done = run("arguments.py", "a", "--shot=s.png", "--after", "2", cwd=folder)
    assert (done.returncode, done.stdout) == (0, "['a', '--shot=s.png', '--after', '2']\n")
    assert done.stderr == (
        "bgi: --shot=s.png stands behind arguments.py, so it is for that program; "
        "options of python -m bgi stand before it\n"
    )
    done = run("--monitor", "none", "arguments.py", "--shot=s.png", cwd=folder)
    assert (done.stdout, done.stderr) == ("['--shot=s.png']\n", "")


WHO_AM_I = """
import sys, __main__
import helper
print(sys.argv, sys.path[0], __name__, __file__, __package__, __spec__)
print(__main__.sys is sys, sys.modules["__main__"].__dict__ is globals(), helper.WORDS)
def f(): return 1 / 0
f()
"""


@pytest.mark.parametrize(
    "name", ["who.py", "sub/who.py", "{}", pytest.param("link.py", marks=posix)]
)
def test_a_program_runs_as_python_runs_it(folder: Path, name: str) -> None:
    for place in (folder, folder / "sub"):
        place.mkdir(exist_ok=True)
        (place / "who.py").write_text(WHO_AM_I)
        (place / "helper.py").write_text(f"WORDS = {place.name!r}")
    if name == "link.py":
        (folder / name).symlink_to(Path("sub", "who.py"))
    command = [name.format(folder / "who.py"), "a", "-b"]
    alone = subprocess.run(
        [sys.executable, *command], cwd=folder, capture_output=True, text=True, timeout=PATIENCE
    )
    through = run(*command, cwd=folder)
    assert "ZeroDivisionError" in alone.stderr
    assert (through.returncode, through.stdout) == (alone.returncode, alone.stdout)
    assert through.stderr == alone.stderr


def test_a_program_that_is_no_python_is_reported_as_ever(folder: Path) -> None:
    (folder / "wrong.py").write_text("print(1\n")
    alone = subprocess.run(
        [sys.executable, "wrong.py"], cwd=folder, capture_output=True, text=True, timeout=PATIENCE
    )
    done = run("wrong.py", cwd=folder)
    assert (done.returncode, done.stderr) == (1, alone.stderr)


def test_a_folder_with_a_main_program(folder: Path) -> None:
    (folder / "sub").mkdir()
    (folder / "sub" / "__main__.py").write_text("print(__name__)")
    assert run("sub", cwd=folder).stdout == "__main__\n"


def test_exit_statuses(folder: Path) -> None:
    for given, status, said in (("7", 7, ""), ("None", 0, ""), ("'no luck'", 1, "no luck\n")):
        (folder / "exit.py").write_text(f"raise SystemExit({given})\n")
        done = run("exit.py", cwd=folder)
        assert (done.returncode, done.stderr) == (status, said)


def test_version(tmp_path: Path) -> None:
    assert run("--version", cwd=tmp_path).stdout == f"bgi {bgi.__version__}\n"
    assert re.fullmatch(r"\d+\.\d+\.\d+", bgi.__version__)


def test_info(tmp_path: Path) -> None:
    done = run("--info", cwd=tmp_path, SDL_AUDIODRIVER="dummy")
    assert (done.returncode, done.stderr) == (0, "")
    lines = dict(line.split(maxsplit=1) for line in done.stdout.splitlines())
    assert set(lines) >= {"bgi", "python", "numpy", "pygame", "pillow", "websockets", "sound"}
    assert "(driver dummy)" in lines["display"]
    assert "TRIP" in lines["fonts"]


def test_info_without_a_display_or_a_sound_card(tmp_path: Path) -> None:
    variables = {"SDL_VIDEODRIVER": "nonsense", "SDL_AUDIODRIVER": "nonsense"}
    done = run("--info", cwd=tmp_path, **variables)
    assert (done.returncode, done.stderr) == (0, "")
    assert "display     none: nonsense not available" in done.stdout
    assert "sound       none" in done.stdout
