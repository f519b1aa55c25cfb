"""The monitor without a screen, and the choice between the monitors."""

import pytest

import bgi.monitor
from bgi.errors import NobodyThere, TimeIsUp
from bgi.memory.card import Card
from bgi.monitor import Headless, Monitor, choose
from bgi.monitor.plan import Plan
from bgi.monitor.script import parse_script


def test_headless_keeps_the_contract() -> None:
    monitor: Monitor = Headless("")
    monitor.show()
    monitor.set_title("a title")
    monitor.close()
    monitor.close()
    assert not monitor.key_waiting()


def test_it_counts_pictures_and_milliseconds() -> None:
    monitor = Headless("")
    monitor.show()
    monitor.show()
    monitor.sleep(1500)
    monitor.sleep(0.5)
    monitor.sleep(-3)
    monitor.flip()
    assert (monitor.shown, round(monitor.now, 3)) == (3, 1550.5)


def test_it_plays_scripted_keys() -> None:
    monitor = Headless("1 Left " + 100 * "x ")
    assert monitor.key_waiting()
    assert [monitor.read_key() for _ in range(3)] == [ord("1"), 0, 75]
    assert [monitor.read_key() for _ in range(100)] == [ord("x")] * 100
    assert not monitor.key_waiting()


def test_it_presses_a_key_later() -> None:
    monitor = Headless("a Wait2s b Wait500ms Left")
    assert monitor.read_key() == ord("a")
    questions = 0
    while not monitor.key_waiting():
        questions += 1
        monitor.show()
    assert 103 < questions < 106  # pictures in what is left of two seconds
    assert monitor.read_key() == ord("b")
    assert not monitor.key_waiting()
    assert [monitor.read_key(), monitor.read_key()] == [0, 75]  # who waits for it gets it
    assert monitor.now == 2500  # when it was pressed
    with pytest.raises(NobodyThere):
        monitor.read_key()


def test_at_the_end_of_the_script_it_says_what_to_do() -> None:
    monitor = Headless("q")
    monitor.read_key()
    for _ in range(2):
        with pytest.raises(NobodyThere, match=r"nobody can press a key .* no window.* BGI_KEYS"):
            monitor.read_key()


def test_keys_from_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "w Esc")
    monitor = Headless()
    assert [monitor.read_key(), monitor.read_key()] == [ord("w"), 27]
    monkeypatch.setenv("BGI_KEYS", "w Escape")
    with pytest.raises(ValueError, match="'Escape' is not a key"):
        Headless()


def test_none_is_silent(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("BGI_MONITOR", "none")
    monitor = choose(Card(), "my plot")
    assert isinstance(monitor, Headless)
    assert monitor.title == "my plot"
    assert capsys.readouterr() == ("", "")


def test_another_monitor_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_MONITOR", "vga")
    with pytest.raises(
        ValueError, match="BGI_MONITOR is 'vga'; it may be 'window', 'web' or 'none'"
    ):
        choose(Card())


def test_without_a_display_one_line_says_so(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    card = Card()
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("BGI_MONITOR", "DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    bgi.monitor._say_that_there_is_no_window.cache_clear()
    assert isinstance(choose(card), Headless)
    assert isinstance(choose(card), Headless)
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    for word in ("no display", "without a window", "DISPLAY", "ssh -X", "BGI_MONITOR=none"):
        assert word in err


@pytest.mark.parametrize("platform", ["win32", "darwin"])
def test_without_a_window_only_x11_is_told_of_x11(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], platform: str
) -> None:
    monkeypatch.setattr("sys.platform", platform)
    bgi.monitor._say_that_there_is_no_window.cache_clear()
    bgi.monitor._say_that_there_is_no_window("no window: nobody knows why")
    assert capsys.readouterr().err == (
        "bgi: no window: nobody knows why; drawing goes on without a window "
        "(BGI_MONITOR=none silences this line)\n"
    )


@pytest.mark.parametrize(
    ("platform", "variable"),
    [
        ("linux", "DISPLAY"),
        ("linux", "WAYLAND_DISPLAY"),
        ("linux", "SDL_VIDEODRIVER"),
        ("win32", "ANYTHING"),
        ("darwin", "ANYTHING"),
    ],
)
def test_with_a_display_there_is_a_window(
    monkeypatch: pytest.MonkeyPatch, platform: str, variable: str
) -> None:
    for name in ("BGI_MONITOR", "DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv(variable, "something")
    opened = []
    monkeypatch.setattr(bgi.monitor, "Window", lambda *arguments: opened.append(arguments[1]))
    card = Card()
    monkeypatch.setattr("sys.platform", platform)
    choose(card, "a plot")
    assert opened == ["a plot"]


# A script that takes its time


def test_a_key_comes_later() -> None:
    monitor = Headless("a Wait2s Esc b")
    assert monitor.read_key() == ord("a")
    asked = 0
    while not monitor.key_waiting():
        monitor.sleep(100)
        asked += 1
    assert asked == 18  # after the quarter of a second that somebody needs to press "a"
    assert (monitor.read_key(), monitor.read_key()) == (27, ord("b"))


def test_whoever_waits_for_a_key_waits_until_it_comes() -> None:
    monitor = Headless("Wait2s Esc Wait3.5 F1")
    assert (monitor.read_key(), monitor.now) == (27, 2000)
    assert (monitor.read_keystroke(), monitor.now) == (b"\0;", 5500)
    with pytest.raises(NobodyThere):
        monitor.read_key()


def test_the_end_comes_before_a_later_key() -> None:
    monitor = Headless(plan=Plan(parse_script("Wait2s Esc"), after=1))
    with pytest.raises(TimeIsUp):
        monitor.read_key()
    assert monitor.now == 1000


def test_keys_are_held_for_their_time() -> None:
    monitor = Headless("Wait1s +Left +Shift Wait1s +x -Left Wait1s -x -Shift")
    seen = []
    for _ in range(4):
        seen.append((monitor.keys.held, monitor.keys.shifts))
        monitor.sleep(1000)
    assert seen == [
        (set(), 0),
        ({"left", "shift"}, 2),
        ({"shift", "x"}, 2),
        (set(), 0),
    ]
    assert [monitor.read_keystroke() for _ in range(2)] == [b"\0K", b"x"]  # they are typed, too


def test_two_of_one_program_have_one_keyboard_and_one_time() -> None:
    one = Headless("a Wait1s b")
    other = Headless("x y z", beside=one)
    other.sleep(300)
    assert one.now == other.now == 300
    assert (other.read_key(), one.read_key(), one.now) == (ord("a"), ord("b"), 1000)


# A loop that asks in vain


@pytest.mark.parametrize(
    ("plan", "rests"),
    [
        (Plan(), True),
        (Plan(after=1e6), False),
        (Plan(parse_script("Wait9999s a")), False),
    ],
)
@pytest.mark.parametrize("question", ["key_waiting()", "mouse"])
def test_a_loop_that_asks_for_what_never_comes_rests(
    monkeypatch: pytest.MonkeyPatch, plan: Plan, rests: bool, question: str
) -> None:
    slept: list[float] = []
    monkeypatch.setattr("bgi.monitor.headless.time.sleep", slept.append)
    monkeypatch.setattr("bgi.monitor.idling.time.perf_counter", lambda: 100.0)
    card = Card()
    card.set_mode(320, 200, 2)
    monitor = Headless(card=card, plan=plan)
    for _ in range(3000):
        eval(f"monitor.{question}")
    assert bool(slept) == rests
    before = len(slept)
    for wait in (monitor.time, lambda: monitor.sleep(1), monitor.show):
        for _ in range(3000):
            eval(f"monitor.{question}")
            wait()
    assert len(slept) == before
    for number in range(3000):  # one that draws does not
        card.page(0)[number] = 1
        card.touch()
        eval(f"monitor.{question}")
    assert len(slept) <= before + 1
    monitor.close()
