"""A program without a window that waits for what never comes, and those that only look so."""

import threading
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from bgi.memory.card import Card
from bgi.monitor.idling import REST_SECONDS
from bgi.monitor.waiting import DELAYS, LOOK_SECONDS, LOOKS, Waiting

A_DAY = 24 * 3600


class Program:
    """It asks in vain on and on, by a clock of its own."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 100.0
        clock = SimpleNamespace(monotonic=lambda: self.now)
        monkeypatch.setattr("bgi.monitor.waiting.time", clock)
        before = threading.enumerate()  # other tests may have left some
        threads = SimpleNamespace(
            current_thread=threading.current_thread,
            enumerate=lambda: [one for one in threading.enumerate() if one not in before],
        )
        monkeypatch.setattr("bgi.monitor.waiting.threading", threads)
        self.card = Card()
        self.card.set_mode(64, 32, 2, 1, False)
        self.pixels = np.frombuffer(self.card.page(0), np.uint8)
        self.waiting = Waiting(self.card)

    def asks(self, seconds: float, between: Callable[[], object]) -> float:
        """How long it asks, doing something between two questions that takes so long."""
        began = self.now
        while not self.waiting.is_endless() and self.now < began + A_DAY / 8:
            between()
            self.now += seconds
        return self.now - began


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch) -> Program:
    return Program(monkeypatch)


MINUTE = LOOKS * LOOK_SECONDS
FOR_EVER = pytest.approx(A_DAY / 8, abs=60)


def test_one_that_does_nothing_else_waits_for_ever(program: Program) -> None:
    assert 60 < MINUTE < program.asks(REST_SECONDS, program.waiting.rest) < 70


def test_one_that_lets_time_pass_waits_for_ever(program: Program) -> None:
    def delay() -> None:
        program.waiting.delay(1000)

    assert MINUTE < program.asks(0.001, delay) < 70
    hour = LOOKS * DELAYS / 1000
    assert hour <= program.asks(1.0, delay) < hour + DELAYS / 500  # it computes for a second


def test_one_that_has_been_told_may_wait_again(program: Program) -> None:
    for _ in range(2):
        assert program.asks(REST_SECONDS, program.waiting.rest) < 70


def test_one_that_draws_once_a_minute_does_not(program: Program) -> None:
    def clock() -> None:
        program.waiting.rest()
        program.pixels[0] = program.now // 60 % 2

    assert program.asks(0.5, clock) == FOR_EVER


def test_one_that_only_moves_things_does_not(program: Program) -> None:
    program.pixels[:8] = 15
    before = program.card.checksum()

    def move() -> None:
        program.waiting.rest()
        program.pixels[:] = np.roll(program.pixels, 8)

    assert program.asks(REST_SECONDS * 17, move) == FOR_EVER
    assert program.card.checksum() == before  # a sum cannot tell


def test_one_that_computes_or_sleeps_by_itself_does_not(program: Program) -> None:
    assert program.asks(1.0, lambda: None) == FOR_EVER


def test_one_with_a_thread_at_work_does_not_before_that_ends(program: Program) -> None:
    done = threading.Event()
    thread = threading.Thread(target=done.wait)
    thread.start()
    assert program.asks(0.5, program.waiting.rest) == FOR_EVER
    done.set()
    thread.join()
    assert program.asks(REST_SECONDS, program.waiting.rest) < 70
