"""What a program may ask about the machine."""

import sys

import pytest

import bgi
from bgi.machine import UNSEEN, desktop_size, display_exists
from bgi.memory.sdl import pygame
from tests.skips import needs_pygame

NAMES = "DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"


@pytest.mark.parametrize("platform", ["linux", "win32", "darwin"])
def test_a_display_without_variables(monkeypatch, platform):
    monkeypatch.setattr(sys, "platform", platform)
    for name in NAMES:
        monkeypatch.delenv(name, raising=False)
    assert display_exists() == (platform != "linux")


@pytest.mark.parametrize("name", NAMES)
def test_a_display_named_by_a_variable(monkeypatch, name):
    monkeypatch.setattr(sys, "platform", "linux")
    for other in NAMES:
        monkeypatch.setenv(other, ":0" if other == name else "")
    assert display_exists()


@pytest.fixture
def asked_anew():
    """Ask again, as in a new process."""
    desktop_size.cache_clear()
    yield
    desktop_size.cache_clear()


def test_without_a_display_the_desktop_has_a_usual_size(asked_anew, monkeypatch):
    monkeypatch.setenv("BGI_MONITOR", "none")
    assert desktop_size() == UNSEEN
    assert (bgi.getmaxwidth(), bgi.getmaxheight()) == UNSEEN


@needs_pygame
def test_the_desktop_is_asked_and_pygame_left_as_it_was(asked_anew, monkeypatch):
    monkeypatch.setenv("BGI_MONITOR", "window")
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [(1366, 768), (9, 9)])
    assert (bgi.getmaxwidth(), bgi.getmaxheight()) == (1366, 768)
    assert not pygame.display.get_init()
    desktop_size.cache_clear()
    pygame.display.init()
    try:
        assert desktop_size() == (1366, 768)
        assert pygame.display.get_init()
    finally:
        pygame.display.quit()
