"""The window as a real process: what it shows, what it says, and how it is lost.

SDL's dummy driver takes the place of the screen.
"""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from bgi.card import Card
from bgi.errors import BGIError
from bgi.monitor import Monitor, Window, choose
from bgi.monitor.protocol import decode, encode, receive
from tests.processes import LOSSES, gone, shared_memory, wait_until

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="uses POSIX signals")


@pytest.fixture(autouse=True)
def shared_memory_stays_clean() -> Iterator[None]:
    before = shared_memory()
    yield
    assert shared_memory() <= before


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_mode(320, 200, 2)
    return card


@pytest.fixture
def errors() -> list[BGIError]:
    """What on_lost was told."""
    return []


@pytest.fixture
def window(card: Card, errors: list[BGIError]) -> Iterator[Window]:
    window = Window(card, "a test", errors.append)
    yield window
    window.close()
    assert gone(window._process.pid)


# The protocol


@pytest.mark.parametrize("text", ["plain", "", "two\nlines", "ünï ✓ \\n", " blanks ", "\ud800"])
def test_any_text_crosses_as_one_line(text: str) -> None:
    line = encode("title", text)
    assert line.endswith(b"\n")
    assert line.count(b"\n") == 1
    assert decode(line[:-1]) == ("title", text)


def test_messages_are_put_together_again() -> None:
    reader, writer = os.pipe()
    for piece in (b"sho", b"wn 3 4\nkey 0 72\nclo", b"sed\nunfinished"):
        os.write(writer, piece)
    os.close(writer)
    assert list(receive(reader)) == [("shown", "3 4"), ("key", "0 72"), ("closed", "")]
    os.close(reader)


def test_garbage_is_a_word_nobody_knows() -> None:
    assert decode(b"\xff\\x") == decode(b"\xff\\x")
    assert encode("shown", 3, 4) == b"shown 3 4\n"


# Pictures


def test_show_presents_only_what_has_changed(card: Card, window: Window) -> None:
    def presents() -> int:
        window.show()
        return window.presents

    start = presents()
    assert [presents() for _ in range(3)] == [start] * 3
    card.page(0)[100] = 3
    assert presents() == start + 1
    card.page(1)[100] = 3  # hidden
    card.touch()
    assert presents() == start + 1
    card.visible = 1  # the same picture
    assert presents() == start + 1
    card.page(1)[7] = 3
    assert presents() == start + 2
    card.palette[3] = 1, 2, 3
    assert presents() == start + 3
    card.set_mode(640, 350, 2)
    assert presents() == start + 4


def test_a_damaged_header_is_survived(card: Card, window: Window) -> None:
    for offset in (12, 16, 20, 28):
        card._set(offset, 0xFFFFFFFF)
        window.show()
    card.set_mode(640, 480, 2)
    before = window.presents
    window.show()
    assert window.presents == before + 1


def test_any_title_will_do(window: Window) -> None:
    for title in ("", "two\nlines", "nul\0", "✓ 😀", "\ud800", "x" * 3000):
        window.set_title(title)
    window.show()


def test_sleep_waits(window: Window) -> None:
    start = time.monotonic()
    window.sleep(30)
    window.sleep(0)
    window.sleep(-5)
    assert time.monotonic() - start >= 0.03


# The end of a window


def lose(window: Window, how: signal.Signals) -> None:
    os.kill(window._process.pid, how)


@pytest.mark.parametrize(("how", "kind", "text"), LOSSES)
def test_after_the_window_every_call_raises(
    window: Window, errors: list[BGIError], how: signal.Signals, kind: type[BGIError], text: str
) -> None:
    lose(window, how)
    wait_until(lambda: bool(errors))
    calls: list[Callable[[], object]] = [
        window.show,
        window.key_waiting,
        window.read_key,
        lambda: window.sleep(1),
        lambda: window.set_title("x"),
    ]
    for call in calls:
        with pytest.raises(kind) as caught:
            call()
        assert str(caught.value) == text
    window.close()
    window.close()
    assert [str(error) for error in errors] == [text]


def test_show_is_woken_when_the_window_dies(window: Window) -> None:
    os.kill(window._process.pid, signal.SIGSTOP)
    killer = subprocess.Popen(["sh", "-c", f"sleep 0.2; kill -9 {window._process.pid}"])
    with pytest.raises(BGIError, match="ended unexpectedly"):
        window.show()
    killer.wait()


def test_on_lost_may_close(card: Card) -> None:
    lost: list[BGIError] = []

    def close(error: BGIError) -> None:
        fragile.close()
        lost.append(error)

    fragile = Window(card, on_lost=close)
    lose(fragile, signal.SIGTERM)
    wait_until(lambda: bool(lost))
    assert gone(fragile._process.pid)


def test_the_program_may_close_the_window(window: Window, errors: list[BGIError]) -> None:
    window.close()
    assert gone(window._process.pid)
    with pytest.raises(BGIError, match="closed by the program"):
        window.show()
    window.close()
    assert errors == []


def test_a_hanging_window_is_killed(window: Window) -> None:
    os.kill(window._process.pid, signal.SIGSTOP)
    window.close()
    assert gone(window._process.pid)


def test_files_named_like_modules_do_not_disturb_the_window(
    card: Card, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("random.py", "numpy.py", "signal.py"):
        (tmp_path / name).write_text("raise SystemExit('the wrong module')")
    monkeypatch.chdir(tmp_path)
    window = Window(card)
    window.show()
    window.close()


# No window


def test_no_window_is_one_clear_line(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "window")
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    with pytest.raises(BGIError, match=r"^no window: nonsense not available \(BGI_MONITOR=none"):
        choose(card)


@pytest.mark.skipif(sys.platform != "linux", reason="needs X11")
def test_a_display_that_is_not_there(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("BGI_MONITOR")
    monkeypatch.delenv("SDL_VIDEODRIVER")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setenv("DISPLAY", ":4711")
    with pytest.raises(BGIError, match=r"^no window: the display ':4711' cannot be opened"):
        choose(card)


def test_a_python_that_is_not_there(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    with pytest.raises(BGIError, match=r"no window: its process could not be started: .*nowhere"):
        Window(card)


def test_choose_opens_a_window(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "window")
    monitor: Monitor = choose(card, "chosen")
    assert isinstance(monitor, Window)
    monitor.show()
    assert not monitor.key_waiting()
    monitor.close()
