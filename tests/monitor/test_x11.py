"""The window on a real screen, an Xvfb of its own: what is seen, typed and clicked.

A test is skipped where one of Xvfb, xdotool and ImageMagick's import is not installed.
"""

import ctypes
import ctypes.util
import os
import select
import shutil
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from bgi.constants import WM_RBUTTONUP
from bgi.errors import WindowClosed
from bgi.memory.card import Card
from bgi.memory.sdl import pygame
from bgi.monitor import Window
from bgi.monitor.inputs import REPEAT_SECONDS
from bgi.monitor.pointer import pressed, released
from tests.processes import PATIENCE, gone, wait_until


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_mode(320, 200, 2)
    return card


@pytest.fixture(scope="module")
def xvfb() -> Iterator[str]:
    """The name of an X display of 1600 x 1200 pixels that nobody else uses."""
    if not shutil.which("Xvfb"):
        pytest.skip("needs Xvfb")
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1200x24", "-noreset"],
        pass_fds=[writer],
        stderr=subprocess.DEVNULL,
    )
    os.close(writer)
    try:
        ready, _, _ = select.select([reader], [], [], PATIENCE)
        number = os.read(reader, 10).decode().strip() if ready else ""
        if not number:
            pytest.fail("Xvfb does not start")
        yield f":{number}"
    finally:
        os.close(reader)
        server.kill()
        server.wait(PATIENCE)


@pytest.fixture
def seen(
    xvfb: str, card: Card, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> Iterator[Window]:
    """A window on that display, of a program that runs in `tmp_path`."""
    monkeypatch.setenv("DISPLAY", xvfb)
    monkeypatch.delenv("SDL_VIDEODRIVER")
    monkeypatch.chdir(tmp_path)
    window = Window(card, "seen ✓")
    window.show()
    yield window
    window.close()


def tool(*command: str) -> bytes:
    """The output of a command-line tool; the test is skipped where it is not installed."""
    if not shutil.which(command[0]):
        pytest.skip(f"needs {command[0]}")
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, timeout=PATIENCE).stdout


def number_of(window: Window) -> str:
    """X's number of the window; full screen it is another one."""
    search = ["xdotool", "search", "--onlyvisible", "--pid", str(window.pid)]
    found: list[str] = []

    def find() -> bool:
        answer = subprocess.run(search, capture_output=True, text=True, timeout=PATIENCE)
        found[:] = answer.stdout.split()
        return bool(found)

    tool("xdotool", "version")
    wait_until(find)
    return found[-1]


def focus(window: Window) -> None:
    """Make the window the one in which is typed."""
    tool("xdotool", "windowfocus", "--sync", number_of(window))


def title_of(window: Window) -> str:
    return tool("xdotool", "getwindowname", number_of(window)).decode().rstrip("\n")


def size_of(window: Window) -> str:
    return tool("xdotool", "getwindowgeometry", number_of(window)).decode().split()[-1]


def picture_in(window: Window, tmp_path: Path) -> NDArray[np.uint8]:
    """What the display shows in that window, (height, width, 3)."""
    file = tmp_path / "window.png"
    tool("import", "-window", number_of(window), str(file))
    image = pygame.image.load(str(file))
    pixels = np.frombuffer(pygame.image.tobytes(image, "RGB"), np.uint8)
    return pixels.reshape(*image.get_size()[::-1], 3)


def test_the_picture_is_what_the_card_holds(seen: Window, card: Card, tmp_path: Path) -> None:
    generator = np.random.default_rng(1)
    for width, height, steps in [(320, 200, 4), (720, 348, 1), (640, 350, 2)]:
        card.palette[:] = generator.integers(0, 256, (256, 3))
        card.set_mode(width, height, 2)
        page = generator.integers(0, 256, (height, width), np.uint8)
        card.page(0)[:] = page.tobytes()
        seen.show()
        picture = picture_in(seen, tmp_path)
        assert len(picture) == steps * width * 3 // 4
        # 4:3 asks for some rows once more than for others: pygame and pygame-ce choose differently.
        first = np.append(True, (picture[1:] != picture[:-1]).any(axis=(1, 2)))
        assert np.array_equal(picture[first], card.palette[page].repeat(steps, axis=1))
        assert np.ptp(np.diff(np.flatnonzero(first))) <= 1


def test_true_colours_in_square_pixels(seen: Window, card: Card, tmp_path: Path) -> None:
    generator = np.random.default_rng(2)
    card.palette[:16] = generator.integers(0, 256, (16, 3))
    card.set_mode(500, 300, 1, pixel_bytes=4, square=True)
    page = generator.integers(0, 1 << 32, (300, 500), np.uint32)
    page[:100] &= 15
    card.page(0)[:] = page.astype("<u4").tobytes()
    seen.show()
    colours = np.stack([page & 255, page >> 8 & 255, page >> 16 & 255], axis=-1)
    colours[:100] = card.palette[page[:100]]
    assert np.array_equal(picture_in(seen, tmp_path), colours.repeat(2, axis=0).repeat(2, axis=1))


def test_a_window_of_another_size(seen: Window, card: Card, tmp_path: Path) -> None:
    card.palette[1] = 255, 255, 255
    card.page(0)[:] = bytes([1]) * (320 * 200)

    def white() -> tuple[int, int, int, int]:
        """Where the picture is: left, top, width, height; nothing else is anywhere."""
        seen.show()
        picture = picture_in(seen, tmp_path)
        y, x = picture.any(axis=2).nonzero()
        assert len(x) == (np.ptp(x) + 1) * (np.ptp(y) + 1)
        return int(x.min()), int(y.min()), int(np.ptp(x)) + 1, int(np.ptp(y)) + 1

    assert white() == (0, 0, 1280, 960)
    tool("xdotool", "windowsize", number_of(seen), "1000", "600")
    wait_until(lambda: white() == (180, 60, 640, 480))
    tool("xdotool", "windowsize", number_of(seen), "200", "600")
    wait_until(lambda: white() == (0, 225, 200, 150))
    card.set_mode(640, 350, 2)  # the size is the user's from now on
    card.page(0)[:] = bytes([1]) * (640 * 350)
    wait_until(lambda: white() == (0, 225, 200, 150))


@pytest.mark.parametrize("key", ["F11", "alt+Return"])
def test_full_screen(seen: Window, key: str) -> None:
    focus(seen)
    tool("xdotool", "key", key)
    wait_until(lambda: size_of(seen) == "1600x1200")
    focus(seen)
    seen.sleep(1000 * REPEAT_SECONDS)
    tool("xdotool", "key", key)
    wait_until(lambda: size_of(seen) == "1280x960")
    assert not seen.key_waiting()


def test_scan_lines(xvfb: str, card: Card, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("DISPLAY", xvfb)
    monkeypatch.delenv("SDL_VIDEODRIVER")
    monkeypatch.setenv("BGI_CRT", "1")
    card.palette[0] = 200, 100, 40
    window = Window(card)
    window.show()
    rows = picture_in(window, tmp_path)[:, 0].tolist()
    window.close()
    bright, dark = [200, 100, 40], [150, 75, 30]
    assert rows[:10] == [bright] * 4 + [dark] + [bright] * 4 + [dark]
    assert rows.count(dark) == 200


def test_f12_saves_a_picture(seen: Window, card: Card, tmp_path: Path) -> None:
    card.palette[:] = np.random.default_rng(1).integers(0, 256, (256, 3))
    card.page(0)[:] = bytes(range(250)) * 256
    seen.mouse.show()
    (tmp_path / "bgi-001.png").write_text("somebody else's")
    focus(seen)
    tool("xdotool", "key", "F12")
    file = tmp_path / "bgi-002.png"
    wait_until(lambda: title_of(seen) == "saved bgi-002.png - seen ✓")
    image = pygame.image.load(str(file))
    assert image.get_buffer().raw == bytes(card.page(0))
    assert [tuple(colour)[:3] for colour in image.get_palette()] == list(map(tuple, card.palette))
    assert (tmp_path / "bgi-001.png").read_text() == "somebody else's"
    wait_until(lambda: title_of(seen) == "seen ✓")
    assert not seen.key_waiting()


def test_a_picture_that_cannot_be_saved(seen: Window, tmp_path: Path) -> None:
    tmp_path.rmdir()
    focus(seen)
    tool("xdotool", "key", "F12")
    wait_until(lambda: title_of(seen) == "not saved: No such file or directory - seen ✓")


def test_ctrl_f5_records(seen: Window, card: Card, tmp_path: Path) -> None:
    pil = pytest.importorskip("PIL.Image", reason="needs Pillow")
    card.palette[:3] = [(0, 0, 0), (10, 20, 30), (200, 100, 50)]
    focus(seen)
    tool("xdotool", "key", "ctrl+F5")
    wait_until(lambda: title_of(seen) == "recording - seen ✓")
    for index in (1, 2):
        card.page(0)[:] = bytes([index]) * (320 * 200)
        seen.show()
        seen.sleep(100)
    tool("xdotool", "key", "ctrl+F5")
    wait_until(lambda: title_of(seen) == "saved bgi-001.gif - seen ✓")
    with pil.open(tmp_path / "bgi-001.gif") as gif:
        assert (gif.size, gif.n_frames) == ((320, 200), 3)
        colours = [(gif.seek(n), gif.convert("RGB").getpixel((5, 5)))[1] for n in range(3)]
    assert colours == [(0, 0, 0), (10, 20, 30), (200, 100, 50)]
    assert not seen.key_waiting()


def test_nothing_is_torn(seen: Window, card: Card, tmp_path: Path) -> None:
    """Pages of one colour each in turn: a mixture of two is never seen."""
    card.palette[:3] = [(0, 0, 0), (255, 0, 0), (0, 0, 255)]
    stop = threading.Event()

    def flip() -> None:
        page = 0
        while not stop.is_set():
            page = 1 - page
            card.page(page)[:] = bytes([1 + page]) * (320 * 200)
            card.visible = page
            seen.show()

    program = threading.Thread(target=flip)
    program.start()
    try:
        pictures = [picture_in(seen, tmp_path) for _ in range(20)]
    finally:
        stop.set()
        program.join()
    assert all((picture == picture[0, 0]).all() for picture in pictures)
    colours = {tuple(picture[0, 0].tolist()) for picture in pictures}
    assert {(255, 0, 0), (0, 0, 255)} <= colours <= {(0, 0, 0), (255, 0, 0), (0, 0, 255)}


def test_keys_arrive_as_dos_codes(seen: Window) -> None:
    focus(seen)
    typed = ["a", "A", "Up", "F1", "shift+F2", "ctrl+c", "alt+x", "shift+Tab", "Return", "Escape"]
    tool("xdotool", "key", "--delay", "20", *typed)
    expected = [97, 65, 0, 72, 0, 59, 0, 85, 3, 0, 45, 0, 15, 13, 27]
    codes = []
    for _ in expected:
        wait_until(seen.key_waiting)
        codes.append(seen.read_key())
    assert codes == expected
    assert not seen.key_waiting()


def test_characters_beyond_ascii(xvfb: str, request: pytest.FixtureRequest) -> None:
    tool("setxkbmap", "-display", xvfb, "de")
    seen: Window = request.getfixturevalue("seen")
    focus(seen)
    typed = ["odiaeresis", "Udiaeresis", "ssharp", "at"]  # the last one with AltGr
    tool("xdotool", "key", "--delay", "20", *typed)
    codes = []
    for _ in typed:
        wait_until(seen.key_waiting)
        codes.append(seen.read_key())
    tool("setxkbmap", "-display", xvfb, "us")
    assert codes == [0x94, 0x9A, 0xE1, ord("@")]


def test_keys_that_are_down_together(seen: Window) -> None:
    focus(seen)
    tool("xdotool", "keydown", "Left", "keydown", "space", "keydown", "d")
    wait_until(lambda: seen.keys.held == {"left", "space", "d"})
    tool("xdotool", "keyup", "space")
    wait_until(lambda: seen.keys.held == {"left", "d"})
    tool("xdotool", "keyup", "Left", "keyup", "d")
    wait_until(lambda: not seen.keys.held)


def test_the_keyboard_belongs_to_the_window_in_front(seen: Window, card: Card) -> None:
    other = Window(card, beside=seen)
    for window, key in [(other, "a"), (seen, "b"), (other, "c")]:
        focus(window)
        tool("xdotool", "key", key)
        wait_until(seen.key_waiting)
        assert seen.read_key() == ord(key)
    other.close()


def test_no_key_is_stuck_when_the_focus_is_lost(seen: Window, card: Card) -> None:
    other = Window(card)
    try:
        focus(seen)
        tool("xdotool", "keydown", "shift", "keydown", "a")
        wait_until(lambda: seen.keys.shifts == 2)
        wait_until(lambda: seen.keys.held == {"a", "shift"})
        wait_until(seen.key_waiting)
        focus(other)
        wait_until(lambda: seen.keys.shifts == 0)
        wait_until(lambda: not seen.keys.held)
        while seen.key_waiting():
            seen.read_key()
        seen.sleep(700)  # a key that is held repeats after half a second
        assert not seen.key_waiting()
    finally:
        tool("xdotool", "keyup", "a", "keyup", "shift")
        other.close()


# The mouse


def test_the_mouse_in_pixels_of_the_page(seen: Window) -> None:
    tool("xdotool", "mousemove", "--window", number_of(seen), "402", "41")
    wait_until(lambda: (seen.mouse.x, seen.mouse.y) == (100, 8))
    tool("xdotool", "click", "1", "click", "3")
    wait_until(lambda: seen.mouse.has(WM_RBUTTONUP))
    assert seen.mouse.take_count(pressed(0)) == (1, 100, 8)
    assert seen.mouse.take_count(released(1)) == (1, 100, 8)
    tool("xdotool", "click", "4", "click", "5", "click", "5", "click", "5")  # the wheel
    turned = 0

    def wheel() -> int:
        nonlocal turned
        turned += seen.mouse.take_wheel()
        return turned

    wait_until(lambda: wheel() == 2)
    tool("xdotool", "windowsize", number_of(seen), "1000", "600")  # the picture: 640x480 at 180, 60
    wait_until(lambda: size_of(seen) == "1000x600")
    seen.sleep(100)
    for place, pixel in [(("180", "60"), (0, 0)), (("500", "300"), (160, 100))]:
        tool("xdotool", "mousemove", "--window", number_of(seen), *place)
        wait_until(lambda pixel=pixel: (seen.mouse.x, seen.mouse.y) == pixel)
    tool("xdotool", "mousemove", "--window", number_of(seen), "999", "599")  # beside the picture
    wait_until(lambda: (seen.mouse.x, seen.mouse.y) == (319, 199))


def test_the_pointer_is_over_the_picture_and_not_in_it(
    seen: Window, card: Card, tmp_path: Path
) -> None:
    def changed() -> set[tuple[int, int]]:
        """The pixels of the page on which something is seen."""
        seen.show()
        y, x = picture_in(seen, tmp_path)[::4].any(axis=2).nonzero()
        return {(int(a) // 4, int(b) * 4 * 200 // 960) for a, b in zip(x, y, strict=True)}

    seen.mouse.move(100, 50)
    seen.mouse.show()
    wait_until(lambda: bool(changed()))
    x, y = np.array(sorted(changed())).T
    assert 100 <= x.min() <= 102
    assert 50 <= y.min() <= 52
    assert x.max() <= 112
    assert y.max() <= 66
    seen.mouse.limit(0, 0, 40, 40)
    tool("xdotool", "mousemove", "--window", number_of(seen), "900", "900")
    wait_until(lambda: (seen.mouse.x, seen.mouse.y) == (40, 40))
    wait_until(lambda: max(x for x, _ in changed()) <= 52)
    seen.mouse.hide()
    wait_until(lambda: not changed())
    assert not any(card.page(0))


class ClientMessage(ctypes.Structure):
    """Xlib's XClientMessageEvent, padded to the size of an XEvent."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("window", ctypes.c_ulong),
        ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int),
        ("data", ctypes.c_long * 5),
        ("padding", ctypes.c_long * 24),
    )


def press_the_close_button(display: str, window: int) -> None:
    """What a window manager does when its close button is pressed."""
    name = ctypes.util.find_library("X11")
    assert name  # xdotool needs it too
    x11 = ctypes.CDLL(name)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong
    connection = ctypes.c_void_p(x11.XOpenDisplay(display.encode()))
    message = ClientMessage(type=33, window=window, format=32)
    message.message_type = x11.XInternAtom(connection, b"WM_PROTOCOLS", 0)
    message.data[0] = x11.XInternAtom(connection, b"WM_DELETE_WINDOW", 0)
    x11.XSendEvent(connection, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(message))
    x11.XCloseDisplay(connection)


def test_the_close_button(seen: Window, xvfb: str) -> None:
    press_the_close_button(xvfb, int(number_of(seen)))
    with pytest.raises(WindowClosed, match=r"^the window was closed$"):
        seen.read_key()
    wait_until(lambda: gone(seen.pid))


def test_the_pointer_takes_another_look(seen: Window, tmp_path: Path) -> None:
    """White, but for the last row, which inverts what is there: of black it makes white, too."""

    def white() -> set[tuple[int, int]]:
        """The pixels of the page that are white."""
        seen.show()
        y, x = (picture_in(seen, tmp_path)[::4] == 255).all(axis=2).nonzero()
        return {(int(a) // 4, int(b) * 4 * 200 // 960) for a, b in zip(x, y, strict=True)}

    seen.mouse.move(100, 50)
    seen.mouse.shape(8, 4, [0] * 15 + [0xFFFF] + [0xFFFF] * 16)
    seen.mouse.show()
    wait_until(lambda: bool(white()))
    x, y = np.array(sorted(white())).T
    assert (x.min(), x.max()) == (92, 107)
    assert (y.min(), y.max()) == (46, 61)
