"""Every demo is a test: it runs headless with scripted keys and ends, and its picture shows."""

import ast
import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

import bgi
from bgi import current
from gallery import menu
from gallery.catalogue import C_NAMES, NAMES, load
from gallery.command import main as command
from gallery.pages import KEYS as KEYS_SHOWN
from gallery.pages import MARGIN, Page, leaf_through, show
from tests.pictures import read_indices

ROOT = Path(__file__).parents[1]
DEMOS = ROOT / "demos"
PICTURES = ROOT / "docs" / "pictures"

# What the user does in each demo, up to the key that ends it.
KEYS = {
    "hello": "x",
    "tour": "Space Space Esc",
    "fills": "Space Left Left " + "Space " * 7 + "Esc",
    "fonts": "Space " * 16 + "PgUp Esc",
    "palette": "Right Right Right Left Left Esc",
    "sprites": "Space Space Left Esc",
    "bgidemo": "Space " * 25 + "Esc",
    "ball": "x",
    "bounce": "Space Space Esc",
    "spin": "1 w 2 m 3 f 4 Left Up Space Right Space Esc",
    "paper": "x",
    "waterfall": "Space m Space Esc",
    "parametric": "1 2 m 3 4 Space Esc",
    "turn": "Space Space Esc",
    "explore": "Enter x * y Enter Left + Tab Enter ( Enter Esc Esc",
    "paint": "+ - c Esc",
    "piano": "a w k Esc",
    "keys": "a Up F1 Esc",
    "clock": "x",
    "two_windows": "x",
    "hangman": "a e i o u Esc",
    "form": "F1 x F10 x Tab a Backspace Up Esc",
    "calculator": "1 Enter 2 Enter - 3 Enter x Enter",
    "spacewar": "+w +Up Wait300ms -w +a +Down Wait500ms -a Esc",
}


TRACES = {
    "BALLS.C": "eb2b6f7c750d2d606b249886cddbd5eea1043ca2372581be234e0601c46b68f7",
    "CLOCK.C": "8f94a1a37368cfc908c6a53a24a8001d055dcaded6025ff254ed3a797efb311d",
    "PAINT.C": "de7cce2e712c2d37b818a705b0f19ee48858232128434d09dca6d15436ea6006",
    "PLOTTER.C": "24e07fe5f4b08f99cbda845b1b243e6e9203214ae9e535415719340a7d310013",
    "SNAKE.C": "ff35ba21055807431eb18651437315508d5365ee2f08908e6477f251b83555a7",
}
"""sha256 of what programs in C do, under script A, when gcc has compiled them with a library that
writes down each call of it.
"""

STILL = ("hello", "tour", "paper")
"""The demos that show their picture and wait."""


@pytest.fixture(params=NAMES)
def demo(request):
    """Each demo in turn."""
    return load(request.param)


def run(arguments, folder, **variables):
    """Run Python without a display, in a folder, as someone who has installed the package."""
    environment = os.environ | {"PYTHONPATH": str(ROOT), "BGI_MONITOR": "none"} | variables
    return subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=60,
    )


def assert_shows(picture, demo):
    """Fail unless a file holds what a demo draws."""
    indices = read_indices(picture)
    assert len(np.unique(indices)) >= 3
    if demo.name in STILL:
        assert np.array_equal(indices, read_indices(PICTURES / f"{demo.name}.png"))


class TestEveryDemo:
    def test_has_a_plan_of_keys(self):
        assert set(KEYS) == set(NAMES)

    def test_runs_as_a_file_from_any_folder(self, demo, tmp_path):
        shot = tmp_path / "shot.png"
        ran = run([demo.file], tmp_path, BGI_AFTER="0.3", BGI_SHOT=str(shot))
        assert (ran.returncode, ran.stderr) == (0, "")
        assert_shows(shot, demo)

    def test_says_what_it_is_and_how_to_run_it(self, demo):
        docstring = ast.get_docstring(ast.parse(demo.file.read_text("utf-8")))
        says, runs, shows = docstring.split("\n\n")[:3]
        assert says.endswith(".") and "\n" not in says
        assert runs.strip() == f"python demos/{demo.file.name}"
        assert shows.startswith("What it shows: ")

    def test_has_a_mode_that_opens(self, demo):
        assert bgi.initgraph(*demo.mode) == demo.mode
        assert bgi.graphresult() == bgi.grOk

    def test_draws_a_picture_on_the_page_that_is_shown(self, demo):
        bgi.initgraph(*demo.mode)
        demo.draw()
        assert current.screen.card.visible == 0
        picture = np.frombuffer(current.screen.card.page(0), np.uint8)
        assert len(np.unique(picture)) >= 5
        assert np.count_nonzero(picture) > picture.size / 50

    def test_runs_until_its_last_key_and_leaves_the_window_to_the_gallery(self, demo, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", KEYS[demo.name])
        bgi.initgraph()
        before = current.screen.monitor
        demo.run()
        assert current.screen.monitor is before
        assert not bgi.kbhit()

    def test_is_shown_and_explained_in_the_folder(self, demo):
        assert (PICTURES / f"{demo.name}.png").is_file()
        text = (DEMOS / "README.md").read_text("utf-8")
        (row,) = (row for row in text.splitlines() if f"({demo.file.name})" in row)
        assert f"../docs/pictures/{demo.name}.png" in row
        assert f"`python demos/{demo.file.name}`" in row
        assert demo.summary in row
        assert demo.lesson in row.replace("`", "")


class TestProgramsInC:
    """The programs in demos/c: that they draw what they drew is in test_docs."""

    @pytest.mark.parametrize("name", TRACES)
    def test_does_call_by_call_what_it_does_compiled_by_gcc(self, name, tmp_path):
        trace = tmp_path / "trace"
        words = ["-m", "bgi", "--script", "A", "--trace", trace, load(name).file]
        ran = run(words, tmp_path)
        assert (ran.returncode, ran.stderr) == (0, "")
        assert hashlib.sha256(trace.read_bytes()).hexdigest() == TRACES[name]

    def test_runs_from_the_gallery(self, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", "End Enter Esc Wait2s Esc Esc")
        assert command([]) == 0

    def test_runs_by_its_name_in_any_case(self, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", "x")
        assert command(["clock.c"]) == 0

    def test_has_the_endings_of_its_day(self):
        assert all(re.fullmatch(r"[A-Z]{1,8}\.(C|CPP)", name) for name in C_NAMES)

    @pytest.mark.parametrize("name", C_NAMES)
    def test_is_shown_and_explained_in_the_folder(self, name):
        text = (DEMOS / "README.md").read_text("utf-8")
        (row,) = (row for row in text.splitlines() if f"(c/{name})" in row)
        assert f"../docs/pictures/{name}.png" in row
        assert f"`python -m bgi demos/c/{name}`" in row
        assert load(name).summary in row
        assert load(name).lesson in row


class TestFolder:
    def test_its_numbers_are_the_order_of_the_gallery(self):
        files = sorted(file.name for file in DEMOS.glob("*.py") if file.name[0] != "_")
        assert files == [f"{place:02}_{name}.py" for place, name in enumerate(NAMES, 1)]
        rows = re.findall(r"\((\d\d_\w+\.py)\)", (DEMOS / "README.md").read_text("utf-8"))
        assert rows == files

    def test_no_file_hides_a_module_from_the_demos(self):
        """Python looks for a module first in the folder of the program that it runs."""
        stems = {file.stem for file in DEMOS.iterdir()}
        assert not stems & {"bgi", "surfaces", "numpy", "pygame", *sys.stdlib_module_names}

    def test_demos_use_public_names_only(self, demo):
        modules = re.findall(r"^(?:from|import) ([\w.]+)", demo.file.read_text("utf-8"), re.M)
        private = [
            module
            for module in modules
            if re.match(r"(bgi|surfaces)\.(?!conio$|dos$|keyboard$|stdio$)", module)
        ]
        assert not private


class TestWaysToRun:
    @pytest.mark.parametrize("name", ["ball", "fills", "spin"])
    def test_by_the_command_of_bgi(self, tmp_path, name):
        demo, shot = load(name), tmp_path / "shot.png"
        options = ["--monitor", "none", "--after", "300ms", "--shot", shot]
        ran = run(["-m", "bgi", *options, demo.file], tmp_path)
        assert (ran.returncode, ran.stderr) == (0, f"bgi: {shot} was written\n")
        assert_shows(shot, demo)

    @pytest.mark.parametrize(
        ("name", "command"),
        [("hello", ["-m", "demos"]), ("04_tour", ["-m", "bgi.demos"]), ("16_paper.py", [DEMOS])],
    )
    def test_by_the_gallery(self, tmp_path, name, command):
        folder = ROOT if command == ["-m", "demos"] else tmp_path
        shot = tmp_path / "shot.png"
        ran = run([*command, name], folder, BGI_KEYS="x", BGI_SHOT=str(shot))
        assert (ran.returncode, ran.stderr) == (0, "")
        assert_shows(shot, load(re.sub(r"\d+_|\.py", "", name)))


class TestAnotherPackageInTheWay:
    """A package of the same name, as someone may have installed it, is named in one line."""

    def run_beside(self, folder, name, text, *arguments):
        """Run the gallery where another package is found first."""
        (folder / name).mkdir()
        (folder / name / "__init__.py").write_text(text, encoding="utf-8")
        path = os.pathsep.join(map(str, (folder, ROOT)))
        return run([DEMOS, *arguments], folder, PYTHONPATH=path, BGI_KEYS="x")

    @pytest.mark.parametrize("name", ["bgi", "surfaces"])
    def test_is_named(self, tmp_path, name):
        ran = self.run_beside(tmp_path, name, "", "paper")
        assert ran.returncode == 1
        assert ran.stderr.count("\n") == 1
        assert str(tmp_path / name / "__init__.py") in ran.stderr
        assert f"not the package {name}" in ran.stderr

    def test_what_is_not_installed_is_named(self, tmp_path):
        ran = self.run_beside(tmp_path, "numpy", "import _of_its_own", "hello")
        assert ran.returncode == 1
        assert ran.stderr == (
            "demos: No module named '_of_its_own'; "
            "in the folder of the project, type: pip install .\n"
        )

    def test_a_broken_pygame_is_advised_on_once(self, tmp_path):
        ran = self.run_beside(tmp_path, "pygame", "", "hello")
        assert ran.returncode == 1
        assert ran.stderr.startswith("demos: pygame is there, but broken")
        assert ran.stderr.endswith("&& pip install pygame-ce\n")


class TestWheel:
    @pytest.fixture
    def installed(self, tmp_path):
        """A folder with what the wheel puts into site-packages."""
        pytest.importorskip("hatchling", reason="needs hatchling")
        command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
        subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
        (wheel,) = tmp_path.glob("*.whl")
        with ZipFile(wheel) as archive:
            archive.extractall(tmp_path / "installed")
        return tmp_path / "installed"

    def test_puts_two_packages_and_no_demos_into_site_packages(self, installed):
        names = {path.name for path in installed.iterdir() if path.suffix != ".dist-info"}
        assert names == {"bgi", "surfaces"}
        demos = {path.name for path in (installed / "bgi" / "demos").glob("*.py")}
        assert demos == {path.name for path in DEMOS.glob("*.py")}
        assert not (installed / "bgi" / "demos.py").exists()

    def test_has_the_page_of_the_web_monitor(self, installed):
        folder = Path("bgi/monitor/web/page")
        files = sorted(file.name for file in (ROOT / folder).iterdir())
        assert "index.html" in files
        assert sorted(file.name for file in (installed / folder).iterdir()) == files

    def test_has_the_gallery_and_every_picture(self, installed, tmp_path):
        folder = tmp_path / "empty"
        folder.mkdir()
        ran = run(["-m", "bgi.demos", "--save", "."], folder, PYTHONPATH=str(installed))
        assert (ran.returncode, ran.stderr) == (0, "")
        assert ran.stdout.split() == [f"{name}.png" for name in menu.CHOICES]
        for file in folder.iterdir():
            assert np.array_equal(read_indices(file), read_indices(PICTURES / file.name))


class TestMenu:
    @pytest.mark.parametrize(
        ("keys", "chosen"),
        [
            ("Enter", 0),
            ("Down Down Enter", 2),
            ("Up Enter", len(menu.CHOICES) - 1),
            ("Right Enter", menu.COLUMN),
            ("Down Left Right Enter", 1),
            ("End Down Enter", 0),
            ("Down Home Enter", 0),
            ("2", 1),
            ("Q 0 F1 Enter", 0),
            ("Down Esc", None),
        ],
    )
    def test_keys(self, monkeypatch, keys, chosen):
        monkeypatch.setenv("BGI_KEYS", keys)
        assert menu.choose(0) == chosen

    def test_shows_another_picture_for_every_choice(self, monkeypatch):
        pictures = set()
        for place in range(len(menu.CHOICES)):
            monkeypatch.setenv("BGI_KEYS", "Esc")
            bgi.closegraph()
            menu.choose(place)
            card = current.screen.card
            pictures.add(bytes(card.page(card.visible)))
        assert len(pictures) == len(menu.CHOICES)


class TestCommand:
    def test_runs_a_demo_from_the_menu_and_comes_back(self, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", "Down Enter Esc Esc")
        assert command([]) == 0

    def test_goes_on_in_the_same_window(self, monkeypatch):
        screens = []
        choose = menu.choose

        def watched(place):
            answer = choose(place)
            screens.append(current.screen.monitor)
            return answer

        monkeypatch.setattr(menu, "choose", watched)
        monkeypatch.setenv("BGI_KEYS", "1 x 4 Esc Esc")
        assert command([]) == 0
        assert len(screens) == 3
        assert len(set(screens)) == 1

    @pytest.mark.parametrize("name", ["hello", "fills", "paper"])
    def test_runs_one_demo_and_closes_the_screen(self, monkeypatch, name):
        monkeypatch.setenv("BGI_KEYS", KEYS[name])
        assert command([name]) == 0
        assert current.loaded() is None

    def test_lists_the_demos(self, capsys):
        assert command(["--list"]) == 0
        lines = capsys.readouterr().out.splitlines()
        assert [line.split()[0] for line in lines] == list(menu.CHOICES)
        assert all(
            load(name).summary in line for name, line in zip(menu.CHOICES, lines, strict=True)
        )

    def test_saves_every_picture(self, tmp_path, capsys):
        folder = tmp_path / "new" / "folder"
        assert command(["--save", str(folder)]) == 0
        files = [folder / f"{name}.png" for name in menu.CHOICES]
        assert capsys.readouterr().out.splitlines() == list(map(str, files))
        assert all(file.read_bytes().startswith(b"\x89PNG") for file in files)

    def test_saves_one_picture(self, tmp_path):
        assert command(["tour", "--save", str(tmp_path)]) == 0
        assert [file.name for file in tmp_path.iterdir()] == ["tour.png"]

    def test_says_where_it_cannot_save(self, tmp_path, capsys):
        (tmp_path / "file").touch()
        assert command(["--save", str(tmp_path / "file")]) == 1
        assert capsys.readouterr().err.startswith("demos: ")

    def test_names_the_demos_when_the_name_is_unknown(self, capsys):
        with pytest.raises(SystemExit) as exit:
            command(["nonsense"])
        assert exit.value.code == 2
        message = capsys.readouterr().err.splitlines()[-1]
        assert "nonsense" in message
        assert all(name in message for name in NAMES)

    @pytest.mark.parametrize(
        ("error", "code"), [(bgi.WindowClosed("closed"), 0), (KeyboardInterrupt(), 130)]
    )
    def test_ends_quietly_when_the_user_ends_it(self, monkeypatch, capsys, error, code):
        def interrupted():
            raise error

        monkeypatch.setattr("gallery.catalogue.Demo.run", lambda demo: interrupted())
        assert command(["hello"]) == code
        assert capsys.readouterr().err == ""

    def test_nobody_there_is_one_line(self, capsys):
        assert command(["hello"]) == 0  # no window, and no scripted key
        assert re.fullmatch("demos: nobody can press a key.*\n", capsys.readouterr().err)

    @pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display")
    def test_without_a_display_it_says_so_in_one_line(self):
        hidden = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "BGI_MONITOR"}
        environment = {name: value for name, value in os.environ.items() if name not in hidden}
        ran = subprocess.run(
            [sys.executable, "-m", "demos"],
            cwd=ROOT,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert ran.returncode == 1
        assert ran.stdout == ""
        assert ran.stderr.count("\n") == 1
        assert "no display" in ran.stderr
        assert "python -m demos --save DIR" in ran.stderr


class TestSpacewar:
    """The duel for two: its keys at once, its sun, its torpedoes and its score."""

    @pytest.fixture
    def game(self):
        return load("spacewar").module()

    def flown(self, game, monkeypatch, keys, pictures):
        """The ships and the torpedoes after some pictures with some keys."""
        monkeypatch.setenv("BGI_KEYS", keys)
        bgi.initgraph(*game.MODE)
        ships = game.two_ships()
        torpedoes: list[object] = []
        for _ in range(pictures):
            game.play(ships, torpedoes)
        bgi.closegraph()
        return ships, torpedoes

    def test_both_are_steered_at_once(self, game, monkeypatch):
        (left, right), _ = self.flown(game, monkeypatch, "", 1)
        (turned, burning), torpedoes = self.flown(game, monkeypatch, "+a +w +Right +Up +Down", 1)
        assert (turned.angle - left.angle, burning.angle - right.angle) == (game.TURN, -game.TURN)
        assert turned.burning and burning.burning
        assert turned.dx - left.dx == pytest.approx(0.05 * np.cos(np.radians(274)))
        assert burning.dy - right.dy == pytest.approx(-0.05 * np.sin(np.radians(86)))
        assert len(torpedoes) == 1 and torpedoes[0].distance(right.x, right.y) < 2 * game.SIZE

    def test_left_alone_both_go_round_the_sun(self, game, monkeypatch):
        ships, torpedoes = self.flown(game, monkeypatch, "", 700)
        assert [ship.score for ship in ships] == [0, 0] and torpedoes == []
        assert [ship.distance(game.SUN_X, game.SUN_Y) for ship in ships] == pytest.approx(
            [200, 200], abs=5
        )

    def test_a_hit_is_a_point_and_the_ship_begins_anew(self, game, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", "")
        bgi.initgraph(*game.MODE)
        ships = game.two_ships()
        torpedoes = [game.Torpedo(*ships[1].start)]
        game.play(ships, torpedoes)
        assert ([ship.score for ship in ships], torpedoes) == ([1, 0], [])
        assert ships[1].blast == game.BLAST
        for _ in range(game.BLAST):
            game.play(ships, torpedoes)
        assert (ships[1].blast, ships[1].x, ships[1].y) == (0, *ships[1].start[:2])

    def test_the_sun_is_hot(self, game, monkeypatch):
        monkeypatch.setenv("BGI_KEYS", "")
        bgi.initgraph(*game.MODE)
        ships = game.two_ships()
        ships[0].x, ships[0].dx, ships[0].dy = game.SUN_X - 60, 4, 0
        for _ in range(15):
            game.play(ships, [])
        assert [ship.score for ship in ships] == [0, 1]


class TestPages:
    """Demos of several pages: fonts, fills, palette, sprites and bgidemo."""

    @pytest.fixture(params=["fills", "fonts", "palette", "sprites", "bgidemo"])
    def paged(self, request):
        return load(request.param).module()

    def test_every_page_draws_without_an_error(self, paged):
        for place, page in enumerate(paged.PAGES):
            bgi.initgraph(*page.mode)
            show(paged.PAGES, place)
            assert bgi.graphresult() == bgi.grOk, page.title
            assert len(np.unique(current.screen.page.array)) >= 2, page.title

    def test_every_page_can_go_on_for_a_while(self, paged):
        moving = [place for place, page in enumerate(paged.PAGES) if page.move]
        for place in moving:
            page = paged.PAGES[place]
            bgi.initgraph(*page.mode)
            show(paged.PAGES, place)
            for _ in range(5):
                page.move()
            assert bgi.graphresult() == bgi.grOk, page.title

    def test_the_title_fits_beside_the_keys(self, paged):
        for place, page in enumerate(paged.PAGES):
            bgi.initgraph(*page.mode)
            keys = f"{place + 1}/{len(paged.PAGES)}  {KEYS_SHOWN}"
            room = bgi.getmaxx() + 1 - 2 * MARGIN - bgi.textwidth(keys)
            assert bgi.textwidth(page.title + " ") <= room, page.title

    def test_keys_turn_the_pages(self, monkeypatch):
        drawn = []
        pages = [Page(str(n), lambda n=n: drawn.append(n)) for n in range(3)]
        monkeypatch.setenv("BGI_KEYS", "Space Right x Left PgUp Down Esc")
        leaf_through(pages)
        assert drawn == [0, 1, 2, 0, 2, 1, 2]

    def test_a_moving_page_moves_until_a_key_comes(self, monkeypatch):
        moves = []
        monkeypatch.setenv("BGI_KEYS", "Esc")
        leaf_through([Page("", lambda: None, lambda: moves.append(1), 30)])
        assert moves == [1]

    def test_palette_moves_colours_and_no_pixel(self):
        palette = load("palette").module()
        for place, page in enumerate(palette.PAGES):
            bgi.initgraph(*page.mode)
            show(palette.PAGES, place)
            pixels, looks = current.screen.page.array.copy(), current.screen.card.palette.copy()
            page.move()
            assert (current.screen.page.array == pixels).all()
            assert (current.screen.card.palette != looks).any()

    def test_saucers_leave_the_town_as_it_was(self):
        sprites = load("sprites").module()
        bgi.initgraph(*sprites.MODE)
        show(sprites.PAGES, 1)
        sprites.SAUCERS.put()
        town = current.screen.page.array.copy()
        sprites.SAUCERS.put()
        assert (current.screen.page.array != town).any()
        sprites.SAUCERS.put()
        assert (current.screen.page.array == town).all()
