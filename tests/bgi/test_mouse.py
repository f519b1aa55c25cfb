"""The mouse, by WinBGIm's calls and by the driver's: events are what a monitor would report."""

import threading

import pytest

import bgi
from bgi import conio, current, mouse
from bgi.api import clicks
from bgi.constants import (
    NO_CLICK,
    WM_LBUTTONDBLCLK,
    WM_LBUTTONDOWN,
    WM_LBUTTONUP,
    WM_MBUTTONDOWN,
    WM_MOUSEMOVE,
    WM_RBUTTONDOWN,
    WM_RBUTTONUP,
)
from bgi.monitor import pointer as state
from bgi.monitor.pointer import MOVED, Mouse, pressed, released

LEFT_DOWN, LEFT_UP, RIGHT_DOWN, RIGHT_UP, MIDDLE_DOWN, MIDDLE_UP = (2 << n for n in range(6))


@pytest.fixture(autouse=True)
def screen() -> None:
    bgi.initgraph(bgi.VGA, bgi.VGAHI)


def hear(event: int, x: int, y: int, buttons: int = 0) -> None:
    """The monitor reports an event."""
    current.screen.monitor.mouse.hear(event, x, y, buttons)


def test_events_are_the_bits_of_the_drivers_mask() -> None:
    numbers = [event(button) for button in (0, 1, 2) for event in (pressed, released)]
    assert numbers == [LEFT_DOWN, LEFT_UP, RIGHT_DOWN, RIGHT_UP, MIDDLE_DOWN, MIDDLE_UP]


# WinBGIm


def test_where_the_mouse_is() -> None:
    assert (clicks.mousex(), clicks.mousey()) == (0, 0)
    hear(MOVED, 30, 40)
    assert (clicks.mousex(), clicks.mousey()) == (30, 40)


def test_only_the_latest_click_is_kept() -> None:
    assert not clicks.ismouseclick(WM_RBUTTONDOWN)
    assert clicks.getmouseclick(WM_RBUTTONDOWN) == (NO_CLICK, NO_CLICK)
    for x in range(3):
        hear(RIGHT_DOWN, 100 * x, 5, 2)
        hear(RIGHT_UP, 100 * x, 6, 0)
    assert clicks.ismouseclick(WM_RBUTTONDOWN)
    assert clicks.getmouseclick(WM_RBUTTONDOWN) == (200, 5)
    assert not clicks.ismouseclick(WM_RBUTTONDOWN)
    assert clicks.getmouseclick(WM_RBUTTONUP) == (200, 6)
    assert not clicks.ismouseclick(WM_LBUTTONDOWN)


def test_a_queue_keeps_them_all() -> None:
    clicks.setmousequeuestatus(WM_MBUTTONDOWN)
    for x in range(3):
        hear(MIDDLE_DOWN, 100 * x, 5, 4)
    assert clicks.getmouseclick(WM_MBUTTONDOWN) == (0, 5)
    clicks.clearmouseclick(WM_MBUTTONDOWN)
    assert clicks.getmouseclick(WM_MBUTTONDOWN) == (200, 5)
    clicks.clearmouseclick(WM_MBUTTONDOWN)  # none is left
    for x in range(3):
        hear(MIDDLE_DOWN, 100 * x, 7, 4)
    clicks.setmousequeuestatus(WM_MBUTTONDOWN, False)
    assert clicks.getmouseclick(WM_MBUTTONDOWN) == (200, 7)
    assert not clicks.ismouseclick(WM_MBUTTONDOWN)


def test_a_double_click(monkeypatch: pytest.MonkeyPatch) -> None:
    now = 100.0
    monkeypatch.setattr("bgi.monitor.pointer.time.monotonic", lambda: now)
    kinds = []
    for wait, x in [(0, 50), (0.4, 52), (0.4, 52), (0.6, 52), (0.1, 70)]:
        now += wait
        hear(LEFT_DOWN, x, 50, 1)
        double = clicks.ismouseclick(WM_LBUTTONDBLCLK)
        assert double != clicks.ismouseclick(WM_LBUTTONDOWN)
        clicks.clearmouseclick(WM_LBUTTONDBLCLK if double else WM_LBUTTONDOWN)
        kinds.append(double)
    assert kinds == [False, True, False, False, False]


def test_handlers() -> None:
    calls: list[tuple[str, int, int]] = []
    done = threading.Event()

    def click(x: int, y: int) -> None:
        calls.append(("click", x, y))
        bgi.putpixel(x, y, 5)
        bgi.swapbuffers()  # it may even wait

    clicks.registermousehandler(WM_LBUTTONDOWN, click)
    clicks.registermousehandler(WM_MOUSEMOVE, lambda x, y: calls.append(("move", x, y)))
    clicks.registermousehandler(WM_LBUTTONUP, lambda x, y: done.set())
    hear(MOVED, 1, 2)
    hear(LEFT_DOWN, 3, 4, 1)
    clicks.registermousehandler(WM_MOUSEMOVE, None)
    hear(MOVED, 5, 6, 1)
    hear(LEFT_UP, 5, 6)
    assert done.wait(10)
    assert [call for call in calls if call[0] == "click"] == [("click", 3, 4)]
    assert ("move", 5, 6) not in calls


def test_an_error_in_a_handler_is_printed_and_no_more(capfd: pytest.CaptureFixture[str]) -> None:
    done = threading.Event()
    clicks.registermousehandler(WM_LBUTTONDOWN, lambda x, y: 1 / 0)
    clicks.registermousehandler(WM_LBUTTONUP, lambda x, y: done.set())
    hear(LEFT_DOWN, 3, 4, 1)
    hear(LEFT_UP, 3, 4)
    assert done.wait(10)
    assert "ZeroDivisionError" in capfd.readouterr().err


@pytest.mark.parametrize("kind", [0, 511, 522])
def test_other_kinds_are_refused(kind: int) -> None:
    for call in (
        clicks.ismouseclick,
        clicks.getmouseclick,
        clicks.clearmouseclick,
        clicks.setmousequeuestatus,
        lambda kind: clicks.registermousehandler(kind, None),
    ):
        with pytest.raises(ValueError, match=f"kind must be WM_MOUSEMOVE, .* not {kind}"):
            call(kind)


# The mouse driver


def test_position_and_buttons() -> None:
    assert mouse.reset() == 3
    assert mouse.position() == (320, 240)
    hear(LEFT_DOWN, 10, 20, 1)
    hear(RIGHT_DOWN, 11, 21, 3)
    assert (mouse.position(), mouse.buttons()) == ((11, 21), 3)
    mouse.set_position(5, 1000)
    assert mouse.position() == (5, 479)
    mouse.set_position(-7, -1)
    assert mouse.position() == (0, 0)


def test_presses_and_releases_are_counted_until_asked_for() -> None:
    for x in (10, 20, 30):
        hear(LEFT_DOWN, x, 1, 1)
        hear(LEFT_UP, x, 2)
    assert mouse.presses(mouse.LEFT) == (3, 30, 1)
    assert mouse.presses(mouse.LEFT) == (0, 30, 1)
    assert mouse.releases(mouse.LEFT) == (3, 30, 2)
    assert mouse.presses(mouse.MIDDLE) == (0, 0, 0)
    for button in (-1, 3):
        with pytest.raises(ValueError, match="button must be 0"):
            mouse.presses(button)


def test_ranges() -> None:
    mouse.set_position(300, 300)
    mouse.set_horizontal_range(200, 100)
    assert mouse.position() == (200, 300)
    mouse.set_vertical_range(-5, 50)
    assert mouse.position() == (200, 50)
    mouse.set_position(0, 9999)
    assert mouse.position() == (100, 50)
    mouse.reset()
    mouse.set_position(0, 9999)
    assert mouse.position() == (0, 479)


def test_mickeys() -> None:
    mouse.reset()
    hear(MOVED, 330, 250)
    hear(MOVED, 300, 260)
    assert mouse.mickeys() == (-20, 40)
    assert mouse.mickeys() == (0, 0)


def test_wheel() -> None:
    for turned in (-1, -1, -1, 1):
        current.screen.monitor.mouse.roll(turned)
    assert mouse.wheel() == -2
    assert mouse.wheel() == 0


def test_on_event() -> None:
    calls = []
    done = threading.Event()

    def handler(*event: int) -> None:
        calls.append(event)
        if event[0] == RIGHT_UP:
            done.set()

    mouse.on_event(LEFT_DOWN | RIGHT_UP, handler)
    hear(MOVED, 1, 1)
    hear(LEFT_DOWN, 2, 3, 1)
    hear(LEFT_UP, 2, 3)
    hear(RIGHT_UP, 4, 5)
    assert done.wait(10)
    assert calls == [(LEFT_DOWN, 1, 2, 3), (RIGHT_UP, 0, 4, 5)]
    mouse.on_event(0, None)
    assert current.screen.monitor.mouse.handlers == {}


def test_what_the_monitor_is_told() -> None:
    told: list[tuple[object, ...]] = []
    pointer = Mouse(lambda *message: told.append(message))
    pointer.show()
    pointer.show()  # counts no further
    pointer.hide()
    pointer.hide()
    pointer.show()
    pointer.show()
    assert [message[1] for message in told] == [
        "shown",
        "shown",
        "hidden",
        "hidden",
        "hidden",
        "shown",
    ]
    told.clear()
    pointer.limit(1, 2, 3, 4)
    pointer.reset(7, 8)
    assert told == [
        ("limits", 1, 2, 3, 4),
        ("move", 1, 2),
        ("limits",),
        ("pointer", "system"),
        ("shape",),
        ("move", 7, 8),
    ]


def test_the_look_of_the_pointer(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[object, ...]] = []
    monkeypatch.setattr(current.screen.monitor.mouse, "_tell", lambda *word: told.append(word))
    mouse.set_graphics_cursor(8, -16, [0xFFFF] * 16 + [0x18000] * 16)
    assert told == [("shape", 8, -16, *[0xFFFF] * 16, *[0x8000] * 16)]
    for masks in ([], [0] * 31, b"x" * 33):
        with pytest.raises(ValueError, match="masks must be 32 numbers"):
            mouse.set_graphics_cursor(0, 0, masks)
    with pytest.raises(ValueError, match=r"^x and y, the hot spot, must be"):
        mouse.set_graphics_cursor(17, 0, [0] * 32)


def test_waiting_clicks_are_bounded() -> None:
    clicks.setmousequeuestatus(WM_RBUTTONUP)
    for x in range(state.MAX_WAITING + 10):
        hear(RIGHT_UP, x, 0)
    assert clicks.getmouseclick(WM_RBUTTONUP) == (10, 0)


def test_before_initgraph_there_is_a_text_screen() -> None:
    bgi.closegraph()
    assert mouse.reset() == 3
    assert mouse.position() == (320, 200)
    assert current.console().is_text


@pytest.mark.parametrize(
    ("number", "width", "height"),
    [(conio.C80, 640, 400), (conio.C40, 320, 400), (conio.C4350, 640, 400), (conio.MONO, 640, 400)],
)
def test_in_a_text_mode_places_are_pixels_of_its_picture(
    number: int, width: int, height: int
) -> None:
    conio.textmode(number)
    mouse.reset()
    assert mouse.position() == (width // 2, height // 2)
    mouse.set_position(9999, 9999)
    assert mouse.position() == (width - 1, height - 1)
    mouse.set_horizontal_range(-5, 100)
    mouse.set_vertical_range(20, 9999)
    mouse.set_position(9999, 0)
    assert mouse.position() == (100, 20)
    hear(LEFT_DOWN, 10, 20, 1)
    assert (mouse.position(), mouse.buttons(), mouse.presses(0)) == ((10, 20), 1, (1, 10, 20))


def test_over_a_picture_again_they_are_its_own() -> None:
    conio.textmode(conio.C80)
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    mouse.reset()
    assert mouse.position() == (320, 240)
