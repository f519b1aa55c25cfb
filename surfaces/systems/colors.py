"""Colours for values: ramps, and what a screen with few colours makes of them.

A ramp leads from the colour of the least value to that of the greatest; the best known goes from
blue over cyan, green and yellow to red. A mode of 256 colours has room for two smooth ones: entries
16 to 175 are loaded with that of the upper side, 176 to 255 with that of the under side, and the
sixteen everyday colours stay as they are. A mode of 16 has some of these colours ready made: the
values fall into bands, or, dithered, between two bands the pixels take the two colours in turn, in
a pattern of four by four that makes seventeen mixtures (Bayer's ordered dithering). A mode of 4
gives three bands. With 2 colours bands alternate between light and dark, as on a map; dithered,
they make greys.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfaces.arrays import Bools, Ints
from surfaces.systems.pen import (
    BLUE,
    BROWN,
    CYAN,
    DARKGRAY,
    GREEN,
    LIGHTBLUE,
    LIGHTCYAN,
    LIGHTGRAY,
    LIGHTGREEN,
    LIGHTMAGENTA,
    LIGHTRED,
    MAGENTA,
    RED,
    WHITE,
    YELLOW,
    Pen,
)

# Palette entries of the upper and of the under side where there are 256.
UPPER, UNDER = np.arange(16, 176), np.arange(176, 256)

# Bayer's thresholds (1973) for the pixels of a 4x4 square, as parts of a band.
BAYER = (np.array(((0, 8, 2, 10), (12, 4, 14, 6), (3, 11, 1, 9), (15, 7, 13, 5))) + 0.5) / 16


def _within(given: Any, dimensions: int, most: int) -> bool:
    """Whether these are numbers from 0 to `most`, in a table of one dimension or two."""
    try:
        table = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):  # no numbers, or rows of different lengths
        return False
    inside = (table >= 0) & (table <= most)
    return table.ndim == dimensions and table.size > 0 and bool(inside.all())


@dataclass(frozen=True)
class Ramp:
    """Colours from the least value to the greatest."""

    rgb: tuple[tuple[int, int, int], ...]
    """Colours at even steps, in red, green and blue, 0 to 255; between them the ramp is mixed."""
    sixteen: tuple[int, ...]
    """The colours of graphics.h that come near it."""

    def __post_init__(self) -> None:
        if not _within(self.rgb, 2, 255) or np.shape(self.rgb)[1] != 3:
            raise ValueError(f"rgb must be colours of three numbers 0 to 255, not {self.rgb!r:.60}")
        if not _within(self.sixteen, 1, 15):
            raise ValueError(f"sixteen must be colours 0 to 15, not {self.sixteen!r:.60}")

    def mix(self, n: int) -> Ints:
        """n colours from one end to the other, (n, 3)."""
        at, corners = np.linspace(0, len(self.rgb) - 1, n), np.arange(len(self.rgb))
        channels = [np.interp(at, corners, channel) for channel in np.array(self.rgb).T]
        mixed: Ints = np.rint(np.stack(channels, axis=1)).astype(np.int64)
        return mixed


RAMPS: dict[str, Ramp] = {
    "rainbow": Ramp(
        ((0, 0, 255), (0, 255, 255), (0, 255, 0), (255, 255, 0), (255, 0, 0)),
        (BLUE, LIGHTBLUE, CYAN, LIGHTCYAN, LIGHTGREEN, YELLOW, LIGHTRED, RED),
    ),
    "heat": Ramp(
        ((24, 0, 60), (120, 10, 100), (220, 50, 40), (255, 160, 20), (255, 255, 190)),
        (BLUE, MAGENTA, RED, LIGHTRED, YELLOW, WHITE),
    ),
    "earth": Ramp(
        ((12, 40, 130), (60, 150, 200), (50, 130, 60), (200, 190, 90), (140, 90, 50), (250,) * 3),
        (BLUE, LIGHTBLUE, GREEN, LIGHTGREEN, BROWN, LIGHTGRAY, WHITE),
    ),
    "ice": Ramp(
        ((10, 20, 90), (30, 110, 200), (120, 220, 240), (255, 255, 255)),
        (BLUE, LIGHTBLUE, LIGHTCYAN, WHITE),
    ),
    "copper": Ramp(
        ((30, 12, 6), (150, 80, 40), (245, 170, 105), (255, 235, 210)),
        (DARKGRAY, BROWN, YELLOW, WHITE),
    ),
    # Even to the eye: its lightness grows in equal steps, for the colour-blind and in grey, too.
    # After matplotlib's default (van der Walt and Smith, 2015).
    "viridis": Ramp(
        ((68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37)),
        (MAGENTA, BLUE, CYAN, GREEN, LIGHTGREEN, YELLOW),
    ),
    "grey": Ramp(((30, 30, 30), (250, 250, 250)), (DARKGRAY, LIGHTGRAY, WHITE)),
    # Unlike the rainbow's colours, for the under side.
    "dusk": Ramp(((60, 20, 80), (150, 50, 150), (230, 140, 210)), (MAGENTA, LIGHTMAGENTA)),
}

FEW: dict[int, Ints] = {2: np.array((1, 0, 1, 0, 1, 0, 1)), 4: np.arange(1, 4)}
"""Bands where the colours are too few for ramps."""
GREYS = np.arange(2)
"""The two colours that dithering mixes."""


@dataclass(frozen=True)
class Palette:
    """How values become palette entries on a screen."""

    colors: int
    """How many the screen has: 2, 4, 16 or 256."""
    ramp: Ramp
    """Those of the upper side..."""
    under: Ramp
    """... and of the under side."""
    dither: bool
    """Whether to mix neighbouring bands, where there are fewer than 256."""

    def load(self, pen: Pen) -> None:
        """Load the ramps into the palette, where there is room for them."""
        if self.colors == 256:
            pen.palette(UPPER, self.ramp.mix(len(UPPER)))
            pen.palette(UNDER, self.under.mix(len(UNDER)))

    def entries(self, under: bool = False) -> Ints:
        """The palette entries from the least value to the greatest."""
        if self.colors == 256:
            return UNDER if under else UPPER
        if self.colors == 16:
            return np.array((self.under if under else self.ramp).sixteen)
        return GREYS if self.dither and self.colors == 2 else FEW[self.colors]

    def shade(
        self, value: NDArray[np.floating], x: Ints, y: Ints, under: bool | Bools = False
    ) -> Ints:
        """The palette entry of values, 0 to 1, at pixels x, y; all of one shape."""
        if isinstance(under, np.ndarray):
            return np.where(under, self.shade(value, x, y, True), self.shade(value, x, y))
        entries = self.entries(under)
        if self.dither and self.colors < 256:
            band = value * (len(entries) - 1) + BAYER[y & 3, x & 3]
        else:
            band = value * len(entries)
        shades: Ints = entries.take(np.clip(band, 0, len(entries) - 1).astype(np.int64))
        return shades

    def bands(self, value: NDArray[np.floating], under: bool | Bools = False) -> Ints:
        """The palette entry of values without a pixel: never dithered."""
        nowhere = np.zeros(value.shape, dtype=np.int64)
        return replace(self, dither=False).shade(value, nowhere, nowhere, under)


def palette(colors: int, ramp: str | Ramp, under: str | Ramp, dither: bool) -> Palette:
    """A palette from names of ramps or ramps; ValueError for an unknown name."""
    return Palette(colors, _named("ramp", ramp), _named("under", under), dither)


def _named(what: str, ramp: str | Ramp) -> Ramp:
    if isinstance(ramp, Ramp):
        return ramp
    if not isinstance(ramp, str) or ramp not in RAMPS:
        raise ValueError(f"{what} must be one of {', '.join(RAMPS)}, not {ramp!r}")
    return RAMPS[ramp]
