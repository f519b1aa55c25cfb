"""The window's process runs what the program runs, and nothing of the program's folder."""

import os
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from bgi.memory.card import Card
from bgi.monitor import Window, process
from tests.processes import posix

HOME = str(Path(__file__).resolve().parents[2])
OPENS = "from bgi import *\ninitgraph()\ncircle(9, 9, 5)\nswapbuffers()\nprint(getpixel(14, 9))\n"


def run(
    *arguments: object,
    cwd: Path,
    path: str = HOME,
    monitor: str = "window",
    **more: Any,
) -> subprocess.CompletedProcess[str]:
    """A program of its own in a folder; its window is on SDL's dummy driver."""
    environment = os.environ | {
        "BGI_MONITOR": monitor,
        "SDL_VIDEODRIVER": "dummy",
        "PYTHONPATH": path,
    }
    ran: subprocess.CompletedProcess[str] = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=cwd,
        env=environment,
        capture_output=True,
        text=True,
        timeout=100,
        **more,
    )
    return ran


def program(folder: Path, source: str = OPENS) -> Path:
    file = folder / "program.py"
    file.write_text(source, "utf-8")
    return file


def marking(folder: Path, mark: Path) -> None:
    """A module that every interpreter imports which sees it, and that leaves a mark each time."""
    folder.mkdir(exist_ok=True)
    (folder / "sitecustomize.py").write_text(f"open({str(mark)!r}, 'a').write('x')", "utf-8")


@pytest.mark.parametrize(
    "name", ["random", "numpy", "pygame", "signal", "queue", "bgi_unused", "subprocess", "tempfile"]
)
def test_a_file_beside_the_program_is_none_of_the_windows(tmp_path: Path, name: str) -> None:
    """The program keeps its own hands off it, so that only the window could import it."""
    source = "import sys\nfolder = sys.path.pop(0)\n" + OPENS + "sys.path.insert(0, folder)\n"
    file = program(tmp_path, source.replace("swapbuffers()", "swapbuffers()\nkbhit()"))
    (tmp_path / f"{name}.py").write_text("raise SystemExit('ran')", "utf-8")
    ran = run(file, cwd=tmp_path)
    assert (ran.stdout, ran.stderr, ran.returncode) == ("0\n", "", 0)


@pytest.mark.skipif(
    np.lib.NumpyVersion(np.__version__) < "2.0.0", reason="numpy 1 imports random itself"
)
def test_a_random_beside_the_program_does_not_keep_bgi_from_being_imported(tmp_path: Path) -> None:
    (tmp_path / "random.py").write_text("raise SystemExit('ran')", "utf-8")
    ran = run(program(tmp_path), cwd=tmp_path)
    assert (ran.stdout, ran.stderr, ran.returncode) == ("0\n", "", 0)


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_the_window_opens_without_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    card = Card()
    card.set_mode(640, 480, 2)
    window = Window(card)

    def loaded(name: str) -> bool:
        return name in Path(f"/proc/{window.pid}/maps").read_text("utf-8")

    try:
        window.show()
        assert loaded("pygame") and not loaded("numpy")
        card.set_mode(320, 240, 2, 4)  # where pixels are colours it is needed
        window.show()
        assert loaded("numpy")
    finally:
        window.close()


@pytest.mark.parametrize("flag", ["-I", "-E"])
def test_what_the_program_ignores_its_window_ignores(tmp_path: Path, flag: str) -> None:
    mark = tmp_path / "mark"
    marking(tmp_path / "lib", mark)
    source = f"import sys\nsys.path.insert(1, {HOME!r})\n" + OPENS
    ran = run(flag, program(tmp_path, source), cwd=tmp_path, path=str(tmp_path / "lib"))
    assert (ran.stdout, ran.stderr) == ("0\n", "")
    assert not mark.exists()


def test_a_relative_search_path_means_the_same_to_both(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    marking(tmp_path / "lib", mark)
    ran = run(program(tmp_path), cwd=tmp_path, path=os.pathsep.join(("lib", HOME)))
    assert (ran.stdout, ran.stderr) == ("0\n", "")
    assert mark.read_text() == "xx"


def test_the_package_is_the_programs_wherever_another_lies(tmp_path: Path) -> None:
    other = tmp_path / "lib" / "bgi"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("raise SystemExit('another')", "utf-8")
    source = f"import sys\nsys.path.insert(0, {HOME!r})\n" + OPENS
    ran = run(program(tmp_path, source), cwd=tmp_path, path=str(tmp_path / "lib"))
    assert (ran.stdout, ran.stderr) == ("0\n", "")


@posix
@pytest.mark.parametrize("closed", [0, 1, 2])
def test_a_standard_stream_that_is_closed(tmp_path: Path, closed: int) -> None:
    """Its number is free: neither the card nor a pipe may take it by accident."""
    source = OPENS.replace("print(getpixel(14, 9))", "assert getpixel(14, 9) == 0")
    source += "writeimagefile('a.png')\nreadimagefile('a.png')\n"
    file = program(tmp_path, source)
    ran = run(file, cwd=tmp_path, preexec_fn=lambda: os.close(closed))
    assert ran.returncode == 0, ran.stderr


@posix
def test_a_folder_that_has_been_removed(tmp_path: Path) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    file = program(tmp_path, "import os\nos.rmdir(os.getcwd())\n" + OPENS)
    ran = run(file, cwd=gone)
    assert (ran.stdout, ran.stderr, ran.returncode) == ("0\n", "", 0)


def test_the_search_path_ends_where_pygame_lies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", ["", os.getcwd(), "lib", "lib"])
    *found, last = process.search_path()
    assert found == [os.path.abspath("lib")]
    assert (Path(last) / "pygame").is_dir()


@posix
def test_a_fork_leaves_the_programs_screen_alone_and_opens_its_own(tmp_path: Path) -> None:
    source = """
import os, warnings
warnings.simplefilter("ignore")  # Python 3.12 dislikes any fork beside a thread
from bgi import *
initgraph(VGA, VGAHI)
bar(0, 0, 99, 99)
if os.fork() == 0:
    try:
        putpixel(5, 5, RED)
    except BGIError as error:
        print(error, flush=True)
    initgraph(CGA, CGAC0)
    print(getmaxy(), getpixel(50, 50), kbhit(), flush=True)
    os._exit(0)
os.wait()
print(getmaxy(), getpixel(5, 5), getpixel(50, 50))
"""
    ran = run(program(tmp_path, source), cwd=tmp_path)
    assert ran.stdout.splitlines() == [
        "the window belongs to the process that opened it, this is a fork of it: "
        "initgraph() opens one of its own",
        "199 0 0",
        "479 15 15",
    ]
    assert ran.stderr == ""


@posix
@pytest.mark.parametrize("monitor", ["window", "none"])
def test_a_signal_handler_may_make_any_call(tmp_path: Path, monitor: str) -> None:
    """It comes in the middle of another call, even of the same one, whatever that holds."""
    source = """
import signal, time
from bgi import *
from bgi import mouse
def call():
    kbhit(), mousex(), ismouseclick(WM_LBUTTONDOWN), mouse.buttons(), clearmouseclick(WM_MOUSEMOVE)
    circle(99, 99, 50), floodfill(99, 99, 15), getimage(0, 0, 20, 20), swapbuffers()
count = 0
def handler(number, frame):
    global count
    count += 1
    call()
    signal.setitimer(signal.ITIMER_REAL, 0.0005)
initgraph(VGA, VGAHI)
signal.signal(signal.SIGALRM, handler)
signal.setitimer(signal.ITIMER_REAL, 0.0005)
end = time.monotonic() + 2
while time.monotonic() < end:
    call()
signal.setitimer(signal.ITIMER_REAL, 0)
print(count > 5)
"""
    ran = run("-c", source, cwd=tmp_path, monitor=monitor)
    assert (ran.stdout, ran.stderr, ran.returncode) == ("True\n", "", 0)


def test_a_debugger_does_not_follow_the_window(monkeypatch: pytest.MonkeyPatch) -> None:
    followed = True

    @contextmanager
    def skip() -> Generator[None]:
        nonlocal followed
        followed = False
        yield
        followed = True

    debugger = ModuleType("_pydev_bundle.pydev_monkey")  # as VS Code's is loaded
    monkeypatch.setattr(debugger, "skip_subprocess_arg_patch", skip, raising=False)
    monkeypatch.setitem(sys.modules, debugger.__name__, debugger)
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: followed)
    card = Card()
    try:
        assert process.start(card, "bgi.monitor.child") is False
    finally:
        card.close()
    assert followed
