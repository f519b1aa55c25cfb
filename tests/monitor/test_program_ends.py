"""However a program ends: the same status, words and picture, with a window and without one."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import bgi
from bgi import conio, dos, mouse
from bgi.errors import BGIError, NobodyThere, TimeIsUp, WindowClosed
from bgi.memory.sdl import pygame
from tests.processes import PATIENCE, posix

HOME = Path(__file__).resolve().parents[2]
MONITORS = ["none", "window"]
WINDOWS = sys.platform == "win32"

Ended = Callable[..., tuple[int, list[str]]]

BEGINNING = """
import signal, sys, threading, time
import bgi.monitor.headless as headless
from bgi import *
initgraph()
putpixel(3, 4, RED)
"""
NOBODY = (
    "bgi: nobody can press a key here, for there is no window; "
    'to script some: BGI_KEYS="1 w Left Esc"'
)
CTRL_C = 0xC000013A if WINDOWS else -signal.SIGINT

# How a program ends: its exit status, and the last line of its standard error.
ENDS = {
    "pass": (0, ""),
    "closegraph()": (0, ""),
    "raise SystemExit": (0, ""),
    "sys.exit(3)": (3, ""),
    "sys.exit('bad weather')": (1, "bad weather"),
    "1 / 0": (1, "ZeroDivisionError: division by zero"),
    "signal.raise_signal(signal.SIGINT)": (CTRL_C, "KeyboardInterrupt"),
}
COMPUTES = "headless.BUSY_TIMES = headless.BUSY_SECONDS = 1\nwhile True: pass"
# The same where the end is planned.
PLANNED_ENDS = {
    "while not kbhit(): delay(10)": 0,
    "try: getch()\nexcept WindowClosed: sys.exit(5)": 5,
    "thread = threading.Thread(target=getch); thread.start(); thread.join()": 0,
    # These ask for nothing, or hardly anything.
    "while True: time.sleep(0.01)": 0,
    "while not kbhit(): time.sleep(0.05)": 0,
    "time.sleep(1000)": 0,
    COMPUTES: 0,
}


def run(*command: str | Path, cwd: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *map(str, command)],
        cwd=cwd,
        env=os.environ | {"PYTHONPATH": str(HOME)} | variables,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )


@pytest.fixture(params=["none", "window", "python -m bgi"])
def ended(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Ended]:
    """A function that runs a program with a monitor, or through the command, and takes a picture.

    It returns the exit status and what was said, without what the command says of the picture.
    """

    def end(statement: str, after: str = "") -> tuple[int, list[str]]:
        (tmp_path / "program.py").write_text(BEGINNING + statement + "\n")
        if request.param == "python -m bgi":
            options = ["--monitor", "none", "--shot", "s.png"]
            options += ["--after", after] if after else []
            done = run("-m", "bgi", *options, "program.py", cwd=tmp_path)
            said = done.stderr.splitlines()
            said.remove(f"bgi: {tmp_path / 's.png'} was written")
        else:
            plan = {"BGI_SHOT": "s.png", "BGI_AFTER": after}
            done = run("program.py", cwd=tmp_path, BGI_MONITOR=request.param, **plan)
            said = done.stderr.splitlines()
        assert done.stdout == ""
        return done.returncode, said

    yield end
    assert pygame.image.load(str(tmp_path / "s.png")).get_at((3, 4))[:3] == (0xAA, 0, 0)


@pytest.mark.parametrize("statement", ENDS)
def test_every_end(ended: Ended, statement: str) -> None:
    status, last = ENDS[statement]
    returned, said = ended(statement)
    assert returned == status
    assert said[-1:] == [last] * bool(last)
    traceback = "Error" in last or "Interrupt" in last
    assert (said[:1] == ["Traceback (most recent call last):"]) == traceback
    assert len(said) == bool(last) or traceback


@pytest.mark.parametrize("statement", PLANNED_ENDS)
def test_every_planned_end(ended: Ended, statement: str) -> None:
    assert ended(statement, after="300ms") == (PLANNED_ENDS[statement], [])


@posix
@pytest.mark.parametrize("monitor", MONITORS)
@pytest.mark.parametrize("statement", ["time.sleep(1000)", COMPUTES])
def test_a_planned_end_comes_where_ctrl_c_is_ignored(
    tmp_path: Path, statement: str, monitor: str
) -> None:
    """As after nohup, or `&` in a script."""
    (tmp_path / "program.py").write_text(BEGINNING + "signal.raise_signal(2)\n" + statement + "\n")
    ignoring = ["sh", "-c", "trap '' INT; exec \"$@\"", "sh", sys.executable, "program.py"]
    plan = {"BGI_MONITOR": monitor, "BGI_AFTER": "300ms", "PYTHONPATH": str(HOME)}
    done = subprocess.run(
        ignoring, cwd=tmp_path, env=os.environ | plan, capture_output=True, timeout=PATIENCE
    )
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.parametrize("through", [[], ["-m", "bgi"]])
def test_nobody_can_press_a_key(tmp_path: Path, through: list[str]) -> None:
    (tmp_path / "program.py").write_text(BEGINNING + "getch()\n")
    done = run(*through, "program.py", cwd=tmp_path, BGI_MONITOR="none", BGI_SHOT="s.png")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", NOBODY + "\n")
    assert (tmp_path / "s.png").exists()


IMPATIENT = """
import bgi.monitor.waiting as waiting
from bgi import keyboard
waiting.LOOK_SECONDS, waiting.RESTS, waiting.DELAYS = 0, 1, 1
"""
IN_VAIN = (
    "bgi: the program waits for a key or the mouse, but nobody is there, for there is no window; "
    'to script keys: BGI_KEYS="1 w Left Esc", to plan an end: BGI_AFTER=2s'
)


@pytest.mark.parametrize(
    "wait",
    [
        "while not kbhit(): pass",
        "while not kbhit(): delay(10)",
        "while True:\n    if kbhit() and getch() == 27: break",
        "while not ismouseclick(WM_LBUTTONDOWN): pass",
        "while not keyboard.pressed('Esc'): delay(20)",
        "try:\n    while not mousex(): pass\nexcept NobodyThere as no: sys.exit(f'bgi: {no}')",
    ],
)
def test_a_loop_that_waits_in_vain(tmp_path: Path, wait: str) -> None:
    (tmp_path / "program.py").write_text(BEGINNING + IMPATIENT + wait + "\n")
    done = run("program.py", cwd=tmp_path, BGI_MONITOR="none", BGI_SHOT="s.png")
    assert (done.returncode, done.stdout, done.stderr) == ("exit" in wait, "", IN_VAIN + "\n")
    assert (tmp_path / "s.png").exists()


@pytest.mark.parametrize(
    "work",
    [
        "for n in range(600):\n    putpixel(n, 9, RED)\n    delay(1000)\n    if kbhit(): break",
        "for x in range(99):\n    time.sleep(0.01)\n    if kbhit(): break",
        "for x in range(9999):\n    if kbhit(): break\n    hypot = [n ** 0.5 for n in range(99)]",
    ],
)
def test_a_program_that_works_between_its_questions(tmp_path: Path, work: str) -> None:
    (tmp_path / "program.py").write_text(BEGINNING + IMPATIENT + work + "\n")
    done = run("program.py", cwd=tmp_path, BGI_MONITOR="none")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display")
def test_the_first_program_without_a_display(tmp_path: Path) -> None:
    readme = (HOME / "README.md").read_text("utf-8")
    (tmp_path / "first.py").write_text(readme.split("```python\n")[1].split("```")[0])
    no_display = {"BGI_MONITOR": "", "SDL_VIDEODRIVER": "", "DISPLAY": "", "WAYLAND_DISPLAY": ""}
    done = run("first.py", cwd=tmp_path, **no_display)
    assert (done.returncode, done.stdout) == (0, "")
    first, second = done.stderr.splitlines()
    assert first.startswith("bgi: no display found; drawing goes on without a window")
    assert second == NOBODY


@posix
@pytest.mark.parametrize("through", [[], ["-m", "bgi"]])
def test_the_user_closes_the_window(tmp_path: Path, through: list[str]) -> None:
    program = tmp_path / "program.py"
    program.write_text(
        BEGINNING
        + """
import os
from bgi import current
os.kill(current.screen.monitor._process.pid, signal.SIGTERM)  # as polite as the close button
getch()
"""
    )
    done = run(*through, program, cwd=tmp_path, BGI_MONITOR="window")
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == "bgi: the window was closed\n"


# The prompt


def test_the_prompt_stays(tmp_path: Path) -> None:
    """One line, and the next command; its end is the screen's end, too."""
    typed = BEGINNING + "getch()\nprint('still', 'here')\n1 / 0\ngetch()\n"
    done = subprocess.run(
        [sys.executable, "-i"],
        input=typed,
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(HOME), "BGI_MONITOR": "none", "BGI_SHOT": "s.png"},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert done.returncode == 0
    assert "still here\n" in done.stdout
    assert done.stderr.count(NOBODY) == 2
    assert done.stderr.count("Traceback") == 1
    assert (tmp_path / "s.png").exists()


def test_a_program_that_leads_to_the_prompt(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(BEGINNING + "getch()\n")
    done = subprocess.run(
        [sys.executable, "-i", "program.py"],
        input="print('still', getpixel(3, 4))\n",
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(HOME), "BGI_MONITOR": "none"},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert (done.returncode, done.stdout) == (0, "still 4\n")
    assert NOBODY in done.stderr
    assert "Traceback" not in done.stderr


def test_a_notebook_shows_one_line() -> None:
    assert WindowClosed("gone")._render_traceback_() == ["bgi: gone"]


# Who catches what


def test_a_program_may_catch_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "none")
    bgi.initgraph()
    for kind in (NobodyThere, WindowClosed, BGIError):
        with pytest.raises(kind, match="nobody can press a key here"):
            bgi.getch()
    bgi.putpixel(3, 4, bgi.RED)  # the screen is still there
    assert bgi.getpixel(3, 4) == bgi.RED


# Every wait comes to its planned end


def loop(question: Callable[[], object]) -> Callable[[], None]:
    def wait() -> None:
        while True:
            question()

    return wait


def flip() -> None:
    bgi.setactivepage(1 - bgi.getvisualpage())
    bgi.setvisualpage(1 - bgi.getvisualpage())


WAITS: dict[str, Callable[[], object]] = {
    "getch": bgi.getch,
    "getche": conio.getche,
    "bioskey": lambda: dos.bioskey(0),
    "delay": lambda: bgi.delay(1e9),
    "sleep": lambda: dos.sleep(1e6),
    "kbhit loop": loop(bgi.kbhit),
    "bioskey loop": loop(lambda: dos.bioskey(1)),
    "Shift loop": loop(lambda: dos.bioskey(2)),
    "click loop": loop(lambda: bgi.ismouseclick(bgi.WM_LBUTTONDOWN)),
    "getmouseclick loop": loop(lambda: bgi.getmouseclick(bgi.WM_LBUTTONDOWN)),
    "mousex loop": loop(bgi.mousex),
    "buttons loop": loop(mouse.buttons),
    "position loop": loop(mouse.position),
    "presses loop": loop(lambda: mouse.presses(0)),
    "gettime loop": loop(dos.gettime),
    "clock loop": loop(dos.clock),
    "biostime loop": loop(lambda: dos.biostime(0)),
    "swapbuffers loop": loop(bgi.swapbuffers),
    "pages loop": loop(flip),
    "delay loop": loop(lambda: bgi.delay(1)),
}


@pytest.fixture(params=MONITORS)
def monitor(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A screen of each kind that has 0.2 seconds to live."""
    monkeypatch.setenv("BGI_MONITOR", request.param)
    monkeypatch.setenv("BGI_AFTER", "0.2")
    bgi.initgraph()
    yield request.param
    bgi.closegraph()


@pytest.mark.parametrize("wait", WAITS)
def test_every_wait_ends(monitor: str, wait: str) -> None:
    with pytest.raises(TimeIsUp, match=r"^ended after 0.2 s, as planned$"):
        WAITS[wait]()
    for call in (bgi.kbhit, bgi.getch, bgi.getmaxx, bgi.swapbuffers):
        with pytest.raises(TimeIsUp):  # and every call after that
            call()
