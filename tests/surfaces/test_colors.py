"""From values to palette entries."""

from typing import Any

import numpy as np
import pytest

import bgi
from surfaces import RAMPS, Pen, Ramp, surface
from surfaces.systems.colors import UNDER, UPPER, palette

ALL = [2, 4, 16, 256]
NOWHERE = np.zeros(1, dtype=np.int64)


@pytest.mark.parametrize(
    ("rgb", "sixteen", "message"),
    [
        ((), (1,), "rgb must be colours of three numbers 0 to 255"),
        ("ab", (1,), "rgb must"),
        (((0, 0), (1, 1)), (1,), "rgb must"),
        (((0, 0, 256),), (1,), "rgb must"),
        ((3, 4), (1,), "rgb must"),
        (((0, 0, 0),), (), "sixteen must be colours 0 to 15"),
        (((0, 0, 0),), (16,), "sixteen must"),
        (((0, 0, 0),), "red", "sixteen must"),
    ],
)
def test_a_ramp_that_cannot_be_mixed(rgb: Any, sixteen: Any, message: str) -> None:
    """It was found when the box already stood on the screen."""
    with pytest.raises(ValueError, match=message):
        Ramp(rgb, sixteen)


def test_the_ramp_goes_through_its_five_colors() -> None:
    blue, cyan, green, yellow, red = RAMPS["rainbow"].mix(5).tolist()
    assert (blue, cyan, green) == ([0, 0, 255], [0, 255, 255], [0, 255, 0])
    assert (yellow, red) == ([255, 255, 0], [255, 0, 0])


@pytest.mark.parametrize("name", RAMPS)
def test_ramps_are_smooth(name: str) -> None:
    rgb = RAMPS[name].mix(160)
    assert rgb.shape == (160, 3)
    assert rgb.min() >= 0
    assert rgb.max() <= 255
    assert np.abs(np.diff(rgb, axis=0)).max() <= 8


@pytest.mark.parametrize("colors", ALL)
@pytest.mark.parametrize("dither", [False, True])
@pytest.mark.parametrize("under", [False, True])
def test_least_and_greatest(colors: int, dither: bool, under: bool) -> None:
    inks = palette(colors, "rainbow", "dusk", dither)
    j, i = np.indices((4, 4))
    ends = inks.entries(under)
    assert set(inks.shade(np.zeros((4, 4)), i, j, under).ravel()) == {ends[0]}
    assert set(inks.shade(np.ones((4, 4)), i, j, under).ravel()) == {ends[-1]}


@pytest.mark.parametrize("colors", ALL)
def test_every_color_gets_an_equal_share(colors: int) -> None:
    inks = palette(colors, "rainbow", "dusk", False)
    entries = inks.entries()
    value = (np.arange(len(entries)) + 0.5) / len(entries)
    assert inks.shade(value, NOWHERE, NOWHERE).tolist() == entries.tolist()


def test_sixteen_colors_have_the_bands_of_the_rainbow() -> None:
    bands = palette(16, "rainbow", "dusk", False).entries().tolist()
    assert bands == [1, 9, 3, 11, 10, 14, 12, 4]


def test_dithering_mixes_two_bands_in_proportion() -> None:
    """A third of the way from BLUE to LIGHTBLUE: 5 of 16 pixels are the lighter."""
    j, i = np.indices((4, 4))
    value = np.full((4, 4), 1 / 3 / 7)
    shades = palette(16, "rainbow", "dusk", True).shade(value, i, j)
    assert sorted(shades.ravel().tolist()) == [1] * 11 + [9] * 5
    half = palette(2, "rainbow", "dusk", True).shade(np.full((4, 4), 0.5), i, j)
    assert half.tolist() == [[0, 1, 0, 1], [1, 0, 1, 0]] * 2 or half.mean() == 0.5


def test_values_beyond_the_ramp_get_its_ends() -> None:
    value = np.array((-0.1, 1.0, -5.0, 7.0))
    place = np.arange(4)
    shades = palette(16, "rainbow", "dusk", False).shade(value, place, place)
    assert shades.tolist() == [1, 4, 1, 4]


def test_two_sides_at_once() -> None:
    under = np.array((False, True))
    inks = palette(256, "rainbow", "dusk", False)
    shades = inks.shade(np.zeros(2), np.arange(2), np.arange(2), under)
    assert shades.tolist() == [UPPER[0], UNDER[0]]


def test_the_everyday_colors_stay() -> None:
    assert sorted({*UPPER.tolist(), *UNDER.tolist()}) == list(range(16, 256))


def test_a_ramp_of_ones_own_is_loaded() -> None:
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    mine = Ramp(((0, 0, 0), (252, 0, 84)), (0, 4))
    palette(256, mine, "grey", False).load(Pen())
    assert bgi.current.screen.card.palette[UPPER[-1]].tolist() == [255, 0, 85]


@pytest.mark.parametrize("what", ["ramp", "under"])
def test_an_unknown_ramp(what: str) -> None:
    names = {"ramp": "rainbow", "under": "dusk", what: "pink"}
    with pytest.raises(ValueError, match=f"{what} must be one of rainbow, heat, .*, not 'pink'"):
        palette(256, dither=False, **names)


def lightness(rgb: Any) -> Any:
    """CIE 1976 L* of sRGB colours (n, 3): how light they look, 0 to 100."""
    part = np.asarray(rgb) / 255
    linear = np.where(part <= 0.04045, part / 12.92, ((part + 0.055) / 1.055) ** 2.4)
    luminance = linear @ (0.2126, 0.7152, 0.0722)
    return 116 * np.cbrt(np.maximum(luminance, 0.008856)) - 16


def test_viridis_is_even_to_the_eye() -> None:
    light = lightness(RAMPS["viridis"].mix(160))
    assert (np.diff(light) > 0).all()
    assert np.abs(light - np.linspace(light[0], light[-1], 160)).max() < 3
    rainbow = lightness(RAMPS["rainbow"].mix(160))
    assert np.abs(rainbow - np.linspace(rainbow[0], rainbow[-1], 160)).max() > 30


@pytest.mark.parametrize("name", RAMPS)
def test_every_ramp_is_smooth_in_a_window(name: str) -> None:
    bgi.initwindow(800, 600)
    surface(lambda x, y: x, (0, 1), (0, 1), n=60, ramp=name)
    drawn = np.unique(bgi.getimage(0, 0, 799, 599).array)
    colors = np.stack([drawn & 255, drawn >> 8 & 255, drawn >> 16 & 255], axis=1)[drawn >= 16]
    ramp = {tuple(color) for color in RAMPS[name].mix(160).tolist()}
    assert len(ramp & {tuple(color) for color in colors.tolist()}) > 0.85 * len(ramp)


def test_few_colors_are_mixed_unless_told_otherwise() -> None:
    for driver, mode in ((bgi.VGA, bgi.VGAHI), (bgi.CGA, bgi.CGAC0), (bgi.CGA, bgi.CGAHI)):
        pictures = []
        for options in ({}, {"dither": True}, {"dither": False}):
            bgi.initgraph(driver, mode)
            surface(lambda x, y: x + y, (0, 1), (0, 1), n=20, **options)
            pictures.append(bgi.getimage(0, 0, bgi.getmaxx(), bgi.getmaxy()).array)
        assert (pictures[0] == pictures[1]).all()
        assert (pictures[0] != pictures[2]).any()
