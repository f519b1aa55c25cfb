"""Transforms against the matrices of the textbook, written for row vectors."""

from itertools import islice
from math import cos, inf, nan, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import affine, apply, compose, power, powers, rotation, scaling, translation

Point = tuple[float, float, float]

reals = st.floats(-10, 10)
points = st.tuples(reals, reals, reals)
angles = st.floats(-7, 7)
axes = points.filter(lambda v: np.hypot(np.hypot(v[0], v[1]), v[2]) > 0.01)


@given(angles)
def test_the_three_axes(phi: float) -> None:
    S, C = sin(phi), cos(phi)
    Rx = np.array(((1, 0, 0), (0, C, S), (0, -S, C)))
    Ry = np.array(((C, 0, -S), (0, 1, 0), (S, 0, C)))
    Rz = np.array(((C, S, 0), (-S, C, 0), (0, 0, 1)))
    for axis, R in (("x", Rx), ("y", Ry), ("z", Rz)):
        assert rotation(axis, phi) == pytest.approx(affine(R), abs=1e-15)


@pytest.mark.parametrize(
    ("axis", "start", "end"),
    [("z", (1, 0, 0), (0, 1, 0)), ("x", (0, 1, 0), (0, 0, 1)), ("y", (0, 0, 1), (1, 0, 0))],
)
def test_a_quarter_turn(axis: str, start: Point, end: Point) -> None:
    assert apply(start, rotation(axis, pi / 2)) == pytest.approx(end, abs=1e-15)


@given(angles, angles, angles)
def test_any_axis_by_turning_it_onto_z(azimuth: float, altitude: float, phi: float) -> None:
    axis = (cos(azimuth) * cos(altitude), sin(azimuth) * cos(altitude), sin(altitude))
    onto_z = compose(rotation("z", -azimuth), rotation("y", altitude - pi / 2))
    expected = compose(onto_z, rotation("z", phi), power(onto_z, -1))
    assert rotation(axis, phi) == pytest.approx(expected, abs=1e-12)


@given(axes, angles)
def test_a_rotation_is_one(axis: Point, phi: float) -> None:
    T = rotation(axis, phi)
    R = T[:3, :3]
    assert pytest.approx(np.eye(3), abs=1e-12) == R @ R.T
    assert np.linalg.det(R) == pytest.approx(1)
    assert np.trace(R) == pytest.approx(1 + 2 * cos(phi), abs=1e-12)
    assert apply(axis, T) == pytest.approx(axis, abs=1e-12)


def test_the_length_of_an_axis_does_not_matter() -> None:
    assert rotation((0, 0, 5), 0.3) == pytest.approx(rotation("z", 0.3))
    assert rotation((0, 0, -5), 0.3) == pytest.approx(rotation("z", -0.3))
    assert rotation((1, 1, 1), 2 * pi / 3)[0] == pytest.approx((0, 1, 0, 0), abs=1e-15)
    assert apply((sqrt(2), 0, 0), rotation((1, 0, 1), pi / 2)) == pytest.approx(
        (sqrt(0.5), 1, sqrt(0.5))
    )


@given(axes, angles, points)
def test_the_point_about_which_stays(axis: Point, phi: float, about: Point) -> None:
    assert apply(about, rotation(axis, phi, about)) == pytest.approx(about, abs=1e-12)
    assert apply(about, scaling(2, -3, 0.5, about)) == pytest.approx(about, abs=1e-12)
    moved = compose(translation(*(-v for v in about)), rotation(axis, phi), translation(*about))
    assert rotation(axis, phi, about) == pytest.approx(moved, abs=1e-12)


def test_moving_and_scaling() -> None:
    assert apply((1, 2, 3), translation(10, 20, 30)) == pytest.approx((11, 22, 33))
    assert apply((1, 2, 3), scaling(2, -3, 0)) == pytest.approx((2, -6, 0))
    assert apply((1, 2, 3), scaling(2, 2, 2, about=(1, 1, 1))) == pytest.approx((1, 3, 5))


def test_compose_does_the_first_first() -> None:
    T = compose(translation(1, 0, 0), rotation("z", pi / 2), scaling(1, 5, 1))
    assert apply((1, 0, 0), T) == pytest.approx((0, 10, 0), abs=1e-15)
    assert compose() == pytest.approx(np.eye(4))


def test_any_shape_of_points() -> None:
    field = np.random.default_rng(2).normal(size=(2, 3, 4, 3))
    T = rotation((1, 2, 3), 0.4, about=(5, 6, 7))
    assert apply(field, T).shape == field.shape
    assert apply(field, T)[1, 2, 3] == pytest.approx(apply(field[1, 2, 3], T))


@given(axes, angles, points, st.integers(-20, 20))
def test_powers_of_a_rotation_have_a_closed_form(
    axis: Point, phi: float, about: Point, n: int
) -> None:
    expected = rotation(axis, n * phi, about)
    assert power(rotation(axis, phi, about), n) == pytest.approx(expected, abs=1e-10)


def test_powers_step_by_step() -> None:
    T = affine(((1, 0.5, 0), (0, 0.9, 0.1), (0.2, 0, 1.1)), (1, 2, 3))
    steps = list(islice(powers(T), 5))
    for n, step in enumerate(steps, 1):
        assert step == pytest.approx(power(T, n))
    assert steps[2] == pytest.approx(T @ T @ T)
    assert power(T, 0) == pytest.approx(np.eye(4))
    assert power(T, -2) @ T @ T == pytest.approx(np.eye(4))


def test_a_long_animation_does_not_drift() -> None:
    """A hundred turns in steps of one degree: 36 000 products leave the axes in place."""
    T = rotation((1, 2, 3), pi / 180)
    end = next(islice(powers(T), 35_999, None))
    assert np.abs(end - np.eye(4)).max() < 1e-10


@pytest.mark.parametrize("axis", ["w", "X", "", "xy"])
def test_unknown_axis(axis: str) -> None:
    with pytest.raises(ValueError, match=r'axis must be "x", "y", "z" or a vector'):
        rotation(axis, 1)


@pytest.mark.parametrize("axis", [(0, 0, 0), (nan, 0, 1), (inf, 0, 0)])
def test_axis_without_direction(axis: Point) -> None:
    with pytest.raises(ValueError, match=r"axis must be a finite vector other than \(0, 0, 0\)"):
        rotation(axis, 1)
