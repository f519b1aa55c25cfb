"""Any primitive graphics system: the same picture, however little the system can do."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

import bgi
from bgi.memory.imagefile import load
from surfaces import FIGURES, RAMPS, Pen, parametric, rotation, surface
from surfaces.systems import trace
from surfaces.systems.characters import Text
from surfaces.systems.svg import Svg

TURNS = {"as it is": None, "tumbling": rotation((1, 2, 3), 1.1)}
HOW: dict[str, dict[str, Any]] = {
    "fill": {"n": 60},
    "mesh": {"n": 30, "mode": "mesh"},
    "fill+mesh": {"n": 60, "mode": "fill+mesh", "every": 3},
    "waterfall": {"n": 30, "mode": "waterfall"},
    "wire": {"n": 20, "mode": "wire"},
    "facets": {"n": 40, "mode": "facets"},
    "around": {"n": 20, "box": True, "axes": True, "contours": 5, "floor": 5, "colorbar": True},
    "holes": {"n": 20, "holes": True, "mode": "mesh"},
    "holes, filled": {"n": 20, "holes": True},
    "dithered": {"n": 30, "dither": True},
}


class Dots:
    """A graphics system that can set a pixel, and nothing else."""

    def __init__(self, width: int, height: int, colors: int) -> None:
        self.array = np.zeros((height, width), dtype=np.int64)
        self.colors = colors

    def getmaxx(self) -> int:
        return self.array.shape[1] - 1

    def getmaxy(self) -> int:
        return self.array.shape[0] - 1

    def getmaxcolor(self) -> int:
        return self.colors - 1

    def putpixel(self, x: int, y: int, color: int) -> None:
        assert (type(x), type(y), type(color)) == (int, int, int)
        assert 0 <= x <= self.getmaxx()
        assert 0 <= y <= self.getmaxy()
        self.array[y, x] = color


def draw(on: Any, holes: bool = False, **how: Any) -> None:
    fig = FIGURES[1]

    def f(x: Any, y: Any) -> Any:
        return np.where(x * x + y * y < 0.7, np.nan, fig.f(x, y)) if holes else fig.f(x, y)

    surface(f, fig.x, fig.y, zfrac=fig.zfrac, on=on, **how)


def page() -> NDArray[Any]:
    x, y = np.meshgrid(np.arange(bgi.getmaxx() + 1), np.arange(bgi.getmaxy() + 1))
    return np.asarray(bgi.getpixel(x, y))


@pytest.mark.parametrize("how", HOW.values(), ids=HOW.keys())
@pytest.mark.parametrize("turn", TURNS.values(), ids=TURNS.keys())
@pytest.mark.parametrize("mode", [bgi.IBM8514, bgi.VGA])
def test_pixel_by_pixel_it_is_the_same_picture(how: Any, turn: Any, mode: int) -> None:
    """The BGI's arrays, lines and polygons against nothing but putpixel, one at a time."""
    bgi.initgraph(mode, bgi.VGAHI if mode == bgi.VGA else bgi.IBM8514LO)
    # A system without writing: the BGI's, with the one call taken away.
    quiet = Quiet()
    draw(quiet, transform=turn, lines=14, **how)
    dots = Dots(640, 480, bgi.getmaxcolor() + 1)
    draw(dots, transform=turn, lines=14, **how)
    assert (page() == dots.array).all()
    assert dots.array.any()


class Quiet:
    """The BGI without outtextxy."""

    arrays = True

    def __getattr__(self, name: str) -> Any:
        if name in ("outtextxy", "vector", "aspect", "character"):
            raise AttributeError(name)
        return getattr(bgi, name)


def test_a_scalar_system_with_lines_and_polygons() -> None:
    """graphics.h's own calls, one number at a time: setcolor, setfillstyle, line, fillpoly."""

    class Borland:
        def __getattr__(self, name: str) -> Any:
            if name in ("outtextxy", "arrays", "vector", "aspect", "character"):
                raise AttributeError(name)
            return getattr(bgi, name)

    pictures = []
    for system in (Quiet(), Borland()):
        bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
        draw(system, n=15, mode="mesh", holes=True, box=True, axes=True, lines=14)
        pictures.append(page())
    assert (pictures[0] == pictures[1]).all()


@pytest.mark.parametrize("mode", ["fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"])
def test_svg_is_a_drawing_of_shapes(mode: str) -> None:
    svg = Svg(640, 480)
    draw(svg, n=12, mode=mode, axes=True, box=True, colorbar=True, title="a < b & c", lines=14)
    root = ElementTree.fromstring(str(svg))
    shapes = [child for child in root if child.tag.endswith("path")]
    assert len(shapes) >= 100
    assert not [shape for shape in shapes if "h1v1" in shape.attrib["d"]]  # no single pixels
    texts = [child.text for child in root if child.tag.endswith("text")]
    assert texts[-1] != ""
    assert "a < b & c" in texts
    assert {"x", "y", "z"} <= set(texts)


def test_svg_has_every_call(tmp_path: Any) -> None:
    svg = Svg(100, 50, background="#ffffff")
    svg.setcolor(4)
    svg.putpixel(3, 4, 2)
    svg.line(0, 0, 99, 49)
    svg.setfillstyle(1, 14)
    svg.setcolor(0)
    svg.fillpoly([(1, 1), (5, 1), (3, 9)])
    svg.setrgbpalette(200, 1, 2, 255)
    svg.putpixel(9, 9, 200)
    svg.save(tmp_path / "a.svg")
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    ElementTree.fromstring(text)
    assert 'viewBox="-0.5 -0.5 100 50"' in text
    assert 'd="M2.5 3.5h1v1h-1z" fill="#00aa00"' in text
    assert 'd="M0 0L99 49" stroke="#aa0000"' in text
    assert 'd="M1 1L5 1L3 9z" fill="#ffff55" stroke="#ffff55"' in text
    assert 'fill="#0102ff"' in text
    assert (svg.getmaxx(), svg.getmaxy(), svg.getmaxcolor(), svg.getcolor()) == (99, 49, 255, 0)


@pytest.mark.parametrize(
    ("text", "shown"),
    [("a\x01b", "a\ufffdb"), ("\0", "\ufffd"), ("\x1b[31m", "\ufffd[31m"), ("\ud800", "\ufffd")]
    + [(same, same) for same in ("<&>\"'", "𝛼 < β", "a\tb")],
)
def test_svg_holds_any_text(text: str, shown: str, tmp_path: Path) -> None:
    svg = Svg()
    svg.outtextxy(5, 5, text)
    svg.save(tmp_path / "a.svg")
    root = ElementTree.parse(tmp_path / "a.svg").getroot()
    assert [child.text for child in root if child.tag.endswith("text")] == [shown]


def test_svg_takes_its_background_as_a_color_only() -> None:
    evil = '"/><script>alert(1)</script><rect fill="'
    root = ElementTree.fromstring(str(Svg(background=evil)))
    assert [(child.tag.split("}")[1], child.attrib["fill"]) for child in root] == [("rect", evil)]


def test_svg_that_cannot_be_written_leaves_the_old_file(tmp_path: Path) -> None:
    file = tmp_path / "a.svg"
    file.write_text("old", encoding="utf-8")
    unwritable: Any = "\ud800"
    with pytest.raises(UnicodeEncodeError):
        Svg(width=unwritable).save(file)
    assert file.read_text(encoding="utf-8") == "old"


def test_text_draws_with_characters() -> None:
    page = Text(60, 24)
    surface(lambda x, y: -x * x - y * y, (-1, 1), (-1, 1), n=40, on=page, title="a hill", zfrac=0.4)
    lines = str(page).split("\n")
    assert len(lines) == 24
    assert "a hill" in lines[1]
    picture = "".join(lines[3:])
    assert set(".:-=+*o#%@") <= set(picture)
    assert max(map(len, lines)) <= 60


def test_text_of_one_color() -> None:
    page = Text(40, 20)
    surface(lambda x, y: x * y, (-1, 1), (-1, 1), n=6, mode="wire", on=page)
    assert set(str(page)) == {" ", "*", "\n"}
    page.outtextxy(-3, 99, "x" * 99)
    assert str(page).split("\n")[-1] == "x" * 40


def test_a_parametric_surface_on_dots() -> None:
    dots = Dots(80, 60, 256)

    def ball(u: Any, v: Any) -> Any:
        return np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)

    parametric(ball, (0, 2 * np.pi), (0, np.pi), n=30, projection="isometric", on=dots)
    rows, columns = np.nonzero(dots.array)
    assert np.ptp(columns) == pytest.approx(np.ptp(rows), abs=1)
    assert len(rows) == pytest.approx(np.pi / 4 * (np.ptp(rows) + 1) ** 2, rel=0.05)


def test_what_a_pen_knows_of_its_system() -> None:
    bgi.initgraph(bgi.EGA, bgi.EGAHI)
    pen = Pen()
    assert (pen.width, pen.height, pen.colors, pen.arrays, pen.vector) == (
        640,
        350,
        16,
        True,
        False,
    )
    assert (pen.aspect, pen.character) == (pytest.approx(4 * 350 / (3 * 640)), 8)
    bgi.initwindow(800, 300)
    assert Pen().aspect == 1  # its pixels are square, whatever its shape
    page = Pen(Text())
    assert (page.arrays, page.aspect, page.character, page.color) == (False, 0.5, 1, 15)
    assert Pen(Dots(4, 4, 4)).color == 3


PICTURES: dict[str, Callable[[], object]] = {
    "fill": lambda: surface(wave, (-3, 3), (-3, 3), 60, colorbar=True, axes=True, title="wave"),
    "facets": lambda: surface(wave, (-3, 3), (-3, 3), 20, "facets", lines=bgi.WHITE),
    "lines": lambda: surface(wave, (-3, 3), (-3, 3), 40, "fill+mesh", contours=5, floor=8),
    "two": lambda: surface([wave, lambda x, y: 0 * x], (-3, 3), (-3, 3), 30, ramp="heat"),
    "body": lambda: parametric(
        lambda u, v: (np.cos(u), np.sin(u), v), (0, 6), (0, 1), 30, under="ice"
    ),
}


def wave(x: Any, y: Any) -> Any:
    """Up and down, so that both sides are seen."""
    return np.sin(x * y)


@pytest.mark.parametrize("name", PICTURES)
def test_a_window_shows_what_256_colors_show(name: str, tmp_path: Path) -> None:
    """There is no palette to load: the colours are mixed one by one."""
    shown = []
    for number, open_screen in enumerate(
        (lambda: bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO), lambda: bgi.initwindow(640, 480))
    ):
        open_screen()
        bgi.setcolor(bgi.YELLOW)
        PICTURES[name]()
        assert bgi.getcolor() == bgi.YELLOW
        file = tmp_path / f"{number}.png"
        bgi.writeimagefile(file)
        shown.append(load(file).rgba[..., :3].astype(int))
    assert len(np.unique(shown[1].reshape(-1, 3), axis=0)) > 16
    assert np.abs(shown[0] - shown[1]).max() <= 3  # the 8514 takes the upper six bits


@pytest.mark.parametrize("mode", ["fill", "wire"])
def test_the_floor_has_its_colors_though_it_is_drawn_first(mode: str) -> None:
    """Contours below the first picture were white: the palette was loaded after them."""
    picture = Svg()
    surface(lambda x, y: x, (-1, 1), (-1, 1), 10, mode, floor=[0.0], lines=bgi.BLUE, on=picture)
    strokes = set(re.findall(r'<path d="M[^z"]*" stroke="(#\w+)"', str(picture)))
    red, green, blue = RAMPS["rainbow"].mix(160)[80]
    assert f"#{red:02x}{green:02x}{blue:02x}" in strokes
    assert "#ffffff" not in strokes


def test_lines_in_a_color_of_ones_own() -> None:
    bgi.initwindow(320, 200)
    ink = bgi.COLOR(250, 128, 3)
    surface(wave, (-3, 3), (-3, 3), 10, "mesh", lines=ink)
    assert ink in np.unique(bgi.getpixel(*np.meshgrid(np.arange(320), np.arange(200))))


def test_what_rounding_leaves_of_a_half_is_a_half() -> None:
    """The last bit of a sine depends on the machine's C library, a picture does not."""
    halves = np.array([[20.5, 7.5], [300.5, 0.5]])
    for error in (0.0, 1e-10, -1e-10):
        assert trace.rounded(halves + error).tolist() == [[21, 8], [301, 1]]
        starts, ends, _ = trace.clip(halves + error, halves[::-1] + error, 640, 480)
        assert starts.tolist() == [[21, 8], [301, 1]]
        assert ends.tolist() == [[301, 1], [21, 8]]
