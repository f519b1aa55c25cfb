"""The explorer: what its keys do, typed one by one."""

from pathlib import Path

import pytest

import bgi
from bgi import current
from bgi.monitor.pointer import MOVED, pressed, released
from gallery.catalogue import load
from gallery.panel import DELETE, END, EXTENDED, HOME, LEFT, RIGHT, UP, Editor, read_key

explore = load("explore").module()
EXAMPLES, Explorer, View = explore.EXAMPLES, explore.Explorer, explore.View


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
        explorer.press(read_key())
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
    editor = Editor(list(EXAMPLES))
    for key in b"xy":
        editor.press(key)
    for key in (LEFT, ord("+"), HOME, DELETE, ord("1"), END, 8):
        editor.press(key)
    assert (editor.text, editor.cursor) == ("1+", 2)
    editor.press(RIGHT)
    editor.press(EXTENDED + 59)  # F1
    assert (editor.text, editor.cursor) == ("1+", 2)
    editor.begin("old")
    editor.press(8)
    assert (editor.text, editor.cursor) == ("", 0)
    editor.press(UP)
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


def test_f3_saves_a_turn(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    image = pytest.importorskip("PIL.Image")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(explore, "FRAMES", 8)
    press(explorer, "F3", monkeypatch)
    assert explorer.note == "saved as explore-001.gif"
    with image.open(tmp_path / "explore-001.gif") as turn:
        assert (turn.size, turn.n_frames) == ((explorer.width, explorer.height), 8)
    press(explorer, "F3 x", monkeypatch)  # a key ends it after the first picture
    with image.open(tmp_path / "explore-002.gif") as turn:
        assert getattr(turn, "n_frames", 1) == 1


def test_f3_without_pillow(
    explorer: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    press(explorer, "F3", monkeypatch)
    assert 'pip install ".[record]"' in explorer.note
    assert not list(tmp_path.iterdir())


class TestMouse:
    def hear(self, explorer: Explorer, event: int, x: int, y: int, held: int) -> bool:
        current.screen.monitor.mouse.hear(event, x, y, held)
        return explorer.follow()

    def test_it_takes_the_cross_hair_along_and_the_surface_stays(self, explorer: Explorer) -> None:
        explorer.draw()
        drawn = explorer.picture
        assert drawn is not None
        assert self.hear(explorer, MOVED, 300, 200, 0)
        explorer.draw()
        assert explorer.cross == (300, 200)
        assert explorer.picture is drawn
        assert not explorer.follow()
        assert self.hear(explorer, MOVED, 310, 479, 0)  # over the lines of text
        assert explorer.cross == (300, 200)

    def test_the_left_button_turns_and_the_right_one_zooms(self, explorer: Explorer) -> None:
        self.hear(explorer, pressed(0), 300, 200, 1)
        assert self.hear(explorer, MOVED, 320, 190, 1)
        assert (explorer.view.spin.value, explorer.view.tilt.value) == (10, -5)
        self.hear(explorer, released(0), 320, 190, 0)
        self.hear(explorer, pressed(1), 320, 190, 2)
        explorer.draw()
        assert self.hear(explorer, MOVED, 320, 150, 2)
        assert explorer.view.zoom.value == 6
        assert explorer.picture is None

    def test_the_wheel_zooms(self, explorer: Explorer) -> None:
        current.screen.monitor.mouse.roll(-3)
        assert explorer.follow()
        assert explorer.view.zoom.value == 5

    def test_it_does_nothing_while_a_formula_is_typed(self, explorer: Explorer) -> None:
        explorer.editing = True
        assert not self.hear(explorer, MOVED, 300, 200, 1)
        assert explorer.view == View()


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
