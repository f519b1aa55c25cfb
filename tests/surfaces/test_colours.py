"""From heights to palette entries."""

import numpy as np
import pytest

from surfaces.colours import RAMPS, ramp_rgb, shades


def test_the_ramp_goes_through_its_five_colours() -> None:
    blue, cyan, green, yellow, red = ramp_rgb(5).tolist()
    assert (blue, cyan, green) == ([0, 0, 255], [0, 255, 255], [0, 255, 0])
    assert (yellow, red) == ([255, 255, 0], [255, 0, 0])


def test_the_ramp_is_smooth() -> None:
    rgb = ramp_rgb(240)
    assert rgb.shape == (240, 3)
    assert len(np.unique(rgb, axis=0)) == 240
    assert np.abs(np.diff(rgb, axis=0)).max() <= 5


@pytest.mark.parametrize("colours", [2, 4, 16, 256])
@pytest.mark.parametrize("dither", [False, True])
def test_lowest_and_highest(colours: int, dither: bool) -> None:
    field = np.zeros((4, 4))
    assert set(shades(field, colours, dither).ravel()) == {RAMPS[colours][0]}
    assert set(shades(field + 1, colours, dither).ravel()) == {RAMPS[colours][-1]}


@pytest.mark.parametrize("colours", [2, 4, 16, 256])
def test_every_colour_gets_an_equal_share(colours: int) -> None:
    ramp = RAMPS[colours]
    field = ((np.arange(len(ramp)) + 0.5) / len(ramp))[:, np.newaxis]
    assert shades(field, colours).ravel().tolist() == ramp.tolist()


def test_between_two_bands_the_cells_alternate() -> None:
    """Half way between BLUE and LIGHTBLUE."""
    assert shades(np.full((2, 3), 0.5 / 7), 16, dither=True).tolist() == [[1, 9, 1], [9, 1, 9]]


def test_a_missing_height_is_harmless() -> None:
    assert shades(np.array(((np.nan, 1.0),)), 16).tolist() == [[1, 4]]


def test_the_everyday_colours_stay() -> None:
    assert RAMPS[256].min() == 16
    assert RAMPS[256].max() == 255
