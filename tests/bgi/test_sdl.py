"""pygame, where one of its two distributions is in the way of the other."""

import subprocess
import sys
from pathlib import Path

import pytest

from bgi.memory.sdl import twins
from tests.skips import needs_pygame

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    "installed",
    [
        [],
        ["pygame-2.6.1.dist-info"],
        ["pygame_ce-2.5.8.dist-info"],
        ["pygame_ce-2.5.8.dist-info", "pygame"],
    ],
)
def test_one_pygame_is_no_news(tmp_path, installed):
    for name in installed:
        (tmp_path / name).mkdir()
    assert twins(tmp_path) == ""


@pytest.mark.parametrize("name", ["pygame-2.6.1.dist-info", "pygame-2.1.2.egg-info"])
def test_two_of_them_are(tmp_path, name):
    (tmp_path / name).mkdir()
    (tmp_path / "pygame_ce-2.5.8.dist-info").mkdir()
    assert twins(tmp_path) == (
        "pygame and pygame-ce are both installed and overwrite each other; "
        "type: pip uninstall -y pygame pygame-ce && pip install pygame-ce"
    )


@needs_pygame
def test_what_is_left_of_a_pygame_is_no_pygame(tmp_path):
    """Uninstalling one of the two leaves a folder that lacks the modules of the other."""
    (tmp_path / "pygame").mkdir()
    (tmp_path / "pygame" / "__init__.py").touch()
    program = f"import sys; sys.path[:0] = [{str(tmp_path)!r}, {str(ROOT)!r}]; import bgi"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    last = done.stderr.splitlines()[-1]
    assert last.startswith("ImportError: pygame is there, but broken (cannot import name 'Surface'")
    assert last.endswith("type: pip uninstall -y pygame pygame-ce && pip install pygame-ce")
