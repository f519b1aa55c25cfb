"""The interactive demo, driven by a script of keys."""

import pytest

import bgi
from demos import surfaces as demo


@pytest.fixture(autouse=True)
def closed() -> None:
    bgi.closegraph()


def test_every_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "1 w 2 m 3 f 4 Up Down Left Right q Home Space Up Space 2 Esc")
    demo.main()
    assert not bgi.kbhit()


def test_keys_change_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "Up Left F1")
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    scene = demo.Scene()
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
