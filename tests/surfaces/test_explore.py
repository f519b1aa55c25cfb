"""The explorer: what its keys do, typed one by one."""

from pathlib import Path

import pytest

import bgi
from demos import explore
from demos.explore import EXAMPLES, EXTENDED, Editor, Explorer, View


@pytest.fixture
def explorer() -> Explorer:
    bgi.initgraph(*explore.MODE)
    return Explorer()


def press(explorer: Explorer, keys: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Press keys, named as in BGI_KEYS, drawing a picture after each."""
    monkeypatch.setenv("BGI_KEYS", keys)
    bgi.closegraph()
    bgi.initgraph(*explore.MODE)
    while bgi.kbhit():
        explorer.press(explore.read_key())
        explorer.draw()


def test_typing_a_formula_takes_the_place_of_the_old_one(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(explorer, "Enter x * y Enter", monkeypatch)
    assert (explorer.text, explorer.editing) == ("x*y", False)
    press(explorer, "Enter Left 2 * End + 1 Home - Enter", monkeypatch)
    assert (explorer.text, explorer.editing) == ("-x*2*y+1", False)


def test_an_error_stays_in_the_editor_until_it_is_mended(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(explorer, "Enter s i n ( x * y y ) Enter", monkeypatch)
    assert explorer.editing
    assert explorer.editor.error is not None
    assert (explorer.editor.text, explorer.editor.cursor) == ("sin(x*yy)", 6)
    assert explorer.text == EXAMPLES[0]
    press(explorer, "Del Enter", monkeypatch)
    assert (explorer.text, explorer.editing) == ("sin(x*y)", False)


def test_esc_leaves_the_editor_and_then_the_demo(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(explorer, "Enter q Esc", monkeypatch)
    assert (explorer.text, explorer.editing, explorer.running) == (EXAMPLES[0], False, True)
    press(explorer, "Esc", monkeypatch)
    assert not explorer.running


def test_a_formula_that_is_none_from_the_beginning(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_KEYS", "x Esc Left Esc")
    explore.main("x +")
    assert not bgi.kbhit()


def test_every_example_is_drawn(explorer: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    for text in EXAMPLES:
        press(explorer, "Enter Down Enter", monkeypatch)
        assert not explorer.editing
        assert explorer.view.show(text).box[1][2] > 0


def test_the_editor() -> None:
    editor = Editor()
    for key in b"xy":
        editor.press(key)
    for key in (explore.LEFT, ord("+"), explore.HOME, explore.DELETE, ord("1"), explore.END, 8):
        editor.press(key)
    assert (editor.text, editor.cursor) == ("1+", 2)
    editor.press(explore.RIGHT)
    editor.press(EXTENDED + 59)  # F1
    assert (editor.text, editor.cursor) == ("1+", 2)
    editor.begin("old")
    editor.press(8)
    assert (editor.text, editor.cursor) == ("", 0)
    editor.press(explore.UP)
    assert editor.text == EXAMPLES[-1]
    for _ in range(600):
        editor.press(ord("x"))
    assert editor.text == "x" * 500


@pytest.mark.parametrize(
    ("key", "shows"),
    [
        ("Tab", "mesh"),
        ("PgUp", "300x300"),
        ("PgDn", "150x150"),
        ("+", "zoom 1.5"),
        ("=", "zoom 1.5"),
        ("-", "zoom 1.1"),
        (",", "x, y to 2.4"),
        (".", "x, y to 3.8"),
        ("[", "theta 40"),
        ("]", "theta 50"),
        (";", "rho_z 0.9"),
        ("z", "x, y, z to 3"),
        ("p", "cabinet"),
        ("r", "heat: z"),
        ("c", "rainbow: slope"),
    ],
)
def test_keys_change_the_view(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch, key: str, shows: str
) -> None:
    assert shows not in str(explorer.view)
    press(explorer, key, monkeypatch)
    assert shows in str(explorer.view)
    press(explorer, "Home", monkeypatch)
    assert explorer.view == View()


def test_arrows_turn_and_space_spins(explorer: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    press(explorer, "Left Up Up Space x", monkeypatch)
    view = explorer.view
    assert (view.spin.value, view.tilt.value, view.spinning) == (-5, 10, True)
    assert view.axes.word == "axes"


def test_no_dial_turns_beyond_its_end(explorer: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    for keys in ("[ " * 30, "; " * 30, ", " * 30, "- " * 30, "PgDn " * 30):
        press(explorer, keys, monkeypatch)
    assert "20x20" in str(explorer.view)
    assert "theta 5 rho_z 0.1" in str(explorer.view)


def test_the_cross_hair_reads_the_surface(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    x, y = explorer.cross
    press(explorer, "d d w D S", monkeypatch)
    assert explorer.cross == (x + 17, y - 7)
    plot = explorer.view.show("x*y")
    point = plot.pick(*explorer.cross)
    assert point is not None
    assert point[2] == pytest.approx(point[0] * point[1], abs=0.01)
    press(explorer, "a " * 99, monkeypatch)
    assert explorer.cross == (0, y - 7)


def test_f2_saves_the_picture_under_a_new_name(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    press(explorer, "F2", monkeypatch)
    assert explorer.note == "saved as explore-001.png"
    press(explorer, "Left F2", monkeypatch)
    assert explorer.note == "saved as explore-002.png"
    one, two = (tmp_path / f"explore-00{n}.png" for n in (1, 2))
    assert one.read_bytes() != two.read_bytes()
    assert sorted(tmp_path.iterdir()) == [one, two]


def test_it_says_when_it_cannot_save(explorer: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*arguments: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(explore, "writeimagefile", refuse)
    press(explorer, "F2", monkeypatch)
    assert explorer.note == "not saved: Permission denied"


@pytest.mark.parametrize("text", ["log(-1-r)", "1e308*x", "1e-320*x", "exp(700)*r"])
def test_what_cannot_be_drawn_ends_nothing(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    explorer.enter(text)
    press(explorer, "Left Tab Tab", monkeypatch)
    assert explorer.running
