"""Every test runs without a display; those that want a window say so and start their own."""

import itertools
import os
import signal

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["BGI_MONITOR"] = "none"
os.environ.pop("BGI_KEYS", None)

from collections.abc import Callable, Iterator

import hypothesis
import pytest

import bgi
from bgi import current
from bgi.graphics import Graphics
from bgi.kernel.modes import find
from bgi.kernel.state import KERNEL
from bgi.memory import sdl
from bgi.monitor import moment

# In the background of a script Ctrl-C is ignored; the programs that tests start would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# An example may take its time: machines are busy now and then.
hypothesis.settings.register_profile("patient", deadline=None)
hypothesis.settings.load_profile("patient")

pytest_plugins = ["tests.skips", "tests.browser"]

# What is about windows and pages, by processes and pygame's own names.
_WINDOW = ("keys", "lens", "pointer_look", "process", "program_ends", "window", "x11")
_WITHOUT = [
    *("test_bench.py", "monitor/web", "site/test_in_the_browser.py"),
    *(f"monitor/test_{name}.py" for name in _WINDOW),
]
collect_ignore = [] if sdl.FOUND else _WITHOUT


@pytest.fixture(autouse=True)
def _fresh() -> Iterator[None]:
    """Begin each test with a fresh kernel and without a screen, and end it so."""
    KERNEL.reset()
    moment._questions = itertools.count()
    yield
    current.close_screen()
    KERNEL.reset()


@pytest.fixture
def new_screen() -> Callable[..., Graphics]:
    """A function that makes a screen of its own: new_screen(VGA, VGAHI)."""

    def make(driver: int = bgi.VGA, mode: int = bgi.VGAHI) -> Graphics:
        found = find(driver, mode)
        assert found is not None
        return Graphics(found)

    return make


@pytest.fixture
def vga(new_screen: Callable[..., Graphics]) -> Graphics:
    """A fresh 640x480 screen of 16 colours."""
    return new_screen()
