"""The page in a real browser, a headless Chromium: what is seen, typed, clicked and saved.

These tests are skipped in CI, and where Chromium is not installed.
"""

import os
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from bgi.errors import WindowClosed
from bgi.memory import imagefile
from bgi.memory.card import NO_CURSOR, Card
from bgi.monitor import PageWindow, picture
from bgi.monitor.letters import drawn
from bgi.monitor.pointer import LEFT, MIDDLE, RIGHT, pressed, released
from bgi.monitor.web import pagewindow
from tests.monitor.web.page import addressed
from tests.monitor.web.tabs import CANVAS, click, on, shows
from tests.processes import KILL, wait_until
from tools.chromium import Browser, Tab

NOTICE = "document.querySelector('#notice:not([hidden]) span')?.textContent"
CTRL, SHIFT = 2, 8

# Pictures


@pytest.mark.parametrize(
    ("width", "height", "size", "square"),
    [(640, 480, 1, False), (320, 200, 1, False), (320, 240, 4, True)],
)
def test_the_picture_is_the_cards(
    card: Card, tab: Tab, width: int, height: int, size: int, square: bool
) -> None:
    """Index for index: every index has a colour of its own."""
    chance = np.random.default_rng(1)
    card.set_mode(width, height, 2, size, square)
    card.palette[:] = [(i, 255 - i, i ^ 85) for i in range(256)]
    for _ in range(3):
        start, end = sorted(chance.integers(0, width * height * size, 2))
        card.page(0)[start:end] = chance.integers(0, 256, end - start, np.uint8).tobytes()
        shows(tab, lambda: on(card))
    card.palette[:] = card.palette[::-1].copy()  # colours move, pixels stay
    shows(tab, lambda: on(card))


def test_a_text_screen(card: Card, tab: Tab) -> None:
    card.set_text_mode(80, 25, 16)
    cells = card.page(0)
    cells[:] = np.random.default_rng(1).integers(0, 128, len(cells), np.uint8).tobytes()
    card.cursor[0] = NO_CURSOR
    frame = card.frame()
    assert frame is not None and frame.text is not None
    expected = picture.colors(card.colors())[drawn(frame, frame.text)]
    shows(tab, lambda: expected)


@pytest.mark.parametrize(
    ("room", "shape"),
    [
        ((1400, 1100), (640, 480, False)),
        ((1000, 700), (320, 200, False)),
        ((1000, 700), (640, 350, False)),
        ((500, 300), (640, 480, False)),
        ((1000, 700), (200, 300, True)),
    ],
)
def test_it_is_enlarged_as_in_the_window(
    card: Card, tab: Tab, room: tuple[int, int], shape: tuple[int, int, bool]
) -> None:
    width, height, square = shape
    card.set_mode(width, height, 1, 1, square)
    tab.resize(*room)
    tab.wait_for(f"{CANVAS}.width === {width} && innerWidth === {room[0]}")
    bar = tab.evaluate("document.getElementById('bar').offsetHeight")
    expected = picture.inside(picture.Shape(width, height, square), room[0], room[1] - bar)
    tab.wait_for(f"{CANVAS}.offsetWidth === {expected[0]}")
    assert tab.evaluate(f"{CANVAS}.offsetHeight") == expected[1]
    crisp = tab.evaluate(f"getComputedStyle({CANVAS}).imageRendering") == "pixelated"
    assert crisp == (expected[0] >= width and expected[1] >= height)


def test_on_a_phone_nothing_sticks_out(card: Card, tab: Tab) -> None:
    tab.resize(380, 700, 3, phone=True)
    tab.evaluate("location.reload()")
    tab.wait_for(f"{CANVAS}.offsetWidth > 300 && !document.getElementById('keyboard').hidden")
    assert tab.evaluate("document.documentElement.scrollWidth") == 380
    for part in ("#screen", "#bar", "#keyboard", "#keyboard button:last-child"):
        box = f"document.querySelector('{part}').getBoundingClientRect()"
        assert tab.evaluate(f"{box}.left >= 0 && {box}.right <= 380 && {box}.bottom <= 700"), part


def test_the_pointer_lies_over_the_picture(window: PageWindow, tab: Tab) -> None:
    def painted() -> Any:
        return tab.evaluate(
            """(() => {
                const canvas = document.getElementById("pointer");
                const { data } = canvas.getContext("2d").getImageData(100, 50, 4, 3);
                return [...data.filter((_, i) => i % 4 === 3)].map((alpha) => alpha > 0);
            })()"""
        )

    window.mouse.move(100, 50)
    window.mouse.show()
    arrow = [1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0]
    wait_until(lambda: painted() == [bool(pixel) for pixel in arrow])
    assert tab.evaluate("getComputedStyle(document.getElementById('room')).cursor") == "none"
    window.mouse.hide()
    wait_until(lambda: not any(painted()))


# Keys and mouse


def test_keys(window: PageWindow, tab: Tab) -> None:
    tab.press("a", "KeyA")
    tab.press("A", "KeyA", SHIFT)
    tab.press("ArrowUp", "ArrowUp")
    tab.press("c", "KeyC", CTRL)
    tab.press("Tab", "Tab")
    tab.press("F1", "F1")
    codes = [97, 65, 0, 72, 3, 9, 0, 59]
    assert [window.read_key() for _ in codes] == codes
    tab.key("down", "Shift", "ShiftLeft", SHIFT)
    wait_until(lambda: window.keys.held == {"shift"})
    tab.key("up", "Shift", "ShiftLeft")
    wait_until(lambda: not window.keys.held)


def test_what_the_browser_keeps_has_a_stand_in(window: PageWindow, tab: Tab) -> None:
    """Ctrl-W closes a tab: so it is typed on the page's own keys."""
    click(tab, "[data-action=keys]")
    for name in ("Ctrl", "w", "Shift", "!", "F10", "Alt", "x", "Esc"):
        keys = "[...document.querySelectorAll('#keyboard button')]"
        click(tab, f"{keys}.find(key => key.textContent === '{name}')")
    codes = [23, ord("!"), 0, 68, 0, 45, 27]
    assert [window.read_key() for _ in codes] == codes
    wait_until(lambda: not window.keys.held)
    assert not window.key_waiting()


def test_the_mouse(window: PageWindow, tab: Tab) -> None:
    left, top = tab.evaluate(f"(({{left, top}}) => [left, top])({CANVAS}.getBoundingClientRect())")
    for button, name, mask in ((LEFT, "left", 1), (RIGHT, "right", 2), (MIDDLE, "middle", 4)):
        x, y = 100 + button, 50
        tab.mouse("Moved", left + x + 0.5, top + y + 0.5)
        tab.mouse("Pressed", left + x + 0.5, top + y + 0.5, button=name, buttons=mask, clickCount=1)
        wait_until(lambda mask=mask: window.mouse.buttons == mask)
        tab.mouse("Moved", left + 300, top + 200, button=name, buttons=mask)
        tab.mouse("Released", left + 300.5, top + 200.5, button=name, buttons=0, clickCount=1)
        wait_until(lambda: window.mouse.buttons == 0)
        assert window.mouse.take_count(pressed(button)) == (1, x, y)
        assert window.mouse.take_count(released(button)) == (1, 300, 200)
    tab.mouse("Wheel", left + 9, top + 9, deltaX=0, deltaY=200)
    wait_until(lambda: window.mouse.take_wheel() == 2)


def test_a_finger(window: PageWindow, tab: Tab) -> None:
    tab.resize(380, 700, 2, phone=True)
    left, top, scale = tab.evaluate(
        f"(({{left, top, width}}) => [left, top, width / 640])({CANVAS}.getBoundingClientRect())"
    )
    point = {"x": left + 320 * scale, "y": top + 240 * scale}
    tab.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[point])
    wait_until(lambda: window.mouse.buttons == 1)
    tab.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    wait_until(lambda: window.mouse.buttons == 0)
    times, x, y = window.mouse.take_count(pressed(LEFT))
    assert times == 1 and abs(x - 320) <= 2 and abs(y - 240) <= 2


# What is saved


def saved(folder: Path, name: str) -> Path:
    file = folder / name
    wait_until(lambda: file.exists() and not [*folder.glob("*.crdownload")])
    return file


def test_a_picture_is_saved(card: Card, tab: Tab, tmp_path: Path) -> None:
    card.page(0)[:] = (
        np.random.default_rng(1).integers(0, 16, len(card.page(0)), np.uint8).tobytes()
    )
    shows(tab, lambda: on(card))
    tab.save_to(tmp_path)
    tab.press("F12", "F12")
    read = imagefile.load(saved(tmp_path, "bgi-001.png"))
    assert read.colors is not None
    assert read.pixels.tobytes() == bytes(card.page(0))
    assert np.array_equal(read.colors[:16, :3], card.palette[:16])
    card.set_mode(100, 50, 1, 4, True)
    card.page(0)[:] = np.random.default_rng(1).integers(0, 256, 20000, np.uint8).tobytes()
    shows(tab, lambda: on(card))
    click(tab, "[data-action=png]")
    read = imagefile.load(saved(tmp_path, "bgi-002.png"))
    assert np.array_equal(read.rgba[..., :3], on(card))


@pytest.mark.parametrize("size", [1, 4])
def test_a_recording_is_saved(card: Card, tab: Tab, tmp_path: Path, size: int) -> None:
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    tab.save_to(tmp_path)
    card.set_mode(320, 200, 1, size)
    card.palette[:16] = [(17 * i, 255 - 17 * i, 5 * i) for i in range(16)]
    seen = []
    chance = np.random.default_rng(1)

    def draw(first: int, last: int) -> None:
        rows = chance.integers(0, 16, (last - first, 320, size), np.uint8)
        rows[..., 1:] = 0
        card.page(0)[first * 320 * size : last * 320 * size] = rows.tobytes()
        shows(tab, lambda: on(card))
        seen.append(on(card))
        # What follows within a fiftieth of a second is seen with the next picture.
        tab.evaluate("new Promise((done) => setTimeout(done, 50))")

    draw(0, 200)
    tab.press("F5", "F5", CTRL)
    for first, last in ((10, 20), (0, 200), (199, 200), (50, 120)):
        draw(first, last)
    tab.press("F5", "F5", CTRL)
    with image.open(saved(tmp_path, "bgi-001.gif")) as gif:
        assert gif.n_frames == len(seen)
        for number, expected in enumerate(seen):
            gif.seek(number)
            assert np.array_equal(np.asarray(gif.convert("RGB")), expected), number


# The line


def test_the_token_leaves_the_address_bar(window: PageWindow, tab: Tab) -> None:
    host, token = addressed(window.url)
    assert tab.evaluate("location.href") == f"http://{host}/"
    assert token not in tab.evaluate("document.documentElement.outerHTML")
    asked = [
        event["params"]["request"]["url"]
        for event in tab.events
        if event["method"] == "Network.requestWillBeSent"
    ]
    assert all(url.startswith((f"http://{host}/", "about:", "data:")) for url in asked)
    assert not [
        event
        for event in tab.events
        if event["method"] in ("Runtime.exceptionThrown", "Log.entryAdded")
    ]


def test_without_the_token_it_says_so(window: PageWindow, blank: Tab) -> None:
    host, _ = addressed(window.url)
    for url in (f"http://{host}/", f"http://{host}/#wrong"):
        blank.go(url)
        assert "Not let in: wrong token" in blank.wait_for(NOTICE)


def test_it_may_be_loaded_anew(card: Card, window: PageWindow, tab: Tab) -> None:
    for number in range(1, 6):
        tab.evaluate("location.reload()")
        card.page(0)[0] = number
        shows(tab, lambda: on(card))
        tab.wait_for(f"!({NOTICE})")
    tab.press("a", "KeyA")
    assert window.read_key() == ord("a")


def test_the_end_of_the_program(card: Card, window: PageWindow, tab: Tab, tmp_path: Path) -> None:
    card.page(0)[0] = 4
    window.close()
    assert tab.wait_for(NOTICE) == "The program has ended."
    tab.save_to(tmp_path)
    click(tab, "#notice button")  # the last picture can still be saved
    assert imagefile.load(saved(tmp_path, "bgi-001.png")).pixels[0, 0] == 4


def test_it_comes_back_by_itself(card: Card, window: PageWindow, tab: Tab) -> None:
    window.close()
    tab.wait_for(NOTICE)
    again = PageWindow(card)
    try:
        card.page(0)[1] = 2
        shows(tab, lambda: on(card))
        tab.wait_for(f"!({NOTICE})")
        tab.press("b", "KeyB")
        assert again.read_key() == ord("b")
    finally:
        again.close()


def test_a_line_that_is_lost(window: PageWindow, tab: Tab) -> None:
    os.kill(window.pid, KILL)
    assert "No line to the program" in tab.wait_for(NOTICE)


def test_several_look_and_one_types(
    browser: Browser, card: Card, window: PageWindow, tab: Tab
) -> None:
    other = browser.tab()
    try:
        other.go(window.url)
        assert other.wait_for(NOTICE) == "Somebody else types."
        card.page(0)[0] = 9
        shows(other, lambda: on(card))
        shows(tab, lambda: on(card))
        other.press("x", "KeyX")
        click(other, "#notice button")
        other.wait_for(f"!({NOTICE})")
        assert tab.wait_for(NOTICE) == "Somebody else types."
        other.press("y", "KeyY")
        assert window.read_key() == ord("y")
    finally:
        other.close()


def test_whoever_closes_the_tab_closes_the_program(browser: Browser, window: PageWindow) -> None:
    tab = browser.tab()
    tab.go(window.url)
    tab.wait_for(f"{CANVAS}.width > 300")
    tab.close()
    with pytest.raises(WindowClosed, match="the page was closed"):
        window.sleep(60_000)


def test_the_close_button(window: PageWindow, tab: Tab) -> None:
    click(tab, "[data-action=close]")
    with pytest.raises(WindowClosed, match="the page was closed"):
        window.sleep(60_000)


def test_sound(window: PageWindow, tab: Tab) -> None:
    button = "document.querySelector('[data-action=sound]').textContent"
    window.sound(440)
    tab.wait_for(f"{button} === 'Sound on'")
    click(tab, "[data-action=sound]")
    tab.wait_for(f"{button} === 'Sound off'")
    click(tab, "[data-action=sound]")
    tab.wait_for(f"{button} === 'Sound on'")


def test_the_whole_screen(tab: Tab) -> None:
    tab.press("F11", "F11")
    tab.wait_for("document.fullscreenElement && !document.getElementById('bar').offsetHeight")
    tab.press("F11", "F11")
    tab.wait_for("!document.fullscreenElement")


def test_in_the_frame_of_a_notebook(
    card: Card, monkeypatch: pytest.MonkeyPatch, blank: Tab
) -> None:
    """Which comes from another port of this machine; and goes without closing the program."""
    monkeypatch.setattr(pagewindow, "PAGE_SECONDS", 0)
    window = PageWindow(card)
    frame = window.notebook_html().encode()

    class Notebook(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(b"<!doctype html>" + frame)

        def log_message(self, *arguments: object) -> None: ...

    server = ThreadingHTTPServer(("127.0.0.1", 0), Notebook)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        blank.go(f"http://localhost:{server.server_port}/")
        wait_until(lambda: window._pages == 1)

        def clicked() -> bool:  # once there is a picture
            for kind, held in (("Pressed", 1), ("Released", 0)):
                blank.mouse(kind, 300, 300, button="left", buttons=held, clickCount=1)
            return window.mouse.take_count(pressed(LEFT)).times > 0

        wait_until(clicked)
        blank.press("a", "KeyA")
        assert window.read_key() == ord("a")
        blank.go("about:blank")
        wait_until(lambda: window._pages == 0)
        window.show()
    finally:
        server.shutdown()
        server.server_close()
        window.close()
