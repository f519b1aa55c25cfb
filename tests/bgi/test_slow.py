"""Drawing that can be watched: the same picture at the end, and pixels in the algorithm's order."""

import contextlib
import inspect
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import bgi
from bgi import current
from bgi.graphics import Graphics
from bgi.graphics.slow import ORDERS
from bgi.monitor.headless import Headless

Place = tuple[int, int]


@pytest.fixture(autouse=True)
def screen() -> Iterator[None]:
    bgi.initgraph(bgi.EGA, bgi.EGAHI)
    yield
    bgi.slow(0)
    bgi.closegraph()


def watched(draw: Callable[[], object]) -> list[Place]:
    """The places x, y in the order in which they change, by looking whenever the clock moves."""
    page = current.reachable().page
    seen: list[Place] = []
    before = page.array.copy()
    sleep = Headless.sleep

    def look(self: Headless, milliseconds: float) -> None:
        nonlocal before
        changed = np.argwhere(page.array != before)
        before = page.array.copy()
        seen.extend((int(x), int(y)) for y, x in changed)
        sleep(self, milliseconds)

    with pytest.MonkeyPatch.context() as patch, bgi.slow(50):  # one pixel a look
        patch.setattr(Headless, "sleep", look)
        draw()
    return seen


class TestOrder:
    def test_a_line_begins_at_its_first_end(self) -> None:
        assert watched(lambda: bgi.line(5, 3, 1, 1)) == [(5, 3), (4, 3), (3, 2), (2, 2), (1, 1)][:5]
        assert watched(lambda: bgi.line(10, 9, 10, 6)) == [(10, 9), (10, 8), (10, 7), (10, 6)]

    def test_a_polygon_goes_from_corner_to_corner(self) -> None:
        assert watched(lambda: bgi.rectangle(0, 0, 2, 2)) == [
            *((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)),
        ]

    def test_a_circle_grows_by_octants(self) -> None:
        bgi.setaspectratio(10000, 10000)
        seen = watched(lambda: bgi.circle(50, 50, 20))
        steps = [min(abs(x - 50), abs(y - 50)) for x, y in seen]
        assert steps == sorted(steps)
        assert sorted(seen[:4]) == [(30, 50), (50, 30), (50, 70), (70, 50)]
        eight = {(abs(x - 50), abs(y - 50)) for x, y in seen[4:12]}
        assert eight == {(1, 20), (20, 1)}

    def test_an_ellipse_grows_by_quadrants(self) -> None:
        seen = watched(lambda: bgi.ellipse(50, 50, 0, 360, 30, 10))
        assert sorted(seen[:2]) == [(50, 40), (50, 60)]
        assert sorted(seen[-2:]) == [(20, 50), (80, 50)]

    def test_an_arc_goes_from_its_start_to_its_end(self) -> None:
        bgi.setaspectratio(10000, 10000)
        seen = watched(lambda: bgi.arc(50, 50, 0, 90, 20))
        assert (seen[0], seen[-1]) == ((70, 50), (50, 30))
        assert [y for _, y in seen] == sorted((y for _, y in seen), reverse=True)

    def test_areas_are_filled_row_by_row(self) -> None:
        bgi.setfillstyle(bgi.SOLID_FILL, 5)
        assert watched(lambda: bgi.bar(3, 3, 4, 5)) == [(x, y) for y in (3, 4, 5) for x in (3, 4)]

    def test_a_polygon_is_filled_before_its_outline_is_drawn(self) -> None:
        bgi.setfillstyle(bgi.SOLID_FILL, 5)
        seen = watched(lambda: bgi.fillpoly([(0, 0), (8, 0), (8, 8), (0, 8)]))
        outline = [place for place in seen if {0, 8} & set(place)]
        assert seen[-len(outline) :] == outline
        inside = seen[: -len(outline)]
        assert inside and inside == sorted(inside, key=lambda place: place[::-1])

    def test_a_flood_spreads_from_its_seed(self) -> None:
        bgi.rectangle(0, 0, 12, 12)
        bgi.setfillstyle(bgi.SOLID_FILL, 5)
        seen = watched(lambda: bgi.floodfill(6, 6, bgi.WHITE))
        far = [abs(x - 6) + abs(y - 6) for x, y in seen]
        assert seen[0] == (6, 6) and far == sorted(far) and len(seen) == 121

    def test_points_come_as_they_stand_in_the_array(self) -> None:
        places = [(5, 5), (1, 1), (9, 0), (3, 7)]
        x, y = np.array(places).T
        assert watched(lambda: bgi.putpixel(x, y, 4)) == places

    def test_figures_of_an_array_come_one_after_the_other(self) -> None:
        x = np.array([0, 100])
        seen = watched(lambda: bgi.line(x, 0, x + 5, 5))
        assert seen == [*((i, i) for i in range(6)), *((100 + i, i) for i in range(6))]

    def test_the_viewport_moves_all_of_it(self) -> None:
        bgi.setviewport(20, 10, 60, 60, 1)
        assert watched(lambda: bgi.line(2, 0, 0, 0)) == [(22, 10), (21, 10), (20, 10)]


coordinates = st.integers(-30, 90)
colors = st.integers(0, 15)


def forms() -> dict[str, list[Any]]:
    """What the arguments of each call that draws may be."""
    c = coordinates
    return {
        **{"putpixel": [c, c, colors], "line": [c, c, c, c], "rectangle": [c, c, c, c]},
        **{"lineto": [c, c], "linerel": [c, c], "bar": [c, c, c, c], "circle": [c, c, c]},
        "bar3d": [c, c, c, c, st.integers(0, 9), st.integers(0, 1)],
        **{"arc": [c, c, c, c, c], "ellipse": [c, c, c, c, c, c], "sector": [c] * 6},
        **{"pieslice": [c] * 5, "fillellipse": [c] * 4, "floodfill": [c, c, colors]},
        **{"outtextxy": [c, c, st.text(max_size=3)], "outtext": [st.text(max_size=3)]},
        **{"cleardevice": [], "clearviewport": [], "readimagefile": [st.just(FILE), c, c, c, c]},
        **{name: [st.lists(st.tuples(c, c), min_size=1, max_size=5)] for name in POLYGONS},
        "putimage": [
            c,
            c,
            st.just(IMAGE),
            st.integers(0, 4),
        ],
    }


@st.composite
def calls(draw: Any, name: str = "") -> tuple[str, tuple[Any, ...]]:
    """A call that draws, this one or any, with numbers or with arrays."""
    c, known = coordinates, forms()
    name = name or draw(st.sampled_from(sorted(known)))
    given_ = [draw(one) for one in known[name]]
    if name in ARRAYS and draw(st.booleans()):
        given_[0] = np.array([given_[0], draw(c)])
    return name, tuple(given_)


IMAGE = bgi.Image(np.arange(30, dtype="u1").reshape(5, 6) % 16)
FILE = Path(__file__).parents[2] / "demos" / "course" / "expected" / "01_frame.png"
POLYGONS = ("drawpoly", "fillpoly")
ARRAYS = ("putpixel", "line", "bar", "circle", "floodfill", "ellipse", "fillellipse")


def test_every_call_that_draws_is_tried() -> None:
    assert forms().keys() == ORDERS.keys()


NOT_DRAWN = {"initgraph", "setgraphmode", "swapbuffers", "restorecrtmode", "closegraph"}
"""What shows another page, or an empty one."""
OTHERS = sorted(
    name
    for name, _ in inspect.getmembers(Graphics, inspect.isfunction)
    if not name.startswith("_") and name not in ORDERS.keys() | NOT_DRAWN
)


@pytest.mark.parametrize("name", OTHERS)
def test_no_other_call_draws(name: str) -> None:
    """So slow() has forgotten none: whatever numbers the others are given, no pixel changes."""
    bgi.setfillstyle(bgi.XHATCH_FILL, 5)
    bgi.bar(0, 0, 99, 99)
    page = current.reachable().page
    before = page.array.copy()
    needed = inspect.signature(getattr(bgi, name, lambda: None)).parameters.values()
    given_ = [20 for one in needed if one.default is one.empty and one.kind is not one.VAR_KEYWORD]
    with contextlib.suppress(bgi.BGIError, TypeError, ValueError, OSError):
        getattr(bgi, name, lambda: None)(*given_)
    assert np.array_equal(page.array, before)


@pytest.mark.parametrize("name", sorted(forms()))
@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    st.data(),
    st.lists(calls(), max_size=3),
    st.tuples(st.integers(0, 4), st.sampled_from([1, 3]), st.integers(0, 1), st.integers(0, 12)),
    st.sampled_from([(bgi.VGA, bgi.VGAHI), (bgi.CGA, bgi.CGAC0), (bgi.CGA, bgi.CGAHI)]),
)
def test_the_picture_is_the_same(
    name: str,
    data: Any,
    others: list[tuple[str, tuple[Any, ...]]],
    style: tuple[int, int, int, int],
    mode: Place,
) -> None:
    drawn = [*others, data.draw(calls(name))]
    pictures = []
    for rate in (0, 10**7):
        bgi.initgraph(*mode)
        bgi.setviewport(5, 5, 80, 70, 1)
        bgi.setlinestyle(style[0], 0x0F35, style[1])
        bgi.setwritemode(style[2])
        bgi.setfillstyle(style[3] % 12, 3)
        with bgi.slow(rate):
            for called, given_ in drawn:
                getattr(bgi, called)(*given_)
        page = current.reachable().page
        pictures.append((page.array.copy(), bgi.getx(), bgi.gety()))
    assert np.array_equal(pictures[0][0], pictures[1][0])
    assert pictures[0][1:] == pictures[1][1:]


def test_time_passes_as_asked_for() -> None:
    monitor = current.reachable().monitor
    assert isinstance(monitor, Headless)
    before = monitor.now
    with bgi.slow(100):
        bgi.line(0, 0, 199, 0)
    assert abs(monitor.now - before - 2000) < 50
    bgi.line(0, 0, 199, 0)
    assert abs(monitor.now - before - 2000) < 50


def test_what_is_hidden_takes_no_time() -> None:
    monitor = current.reachable().monitor
    assert isinstance(monitor, Headless)
    bgi.setactivepage(1)
    before = monitor.now
    with bgi.slow(100):
        bgi.bar(0, 0, 199, 9)
    assert monitor.now == before


@pytest.mark.parametrize("rate", [-1, float("nan"), float("inf"), "fast", None])
def test_a_wrong_pace_is_refused(rate: Any) -> None:
    with pytest.raises((ValueError, TypeError), match="pixels_a_second"):
        bgi.slow(rate)


def test_an_error_leaves_the_picture_as_it_was() -> None:
    with bgi.slow(1000), pytest.raises(TypeError, match="x2"):
        bgi.line(0, 0, "5", 5)
    assert not current.reachable().page.array.any()


def run(program: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "bgi", "--monitor", "none", *options, str(program)],
        capture_output=True,
        text=True,
    )


def test_a_program_can_be_stepped_through(tmp_path: Path) -> None:
    program = tmp_path / "two.py"
    program.write_text("from bgi import *\ninitgraph()\nline(0, 0, 9, 9)\ncircle(50, 50, 9)\n")
    done = run(program, "--step", "--keys", "1 2")
    assert done.stderr.splitlines() == ["two.py:3: line(0, 0, 9, 9)", "two.py:4: circle(50, 50, 9)"]
    assert run(program, "--step", "--keys", "Esc").stderr == "two.py:3: line(0, 0, 9, 9)\n"


def test_so_can_a_program_in_c(tmp_path: Path) -> None:
    program = tmp_path / "TWO.C"
    program.write_text(
        "#include <graphics.h>\nvoid main()\n{ int gd = DETECT, gm;\n"
        'initgraph(&gd, &gm, "");\n  line(0, 0, 9, 9);\n  circle(50, 50, 9); }\n'
    )
    done = run(program, "--step", "--keys", "1 2")
    assert done.stderr.splitlines() == [
        "TWO.C:5: line(0, 0, 9, 9);",
        "TWO.C:6: circle(50, 50, 9); }",
    ]


def test_a_wrong_pace_on_the_command_line(tmp_path: Path) -> None:
    done = run(tmp_path / "none.py", "--slow", "quick")
    assert done.returncode == 2 and "it is a number of pixels a second" in done.stderr
