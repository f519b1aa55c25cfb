"""The demos of surfaces, driven by scripts of keys."""

import numpy as np
import pytest

import bgi
from gallery.catalogue import load

KEYS = {
    "spin": "1 w 2 m 3 f 4 b Up Down Left Right q Home Space Up Space 2 Esc",
    "paper": "x",
    "waterfall": "m m m m Space x Space Esc",
    "parametric": "2 m 3 m 4 m 1 m Space 2 Space 9 Esc",
    "turn": "x Space x Space Esc",
}


@pytest.mark.parametrize(("name", "keys"), KEYS.items())
def test_every_key(monkeypatch: pytest.MonkeyPatch, name: str, keys: str) -> None:
    monkeypatch.setenv("BGI_KEYS", keys)
    bgi.closegraph()
    load(name).run()
    assert not bgi.kbhit()


@pytest.mark.parametrize("name", KEYS)
@pytest.mark.parametrize("mode", [(bgi.VGA, bgi.VGAHI), (bgi.IBM8514, bgi.IBM8514LO)])
def test_the_picture_in_the_gallery(name: str, mode: tuple[int, int]) -> None:
    bgi.initgraph(*mode)
    load(name).draw()
    x, y = np.meshgrid(np.arange(640), np.arange(480))
    picture = np.asarray(bgi.getpixel(x, y))
    assert (picture != 0).mean() > 0.02
    assert len(np.unique(picture)) >= 4


def test_the_way_on_the_screen_is_the_way_through_space() -> None:
    turning = load("turn").module().Turning(640, 480)
    for _ in range(360):
        turning.turn()
    assert np.abs(turning.triples - turning.anew()).max() < 1e-9
    assert np.abs(turning.rounded - turning.anew()).max() > 5


def test_keys_change_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "Up Left F1")
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    scene = load("spin").module().Scene()
    for key in "4wz ":
        scene.press(ord(key))
    assert (scene.figure, scene.mode, scene.spinning) == (3, "wire", False)
    scene.press(bgi.getch())
    assert (scene.spin, scene.tilt) == (0, 5)
    scene.press(bgi.getch())
    assert (scene.spin, scene.tilt) == (-5, 5)
    scene.press(bgi.getch())
    assert (scene.spin, scene.tilt) == (-5, 5)
    assert scene.running
    scene.press(27)
    assert not scene.running
    bgi.closegraph()
