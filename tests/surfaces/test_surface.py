"""surface() on a real screen: what is drawn, where, and what is left alone."""

from collections.abc import Iterator
from math import pi
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import bgi
import surfaces
from surfaces import FIGURES, Mapping, affine, compose, rotation, scaling, translation
from surfaces.shape.grid import sample
from surfaces.systems.colors import UNDER, UPPER, palette

MODES = ["wire", "mesh", "fill", "fill+mesh", "waterfall", "facets"]
SMALL: dict[str, Any] = {"x": (-1, 1), "y": (-1, 1)}
VIEW = Mapping(theta=0.7, origin=(310, 250), scale=(150, 170, 90))
TURNS = {
    "none": np.eye(4),
    "turned": rotation("z", 2.3),
    "tumbling": rotation((1, 2, 3), 4.0),
    "mirrored": scaling(-1, 1, 1),
    "sheared": affine(((1, 0.4, 0), (0, 1, 0.3), (0, 0.5, 1))),
}


@pytest.fixture(autouse=True)
def screen() -> Iterator[None]:
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    yield
    bgi.closegraph()


def page() -> NDArray[Any]:
    """The active page, [y, x]."""
    width, height = bgi.getmaxx() + 1, bgi.getmaxy() + 1
    return np.asarray(bgi.getpixel(*np.meshgrid(np.arange(width), np.arange(height))))


def drawn(*args: Any, **kwargs: Any) -> NDArray[Any]:
    """The page after surface(...) on a blank one."""
    bgi.cleardevice()
    surfaces.surface(*args, **kwargs)
    return page()


def hill(x: Any, y: Any) -> Any:
    return np.exp(-3 * (x * x + y * y))


def plane(x: Any, y: Any) -> Any:
    return 0 * x


# Where it is drawn -----------------------------------------------------------------------------


def extent(picture: NDArray[Any]) -> tuple[int, int, int, int]:
    """Left, top, right, bottom of what is not background."""
    y, x = np.nonzero(picture)
    return int(x.min()), int(y.min()), int(x.max()), int(y.max())


@pytest.mark.parametrize("mode", MODES)
def test_the_picture_fills_the_width_and_is_centred(mode: str) -> None:
    left, top, right, bottom = extent(drawn(lambda x, y: x * y, **SMALL, mode=mode, lines=15))
    assert left in (24, 25)  # a filled cell may lack the tip of its lowest row
    assert right in (614, 615)
    assert abs((top + bottom) / 2 - 239.5) <= 1


@pytest.mark.parametrize("mode", MODES)
def test_nothing_is_written_outside_the_viewport(mode: str) -> None:
    bgi.setviewport(200, 150, 400, 300, 1)
    surfaces.surface(FIGURES[1].f, FIGURES[1].x, FIGURES[1].y, 40, mode)
    bgi.setviewport(0, 0, 639, 479, 1)
    picture = page()
    assert picture[150:301, 200:401].any()
    picture[150:301, 200:401] = 0
    assert not picture.any()


def test_turning_does_not_change_the_scale() -> None:
    """The fit depends on the surface, not on the turn: its height stays while it spins."""
    needle = scaling(1e-9, 1e-9, 1)
    spins = [compose(needle, rotation("z", angle)) for angle in (0, 1, 2, 3)]
    extents = [extent(drawn(hill, **SMALL, n=20, mode="wire", transform=T)) for T in spins]
    assert len(set(extents)) == 1


def test_a_mapping_is_used_as_it_is() -> None:
    """The square 0..100 in the plane z = 0, seen with theta of sin 3/5."""
    mapping = Mapping(theta=np.arcsin(0.6), origin=(300, 100))
    bgi.setcolor(7)
    picture = drawn(plane, (0, 100), (0, 100), 1, "wire", mapping=mapping)
    bgi.cleardevice()
    bgi.drawpoly([(300, 100), (240, 180), (340, 180), (400, 100), (300, 100)])
    assert (picture == page()).all()


def test_transform_comes_before_the_mapping() -> None:
    mapping = Mapping(theta=np.arcsin(0.6), origin=(300, 100))
    moved = Mapping(theta=np.arcsin(0.6), origin=(300 + 20 - 6, 100 - 30 + 8))
    picture = drawn(hill, (0, 99), (0, 99), 9, transform=translation(10, 20, 30), mapping=mapping)
    assert (picture == drawn(hill, (0, 99), (0, 99), 9, mapping=moved)).all()


@pytest.mark.parametrize("mode", MODES)
def test_far_outside_is_harmless(mode: str) -> None:
    huge = Mapping(scale=(1e12, 1e12, 1e12))
    assert drawn(hill, **SMALL, n=4, mode=mode, mapping=huge).shape == (480, 640)


# What is drawn ---------------------------------------------------------------------------------


def test_wire_is_both_families_of_lines() -> None:
    bgi.setcolor(14)
    picture = drawn(hill, **SMALL, n=(3, 4), mode="wire", mapping=VIEW)
    grid = sample(hill, (-1, 1), (-1, 1), (3, 4))
    nodes = np.floor(VIEW.project(grid.points)[..., :2] + 0.5).astype(int)
    bgi.cleardevice()
    for i in range(4):
        for j in range(5):
            if i < 3:
                bgi.line(*nodes[i, j].tolist(), *nodes[i + 1, j].tolist())
            if j < 4:
                bgi.line(*nodes[i, j].tolist(), *nodes[i, j + 1].tolist())
    assert (picture == page()).all()


@pytest.mark.parametrize("mode", MODES)
def test_an_even_function_looks_the_same_from_behind(mode: str) -> None:
    def even(x: Any, y: Any) -> Any:
        return np.cos(3 * x) * np.cos(2 * y) + x * y

    front = drawn(even, **SMALL, n=20, mode=mode, transform=np.eye(4))
    back = drawn(even, **SMALL, n=20, mode=mode, transform=scaling(-1, -1, 1))
    assert (front == back).all()


@pytest.mark.parametrize("mode", [mode for mode in MODES if mode != "waterfall"])
def test_exchanging_x_and_y_twice_changes_nothing(mode: str) -> None:
    exchange = affine(((0, 1, 0), (1, 0, 0), (0, 0, 1)))
    plain = drawn(lambda x, y: x - y**3, **SMALL, n=20, mode=mode, transform=np.eye(4))
    twice = drawn(lambda x, y: y - x**3, **SMALL, n=20, mode=mode, transform=exchange)
    assert (plain == twice).all()


def test_mesh_hides_lines_of_the_wire() -> None:
    bgi.setcolor(14)
    fig = FIGURES[2]
    wire = drawn(fig.f, fig.x, fig.y, 30, "wire")
    mesh = drawn(fig.f, fig.x, fig.y, 30, "mesh")
    assert set(np.unique(mesh)) == {0, 14}
    assert (mesh != 0).sum() < 0.9 * (wire != 0).sum()
    assert not (mesh[wire == 0]).any()


def gaps(picture: NDArray[Any]) -> int:
    """Background pixels with drawn pixels on all four sides."""
    on = picture != 0
    around = on[:-2, 1:-1] & on[2:, 1:-1] & on[1:-1, :-2] & on[1:-1, 2:]
    return int((around & ~on[1:-1, 1:-1]).sum())


@pytest.mark.parametrize("fig", FIGURES, ids=lambda fig: fig.name)
def test_the_figures_have_no_gaps(fig: surfaces.Figure) -> None:
    assert gaps(drawn(fig.f, fig.x, fig.y, 100, zfrac=fig.zfrac)) == 0


@pytest.mark.parametrize("T", TURNS.values(), ids=TURNS.keys())
@pytest.mark.parametrize("n", [7, 50, 150])
def test_cells_meet_without_gaps(T: NDArray[Any], n: int) -> None:
    assert gaps(drawn(lambda x, y: x * y, **SMALL, n=n, zfrac=0.1, transform=T)) == 0


@pytest.mark.parametrize("turn", [0, 1, 2, 3, 4, 5, 6])
@pytest.mark.parametrize(("elevation", "side"), [(pi / 2, "upper"), (-pi / 2, "under")])
def test_seen_along_z_a_surface_shows_one_side(turn: float, elevation: float, side: str) -> None:
    """There heights have no length on the screen, and cannot tell the sides apart."""
    surfaces.surface(
        lambda x, y: np.sin(x * y) / 5,
        **SMALL,
        n=20,
        transform=rotation("z", turn),
        projection=surfaces.orthographic(0, elevation),
    )
    inks = {"upper": UPPER, "under": UNDER}[side]
    drawn = np.unique(page())
    assert set(drawn) <= {0, *inks.tolist()}
    assert len(drawn) > 10


def test_the_quotient_has_no_holes() -> None:
    fig = FIGURES[2]
    quotient = drawn(lambda x, y: np.sin(x + y) / (x + y), fig.x, fig.y, 100, zfrac=fig.zfrac)
    assert ((quotient != 0) != (drawn(fig.f, fig.x, fig.y, 100, zfrac=fig.zfrac) != 0)).sum() < 5


@pytest.mark.parametrize("mode", MODES)
def test_a_hole_stays_empty(mode: str) -> None:
    def ring(x: Any, y: Any) -> Any:
        return np.where(x * x + y * y < 0.5, np.nan, 0)

    bgi.setcolor(15)
    picture = drawn(ring, **SMALL, n=40, mode=mode, mapping=VIEW)
    assert not picture[240:260, 290:330].any()
    assert picture.any()


def test_a_surface_of_one_value_is_drawn() -> None:
    assert set(np.unique(drawn(lambda x, y: 5, **SMALL, n=3))) == {0, 16}


@pytest.mark.parametrize(
    ("driver", "mode", "colors"),
    [(bgi.VGA, bgi.VGAHI, 16), (bgi.EGA, bgi.EGAHI, 16), (bgi.CGA, bgi.CGAC1, 4), (bgi.CGA, 4, 2)],
)
@pytest.mark.parametrize("dither", [False, True])
def test_every_kind_of_screen(driver: int, mode: int, colors: int, dither: bool) -> None:
    bgi.initgraph(driver, mode)
    picture = drawn(hill, **SMALL, n=30, dither=dither)
    inks = palette(colors, "rainbow", "dusk", dither)
    seen = {0, *inks.entries().tolist()}
    assert seen <= set(np.unique(picture)) <= seen | {*inks.entries(under=True).tolist()}
    assert not picture[0].any()
    assert not picture[:, 0].any()


# What is left alone ----------------------------------------------------------------------------


@pytest.mark.parametrize("mode", MODES)
def test_the_drawing_color_stays(mode: str) -> None:
    bgi.setcolor(5)
    surfaces.surface(hill, **SMALL, n=5, mode=mode)
    assert bgi.getcolor() == 5


BAD: dict[str, tuple[dict[str, Any], str]] = {
    "mode": ({"mode": "solid"}, "mode must be one of 'fill', 'mesh', .*, not 'solid'"),
    "x": ({"x": (1, -1)}, r"x must be \(a, b\)"),
    "n": ({"n": 0}, "n must be at least 1"),
    "f": ({"f": lambda x, y: np.log(-1 - x * x)}, "no finite value"),
    "theta": ({"theta": 2}, "theta must be"),
    "rho_z": ({"rho_z": 0}, "rho_z must be"),
    "zfrac": ({"zfrac": 1}, "zfrac must be"),
    "3x3": ({"transform": np.eye(3)}, "transform must be a 4x4 matrix"),
    "nan": ({"transform": np.full((4, 4), np.nan)}, "transform must be a 4x4 matrix"),
    "flat": ({"transform": scaling(1, 1, 0)}, "transform must be invertible"),
}


@pytest.mark.parametrize(("wrong", "message"), BAD.values(), ids=BAD.keys())
def test_bad_input_changes_nothing(wrong: dict[str, Any], message: str) -> None:
    before = drawn(hill, **SMALL, n=10)
    with pytest.raises(ValueError, match=message):
        surfaces.surface(**{"f": hill, **SMALL, **wrong})
    assert (page() == before).all()


def test_an_error_in_f_comes_through_and_nothing_is_drawn() -> None:
    def broken(x: Any, y: Any) -> Any:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        surfaces.surface(broken, **SMALL)
    assert not page().any()


def test_without_a_screen() -> None:
    bgi.closegraph()
    with pytest.raises(bgi.BGIError, match="initgraph"):
        surfaces.surface(hill, **SMALL)


# Formulas --------------------------------------------------------------------------------------


def test_a_formula_is_drawn_as_its_function() -> None:
    wanted = drawn(lambda x, y: np.sin(x * y) / 2, (-3, 3), (-3, 3), 50)
    assert (drawn("sin(x*y)/2", n=50) == wanted).all()
    assert (drawn("sin(x*y)/2", x=(0, 1), n=50) != wanted).any()


def test_several_formulas() -> None:
    both = [lambda x, y: x * y, lambda x, y: 1 - x]
    wanted = drawn(both, (-1, 1), (-2, 2), 20)
    assert (drawn(["x*y", both[1]], (-1, 1), (-2, 2), 20) == wanted).all()


def test_a_text_that_is_no_formula_is_refused() -> None:
    with pytest.raises(surfaces.FormulaError, match="an operator is missing"):
        surfaces.surface("2x")
    assert not page().any()
