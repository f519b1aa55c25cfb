"""The window on a real screen, an Xvfb of its own: what is seen, typed and clicked.

A test is skipped where one of Xvfb, xdotool and ImageMagick's import is not installed.
"""

import ctypes
import ctypes.util
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from bgi.card import Card
from bgi.errors import WindowClosed
from bgi.monitor import Window
from bgi.sdl import pygame
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
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1200x24", "-nolisten", "tcp"],
        pass_fds=[writer],
        stderr=subprocess.DEVNULL,
    )
    os.close(writer)
    with os.fdopen(reader) as pipe:
        number = pipe.readline().strip()
    if not number:
        server.wait()
        pytest.skip("Xvfb does not start here")
    yield f":{number}"
    server.terminate()
    server.wait()


@pytest.fixture
def seen(xvfb: str, card: Card, monkeypatch: pytest.MonkeyPatch) -> Iterator[Window]:
    """A window on that display."""
    monkeypatch.setenv("DISPLAY", xvfb)
    monkeypatch.delenv("SDL_VIDEODRIVER")
    window = Window(card, "seen ✓")
    window.show()
    yield window
    window.close()


def tool(*command: str) -> bytes:
    """The output of a command-line tool; the test is skipped where it is not installed."""
    if not shutil.which(command[0]):
        pytest.skip(f"needs {command[0]}")
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, timeout=PATIENCE).stdout


def number_of(window: Window) -> int:
    """X's number of the window."""
    return int(tool("xdotool", "search", "--onlyvisible", "--pid", str(window._process.pid)))


def picture_in(window: Window, tmp_path: Path) -> NDArray[np.uint8]:
    """What the display shows in that window, (height, width, 3)."""
    file = tmp_path / "window.png"
    tool("import", "-window", str(number_of(window)), str(file))
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


def test_keys_arrive_as_dos_codes(seen: Window) -> None:
    tool("xdotool", "windowfocus", "--sync", str(number_of(seen)))
    typed = ["a", "A", "Up", "F1", "shift+F2", "ctrl+c", "alt+x", "shift+Tab", "Return", "Escape"]
    tool("xdotool", "key", "--delay", "20", *typed)
    expected = [97, 65, 0, 72, 0, 59, 0, 85, 3, 0, 45, 0, 15, 13, 27]
    codes = []
    for _ in expected:
        wait_until(seen.key_waiting)
        codes.append(seen.read_key())
    assert codes == expected
    assert not seen.key_waiting()


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
    if name is None:
        pytest.skip("needs libX11")
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
    press_the_close_button(xvfb, number_of(seen))
    with pytest.raises(WindowClosed, match=r"^the window was closed$"):
        seen.read_key()
    wait_until(lambda: gone(seen._process.pid))
