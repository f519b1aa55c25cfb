"""The benchmark: every row runs, the report is in order, runs are kept, the README's rows exist.

What is measured here counts for nothing: no test depends on a time.
"""

import pytest

import bgi
from bench import arguments, calls, command, libraries, readme, report, timing
from bench.groups import plots
from bench.saved import Run
from bench.timing import OURS, Result
from bgi.memory.sdl import pygame

CALLS = sorted(command.GROUPS.keys() - {"startup", "surfaces", "growth", "memory"})


@pytest.fixture(autouse=True)
def without_plotters(monkeypatch):
    """Those that happen to be installed take their time."""
    absent = {"matplotlib": None, "gnuplot": None, "PLplot": None}
    monkeypatch.setattr(plots, "plotters", lambda: absent)
    monkeypatch.setattr(command, "plotters", lambda: absent)


def result(name, group="lines", units=10.0, **ratios):
    return Result(group, name, units / 1e6, units, ratios)


def run(*results):
    return Run(1, ["PLplot"], 25e-9, list(results), {"Python": "3"})


@pytest.mark.parametrize("group", CALLS)
def test_every_row_of_calls_runs(group):
    for row in command.GROUPS[group].rows():
        measured = timing.measure(row, 0)
        assert measured.name == row.name
        assert measured.ratios.keys() == row.tasks.keys() - {OURS}


@pytest.mark.parametrize("plot", plots.PLOTS, ids=lambda plot: plot.name)
def test_every_kind_of_surface_is_drawn(plot):
    assert plots.task_of(plot, 8)(0) >= 0


def test_a_row_has_its_own_name():
    names = [row.name for group in command.GROUPS.values() for row in group.rows()]
    assert len(names) == len(set(names))


def test_a_ratio_is_that_of_its_round():
    times = {OURS: [9, 1, 2, 4], "SDL_bgi": [9, 3, 4, 4]}  # the first round warms up
    tasks = {name: list(each).__getitem__ for name, each in times.items()}
    measured = timing.measure(timing.Row("lines", "a row", tasks), 3)
    assert measured.seconds == 2
    assert measured.ratios == {"SDL_bgi": 2}


def test_libraries_take_turns():
    asked = []

    def task(name):
        def run_it(number):
            asked.append((number, name))
            return 1.0

        return run_it

    timing.measure(timing.Row("lines", "a row", {n: task(n) for n in (OURS, "pygame")}), 2)
    assert asked == [
        (0, OURS), (0, "pygame"), (1, "pygame"), (1, OURS), (2, OURS), (2, "pygame"),
    ]  # fmt: skip


def test_cold_rows_never_meet_the_same_arguments():
    drawn = []

    class Library:
        name, functions = "theirs", object()

        def reset(self):
            pass

        def function(self, name):
            return lambda *ends: drawn.append(ends)

        def arguments(self, name, many):
            return many

    def drawn_by(cold):
        drawn.clear()
        entry = calls.Call("a", "line", arguments.lines(50), cold=cold)
        task = calls.task_of(entry, Library())
        for number in (0, 1):
            task(number)
        return len(set(drawn))

    assert (drawn_by(cold=False), drawn_by(cold=True)) == (50, 100)


class FakeSdlBgi:
    """Its module, as far as arguments go."""

    SDL = SDL_640x480 = 0

    def __init__(self):
        self.drawn = []

    def __getattr__(self, name):
        def called(*values):
            self.drawn.append((name, *values))
            return 12  # an image's size

        return called


def test_sdl_bgi_is_given_arguments_of_its_own():
    sdl = libraries.SdlBgi(FakeSdlBgi())
    triangle = [(1, 2), (3, 4), (5, 6)]
    assert sdl.arguments("fillpoly", [(triangle,)]) == [(3, [1, 2, 3, 4, 5, 6])]
    assert sdl.arguments("line", [(1, 2, 3, 4)]) == [(1, 2, 3, 4)]
    ((*box, buffer),) = sdl.arguments("getimage", [(5, 5, 14, 14)])
    assert box == [5, 5, 14, 14] and len(buffer) == 12
    sdl.functions.drawpoly(triangle)
    assert sdl.module.drawn[-1] == ("drawpoly", 3, [1, 2, 3, 4, 5, 6])


@pytest.mark.parametrize(
    "name, ends",
    [
        ("putpixel", (50, 60, 15)),
        ("line", (10, 20, 300, 20)),
        ("rectangle", (10, 20, 300, 200)),
        ("bar", (10, 20, 300, 200)),
        ("drawpoly", ([(10, 20), (300, 20), (300, 90)],)),
    ],
)
def test_pygame_draws_the_same(name, ends):
    ours, theirs = libraries.Ours(), libraries.Pygame()
    for library in (ours, theirs):
        library.reset()
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.WHITE)
    for library in (ours, theirs):
        for each in library.arguments(name, [ends]):
            library.function(name)(*each)
    drawn = bgi.getimage(0, 0, 639, 479).array
    assert drawn.any()
    assert (drawn == pygame.surfarray.array2d(theirs.surface).T).all()


def test_the_report_begins_with_the_rows_where_we_are_behind():
    shown = report.table(
        run(
            result("ahead", SDL_bgi=3.0),
            result("alone"),
            result("far behind", SDL_bgi=0.1, pygame=2.0),
            result("behind", SDL_bgi=0.9, pygame=0.01),
            result("behind a plotter", matplotlib=5.0, gnuplot=0.5),
        )
    ).splitlines()
    order = [line[:36].strip() for line in shown[-5:]]
    assert order == ["far behind", "behind a plotter", "behind", "ahead", "alone"]
    assert "PLplot: not installed" in shown


def test_growth_is_told_as_an_exponent_of_the_cells():
    linear, square = (result("a", "growth", **{plots.GROWN: 1 / 16**k}) for k in (1, 2))
    assert report.units(linear) == "^1.00"
    assert report.units(square) == "^2.00"


def test_a_run_is_the_same_when_read_again(tmp_path):
    kept = run(result("a", SDL_bgi=0.5), result("b"))
    kept.save(tmp_path / "run.json")
    assert Run.load(tmp_path / "run.json") == kept


def test_a_comparison_begins_with_what_became_slower():
    then = run(result("same"), result("slower"), result("gone"), result("faster", units=30.0))
    now = run(result("same"), result("slower", units=20.0), result("faster"), result("new"))
    lines = report.comparison(then, now).splitlines()[1:]
    assert [line.split() for line in lines] == [
        ["slower", "10.0", "20.0", "0.50"],
        ["same", "10.0", "10.0", "1.00"],
        ["faster", "30.0", "10.0", "3.00"],
    ]


def test_the_command_keeps_and_compares(tmp_path, capsys):
    file = str(tmp_path / "run.json")
    command.main(["images", "--rounds", "0", "--save", file])
    command.main(["images", "--rounds", "0", "--against", file])
    assert "getimage 16x16" in capsys.readouterr().out.partition("then")[2]
    with pytest.raises(SystemExit, match="no nonsense; there are lines, curves"):
        command.main(["nonsense"])


@pytest.mark.parametrize(
    "words, wrong",
    [
        (["--against", "none.json"], "none.json is no run that --save kept"),
        (["--against", "list.json"], "list.json is no run that --save kept"),
        (["--readme", "list.json"], "list.json is no run that --save kept"),
        (["--save", "none/run.json"], "in a folder that is not there"),
        (["--save", "."], ". is a folder"),
    ],
)
def test_files_are_looked_at_before_anything_is_measured(
    words, wrong, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "list.json").write_text("[]")
    monkeypatch.setattr(command, "measured", lambda *_: pytest.fail("measured"))
    with pytest.raises(SystemExit, match="2"):
        command.main(["images", *words])
    assert wrong in capsys.readouterr().err


def test_the_readme_names_known_rows():
    known = {row.name for group in command.GROUPS.values() for row in group.rows()}
    assert set(readme.CALLS) <= known
    assert {f"{name}, {n}" for name in readme.PLOTS for n in (200, 400, 1600)} <= known
    text = readme.README.read_text("utf-8")
    section = text.partition(readme.BEGIN)[2].partition(readme.END)[0]
    firsts = [line.split(" | ")[0].strip("| ") for line in section.splitlines() if "| " in line]
    shown = [first.removesuffix(" *") for first in firsts if "640x480" not in first]
    assert shown, "run: python -m bench --save run.json; python -m bench --readme run.json"
    assert {name for name in shown if name not in readme.PLOTS} <= known


def test_the_readme_shows_the_worst_rows(tmp_path, monkeypatch):
    monkeypatch.setattr(readme, "README", tmp_path / "README.md")
    readme.README.write_text(f"before\n{readme.BEGIN}\nold\n{readme.END}\nafter\n", "utf-8")
    results = [result(f"row {k}", SDL_bgi=k / 10) for k in range(1, 20)]
    readme.write(run(*results, result("putpixel", SDL_bgi=2.0)))
    text = readme.README.read_text("utf-8")
    assert text.startswith("before\n") and text.endswith("\nafter\n") and "old" not in text
    assert "Of 20 rows that SDL_bgi has, too, we are faster in 10." in text
    rows = [line.split(" | ")[0] for line in text.splitlines() if line.startswith("| ")]
    assert rows[1 : readme.WORST + 2] == [
        *(f"| row {k} *" for k in range(1, readme.WORST + 1)),
        "| putpixel",
    ]
