"""Sampling, the repair of missing points, and the fit to the screen."""

import math
from typing import Any

import numpy as np
import pytest

from surfaces import FIGURES
from surfaces.shape.grid import sample
from surfaces.shape.sampling import evaluate


def test_nodes_and_values() -> None:
    grid = sample(lambda x, y: 10 * x + y, (0, 2), (-1, 1), (2, 4))
    assert grid.x.tolist() == [0, 1, 2]
    assert grid.y.tolist() == [-1, -0.5, 0, 0.5, 1]
    assert grid.z.shape == (3, 5)
    assert grid.z[2, 1] == 19.5
    assert grid.points[2, 1].tolist() == [2, -0.5, 19.5]
    low, high = grid.box
    assert (low.tolist(), high.tolist()) == ([0, -1, -1], [2, 1, 21])


def test_f_is_called_once_with_arrays() -> None:
    shapes = []

    def f(x: Any, y: Any) -> Any:
        shapes.append((x.shape, y.shape))
        return x * y

    sample(f, (0, 1), (0, 1), 7)
    assert shapes == [((8, 8), (8, 8))]


@pytest.mark.parametrize(
    "f",
    [
        lambda x, y: math.sin(x) + y,  # cannot take arrays
        lambda x, y: np.sin(x) + y if x > 0 else y - np.sin(-x),  # cannot decide on arrays
        lambda x, y: np.array([math.sin(x.flat[0]) + y.flat[0]]) if np.ndim(x) else np.sin(x) + y,
    ],
)
def test_a_function_of_single_numbers(f: Any) -> None:
    grid = sample(f, (-1, 1), (-1, 1), 4)
    assert grid.z == pytest.approx(np.sin(grid.x)[:, None] + grid.y)


def test_a_constant_is_a_plane() -> None:
    assert (sample(lambda x, y: 3, (0, 1), (0, 1), 2).z == 3).all()


def test_an_error_in_f_is_not_hidden() -> None:
    def f(x: Any, y: Any) -> Any:
        return x.no_such_thing + y

    with pytest.raises(AttributeError):
        sample(f, (0, 1), (0, 1), 2)


def test_complex_results_are_refused() -> None:
    with pytest.raises(TypeError, match="real numbers"):
        sample(lambda x, y: x + 1j * y, (0, 1), (0, 1), 2)


# Missing points --------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [10, 50, 63, 200])
@pytest.mark.parametrize("R", [1, 10, 7.3])
def test_the_ridge_has_no_holes(n: int, R: float) -> None:
    """sin(u)/u on a grid hits u = 0 exactly at only some of the nodes on the diagonal."""
    grid = sample(lambda x, y: np.sin(x + y) / (x + y), (-R, R), (-R, R), n)
    u = grid.x[:, None] + grid.y
    assert grid.z == pytest.approx(np.sinc(u / np.pi), abs=1e-5)


@pytest.mark.parametrize(
    "f",
    [
        lambda x, y: math.sin(x + y) / (x + y),  # ZeroDivisionError
        lambda x, y: np.sin(np.hypot(x, y)) / np.hypot(x, y),
        lambda x, y: (1 - np.cos(x)) / x**2 + y,
        lambda x, y: np.expm1(x * y) / (x * y),
    ],
)
def test_removable_singularities_are_removed(f: Any) -> None:
    assert np.isfinite(sample(f, (-2, 2), (-2, 2), 8).z).all()


@pytest.mark.parametrize(
    ("f", "hole"),
    [
        (lambda x, y: 1 / (x + y), lambda x, y: x + y == 0),
        (lambda x, y: 1 / x**2 + y, lambda x, y: x == 0),
        (lambda x, y: np.log(x * x) + y, lambda x, y: x == 0),
        (lambda x, y: x * y / (x * x + y * y), lambda x, y: (x == 0) & (y == 0)),
        (lambda x, y: np.log(x * y), lambda x, y: x * y <= 0),
        (lambda x, y: np.sqrt(1 - x * x - y * y), lambda x, y: x * x + y * y > 1),
        (lambda x, y: math.sqrt(1 - x * x - y * y), lambda x, y: x * x + y * y > 1),
        (lambda x, y: math.exp(1000 * x) + y, lambda x, y: x > 0.1),  # beyond 1e30
        (lambda x, y: np.where(x > 0, np.inf, y), lambda x, y: x > 0),
        (lambda x, y: np.where(x > 0, -np.inf, y), lambda x, y: x > 0),
    ],
)
def test_real_holes_stay_and_nothing_warns(f: Any, hole: Any) -> None:
    grid = sample(f, (-2, 2), (-2, 2), 8)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    assert (np.isnan(grid.z) == hole(x, y)).all()
    assert not np.isinf(grid.z).any()


def test_evaluate_keeps_the_callers_settings() -> None:
    with np.errstate(divide="raise"):
        before = np.geterr()  # what raises cannot be tried: WebAssembly notices no such errors
        assert np.isinf(evaluate(lambda x, y: x / y, np.ones(3), np.zeros(3))).all()
        assert np.geterr() == before


# Refusals --------------------------------------------------------------------------------------


@pytest.mark.parametrize("bad", [(1, 1), (2, 1), (0, math.inf), (math.nan, 1)])
def test_bad_domain(bad: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match=r"x must be \(a, b\) with finite a < b, not "):
        sample(lambda x, y: x + y, bad, (0, 1), 2)
    with pytest.raises(ValueError, match=r"y must be \(a, b\) with finite a < b, not "):
        sample(lambda x, y: x + y, (0, 1), bad, 2)


@pytest.mark.parametrize("n", [0, -1, (0, 5), (5, 0)])
def test_bad_n(n: int | tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="n must be at least 1 in each direction, not "):
        sample(lambda x, y: x + y, (0, 1), (0, 1), n)


def test_f_without_any_value() -> None:
    with pytest.raises(ValueError, match="f has no finite value there"):
        sample(lambda x, y: np.log(-1 - x * x), (0, 1), (0, 1), 3)


# The paper's figures ---------------------------------------------------------------------------


def test_the_figures() -> None:
    assert [fig.name for fig in FIGURES] == [
        "sin(x+y)",
        "sin(x^2+y^2)",
        "sin(x+y)/(x+y)",
        "sin((x-y)/2)cos((x+y)/2)",
    ]
    for fig in FIGURES:
        assert np.isfinite(sample(fig.f, fig.x, fig.y, 50).z).all()


def test_the_egg_crate_is_half_a_difference_of_sines() -> None:
    grid = sample(FIGURES[3].f, (-7, 5), (-3, 8), 30)
    assert grid.z == pytest.approx((np.sin(grid.x)[:, None] - np.sin(grid.y)) / 2, abs=1e-12)


def test_the_ridge_is_the_quotient() -> None:
    assert FIGURES[2].f(0.3, 0.4) == pytest.approx(math.sin(0.7) / 0.7)
    assert FIGURES[2].f(0.3, -0.3) == 1
