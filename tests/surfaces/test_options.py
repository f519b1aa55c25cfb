"""Options as they are given: taken where their meaning is plain, else refused before any work."""

import inspect
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import bgi
from surfaces import Svg, parametric, surface
from tests.surfaces.raycast import Canvas


def saddle(x: Any, y: Any) -> Any:
    return x * y


def of_saddle(**how: Any) -> Any:
    page = Canvas(160, 120)
    surface(saddle, (-1, 1), (-1, 1), **{"n": 8, "on": page} | how)
    return page.array


@pytest.mark.parametrize(
    ("given", "plain"),
    [
        ({"contours": np.int64(5)}, {"contours": 5}),
        ({"contours": np.array(5)}, {"contours": 5}),
        ({"contours": 5.0}, {"contours": 5}),
        ({"contours": np.array((0.25, 0.5))}, {"contours": [0.25, 0.5]}),
        ({"contours": range(2)}, {"contours": [0, 1]}),
        ({"floor": np.int32(4)}, {"floor": 4}),
        ({"n": [20, 30]}, {"n": (20, 30)}),
        ({"n": np.array((20, 30))}, {"n": (20, 30)}),
        ({"n": 20.0}, {"n": 20}),
        ({"n": np.uint8(20)}, {"n": 20}),
        ({"every": 2.0, "mode": "mesh"}, {"every": 2, "mode": "mesh"}),
        ({"every": 10**30, "mode": "mesh"}, {"every": 8, "mode": "mesh"}),
        ({"lines": [3, 4], "mode": "mesh"}, {"lines": (3, 4), "mode": "mesh"}),
        ({"lines": np.int64(3), "mode": "mesh"}, {"lines": 3, "mode": "mesh"}),
        ({"axes": 1}, {"axes": True}),
        ({"axes": np.bool_(True)}, {"axes": True}),
        ({"axes": np.array(("a", "b", "c"))}, {"axes": ("a", "b", "c")}),
        ({"box": np.bool_(True), "colorbar": 1}, {"box": True, "colorbar": True}),
        ({"title": np.str_("saddle")}, {"title": "saddle"}),
        ({"theta": np.float32(0.5)}, {"theta": 0.5}),
        ({"zfrac": Fraction(1, 2)}, {"zfrac": 0.5}),
        ({"x": np.array((-1, 1)), "z": [-1, np.int8(1)]}, {"z": (-1.0, 1.0)}),
    ],
)
def test_what_is_plain_is_taken(given: dict[str, Any], plain: dict[str, Any]) -> None:
    pages = []
    for how in (given, plain):
        page = Canvas(160, 120)
        domain = {"x": (-1, 1), "y": (-1, 1), "n": 8}
        surface(saddle, **domain | how, on=page)
        pages.append(page.array)
    assert (pages[0] == pages[1]).all()
    assert pages[0].any()


class Untouched:
    """The BGI's screen, where nothing may be drawn and no palette may be loaded."""

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("get"):
            raise AttributeError(name)
        return getattr(bgi, name)

    def putpixel(self, *pixel: Any) -> None:
        raise AssertionError("something was drawn")

    setrgbpalette = setcolor = outtextxy = line = fillpoly = putpixel


class Stranger:
    """Something that is no number, no text, no sequence and no function."""

    def __repr__(self) -> str:
        return "Stranger()"


LEVELS = [
    *(-1, 2.5, "many", None, 1j, Stranger(), 10**9, range(10**9)),
    *(["high"], [[1]], [float("inf")], [float("nan")]),
]
WRONG: dict[str, list[Any]] = {
    "n": [0, -1, 2.5, "20", (3,), (3, 4, 5), (3, 0), None, Stranger(), float("nan"), 10**5],
    "mode": ["none", "", 3, None, ["fill"], Stranger()],
    "transform": [
        "turn",
        3,
        np.eye(3),
        np.full((4, 4), np.nan),
        1e200 * np.eye(4),
        Stranger(),
        [[1], [2, 3]],
    ],
    "mapping": ["paper", 3, Stranger()],
    "projection": ["none", 3, ["paper"], Stranger()],
    "theta": ["a", None, 0, 2, float("nan"), [1], Stranger(), 1j],
    "rho_z": ["a", None, 0, 2, float("nan"), [1], Stranger()],
    "zfrac": ["a", 0, 1, float("nan"), [1], Stranger()],
    "log": ["a", "xx", "x z", 3, None, True, ["x"], b"x", Stranger()],
    "z": [3, (1, 1), (2, 1), "ab", (0, float("nan")), Stranger()],
    "color": ["none", 3, None, [1, 2], [[1], [2, 3]], Stranger(), [["a"]], np.ones((2, 2))],
    "ramp": ["none", 3, None, ["heat"], Stranger()],
    "under": ["none", 3, ["heat"], Stranger()],
    "dither": ["no", 2, None, [True], 0.5, Stranger()],
    "lines": ["red", 2.5, (1,), (1, 2, 3), (1, "red"), Stranger()],
    "every": [0, -1, 2.5, "2", (1, 2), Stranger(), float("inf")],
    "contours": LEVELS,
    "floor": LEVELS,
    "box": ["no", 2, None, np.ones(2), Stranger()],
    "axes": [2, None, ("x", "y"), (1, 2, 3), "xy", "", Stranger(), np.ones((3, 3))],
    "title": [5, None, b"title", ["a"], Stranger()],
    "colorbar": ["no", 2, None, Stranger()],
    "on": ["a.svg", 3, Stranger()],
}
BOTH = set(WRONG) - {"z", "contours", "floor"}


def a_surface(**how: Any) -> None:
    surface(saddle, (-1, 1), (-1, 1), **{"n": 8} | how)


def a_body(**how: Any) -> None:
    def f(u: Any, v: Any) -> Any:
        return u, v, u * v

    parametric(f, (-1, 1), (-1, 1), **{"n": 8} | how)


@pytest.mark.parametrize("name", WRONG)
def test_what_is_not_plain_is_refused_by_name_before_anything_is_drawn(name: str) -> None:
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    around = {"axes": True, "box": True, "title": "T", "colorbar": True, "on": Untouched()}
    kinds: list[Callable[..., None]] = [a_surface, a_body] if name in BOTH else [a_surface]
    for draw in kinds:
        with pytest.raises(AssertionError, match="something was drawn"):
            draw(**around)
        for wrong in WRONG[name]:
            with pytest.raises((TypeError, ValueError), match=rf"^{name} must") as error:
                draw(**around | {name: wrong})
            assert len(str(error.value)) < 250


def test_every_option_is_asked_the_wrong_thing() -> None:
    assert set(WRONG) == set(inspect.signature(surface).parameters) - {"f", "x", "y"}


@pytest.mark.parametrize("wrong", [{"title": 5}, {"axes": (1, 2, 3)}, {"every": 2.5}])
def test_of_the_wrong_kind_is_a_type_error(wrong: dict[str, Any]) -> None:
    with pytest.raises(TypeError, match=next(iter(wrong))):
        of_saddle(**wrong)


def test_limits_hold_before_any_work() -> None:
    def never(x: Any, y: Any) -> Any:
        raise AssertionError("called")

    for wrong in ({"n": 10**5}, {"n": (1, 10**9)}, {"contours": 10**9}, {"floor": [0.0] * 1001}):
        with pytest.raises(ValueError, match=rf"^{next(iter(wrong))} must"):
            surface(never, (0, 1), (0, 1), on=Canvas(9, 9), **wrong)
    with pytest.raises(ValueError, match=r"^n must"):
        parametric(never, (0, 1), (0, 1), n=10**5, on=Canvas(9, 9))


def test_huge_arrays_are_refused_before_they_are_copied() -> None:
    huge = np.broadcast_to(np.int8(1), (10**5, 10**4))  # takes one byte
    with pytest.raises(ValueError, match=r"^f must have at most 16777216 numbers"):
        surface(huge, on=Canvas(9, 9))
    with pytest.raises(ValueError, match=r"^color must have at most 16777216 numbers"):
        surface(np.eye(3), color=huge, on=Canvas(9, 9))


def test_any_number_of_numpy_is_a_height() -> None:
    heights = np.arange(12).reshape(3, 4)
    expected = Canvas(60, 40)
    surface(heights, on=expected)
    for kind in (np.float16, np.uint8, object, np.longdouble):
        page = Canvas(60, 40)
        surface(heights.astype(kind), on=page)
        assert (page.array == expected.array).all()


@pytest.mark.parametrize("color", [lambda x, y: 1e308 * x, lambda x, y: 1e-320 * x])
def test_a_bar_of_colors_for_any_values(color: Any) -> None:
    """It was drawn after the surface, and ended in an OverflowError."""
    surface(saddle, (-1, 1), (-1, 1), 8, color=color, colorbar=True, on=Svg())
