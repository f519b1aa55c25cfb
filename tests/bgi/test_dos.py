"""conio.h's keyboard and dos.h's time, sound and chance, without a window."""

import itertools
import os
import random
import subprocess
import sys
import time
from array import array
from calendar import timegm

import pytest

import bgi
from bgi import bios, conio, current, dos, stdlib
from bgi.monitor.headless import Headless
from bgi.monitor.speaker import CLOCK_HERTZ, LOUDNESS, RATE, Speaker


@pytest.fixture
def keys(monkeypatch: pytest.MonkeyPatch) -> None:
    """A screen, and keys that will be pressed."""
    monkeypatch.setenv("BGI_KEYS", "a Up Esc 1")
    bgi.initgraph()


def monitor() -> Headless:
    found = current.screen.monitor
    assert isinstance(found, Headless)
    return found


# The keyboard


def test_ungetch_gives_one_character_back(keys: None) -> None:
    assert conio.getch() == ord("a")
    assert conio.ungetch(ord("b")) == ord("b")
    assert conio.ungetch(ord("c")) == conio.EOF
    assert conio.kbhit()
    assert conio.getch() == ord("b")
    assert conio.getch() == 0
    assert conio.ungetch(ord("d")) == conio.EOF
    assert conio.getch() == 72
    with pytest.raises(ValueError, match="c must be a code from 0 to 255, not 256"):
        conio.ungetch(256)


def test_getche_shows_what_it_returns(keys: None) -> None:
    conio.textmode(conio.C80)
    for code in (0x82, 13, 27, 0x82, 8, 0):
        conio.ungetch(code)
        assert conio.getche() == code
    assert conio.getche() == ord("a")
    assert conio.gettext(1, 1, 3, 1)[::2] == b"\x1b\0a"


def test_bioskey(keys: None) -> None:
    assert dos.bioskey(1) == dos.bioskey(1) == dos.bioskey(0) == 0x1E61
    assert dos.bioskey(0) == 0x4800
    assert conio.getch() == 27
    assert dos.bioskey(0) == 0x0231
    assert (dos.bioskey(1), dos.bioskey(2)) == (0, 0)
    monitor().keys.hold("window", 6, frozenset())
    assert dos.bioskey(2) == 6
    with pytest.raises(ValueError, match="cmd must be 0, 1 or 2, not 3"):
        dos.bioskey(3)
    with pytest.raises(bgi.BGIError, match="nobody can press a key"):
        dos.bioskey(0)


@pytest.mark.parametrize("call", [lambda: dos.bioskey(2), lambda: dos.sound(440), bgi.kbhit])
def test_before_initgraph_a_text_screen_opens_for_keys_and_sounds(call) -> None:
    call()
    assert current.console().is_text
    with pytest.raises(bgi.BGIError, match="not initialized"):
        bgi.circle(1, 1, 1)


def test_silence_needs_no_screen() -> None:
    dos.nosound()
    assert not current.is_open()


# Time


def test_the_clock_is_the_monitors() -> None:
    bgi.initgraph()
    ticks, moment = dos.clock(), dos.gettime()
    dos.sleep(3)
    dos.delay(500)
    assert dos.clock() - ticks in (63, 64)  # 3.5 s of 18.2
    seconds = (dos.gettime().ti_sec - moment.ti_sec) % 60
    assert seconds in (3, 4)
    assert dos.gettime().ti_hund in range(100)


def test_a_program_that_waits_by_the_clock_ends() -> None:
    bgi.initgraph()
    end = dos.clock() + 40
    while dos.clock() < end:
        pass
    assert monitor().now == pytest.approx(40 / 18.2 * 1000, abs=60)


def test_today() -> None:
    before, today, after = time.localtime(), dos.getdate(), time.localtime()
    assert (today.da_year, today.da_mon, today.da_day) in {before[:3], after[:3]}
    moment = dos.gettime()
    assert 0 <= dos.biostime(0) < 24 * 3600 * 18.2 + 1
    assert 0 <= moment.ti_hour < 24
    with pytest.raises(ValueError, match="the clock can be read, not set"):
        dos.biostime(1)


def test_fields_are_in_borlands_order() -> None:
    assert repr(dos.time(1, 2, 3, 4)) == "time(ti_min=1, ti_hour=2, ti_hund=3, ti_sec=4)"
    assert repr(dos.date(1992, 2, 3)) == "date(da_year=1992, da_day=2, da_mon=3)"


@pytest.mark.parametrize("graphics", [False, True])
@pytest.mark.parametrize("wrong", [-1, float("nan"), float("inf"), 1e300, 10**400, 1 << 31])
def test_waiting_for_ever_is_refused(wrong: float, graphics: bool) -> None:
    if graphics:
        bgi.initgraph()
    for wait in (dos.delay, dos.Sleep, dos.sleep):
        with pytest.raises(ValueError, match="seconds must be a finite number of 0 or more, at"):
            wait(wrong)


def test_a_text_is_no_time() -> None:
    with pytest.raises(TypeError, match="milliseconds must be a number, not str: '5'"):
        dos.delay("5")


def test_windows_sleep_counts_milliseconds() -> None:
    bgi.initgraph()
    before = monitor().now
    dos.Sleep(1.5)
    dos.Sleep((1 << 31) - 1)
    assert round(monitor().now - before, 3) == (1 << 31) + 0.5


def test_a_clock_that_has_gone_too_far(monkeypatch: pytest.MonkeyPatch) -> None:
    bgi.initgraph()
    monkeypatch.setattr(monitor(), "time", lambda: 1e300)
    for call in (dos.gettime, dos.getdate, lambda: dos.biostime(0)):
        with pytest.raises(ValueError, match="the clock does not go so far"):
            call()


# A script: every run is like every other

QUESTIONS = """
from bgi import *
from bgi import dos
dos.randomize()
print(dos.gettime(), dos.getdate(), dos.clock(), dos.rand())
initgraph()
dos.randomize()
delay(1234)
print(dos.gettime(), dos.getdate(), dos.clock(), dos.rand())
"""


@pytest.mark.parametrize("zone", ["UTC", "Asia/Kathmandu"])
def test_under_a_script_the_clock_begins_at_one_moment(zone: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", QUESTIONS],
        env=os.environ | {"BGI_KEYS": "a", "TZ": zone},
        capture_output=True,
        text=True,
        check=True,
    )
    first, second = done.stdout.splitlines()
    noon = "time(ti_min=0, ti_hour=12, ti_hund=0, ti_sec=0)"
    later = "time(ti_min=0, ti_hour=12, ti_hund=23, ti_sec=1)"
    day = "date(da_year=1992, da_day=1, da_mon=1)"
    dos.srand(timegm((1992, 1, 1, 12, 0, 0)))
    dice = dos.rand()
    assert first == f"{noon} {day} 0 {dice}"
    assert second == f"{later} {day} 22 {dice}"


def test_under_a_script_time_goes_on_without_a_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "a")
    end = dos.clock() + 3
    while dos.clock() < end:
        pass


# Chance


def test_borlands_generator() -> None:
    dos.srand(1)
    assert [dos.rand() for _ in range(8)] == [346, 130, 10982, 1090, 11656, 7117, 17595, 6415]
    dos.srand(1)
    assert [dos.random(100) for _ in range(3)] == [1, 0, 33]
    assert all(0 <= dos.random(7) < 7 for _ in range(1000))
    assert dos.random(0) == 0  # as by the macro of stdlib.h, which counts it as a draw
    with pytest.raises(ValueError, match="num must be 0 or more, not -1"):
        dos.random(-1)


def test_a_star_leaves_the_programs_time_and_random_alone() -> None:
    brought: dict[str, object] = {}
    exec("import random, time\nfrom bgi.dos import *", brought)
    brought.pop("__builtins__")
    assert brought.pop("time") is time
    assert brought.pop("random") is random
    assert sorted(brought) == sorted(dos.__all__)
    assert not {"time", "random", "clock"} & set(brought)


def test_randomize_is_by_the_clock() -> None:
    bgi.initgraph()
    dos.randomize()
    first = dos.rand()
    dos.sleep(1)
    dos.randomize()
    assert dos.rand() != first


# Sound


def test_what_was_played_and_when() -> None:
    bgi.initgraph()
    begin = monitor().now
    dos.sound(440)
    dos.delay(100)
    dos.sound(880.9)
    dos.delay(50)
    dos.nosound()
    dos.sound(-3)
    played = [(round(moment - begin), hertz) for moment, hertz in monitor().sounds]
    assert played == [(0, 440), (100, 880), (150, 0), (150, 0)]


def samples(speaker: Speaker, count: int) -> list[int]:
    room = array("h", [1] * count)
    speaker.fill(memoryview(room))
    return room.tolist()


@pytest.fixture
def speaker(monkeypatch: pytest.MonkeyPatch) -> Speaker:
    """A speaker that opens no sound card."""
    monkeypatch.setattr(Speaker, "_open", lambda self: None)
    return Speaker()


def test_the_wave_is_square(speaker: Speaker) -> None:
    assert samples(speaker, 3) == [0, 0, 0]
    speaker.sound(440)
    second = samples(speaker, RATE)
    assert set(second) == {-LOUDNESS, LOUDNESS}
    flips = sum(a != b for a, b in itertools.pairwise(second))
    assert flips == pytest.approx(2 * CLOCK_HERTZ / (CLOCK_HERTZ // 440), abs=1)
    speaker.sound(0)
    assert samples(speaker, 5) == [0] * 5


def test_a_change_of_pitch_leaves_no_gap(speaker: Speaker) -> None:
    """Neither a jump back nor a longer half-wave than the lower of the two pitches has."""
    played: list[int] = []
    for number in range(40):
        speaker.sound((300, 1000)[number % 2])
        played += samples(speaker, 77)
    runs = [len(list(run)) for _, run in itertools.groupby(played)]
    assert max(runs) <= RATE / 300 / 2 + 1
    assert min(runs[1:-1]) >= RATE / 1000 / 2 - 1


@pytest.mark.parametrize("hertz", [0, -5, 20_001, 65_535, 10**9])
def test_what_nobody_hears(speaker: Speaker, hertz: int) -> None:
    speaker.sound(hertz)
    assert samples(speaker, 3) == [0, 0, 0]


def test_the_clock_cannot_be_set() -> None:
    with pytest.raises(bgi.BGIError, match="the clock can be read, not set"):
        dos.settime(dos.gettime())
    with pytest.raises(bgi.BGIError, match="the date can be read, not set"):
        dos.setdate(dos.getdate())


def test_what_belongs_to_other_headers_is_found_there_too() -> None:
    assert dos.bioskey is bios.bioskey and dos.random is stdlib.random
