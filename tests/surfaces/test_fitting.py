"""The fit to the screen: the paper's "proper scaling", for every projection."""

import math
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import PROJECTIONS, Mapping, apply, orthographic, rotation
from surfaces.space.fitting import fit


def corners(box: Any) -> Any:
    return np.array(list(product(*zip(*box, strict=True))))


BOX = (np.array((-10.0, 5.0, 100.0)), np.array((10.0, 6.0, 250.0)))


def test_fit_is_the_rule_of_the_figures() -> None:
    """24 pixels of margin at 640x480, the base as large as fits, z as high as asked, centred."""
    normal, mapping = fit(BOX, 640, 480, zfrac=0.3)
    seen = mapping.project(apply(corners(BOX), normal))[:, :2]
    assert (seen.min(axis=0) + seen.max(axis=0)) / 2 == pytest.approx((319.5, 239.5))
    side = 591 / (1 + math.sqrt(0.5))
    assert np.ptp(seen, axis=0) == pytest.approx((591, side * math.sqrt(0.5) + 0.3 * 431))
    assert mapping.scale == pytest.approx((side / 2,) * 3)
    assert apply(BOX[0], normal)[:2] == pytest.approx((-1, -1))
    assert apply(BOX[1], normal)[:2] == pytest.approx((1, 1))


sizes = st.integers(20, 2000)


@given(sizes, sizes, st.floats(0.05, 1.5), st.floats(0.1, 1), st.floats(0.1, 0.9))
def test_fit_stays_inside(w: int, h: int, theta: float, rho_z: float, zfrac: float) -> None:
    normal, mapping = fit(BOX, w, h, Mapping(theta, rho_z), zfrac=zfrac)
    seen = mapping.project(apply(corners(BOX), normal))
    margin = 0.05 * min(w, h) - 1e-9
    assert seen[:, 0].min() >= margin
    assert seen[:, 0].max() <= w - 1 - margin
    assert seen[:, 1].min() >= margin
    assert seen[:, 1].max() <= h - 1 - margin


@given(
    st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: any(abs(c) > 0.1 for c in v)),
    st.floats(0, 7),
    st.floats(0.3, 1.2),
)
def test_fit_for_turning_stays_inside(
    axis: tuple[float, float, float], angle: float, theta: float
) -> None:
    normal, mapping = fit(BOX, 640, 480, Mapping(theta), aspect=0.8, turning=True)
    seen = mapping.project(apply(apply(corners(BOX), normal), rotation(axis, angle)))
    assert seen[:, :2].min() >= -1e-9
    assert seen[:, 0].max() <= 639 + 1e-9
    assert seen[:, 1].max() <= 479 + 1e-9


def test_high_pixels_shorten_what_is_high() -> None:
    """On a card whose pixels are higher than wide the picture has its shape all the same."""
    aspect = 0.775
    _, square = fit(BOX, 640, 480, Mapping(0.6, 0.9))
    _, high = fit(BOX, 640, 372, Mapping(0.6, 0.9), aspect=aspect)
    ratio = high.scale[1] / square.scale[1]
    assert square.M32 * (ratio, ratio * aspect) == pytest.approx(high.M32)
    assert high.eye / high.eye[0] == pytest.approx(square.eye / square.eye[0])


def test_a_flat_surface_stays_flat() -> None:
    low, high = np.array((0.0, 0.0, 5.0)), np.array((1.0, 1.0, 5.0))
    normal, _ = fit((low, high), 640, 480)
    assert apply((0.5, 0.5, 5), normal) == pytest.approx((0, 0, 0))


@pytest.mark.parametrize("zfrac", [0, 1, -0.5, math.nan])
def test_bad_zfrac(zfrac: float) -> None:
    with pytest.raises(ValueError, match="zfrac must be between 0 and 1, not "):
        fit(BOX, 640, 480, zfrac=zfrac)


@pytest.mark.parametrize("name", PROJECTIONS)
@pytest.mark.parametrize("turning", [False, True])
def test_every_projection_fits(name: str, turning: bool) -> None:
    normal, mapping = fit(BOX, 640, 480, PROJECTIONS[name], turning=turning)
    seen = mapping.project(apply(corners(BOX), normal))[:, :2]
    if name != "perspective" or not turning:  # near by, what turns is centred as a ball is
        assert (seen.min(axis=0) + seen.max(axis=0)) / 2 == pytest.approx((319.5, 239.5))
    assert seen.min() >= 24 - 1e-9
    if not turning:  # as wide or as high as can be; heights may be foreshortened
        assert np.ptp(seen[:, 0]) == pytest.approx(591) or np.ptp(seen[:, 1]) > 0.9 * 431


def test_looking_straight_down() -> None:
    """Where z has no height on the screen, it takes no part of it."""
    normal, mapping = fit(BOX, 640, 480, orthographic(0, math.pi / 2))
    seen = mapping.project(apply(corners(BOX), normal))
    assert np.ptp(seen[:, 1]) == pytest.approx(431)


def test_room_for_labels_stays_free() -> None:
    normal, mapping = fit(BOX, 640, 480, labels=(30, 20, 100, 10))
    seen = mapping.project(apply(corners(BOX), normal))
    assert (seen[:, 0].min(), seen[:, 0].max()) == pytest.approx((54, 515))
    with pytest.raises(ValueError, match="640 x 480 pixels has no room"):
        fit(BOX, 640, 480, labels=(300, 0, 300, 0))
