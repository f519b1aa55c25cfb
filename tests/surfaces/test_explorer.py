"""The explorer: what its keys do, typed one by one, and what the mouse does."""

import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bgi
from bgi import current
from bgi.monitor.pointer import MOVED, pressed, released
from surfaces import PROJECTIONS, apply, explore
from surfaces.explorer import EXAMPLES, Explorer, Options, canvas, explorer, loop
from surfaces.explorer.editor import Editor
from surfaces.explorer.helppage import INDENT
from surfaces.explorer.keys import (
    CROSS,
    DELETE,
    DIALS,
    END,
    EXTENDED,
    HELP,
    HINTS,
    HOME,
    LEFT,
    RIGHT,
    UP,
    read_key,
)
from surfaces.explorer.options import level
from surfaces.explorer.panel import HINT_ROW, ROWS, columns, packed
from surfaces.explorer.screen import open_screen
from surfaces.explorer.status import read_out, status


@pytest.fixture
def walk() -> Explorer:
    """An explorer of the first example."""
    open_screen()
    return Explorer()


def press(walk: Explorer, keys: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Press keys, named as in BGI_KEYS, drawing a picture after each."""
    monkeypatch.setenv("BGI_KEYS", keys)
    bgi.closegraph()
    open_screen()
    while bgi.kbhit():
        walk.press(read_key())
        walk.draw()


def picture(walk: Explorer) -> bytes:
    """All the pixels of the screen."""
    walk.draw()
    return bytes(current.screen.card.page(current.screen.getactivepage()))


def words(walk: Explorer) -> str:
    """What the lines below the picture say of the options."""
    return "  ".join(status(walk.options))


class TestKeys:
    @pytest.mark.parametrize(
        ("key", "changes"),
        [
            ("Left", {"turn": -5}),
            ("Right", {"turn": 5}),
            ("Up", {"tilt": 5}),
            ("Down", {"tilt": -5}),
            ("+", {"zoom": 3}),
            ("=", {"zoom": 3}),
            ("-", {"zoom": 1}),
            (",", {"wider": -1}),
            (".", {"wider": 1}),
            ("[", {"theta": 40}),
            ("]", {"theta": 50}),
            (";", {"rho_z": 0.9}),
            ("z", {"cut": True}),
            ("PgUp", {"n": 250}),
            ("PgDn", {"n": 150}),
            ("Tab", {"mode": "mesh"}),
            ("p", {"view": "cabinet"}),
            ("r", {"ramp": "heat"}),
            ("c", {"color": "slope"}),
            ("x", {"axes": True}),
            ("b", {"box": True}),
            ("k", {"colorbar": True}),
            ("l", {"contours": 5}),
            ("f", {"floor": 5}),
        ],
    )
    def test_a_key_changes_an_option_and_the_picture(
        self, monkeypatch: pytest.MonkeyPatch, key: str, changes: dict[str, object]
    ) -> None:
        open_screen()
        walk = Explorer("exp(x) + y")  # beyond x and y, and in no way regular
        before, home = picture(walk), replace(walk.options)
        press(walk, key, monkeypatch)
        assert walk.options == replace(home, **changes)
        assert picture(walk) != before
        press(walk, "Home", monkeypatch)
        assert walk.options == home
        assert picture(walk) == before

    def test_rho_z_goes_up_again(self, walk: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
        press(walk, "; ; '", monkeypatch)
        assert walk.options.rho_z == pytest.approx(0.9)

    def test_every_key_of_the_table_is_tried_above(self) -> None:
        tried = self.test_a_key_changes_an_option_and_the_picture.pytestmark[0].args[1]  # type: ignore[attr-defined]
        assert len(tried) == len(DIALS) - 1  # but for the one that is tried beside it

    @pytest.mark.parametrize("key", [*map(ord, "jJ~Q~0"), 7, 127, 255, *range(318, 325), 341, 389])
    def test_a_key_that_means_nothing_does_nothing(self, walk: Explorer, key: int) -> None:
        assert key not in walk.actions
        before, options = picture(walk), replace(walk.options)
        kept = walk.canvas.image
        walk.press(key)
        assert walk.running
        assert walk.options == options
        assert picture(walk) == before
        assert walk.canvas.image is kept

    def test_the_modes_come_one_after_another(
        self, walk: Explorer, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        seen = []
        for _ in PROJECTIONS:
            press(walk, "p", monkeypatch)
            seen.append(walk.options.view)
        assert seen == [*list(PROJECTIONS)[1:], "paper"]

    def test_a_value_of_ones_own_is_followed_by_the_first(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        open_screen()
        walk = Explorer("x", Options(contours=7, n=37))
        press(walk, "l PgUp", monkeypatch)
        assert (walk.options.contours, walk.options.n) == (0, 87)

    def test_arrows_turn_and_space_spins(
        self, walk: Explorer, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        press(walk, "Left Up Up Space x", monkeypatch)
        assert (walk.options.turn, walk.options.tilt, walk.spinning) == (-5, 10, True)
        assert walk.options.axes
        press(walk, "Space", monkeypatch)
        assert not walk.spinning

    def test_no_dial_turns_beyond_its_end(
        self, walk: Explorer, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        for keys in ("[ " * 30, "; " * 30, ", " * 30, "- " * 30, "PgDn " * 30):
            press(walk, keys, monkeypatch)
        said = words(walk)
        assert "fill 10x10" in said
        assert "theta 5 rho_z 0.1" in said

    def test_the_cross_hair_reads_the_surface(
        self, walk: Explorer, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        x, y = walk.canvas.cross
        walk.enter("x*y")
        press(walk, "d d w D S", monkeypatch)
        assert walk.canvas.cross == (x + 17, y - 7)
        point = walk.canvas.point()
        assert point is not None
        assert point[2] == pytest.approx(point[0] * point[1], abs=0.01)
        press(walk, "a " * 99, monkeypatch)
        assert walk.canvas.cross == (0, y - 7)
        assert walk.canvas.point() is None


class TestHelp:
    def test_f1_shows_it_and_any_key_leaves_it(
        self, walk: Explorer, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        before = picture(walk)
        press(walk, "F1", monkeypatch)
        assert picture(walk) != before
        press(walk, "Esc", monkeypatch)
        assert picture(walk) == before
        assert walk.running

    def test_it_names_every_key(self, walk: Explorer) -> None:
        named = " ".join(keys for keys, _ in HELP).split()
        for key in walk.actions:
            character = chr(key).lower()
            assert key >= EXTENDED or key <= 32 or character in named or character == "="
        assert len(CROSS) == 8

    def test_it_fits_the_smallest_window(self) -> None:
        open_screen(loop.SMALLEST)
        assert all(len(keys) < INDENT for keys, _ in HELP)
        assert all(INDENT + len(meaning) <= columns() for _, meaning in HELP)

    def test_the_hints_fit_the_usual_window(self) -> None:
        open_screen()
        lines = packed(HINTS, columns())
        assert len(lines) == ROWS - HINT_ROW
        assert "  ".join(lines).split("  ") == list(HINTS)

    def test_a_narrow_window_shows_the_first_hints(self) -> None:
        assert packed(("one", "two", "three"), 8) == ["one  two", "three"]
        open_screen(loop.SMALLEST)
        shown = packed(HINTS, columns())[: ROWS - HINT_ROW]
        assert {"Esc end", "F1 all keys"} <= set("  ".join(shown).split("  "))


def test_typing_a_formula_takes_the_place_of_the_old_one(
    walk: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(walk, "Enter x * y Enter", monkeypatch)
    assert (walk.text, walk.editing) == ("x*y", False)
    press(walk, "Enter Left 2 * End + 1 Home - Enter", monkeypatch)
    assert (walk.text, walk.editing) == ("-x*2*y+1", False)


def test_an_error_stays_in_the_editor_until_it_is_mended(
    walk: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(walk, "Enter s i n ( x * y y ) Enter", monkeypatch)
    assert walk.editing
    assert walk.editor.error is not None
    assert (walk.editor.text, walk.editor.cursor) == ("sin(x*yy)", 6)
    assert walk.text == EXAMPLES[0]
    press(walk, "Del Enter", monkeypatch)
    assert (walk.text, walk.editing) == ("sin(x*y)", False)


def test_esc_leaves_the_editor_and_then_the_demo(
    walk: Explorer, monkeypatch: pytest.MonkeyPatch
) -> None:
    press(walk, "Enter q Esc", monkeypatch)
    assert (walk.text, walk.editing, walk.running) == (EXAMPLES[0], False, True)
    press(walk, "Esc", monkeypatch)
    assert not walk.running


def test_every_example_is_drawn(walk: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    for _ in EXAMPLES:
        press(walk, "Enter Down Enter", monkeypatch)
        assert not walk.editing
        assert walk.canvas.problem == ""
        assert walk.canvas.plot is not None


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


def test_f2_saves_the_picture_under_a_new_name(
    walk: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    press(walk, "F2", monkeypatch)
    assert walk.note == "saved as explore-001.png"
    press(walk, "Left F2", monkeypatch)
    assert walk.note == "saved as explore-002.png"
    one, two = (tmp_path / f"explore-00{n}.png" for n in (1, 2))
    assert one.read_bytes() != two.read_bytes()
    assert sorted(tmp_path.iterdir()) == [one, two]


def test_f3_saves_a_turn(walk: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(explorer, "FRAMES", 8)
    press(walk, "F3", monkeypatch)
    assert walk.note == "saved as explore-001.gif"
    with image.open(tmp_path / "explore-001.gif") as turn:
        assert (turn.size, turn.n_frames) == ((walk.canvas.width, walk.canvas.height), 8)
    press(walk, "F3 x", monkeypatch)  # a key ends it after the first picture
    with image.open(tmp_path / "explore-002.gif") as turn:
        assert getattr(turn, "n_frames", 1) == 1


def test_f3_without_pillow(walk: Explorer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    press(walk, "F3", monkeypatch)
    assert 'pip install ".[record]"' in walk.note
    assert not list(tmp_path.iterdir())


class TestMouse:
    def hear(self, walk: Explorer, event: int, x: int, y: int, held: int) -> bool:
        current.screen.monitor.mouse.hear(event, x, y, held)
        return walk.follow()

    def test_it_takes_the_cross_hair_along_and_the_surface_stays(self, walk: Explorer) -> None:
        walk.draw()
        drawn = walk.canvas.image
        assert drawn is not None
        assert self.hear(walk, MOVED, 300, 200, 0)
        walk.draw()
        assert walk.canvas.cross == (300, 200)
        assert walk.canvas.image is drawn
        assert not walk.follow()
        assert self.hear(walk, MOVED, 310, 479, 0)  # over the lines of text
        assert walk.canvas.cross == (300, 200)

    def test_the_left_button_turns_and_the_right_one_zooms(self, walk: Explorer) -> None:
        self.hear(walk, pressed(0), 300, 200, 1)
        assert self.hear(walk, MOVED, 320, 190, 1)
        assert (walk.options.turn, walk.options.tilt) == (10, -5)
        self.hear(walk, released(0), 320, 190, 0)
        self.hear(walk, pressed(1), 320, 190, 2)
        walk.draw()
        assert self.hear(walk, MOVED, 320, 150, 2)
        assert walk.options.zoom == 6
        assert walk.canvas.image is None

    def test_the_wheel_zooms(self, walk: Explorer) -> None:
        current.screen.monitor.mouse.roll(-3)
        assert walk.follow()
        assert walk.options.zoom == 5

    def test_it_does_nothing_while_a_formula_is_typed(self, walk: Explorer) -> None:
        walk.editing = True
        assert not self.hear(walk, MOVED, 300, 200, 1)
        assert walk.options == walk.home


def test_it_says_when_it_cannot_save(walk: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*arguments: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(canvas, "writeimagefile", refuse)
    press(walk, "F2", monkeypatch)
    assert walk.note == "not saved: Permission denied"


@pytest.mark.parametrize("text", ["log(-1-r)", "1e308*x", "1e-320*x", "exp(700)*r"])
def test_what_cannot_be_drawn_ends_nothing(
    walk: Explorer, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    walk.enter(text)
    press(walk, "Left Tab Tab", monkeypatch)
    assert walk.running


class TestLoop:
    def test_it_draws_until_esc_and_leaves_the_screen_open(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("BGI_KEYS", "Right Space Up Space Esc")
        explore("x*y", turn=10, axes=True)
        assert not bgi.kbhit()
        assert (bgi.getmaxx(), bgi.getmaxy()) == (639, 479)

    def test_a_spinning_surface_goes_on_by_itself(self, walk: Explorer) -> None:
        walk.press(ord(" "))
        loop.wait(walk)
        loop.wait(walk)
        assert walk.options.turn == pytest.approx(2)

    def test_the_mouse_ends_the_wait(self, walk: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
        waits: list[int] = []

        def move_at_the_third(milliseconds: int) -> None:
            waits.append(milliseconds)
            if len(waits) == 3:
                current.screen.monitor.mouse.hear(MOVED, 30, 40, 0)

        monkeypatch.setattr(loop, "attended", lambda: True)
        monkeypatch.setattr(loop, "delay", move_at_the_third)
        loop.wait(walk)
        assert len(waits) == 3
        assert walk.canvas.cross == (30, 40)

    def test_without_a_display_and_without_keys_it_ends(self, walk: Explorer) -> None:
        with pytest.raises(bgi.BGIError):
            loop.wait(walk)

    @pytest.mark.parametrize(
        ("formula", "options", "message"),
        [
            ("x +", {}, "something is missing"),
            ("log(-1-r)", {}, "no finite value"),
            ("x", {"x": (1, 1)}, "x must be"),
            ("x", {"size": (320, 200)}, "at least 480 x 240"),
        ],
    )
    def test_what_is_wrong_is_said_before_a_window_opens(
        self, formula: str, options: dict[str, tuple[int, int]], message: str
    ) -> None:
        with pytest.raises(ValueError, match=message):
            explore(formula, **options)
        assert current.loaded() is None

    @pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display")
    def test_without_a_display_it_says_so(self, monkeypatch: pytest.MonkeyPatch) -> None:
        for name in ("BGI_MONITOR", "DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
            monkeypatch.delenv(name, raising=False)
        with pytest.raises(bgi.BGIError, match="no display"):
            explore("x")
        monkeypatch.setenv("DISPLAY", ":no-such-display")
        with pytest.raises(bgi.BGIError, match="no window"):
            explore("x")
        assert "BGI_MONITOR" not in os.environ

    def test_an_option_that_there_is_not(self) -> None:
        with pytest.raises(TypeError, match="spin"):
            explore("x", spin=3)


class TestOptions:
    def test_the_domain_in_round_numbers(self) -> None:
        assert Options().domain == ((-3, 3), (-3, 3))
        assert Options(wider=1).domain == ((-3.8, 3.8), (-3.8, 3.8))
        assert Options(x=(0, 10), y=(1, 2), wider=-3).domain == ((2.5, 7.5), (1.25, 1.75))

    def test_heights_are_cut_as_told_or_like_x(self) -> None:
        assert Options().heights is None
        assert Options(cut=True, wider=3).heights == (-6, 6)
        assert Options(z=(0, 4)).heights == (0, 4)

    def test_a_picture_that_never_turns_has_no_room_for_it(self) -> None:
        assert Options().transform is None
        for changed in (Options(turns=True), Options(turn=1), Options(tilt=1), Options(zoom=1)):
            assert changed.transform is not None

    def test_where_there_are_few_colors_they_are_mixed(self) -> None:
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        drawn = []
        for options in (Options(), Options(dither=True)):
            options.draw("x*y")
            drawn.append(bytes(bgi.getimage(0, 0, 639, 479)))
        assert drawn[0] == drawn[1]

    @pytest.mark.parametrize("view", PROJECTIONS)
    def test_a_tilt_leaves_level_what_is_level(self, view: str) -> None:
        """It turns about a line of the floor that leads straight to the right on the screen."""
        tilted, straight = Options(view=view, tilt=10), Options(view=view)
        right = level(straight.projection)
        assert tilted.transform is not None
        assert apply(right, tilted.transform) == pytest.approx(right)
        x, y, _ = straight.projection.project(right)
        assert x > 0
        assert y == pytest.approx(0, abs=1e-12)

    @pytest.mark.parametrize("view", [view for view in PROJECTIONS if view != "top"])
    def test_a_tilt_brings_what_is_high_nearer(self, view: str) -> None:
        tilted = Options(view=view, tilt=10)
        assert tilted.transform is not None
        eye, top = tilted.projection.eye, np.array((0.0, 0.0, 1.0))
        assert apply(top, tilted.transform) @ eye > top @ eye

    def test_in_words(self) -> None:
        assert status(Options()) == (
            "turn 0  tilt 0  zoom 1  theta 45 rho_z 1.0  x, y -3 to 3",
            "fill 200x200  rainbow: z",
        )
        given = Options((0, 5), (-1, 1), (0, 4), turn=-30, view="top", contours=5, floor=10)
        assert status(given) == (
            "turn 330  tilt 0  zoom 1  top  x 0 to 5  y -1 to 1  z 0 to 4",
            "fill 200x200  rainbow: z  contours 5  floor 10",
        )
        assert read_out(None) == "beside the surface"
        assert read_out((1, -2, 0.5)) == "x    1.0000   y   -2.0000   z    0.5000"
        assert read_out((1e5, -2e-5, 0)) == "x  1.00e+05   y -2.00e-05   z    0.0000"

    def test_a_logarithmic_axis_grows_by_factors(self) -> None:
        options = Options(x=(1, 100), y=(-1, 1), log="xz", wider=3, cut=True)
        assert options.domain == ((0.1, 1000), (-2, 2))
        assert options.heights is None  # where x ends need not be above 0
        assert replace(options, z=(1, 2)).heights == (1, 2)
