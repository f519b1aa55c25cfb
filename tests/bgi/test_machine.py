"""What a program may ask about the machine."""

import sys

import pytest

from bgi.machine import display_exists

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
