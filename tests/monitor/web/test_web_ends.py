"""When it begins and how it ends: the page knows, the program knows, and nothing is left."""

import asyncio
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from bgi import __main__ as command
from bgi.errors import BGIError, WindowClosed
from bgi.memory.card import Card
from bgi.monitor import PageWindow, choose
from bgi.monitor.plan import Plan
from bgi.monitor.web import audience, pagewindow
from bgi.monitor.web.audience import Audience
from bgi.monitor.web.words import ENDED, LEFT
from tests.monitor.web.page import Page
from tests.processes import KILL, PATIENCE, gone, posix, wait_until

HOME = Path(__file__).resolve().parents[3]
PRELUDE = """
from bgi import *
from bgi import current
initgraph(VGA, VGAHI)
window = current.screen.monitor
print(window.pid, flush=True)
"""


class Running:
    """A program, its page and the process between them."""

    def __init__(self, source: str, folder: Path, **more: str) -> None:
        (folder / "program.py").write_text(PRELUDE + source, "utf-8")
        self.process = subprocess.Popen(
            [sys.executable, "program.py"],
            cwd=folder,
            env=os.environ | {"BGI_MONITOR": "web", "PYTHONPATH": str(HOME)} | more,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout and self.process.stderr
        found = re.match(r"bgi: see (\S+)\n", self.process.stderr.readline())
        assert found
        self.page = Page(found[1])
        self.child = int(self.process.stdout.readline())

    def end(self) -> tuple[int, str]:
        """The exit status and what was written, once nothing runs any more."""
        _, errors = self.process.communicate(timeout=PATIENCE)
        wait_until(lambda: gone(self.child))
        return self.process.returncode, errors


Start = Callable[..., Running]


@pytest.fixture
def program(tmp_path: Path) -> Iterator[Start]:
    started: list[Running] = []

    def start(source: str, **more: str) -> Running:
        started.append(Running(source, tmp_path, **more))
        return started[-1]

    yield start
    for running in started:
        running.process.kill()
        running.end()
        running.page.close()


def test_the_program_ends(program: Start) -> None:
    running = program("circle(320, 240, 9, RED)\n")
    assert running.page.end() == ENDED
    assert running.page.pixels[240, 311] == 4  # what was drawn last
    assert running.end() == (0, "")


def test_an_exception(program: Start) -> None:
    running = program("1 / 0\n")
    assert running.page.end() == ENDED
    status, errors = running.end()
    assert (status, errors.count("Traceback")) == (1, 1)


@posix
def test_ctrl_c(program: Start) -> None:
    running = program("getch()\n")
    running.page.hear_until(lambda page: page.pictures)
    running.process.send_signal(signal.SIGINT)
    assert running.page.end() == ENDED
    assert running.end()[0] == -signal.SIGINT


@posix
def test_ctrl_c_while_nobody_has_looked_yet(tmp_path: Path) -> None:
    running = subprocess.Popen(
        [sys.executable, "-c", "from bgi import *\ninitgraph()"],
        cwd=tmp_path,
        env=os.environ | {"BGI_MONITOR": "web", "PYTHONPATH": str(HOME)},
        stderr=subprocess.PIPE,
        text=True,
    )
    assert running.stderr
    assert running.stderr.readline().startswith("bgi: see ")
    running.send_signal(signal.SIGINT)
    _, errors = running.communicate(timeout=PATIENCE)  # the process between has its stderr, too
    assert running.returncode == -signal.SIGINT
    assert errors.endswith("KeyboardInterrupt\n")


def test_kill_9_of_the_program(program: Start) -> None:
    running = program("getch()\n")
    running.page.hear_until(lambda page: page.pictures)
    running.process.kill()
    assert running.page.end() == ENDED
    running.end()


@pytest.mark.parametrize("call", ["getch()", "delay(60000)", "while True: swapbuffers()"])
def test_kill_9_of_the_process_between(program: Start, call: str) -> None:
    running = program(f"{call}\n")
    running.page.hear_until(lambda page: page.pictures)
    os.kill(running.child, KILL)
    assert running.page.end() == 1006  # a line that is lost
    status, errors = running.end()
    assert status == 1
    assert "BGIError: the page process ended unexpectedly (exit status" in errors


@posix
def test_a_polite_end_of_the_process_between(program: Start) -> None:
    running = program("getch()\n")
    os.kill(running.child, signal.SIGTERM)
    assert running.page.end() == ENDED
    assert running.end() == (0, "bgi: the page was closed\n")


@pytest.mark.parametrize("call", ["getch()", "delay(60000)", "while True: swapbuffers()"])
def test_the_user_closes_the_program(program: Start, call: str) -> None:
    running = program(f"{call}\n")
    running.page.say("close")
    assert running.page.end() == ENDED
    assert running.end() == (0, "bgi: the page was closed\n")


def test_the_user_closes_the_page(program: Start) -> None:
    running = program("getch()\n")
    running.page.hear_until(lambda page: page.pictures)
    running.page.line.close(LEFT)
    assert running.end() == (0, "bgi: the page was closed\n")


def test_a_planned_end(program: Start, tmp_path: Path) -> None:
    shot = tmp_path / "shot.png"
    running = program("bar(0, 0, 9, 9)\ngetch()\n", BGI_AFTER="500ms", BGI_SHOT=str(shot))
    assert running.page.end() == ENDED
    assert running.end() == (0, "")
    assert shot.exists()


def test_a_recording(program: Start, tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    file = tmp_path / "all.gif"
    source = "for n in range(5):\n    bar(9 * n, 0, 9 * n + 5, 9)\n    delay(100)\n"
    running = program(source, BGI_RECORD=str(file))
    running.page.end()
    assert running.end() == (0, "")
    with image.open(file) as picture:
        assert picture.size == (640, 480) and picture.n_frames >= 4


@posix
def test_a_fork_that_lives_on_keeps_no_page(program: Start) -> None:
    running = program(
        """
import os, time, warnings
warnings.simplefilter("ignore")
fork = os.fork()
if fork == 0:
    os.close(1), os.close(2)
    time.sleep(600)
print(fork, flush=True)
getch()
"""
    )
    assert running.process.stdout
    fork = int(running.process.stdout.readline())
    try:
        running.process.kill()
        assert running.page.end() == ENDED
        running.end()
    finally:
        os.kill(fork, signal.SIGKILL)


# The last page


class Visitor:
    """A connection that is closed with a code."""

    def __init__(self, code: int) -> None:
        self.close_code = code

    def __aiter__(self) -> "Visitor":
        return self

    async def __anext__(self) -> str:
        raise StopAsyncIteration

    async def send(self, message: object) -> None:
        pass


def left(monkeypatch: pytest.MonkeyPatch, *codes: int) -> bool:
    """Whether the program is taken for closed when pages come and go with those codes."""
    monkeypatch.setattr(audience, "LEAVE_SECONDS", 0)
    closed: list[bool] = []

    async def visit() -> None:
        def nothing(*arguments: Any) -> None: ...

        pages = Audience(nothing, nothing, nothing, lambda: closed.append(True))
        for code in codes:
            await pages.admit(Visitor(code))
        await asyncio.sleep(0.01)

    asyncio.run(visit())
    return bool(closed)


def test_a_page_that_is_closed_closes_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    assert left(monkeypatch, LEFT)


def test_a_page_that_is_loaded_anew_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not left(monkeypatch, LEFT, 1006)


def test_a_line_that_is_lost_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not left(monkeypatch, 1006)
    assert not left(monkeypatch, 1001)


# The beginning


def test_it_waits_for_the_first_page(
    card: Card, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(pagewindow, "PAGE_SECONDS", PATIENCE)
    opened: list[PageWindow] = []
    opening = threading.Thread(target=lambda: opened.append(PageWindow(card)))
    opening.start()
    said = ""

    def address() -> str:
        nonlocal said
        said += capsys.readouterr().err
        return said

    wait_until(lambda: address().endswith("\n"))
    assert not opened
    with Page(said.split()[-1]):
        opening.join(PATIENCE)
    opened[0].close()
    assert re.fullmatch(r"bgi: see http://127\.0\.0\.1:\d+/#[\w-]{24}\n", address())


def test_and_goes_on_without_one(window: PageWindow, capsys: pytest.CaptureFixture[str]) -> None:
    assert pagewindow.PAGE_SECONDS == 0
    window.show()


def test_it_says_that_it_goes_on(
    card: Card, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(pagewindow, "PAGE_SECONDS", 0)
    PageWindow(card).close()
    _, line = capsys.readouterr().err.splitlines()
    assert line == "bgi: nobody has looked for 0 seconds; the program goes on"


def test_nobody_lingers_for_nobody(card: Card, window: PageWindow) -> None:
    card.set_text_mode(80, 25, 16)
    card.page(0)[0] = 65
    window.linger()  # returns


def test_text_stays_until_a_key(card: Card, window: PageWindow) -> None:
    card.set_text_mode(80, 25, 16)
    card.page(0)[0] = 65
    with Page(window.url) as page:
        wait_until(lambda: window._pages == 1)
        waiting = threading.Thread(target=window.linger)
        waiting.start()
        page.hear_until(lambda page: "ended: press a key" in page.words.get("title", ""))
        page.say("down", 0, "KeyA", "a")
        waiting.join(PATIENCE)
        assert not waiting.is_alive()


# Without websockets


@pytest.fixture
def nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if websockets were not installed."""
    monkeypatch.setitem(sys.modules, "websockets", None)


MISSING = 'the web monitor needs websockets; type: pip install ".[web]"'


def test_a_program_says_what_to_type(
    nothing: None, card: Card, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("BGI_MONITOR", "web")
    with pytest.raises(BGIError) as caught:
        choose(card)
    assert str(caught.value) == MISSING


def test_the_command_says_it_in_one_line(
    nothing: None, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    with pytest.raises(SystemExit) as caught:
        command.main(["--monitor", "web", "program.py"])
    assert caught.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1] == f"python -m bgi: error: {MISSING}"


# The browser, the notebook


def test_the_browser_is_opened_when_asked(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.setenv("BGI_WEB_OPEN", "1")
    monkeypatch.setattr(pagewindow, "PAGE_SECONDS", 0)
    window = PageWindow(card)
    wait_until(lambda: bool(opened))
    assert opened == [window.url]
    window.close()


def test_open_is_for_the_web_monitor(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        command.main(["--open", "--monitor", "none", "program.py"])
    assert "--open goes with --monitor web" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("prefix", "source"),
    [(None, r"http://127\.0\.0\.1:\d+"), ("/user/ann/", "/user/ann/proxy/\\d+")],
)
def test_a_notebook_shows_the_page_in_a_frame(
    card: Card, monkeypatch: pytest.MonkeyPatch, prefix: str | None, source: str
) -> None:
    import bgi
    from bgi import current

    monkeypatch.setitem(sys.modules, "ipykernel", sys)  # then nobody is waited for
    monkeypatch.setenv("BGI_MONITOR", "web")
    if prefix:
        monkeypatch.setenv("JUPYTERHUB_SERVICE_PREFIX", prefix)
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    shown = current.screen._repr_html_()
    assert shown is not None
    assert re.match(rf'<iframe src="{source}/#[\w-]{{24}}" ', shown)
    bgi.closegraph()
    monkeypatch.setenv("BGI_MONITOR", "none")
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    assert current.screen._repr_html_() is None  # the picture


def test_once_lost_it_is_no_longer_shown(window: PageWindow) -> None:
    window._lose(WindowClosed("gone"), tell=False)
    assert window.notebook_html() == ""
    assert window._plan == Plan()
