"""The window as a real process: what it shows, what it says, and how it is lost.

SDL's dummy driver takes the place of the screen.
"""

import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import bgi.monitor
from bgi.errors import BGIError, WindowClosed
from bgi.memory.card import Card
from bgi.memory.sdl import pygame
from bgi.monitor import Headless, Monitor, Window, choose, pace
from bgi.monitor.child import Child
from bgi.monitor.display import Display
from bgi.monitor.idling import REST_SECONDS, Idling
from bgi.monitor.inputs import Inputs
from bgi.monitor.plan import Plan
from bgi.monitor.protocol import decode, encode, receive
from bgi.monitor.script import parse_script
from bgi.monitor.speaker import LOUDNESS, RATE
from tests.processes import KILL, LOSSES, gone, memory_of, posix, shared_memory, wait_until


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
    assert gone(window.pid)


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
    start = time.perf_counter()  # on Windows time.monotonic() may stand still for 16 ms
    window.sleep(30)
    window.sleep(0)
    window.sleep(-5)
    assert time.perf_counter() - start >= 0.03


# The end of a window


def lose(window: Window, how: signal.Signals) -> None:
    os.kill(window.pid, how)


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


@posix
def test_show_is_woken_when_the_window_dies(window: Window) -> None:
    os.kill(window.pid, signal.SIGSTOP)
    killer = subprocess.Popen(["sh", "-c", f"sleep 0.2; kill -9 {window.pid}"])
    with pytest.raises(BGIError, match="ended unexpectedly"):
        window.show()
    killer.wait()


def test_on_lost_may_close(card: Card) -> None:
    lost: list[BGIError] = []

    def close(error: BGIError) -> None:
        fragile.close()
        lost.append(error)

    fragile = Window(card, on_lost=close)
    lose(fragile, KILL)
    wait_until(lambda: bool(lost))
    assert gone(fragile.pid)


def test_the_program_may_close_the_window(window: Window, errors: list[BGIError]) -> None:
    window.close()
    assert gone(window.pid)
    with pytest.raises(BGIError, match="closed by the program"):
        window.show()
    window.close()
    assert errors == []


@posix
def test_a_hanging_window_is_killed(window: Window) -> None:
    os.kill(window.pid, signal.SIGSTOP)
    window.close()
    assert gone(window.pid)


def test_files_named_like_modules_do_not_disturb_the_window(
    card: Card, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("random.py", "numpy.py", "signal.py"):
        (tmp_path / name).write_text("raise SystemExit('the wrong module')")
    monkeypatch.chdir(tmp_path)
    window = Window(card)
    window.show()
    window.close()


# Many of them, and for long


def test_ten_windows_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    cards = [Card() for _ in range(10)]
    opening = []
    windows: list[Window] = []
    for card in cards:
        card.set_mode(320, 200, 2)
        opening.append(threading.Thread(target=lambda card=card: windows.append(Window(card))))
        opening[-1].start()
    for thread in opening:
        thread.join()
    for window in windows:
        window.show()
    assert len({window.pid for window in windows}) == 10
    lose(windows[3], KILL)
    wait_until(lambda: gone(windows[3].pid))
    for window in windows[:3] + windows[4:]:
        window.show()
    for window in windows:
        window.close()
        assert gone(window.pid)


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_two_thousand_flips_leave_nothing_behind(
    card: Card, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("BGI_RATE", "100000")
    window = Window(card)

    def flip(times: int) -> None:
        for number in range(times):
            card.page(number % 2)[number % 64000] += 1
            card.visible = number % 2
            window.show()

    def state() -> tuple[int, ...]:
        pids = os.getpid(), window.pid
        files = [len(os.listdir(f"/proc/{pid}/fd")) for pid in pids]
        return *files, *map(memory_of, pids)

    flip(200)
    files, child_files, memory, child_memory = state()
    flip(2000)
    after = state()
    assert after[:2] == (files, child_files)
    assert after[2] - memory < 2000  # kilobytes
    assert after[3] - child_memory < 2000
    assert window.presents > 2000
    window.close()


def test_windows_killed_again_and_again(card: Card) -> None:
    for _ in range(8):
        window = Window(card)
        lose(window, KILL)
        with pytest.raises(BGIError, match="ended unexpectedly"):
            while True:
                window.show()
        window.close()
        assert gone(window.pid)


def test_under_a_script_the_clock_of_a_window_begins_at_one_moment(
    card: Card, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("BGI_KEYS", "a")
    window = Window(card)
    assert time.localtime(window.time())[:3] == (1992, 1, 1)
    before = window.time()
    window.sleep(20)
    assert window.time() - before >= 0.019
    window.close()


@pytest.mark.parametrize(
    ("given", "rate"),
    [
        ("100", 100),
        ("0.5", 1),
        ("-3", 1),
        ("nan", pace.RATE),
        ("inf", pace.RATE),
        ("x", pace.RATE),
    ],
)
def test_the_rate_of_pictures(monkeypatch: pytest.MonkeyPatch, given: str, rate: float) -> None:
    monkeypatch.setenv("BGI_RATE", given)
    assert pace.frame_seconds() == 1 / rate


# Sound


def test_the_samples_that_are_played(
    card: Card, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = tmp_path / "samples"
    monkeypatch.setenv("SDL_AUDIODRIVER", "disk")
    monkeypatch.setenv("SDL_DISKAUDIOFILE", str(file))
    window = Window(card)
    window.sleep(50)
    assert not file.exists()  # opened by the first sound
    for hertz in (440, 880, 0):
        window.sound(hertz)
        window.sleep(300)
    window.close()
    samples = np.fromfile(file, "<i2")
    assert set(samples.tolist()) == {-LOUDNESS, 0, LOUDNESS}
    played = np.flatnonzero(samples)
    assert np.ptp(played) + 1 == len(played)  # no gap
    ends = np.flatnonzero(np.diff(samples[played]))
    halves = np.diff(ends)  # samples from one flip of the membrane to the next
    for hertz in (440, 880):
        expected = RATE / hertz / 2
        near = abs(halves - expected) <= 1
        assert near.sum() > 2 * hertz * 0.1  # for a tenth of a second at least
    assert halves.max() <= RATE / 440 / 2 + 1


def test_no_sound_card_is_silence(
    card: Card, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "nonsense")
    window = Window(card)
    window.sound(440)
    window.sound(0)
    window.show()
    window.close()
    assert capfd.readouterr() == ("", "")


# A loop around kbhit()


class Loop:
    """A program that asks for keys on and on, by a clock of its own."""

    def __init__(self, card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 100.0
        monkeypatch.setattr("bgi.monitor.idling.time.perf_counter", lambda: self.now)
        self._idling = Idling(card)

    def rests(self, questions: int, seconds: float, work: Callable[[int], object]) -> int:
        """How often it may rest while it asks so often, doing some work that takes so long."""
        rests = 0
        for number in range(questions):
            work(number)
            self.now += seconds
            rest = self._idling.count_question()
            rests += rest
            self.now += REST_SECONDS * rest
        return rests


def test_a_loop_that_only_asks_for_keys_rests(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    loop = Loop(card, monkeypatch)
    page = card.page(0)

    def draw(number: int) -> None:
        page[number % 64000] ^= 1

    assert loop.rests(10_000, 1e-6, draw) == 0
    assert loop.rests(20_000, 1e-5, lambda number: None) == 0  # it computes
    assert loop.rests(3_000, 1e-6, lambda number: None) > 10
    assert loop.rests(10_000, 1e-6, draw) <= 1  # until it is noticed
    assert loop.rests(3_000, 1e-6, lambda number: card.touch()) <= 1


def test_a_key_ends_a_rest_at_once(window: Window, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bgi.monitor.window.REST_SECONDS", 1000)
    typist = threading.Timer(0.1, window.keys.put, [b"k"])
    typist.start()
    while not window.key_waiting():
        pass
    typist.join()


# The keyboard


def test_a_script_presses_keys_in_a_window_as_well(card: Card) -> None:
    window = Window(card, plan=Plan(parse_script("a Wait0.2s +Left Wait0.1s -Left b")))
    assert window.read_key() == ord("a")
    began = time.monotonic()
    assert window.read_keystroke() == b"\0K"
    assert time.monotonic() > began
    assert "left" in window.keys.held
    assert window.read_key() == ord("b")
    assert window.keys.held == set()
    window.close()


def test_the_keyboard_is_that_of_all_windows(card: Card, window: Window) -> None:
    """What is typed into any of them is read; and one that is lost takes nothing along."""
    other = Window(card, beside=window, plan=Plan(parse_script("x y z")))
    other._hear("key", "97")
    other._hear("key", "0 72")
    other._hear("held", "2 shift up")
    assert window.key_waiting()
    assert (window.read_key(), window.read_keystroke()) == (97, b"\0H")
    assert (window.keys.held, window.keys.shifts) == ({"shift", "up"}, 2)
    waiting = threading.Timer(0.1, other.close)
    waiting.start()
    threading.Timer(0.3, window._hear, ["key", "98"]).start()
    assert window.read_key() == 98
    assert window.keys.held == set()
    with pytest.raises(BGIError, match="closed by the program"):
        other.read_key()
    waiting.join()


def test_what_is_held_is_told_once_it_can_be(
    card: Card, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Keys go down and up, repeat, and the pipe is full for a while."""
    monkeypatch.setattr(pygame.key, "get_focused", lambda: True)
    told: list[tuple[object, ...]] = []
    takes = [True]

    def send(*message: object) -> bool:
        if takes[0]:
            told.append(message)
        return takes[0]

    inputs = Inputs(Display(card, tmp_path), send, {})
    down = {"left": pygame.K_LEFT, "a": pygame.K_a}

    def key(kind: int, number: int) -> None:
        inputs.handle(pygame.event.Event(kind, key=number, mod=0, unicode=""))
        inputs.flush()

    key(pygame.KEYDOWN, down["left"])
    key(pygame.KEYDOWN, down["a"])
    key(pygame.KEYDOWN, down["a"])
    takes[0] = False
    key(pygame.KEYUP, down["left"])
    takes[0] = True
    inputs.flush()
    key(pygame.KEYUP, down["a"])
    assert [message for message in told if message[0] == "held"] == [
        ("held", 0, "left"),
        ("held", 0, "a", "left"),
        ("held", 0, "a"),
        ("held", 0),
    ]
    pygame.quit()


@pytest.mark.parametrize("question", ["mouse", "keys", "time()"])
def test_whoever_asks_for_anything_rests(
    window: Window, monkeypatch: pytest.MonkeyPatch, question: str
) -> None:
    rests: list[str] = []
    monkeypatch.setattr(window._idling, "count_question", lambda: len(rests) < 3)
    monkeypatch.setattr(window, "_wait", lambda done, until: rests.append(question))
    for _ in range(5):
        eval(f"window.{question}")
    assert rests == 3 * [question]


@posix
def test_a_program_that_does_not_read_is_told_later(card: Card, tmp_path: Path) -> None:
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    child = Child(card, tmp_path, queue.SimpleQueue(), writer)
    full = os.write(writer, bytes(1 << 20))  # as much as the pipe takes
    child._show("7")
    child._present()
    assert child._asked == "7"
    assert len(os.read(reader, full)) == full
    child._free = 0
    child._present()
    assert os.read(reader, 100) == encode("shown", 7, child._display.presents)
    os.close(reader)
    os.close(writer)
    pygame.quit()


@posix
def test_a_window_that_goes_without_a_word_was_closed(
    window: Window, errors: list[BGIError], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(window, "_hear", lambda word, rest: None)  # the pipe was full
    os.kill(window.pid, signal.SIGTERM)
    wait_until(lambda: bool(errors))
    assert isinstance(errors[0], WindowClosed)


# No window


def test_no_window_is_one_clear_line(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "window")
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    with pytest.raises(BGIError, match=r"^no window: nonsense not available$"):
        choose(card)


@pytest.mark.skipif(sys.platform != "linux", reason="speaks of X11")
@pytest.mark.parametrize(
    ("driver", "display", "reason"),
    [
        ("", ":4711", "no window: the display ':4711' cannot be opened"),
        ("nonsense", "", "no window: nonsense not available"),
    ],
)
def test_where_no_window_can_be_the_program_goes_on(
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
    card: Card,
    driver: str,
    display: str,
    reason: str,
) -> None:
    for name in ("BGI_MONITOR", "SDL_VIDEODRIVER", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", display)
    if driver:
        monkeypatch.setenv("SDL_VIDEODRIVER", driver)
    bgi.monitor._say_that_there_is_no_window.cache_clear()
    assert isinstance(choose(card), Headless)
    assert isinstance(choose(card), Headless)
    out, err = capfd.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert err.startswith(f"bgi: {reason}; drawing goes on without a window")


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


def test_a_signal_handler_may_ask_while_a_call_holds_a_lock(window: Window) -> None:
    """It runs in the thread that it interrupts: a lock that waits for itself waits for ever."""
    window.keys.put(b"a")
    with window.mouse._lock, window.keys._changed, window._news:
        assert window.key_waiting()
        assert window.read_key() == ord("a")
        window.mouse.move(1, 2)
        assert window.mouse.take_wheel() == 0
        window.show()
        window.sleep(1)
