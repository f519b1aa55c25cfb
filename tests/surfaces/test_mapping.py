"""The paper's map against the paper's own formulas, and against closed forms worked out by hand."""

from math import acos, asin, cos, inf, nan, pi, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import Mapping, apply, power, powers, rotation, translation

reals = st.floats(-100, 100)
points = st.tuples(reals, reals, reals)
scales = st.floats(0.1, 100)
mappings = st.builds(
    Mapping,
    theta=st.floats(0.05, 1.5),
    rho_z=st.floats(0.05, 1.0),
    origin=st.tuples(reals, reals),
    scale=st.tuples(scales, scales, scales),
)
unscaled = st.builds(
    Mapping,
    theta=st.floats(0.05, 1.5),
    rho_z=st.floats(0.05, 1.0),
    origin=st.tuples(reals, reals),
)

# sin = 3/5 and cos = 4/5 give matrices of plain fractions.
FRACTIONS = Mapping(theta=asin(3 / 5), rho_z=1 / 2, origin=(10, 20), scale=(2, 3, 4))


@given(unscaled, points)
def test_project_is_the_papers_equation(m: Mapping, p: tuple[float, float, float]) -> None:
    (x, y, z), (x0, y0) = p, m.origin
    expected = (
        x0 + y - x * sin(m.theta),
        y0 - m.rho_z * z + x * cos(m.theta),
        z,
    )
    assert m.project(p) == pytest.approx(expected, abs=1e-9)


@given(points, points, st.floats(0.05, 1.5))
def test_unproject_is_the_papers_inverse(
    triple: tuple[float, float, float], origin: tuple[float, float, float], theta: float
) -> None:
    (xs, ys, z), (x0, y0, _) = triple, origin
    x = (ys - y0 + z) / cos(theta)
    y = xs - x0 + (ys - y0 + z) * tan(theta)
    found = Mapping(theta=theta, origin=(x0, y0)).unproject(triple)
    assert found == pytest.approx((x, y, z), rel=1e-9, abs=1e-8)


def test_defaults_are_the_papers() -> None:
    m = Mapping()
    half = sqrt(0.5)
    assert (m.theta, m.rho_z) == (pi / 4, 1.0)
    assert np.array(((-half, half), (1, 0), (0, -1))) == pytest.approx(m.M32)
    assert m.M33_inverse == pytest.approx(np.array(((0, 1, 0), (sqrt(2), 1, 0), (sqrt(2), 1, 1))))


def test_matrices_in_plain_fractions() -> None:
    m = FRACTIONS
    assert np.array(((-6 / 5, 8 / 5, 0), (3, 0, 0), (0, -2, 1))) == pytest.approx(m.M33)
    assert m.M33_inverse == pytest.approx(
        np.array(((0, 1 / 3, 0), (5 / 8, 1 / 4, 0), (5 / 4, 1 / 2, 1)))
    )
    assert m.M4[3] == pytest.approx((10, 20, 0, 1))
    assert m.M4_inverse[3] == pytest.approx((-25 / 2, -25 / 3, 0, 1))
    assert np.linalg.det(m.M33) == pytest.approx(-24 / 5)
    assert m.eye / m.eye[0] == pytest.approx((1, 2 / 5, 4 / 5))


def test_adjugate_over_determinant_as_printed() -> None:
    theta = 0.7
    s, c = sin(theta), cos(theta)
    adjugate = np.array(((0, -c, 0), (-1, -s, 0), (-1, -s, -c)))
    assert Mapping(theta=theta).M33_inverse == pytest.approx(adjugate / -c)


@given(mappings)
def test_determinant_knows_nothing_of_heights(m: Mapping) -> None:
    ax, ay, _ = m.scale
    assert np.linalg.det(m.M33) == pytest.approx(-ax * ay * cos(m.theta))


@given(mappings)
def test_inverses(m: Mapping) -> None:
    assert m.M33 @ m.M33_inverse == pytest.approx(np.eye(3), abs=1e-9)
    assert m.M4 @ m.M4_inverse == pytest.approx(np.eye(4), abs=1e-7)


@given(mappings, points)
def test_there_and_back(m: Mapping, p: tuple[float, float, float]) -> None:
    assert m.unproject(m.project(p)) == pytest.approx(p, abs=1e-6)


@given(mappings)
def test_the_eye_sees_its_own_direction_as_a_point(m: Mapping) -> None:
    assert m.eye @ m.M32 == pytest.approx((0, 0), abs=1e-9 * max(m.scale) ** 3)
    assert (m.eye > 0).all()


def test_any_shape_of_points() -> None:
    rng = np.random.default_rng(1)
    field = rng.normal(size=(4, 5, 3))
    triples = FRACTIONS.project(field)
    assert triples.shape == (4, 5, 3)
    assert triples[2, 3] == pytest.approx(FRACTIONS.project(field[2, 3]))
    assert FRACTIONS.unproject(triples) == pytest.approx(field)
    assert (triples[..., 2] == field[..., 2]).all()


def test_nothing_is_rounded() -> None:
    assert Mapping().project((0.25, 0.5, 0.125))[0] == 0.5 - 0.25 * sin(pi / 4)


def test_projection_is_cavalier() -> None:
    """x is drawn at full length, and the line of sight meets the y-z plane at 45 degrees."""
    m = Mapping(theta=0.6)
    x, y, z = np.eye(3)
    assert [np.hypot(*(v @ m.M32)) for v in (x, y, z)] == pytest.approx([1, 1, 1])
    assert acos(m.eye @ x / np.linalg.norm(m.eye)) == pytest.approx(pi / 4)


# M' ------------------------------------------------------------------------------------------


def test_screen_matrix_of_a_turn_about_z() -> None:
    theta, phi = 0.7, 0.3
    s, c, S, C = sin(theta), cos(theta), sin(phi), cos(phi)
    expected = np.array(
        (
            (C + S * s, -S * c, 0),
            (S * (1 + s * s) / c, C - S * s, 0),
            (S * (1 + s * s) / c, C - S * s - 1, 1),
        )
    )
    M = Mapping(theta=theta).screen_matrix(rotation("z", phi))
    assert M[:3, :3] == pytest.approx(expected)


def test_screen_matrix_of_a_turn_about_x() -> None:
    theta, phi, rho = 0.7, 0.3, 0.5
    t, S, C = tan(theta), sin(phi), cos(phi)
    expected = np.array(
        (
            (C, -rho * S, S),
            ((C - 1) * t, 1 - rho * S * t, S * t),
            (rho * (C - 1) * t - S, rho * (1 - C - rho * S * t), C + rho * S * t),
        )
    )
    M = Mapping(theta=theta, rho_z=rho).screen_matrix(rotation("x", phi))
    assert M[:3, :3] == pytest.approx(expected)


def test_screen_matrix_of_a_turn_about_y() -> None:
    theta, phi, rho = 0.7, 0.3, 0.5
    s, c, t, S, C = sin(theta), cos(theta), tan(theta), sin(phi), cos(phi)
    expected = np.array(
        (
            (1, 0, 0),
            ((1 - C) * t, C + rho * S / c, -S / c),
            (rho * (1 - C) * t - S * s, (rho * rho / c + c) * S, C - rho * S / c),
        )
    )
    M = Mapping(theta=theta, rho_z=rho).screen_matrix(rotation("y", phi))
    assert M[:3, :3] == pytest.approx(expected)


def test_the_origin_is_where_the_paper_slips() -> None:
    """One degree about z, with the origin in the middle of a VGA screen."""
    m = Mapping(origin=(320, 240))
    T = rotation("z", pi / 180)
    triple = m.project((1, 2, 0.5))
    assert triple == pytest.approx((321.292893219, 240.207106781, 0.5))
    assert apply(triple, m.screen_matrix(T)) == pytest.approx((321.334830141, 240.182317656, 0.5))
    literal = triple @ m.M33_inverse @ T[:3, :3] @ m.M33
    assert literal == pytest.approx((334.120436129, 233.234964127, 0.5))


@given(mappings, points, points, st.floats(-7, 7))
def test_screen_matrix_is_back_transform_forth(
    m: Mapping, p: tuple[float, float, float], about: tuple[float, float, float], angle: float
) -> None:
    T = rotation((1, 2, 3), angle, about) @ translation(3, -4, 5)
    on_screen = apply(m.project(p), m.screen_matrix(T))
    size = 1 + np.abs(m.M4).max() * np.abs(m.M4_inverse).max()
    assert on_screen == pytest.approx(m.project(apply(p, T)), abs=1e-10 * size)


@given(unscaled, points)
def test_a_move_does_not_depend_on_the_origin(m: Mapping, t: tuple[float, float, float]) -> None:
    tx, ty, tz = t
    s, c = sin(m.theta), cos(m.theta)
    M = m.screen_matrix(translation(tx, ty, tz))
    assert M[:3, :3] == pytest.approx(np.eye(3), abs=1e-9)
    assert M[3, :3] == pytest.approx((ty - tx * s, tx * c - m.rho_z * tz, tz), abs=1e-8)


@pytest.mark.parametrize("axis", ["x", "y", "z", (1, 2, 3)])
@pytest.mark.parametrize("n", [1, 2, 3, 5, 360])
def test_n_times_T_is_n_times_the_screen_matrix(
    axis: str | tuple[float, float, float], n: int
) -> None:
    m = Mapping(theta=0.9, rho_z=0.8, origin=(320, 240), scale=(55, 50, 65))
    angle = 2 * pi / 360
    step = m.screen_matrix(rotation(axis, angle, about=(1, 2, 3)))
    closed = m.screen_matrix(rotation(axis, n * angle, about=(1, 2, 3)))
    assert power(step, n) == pytest.approx(closed, abs=1e-9)
    incremental = next(M for k, M in enumerate(powers(step), 1) if k == n)
    assert incremental == pytest.approx(closed, abs=1e-9)


def test_rounding_between_steps_drifts() -> None:
    """Why triples stay floats: a turn of 360 single degrees should end where it began."""
    m = Mapping(origin=(320, 240), scale=(50, 50, 50))
    M = m.screen_matrix(rotation("z", pi / 180))
    rng = np.random.default_rng(7)
    start = m.project(rng.uniform(-2, 2, size=(500, 3)))
    exact = rounded = start
    for _ in range(360):
        exact = apply(exact, M)
        rounded = apply(rounded, M)
        rounded[:, :2] = np.rint(rounded[:, :2])
    assert np.abs(exact - start).max() < 1e-9
    rms = np.sqrt(((rounded - start)[:, :2] ** 2).sum(axis=1).mean())
    assert rms > 10


# Refusals ------------------------------------------------------------------------------------


@pytest.mark.parametrize("theta", [0, pi / 2, -0.1, 2, 7, nan, inf])
def test_theta_must_lie_inside_the_quadrant(theta: float) -> None:
    with pytest.raises(ValueError, match=r"theta must be between 0 and pi/2, not "):
        Mapping(theta=theta)


@pytest.mark.parametrize("rho_z", [0, -1, 1.01, nan, inf])
def test_rho_compresses(rho_z: float) -> None:
    with pytest.raises(ValueError, match="rho_z must be above 0 and at most 1, not "):
        Mapping(rho_z=rho_z)


@pytest.mark.parametrize("scale", [(1, 0, 1), (1, 1, -1), (nan, 1, 1), (1, inf, 1), (1, 1)])
def test_scale_must_be_three_finite_numbers_above_zero(scale: tuple[float, float, float]) -> None:
    with pytest.raises(ValueError, match="scale must be three finite numbers above 0, not "):
        Mapping(scale=scale)


@pytest.mark.parametrize("origin", [(nan, 0), (0, inf), (1, 2, 3)])
def test_origin_must_be_a_pixel(origin: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="origin must be two finite numbers, not "):
        Mapping(origin=origin)
