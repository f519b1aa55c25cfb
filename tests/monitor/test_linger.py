"""A program that ends on its text screen: what stands there can still be read."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from bgi.memory.card import Card
from bgi.monitor import Headless, Window
from bgi.monitor.plan import Plan
from tests.processes import posix
from tests.skips import needs_pygame


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_text_mode(80, 25, 16)
    return card


def seconds_of_linger(window: Window) -> float:
    began = time.monotonic()
    window.linger()
    return time.monotonic() - began


@needs_pygame
def test_it_stays_until_a_key_is_pressed(card: Card) -> None:
    window = Window(card)
    card.page(0)[0] = 65
    threading.Timer(0.3, window.keys.put, [b" "]).start()
    assert seconds_of_linger(window) >= 0.3
    window.close()


@needs_pygame
def test_it_does_not_where_the_program_has_just_asked_for_a_key(card: Card) -> None:
    window = Window(card)
    card.page(0)[0] = 65
    window.keys.put(b"a")
    window.read_key()
    window.linger()  # returns
    card.page(0)[0] = 66
    window.keys.put(b"b")
    window.read_keystroke()
    window.linger()
    window.close()


@needs_pygame
def test_it_does_not_where_nobody_is_there(card: Card) -> None:
    window = Window(card, plan=Plan(after=60))
    card.page(0)[0] = 65
    window.linger()
    window.close()
    window.linger()  # nor where the window is gone
    Headless(card=card).linger()


PROGRAM = """
from bgi.stdio import printf
printf("Hello")
print("written", flush=True)
{then}
"""


def start(then: str) -> subprocess.Popen[str]:
    environment = {**os.environ, "BGI_MONITOR": "window", "SDL_VIDEODRIVER": "dummy"}
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM.format(then=then)],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@posix
@pytest.mark.parametrize("then", ["", "import time; time.sleep(60)"])
def test_ctrl_c_ends_it_at_once(then: str) -> None:
    """At the end of the program, and before it."""
    program = start(then)
    assert program.stdout is not None
    assert program.stdout.readline() == "written\n"
    time.sleep(0.5)
    assert program.poll() is None
    program.send_signal(signal.SIGINT)
    _, errors = program.communicate(timeout=20)
    assert ("KeyboardInterrupt" in errors) == bool(then)


PRINTS = {
    "graphics": "initgraph(); circle(9, 9, 5)",
    "nothing": "textmode(C40)",
    "text": r"printf('\x01 one\n\n'); gotoxy(5, 4); cputs(' two ')",
}


def printed(program: str, *options: str) -> str:
    """What a program prints where there is no window."""
    imports = "from bgi import *\nfrom bgi.conio import *\nfrom bgi.stdio import printf\n"
    code = f"{imports}{program}"
    run = subprocess.run(
        [sys.executable, *options, "-c", code],
        env={**os.environ, "BGI_MONITOR": "none", "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    return run.stdout


@pytest.mark.parametrize(
    ("name", "words"), [("graphics", ""), ("nothing", ""), ("text", "☺ one\n\n\n     two\n")]
)
def test_without_a_window_it_is_printed_on_the_terminal(name: str, words: str) -> None:
    assert printed(PRINTS[name]) == words


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display")
def test_what_bgi_says_itself_may_come_while_the_words_open_the_screen(tmp_path: Path) -> None:
    """The note that there is no display went to the screen, which was just being opened."""
    program = tmp_path / "hello.py"
    program.write_text("print('Hello')")
    run = subprocess.run(
        [sys.executable, "-m", "bgi", "--console", str(program)],
        env={**os.environ, "BGI_MONITOR": "", "DISPLAY": "", "SDL_VIDEODRIVER": ""},
        capture_output=True,
        text=True,
    )
    assert "no display found" in run.stderr
    assert (run.stdout, run.returncode) == ("Hello\n", 0)
