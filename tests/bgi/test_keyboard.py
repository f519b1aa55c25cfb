"""Keys that are down, and the keyboard that all windows of a program share."""

import pytest

import bgi
from bgi import current, keyboard


def test_two_keys_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "+Left +x Wait1s -Left Wait1s -x")
    bgi.initgraph()
    keys = ("Left", "LEFT", "x", "X", "Right", "Shift")
    assert [keyboard.pressed(key) for key in keys] == [True, True, True, True, False, False]
    bgi.delay(1000)
    assert (keyboard.pressed("left"), keyboard.pressed("x")) == (False, True)
    bgi.delay(1000)
    assert not keyboard.pressed("x")


def test_a_game_by_keys_that_are_held(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "Wait0.5s +Right Wait1s +Down Wait1s -Right Wait0.5s -Down Esc")
    bgi.initgraph()
    x = y = 0
    while bgi.getch() != 27 if bgi.kbhit() else True:
        x += keyboard.pressed("Right")
        y += keyboard.pressed("Down")
        bgi.delay(100)
    assert (x, y) == (20, 15)


@pytest.mark.parametrize("wrong", ["", "Escape", "ab", "F13"])
def test_what_is_not_a_key(wrong: str) -> None:
    bgi.initgraph()
    with pytest.raises(ValueError, match=f"'{wrong}' is not a key: write a single character, Esc,"):
        keyboard.pressed(wrong)


def test_a_code_is_not_a_key() -> None:
    bgi.initgraph()
    with pytest.raises(TypeError, match="key must be a str, not int: 72"):
        keyboard.pressed(72)


def test_before_initgraph_the_keyboard_is_that_of_a_text_screen() -> None:
    assert not keyboard.pressed("a")
    assert current.console().is_text


def test_a_script_is_that_of_the_program_not_of_a_window(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "a b Wait1s c")
    bgi.initgraph()
    first = bgi.getcurrentwindow()
    second = bgi.initwindow(100, 100)
    assert bgi.getch() == ord("a")
    bgi.setcurrentwindow(first)
    assert bgi.getch() == ord("b")
    bgi.closewindow(first)
    bgi.setcurrentwindow(second)
    assert bgi.getch() == ord("c")
    with pytest.raises(bgi.NobodyThere):
        bgi.getch()
