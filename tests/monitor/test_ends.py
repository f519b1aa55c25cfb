"""Every way in which a program can end: its window goes, and nothing is left behind."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from bgi.errors import BGIError, WindowClosed
from tests.processes import LOSSES, PATIENCE, gone, posix, shared_memory, wait_until

KILLED = 1 if sys.platform == "win32" else -signal.SIGKILL  # the exit status

HOME = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def shared_memory_stays_clean() -> Iterator[None]:
    before = shared_memory()
    yield
    assert shared_memory() <= before


class Running:
    """A program in a process group of its own, and its window."""

    def __init__(self, source: str, script: Path, cwd: Path) -> None:
        script.write_text(PRELUDE.format(home=str(HOME)) + source, "utf-8")
        self.process = subprocess.Popen(
            [sys.executable, str(script)],
            cwd=cwd,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            process_group=None if sys.platform == "win32" else 0,
        )
        assert self.process.stdout
        self.window = int(self.process.stdout.readline())
        self.stderr = ""

    def end(self) -> int:
        """The exit status, once program and window have ended."""
        _, self.stderr = self.process.communicate(timeout=PATIENCE)
        wait_until(lambda: gone(self.window))
        return self.process.returncode

    def ends_by(self, kind: type[BGIError], text: str) -> None:
        """Check the status of a program that lost its window, and what it wrote."""
        assert self.end() == (0 if kind is WindowClosed else 1)
        if kind is WindowClosed:  # nothing to look into
            assert self.stderr == f"bgi: {text}\n"
        else:
            assert self.stderr.count("Traceback") == 1
            assert self.stderr.endswith(f"bgi.errors.{kind.__name__}: {text}\n")


Start = Callable[[str], Running]

PRELUDE = """
import os, signal, sys, time
sys.path.insert(0, {home!r})
os.environ["BGI_MONITOR"] = "window"
import bgi
from bgi import current
bgi.initgraph(bgi.CGA, bgi.CGAC0)
window, card = current.screen.monitor, current.screen.card
print(window.pid, flush=True)
"""


@pytest.fixture
def program(tmp_path: Path) -> Iterator[Start]:
    started: list[Running] = []

    def start(source: str) -> Running:
        started.append(Running(source, tmp_path / "program.py", tmp_path))
        return started[-1]

    yield start
    for running in started:
        running.process.kill()
        running.end()


@pytest.mark.parametrize(
    ("source", "status", "last"),
    [
        ("window.show()", 0, ""),
        ("window.show(); window.close()", 0, ""),
        ("window.show(); view = card.page(0); card.close(); card.close()", 0, ""),
        ("window.show(); sys.exit(3)", 3, ""),
        ("os._exit(4)", 4, ""),
        ("window.show(); 1 / 0", 1, "ZeroDivisionError: division by zero\n"),
        ("import threading\nthreading.Thread(target=window.show).start()", 0, ""),
    ],
)
def test_a_program_ends(program: Start, source: str, status: int, last: str) -> None:
    running = program(source)
    assert running.end() == status
    assert running.stderr.endswith(last)
    assert running.stderr.count("Traceback") == bool(last)
    if not last:
        assert running.stderr == ""


@posix
@pytest.mark.parametrize("call", ["read_key()", "sleep(1e9)"])
def test_ctrl_c_is_for_the_program(program: Start, call: str) -> None:
    running = program(
        f"""
try:
    print("waiting", flush=True)
    window.{call}
except KeyboardInterrupt:
    pass
window.show()  # the window lives on
print("shown", flush=True)
window.{call}
"""
    )
    assert running.process.stdout
    assert running.process.stdout.readline() == "waiting\n"
    os.killpg(running.process.pid, signal.SIGINT)
    os.kill(running.window, signal.SIGINT)
    assert running.process.stdout.readline() == "shown\n"
    os.killpg(running.process.pid, signal.SIGINT)
    assert running.end() == -signal.SIGINT
    assert running.stderr.count("Traceback") == 1
    assert running.stderr.endswith("KeyboardInterrupt\n")


def test_kill_9_of_the_program(program: Start) -> None:
    running = program("window.read_key()")
    running.process.kill()
    assert running.end() == KILLED
    assert running.stderr == ""


@posix
def test_kill_9_of_the_program_while_a_fork_of_it_lives(program: Start) -> None:
    running = program(
        """
fork = os.fork()
if fork == 0:
    os.close(1), os.close(2)
    time.sleep(600)
print(fork, flush=True)
window.read_key()
"""
    )
    assert running.process.stdout
    fork = int(running.process.stdout.readline())
    try:
        running.process.kill()
        running.end()
        assert not gone(fork)
    finally:
        os.kill(fork, signal.SIGKILL)


def test_kill_9_of_the_program_again_and_again(program: Start) -> None:
    for _ in range(5):
        running = program("while True: card.page(0)[5] ^= 1; window.show()")
        running.process.kill()
        assert running.end() == KILLED


@pytest.mark.parametrize("busy", ["pass", "card.page(0)[5] ^= 1"])
def test_a_busy_program_does_not_keep_its_window_from_closing(program: Start, busy: str) -> None:
    running = program(f"while window._error is None: {busy}\nwindow.show()")
    how, kind, text = LOSSES[0]
    os.kill(running.window, how)
    running.ends_by(kind, text)


@posix
def test_a_stopped_program_does_not_keep_its_window_from_closing(program: Start) -> None:
    running = program("window.read_key()")
    os.kill(running.process.pid, signal.SIGSTOP)
    os.kill(running.window, signal.SIGTERM)
    wait_until(lambda: gone(running.window))
    os.kill(running.process.pid, signal.SIGCONT)
    assert running.end() == 0


def test_several_threads_draw(program: Start) -> None:
    """Every call is whole; what is set (colour, page) is common to all threads."""
    running = program(
        """
import threading
bgi.initgraph(bgi.VGA, bgi.VGAHI)
def draw(number):
    for i in range(300):
        bgi.line(80 * number, i, 80 * number + 79, i, number + 1)
        bgi.putpixel(80 * number + i % 80, 400, number + 1)
        if i % 100 == 0:
            current.screen.monitor.show()
threads = [threading.Thread(target=draw, args=[n]) for n in range(8)]
for thread in threads: thread.start()
for thread in threads: thread.join()
print(all(bgi.getpixel(x, y) == x // 80 + 1 for x in range(640) for y in (*range(300), 400)))
bgi.closegraph()
"""
    )
    assert running.process.stdout
    assert running.process.stdout.readline() == "True\n"
    assert running.end() == 0
    assert running.stderr == ""


@posix
def test_a_fork_leaves_the_window_alone(program: Start) -> None:
    running = program(
        """
import warnings
warnings.simplefilter("ignore")  # Python 3.12 dislikes any fork beside a thread
if os.fork() == 0:
    try:
        window.show()
    except Exception as error:
        print(error, flush=True)
    sys.exit()
os.wait()
window.show()
print("still there", flush=True)
"""
    )
    assert running.process.stdout
    assert "the process that opened it" in running.process.stdout.readline()
    assert running.process.stdout.readline() == "still there\n"
    assert running.end() == 0
    assert running.stderr == ""


@pytest.mark.parametrize("call", ["read_key()", "sleep(1e9)"])
@pytest.mark.parametrize(("how", "kind", "text"), LOSSES)
def test_whoever_waits_is_woken(
    program: Start, how: signal.Signals, kind: type[BGIError], text: str, call: str
) -> None:
    running = program(f"window.{call}")
    os.kill(running.window, how)
    running.ends_by(kind, text)


def test_other_errors_are_reported_as_ever(program: Start) -> None:
    running = program("sys.excepthook(ValueError, ValueError('wrong'), None)\nraise KeyError('x')")
    assert running.end() == 1
    assert running.stderr.startswith("ValueError: wrong\nTraceback")
    assert running.stderr.endswith("KeyError: 'x'\n")
