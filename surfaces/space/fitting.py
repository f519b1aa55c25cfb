"""The "proper scaling" of the paper's figures: how a surface fills the screen.

x may run over 20 units and z over one. So the surface is first put into a box of pleasing shape,
-1 to 1 along x and y, around (0, 0, 0); turned there, it keeps its shape. Then `fit` chooses how
many pixels a unit of that box gets.
"""

import numpy as np

from surfaces.arrays import Box, Doubles
from surfaces.space.mapping import Mapping, Projection
from surfaces.space.transforms import compose, scaling, translation

Room = tuple[float, float, float, float]
"""Pixels at the left, the top, the right and the bottom."""

# What stays free around the picture, as a part of the shorter side: 24 pixels of 480.
MARGIN = 0.05
FLAT = 1e-12
"""An arrow as short as this is a rounding error."""


def fit(
    box: Box,
    width: int,
    height: int,
    projection: Projection | None = None,
    *,
    zfrac: float | None = 0.3,
    aspect: float = 1.0,
    turning: bool = False,
    labels: Room = (0, 0, 0, 0),
) -> tuple[Doubles, Projection]:
    """Scale a box to fill a screen of width x height pixels, its centre in the middle.

    Args:
        box: The lowest and the highest corner, (3,) each.
        width: Pixels of the screen, across...
        height: ... and down.
        projection: How the box is seen. None: as the paper does.
        zfrac: The part of the screen's height that z takes, between 0 and 1. None: one scale for
            x, y and z.
        aspect: The width of a pixel divided by its height.
        turning: Whether the picture must stay on the screen however it is turned: it is smaller.
        labels: Room to leave free, besides the margin.

    Returns:
        A transform, 4x4, and a mapping. The transform puts the box around (0, 0, 0), with x and y
        from -1 to 1; turn the surface there, and its shape is kept. The mapping brings that to the
        screen.

    Raises:
        ValueError: if zfrac is outside its range, or nothing is left of the screen.
    """
    if zfrac is not None and not 0.0 < zfrac < 1.0:
        raise ValueError(f"zfrac must be between 0 and 1, not {zfrac!r}")
    view = (projection or Mapping()).placed((0.0, 0.0), 1.0)
    left, top, right, bottom = labels
    # From the centre of the first pixel to that of the last, in widths of a pixel.
    across, down = width - 1 - left - right, (height - 1 - top - bottom) / aspect
    margin = MARGIN * min(width, height)
    wide, high = across - 2 * margin, down - 2 * margin / aspect
    if wide <= 0 or high <= 0:
        raise ValueError(f"a screen of {width} x {height} pixels has no room for the picture")
    ex, ey, ez = np.abs(view.M32)
    lowest, highest = box
    extent = highest - lowest
    extent = np.where(extent == 0, 1.0, extent)  # a flat surface stays flat
    if zfrac is None:
        size = 2 * extent / extent.max()
        unit = np.inf
    else:
        base = 2 * (ex + ey)
        # Seen from straight above z has no height on the screen, and needs no part of it.
        level = high * (1 - zfrac) if ez[1] > FLAT else high
        unit = min(_ratio(wide, base[0]), _ratio(level, base[1]))
        size = np.array((2, 2, high * zfrac / unit))
    left_top, right_bottom = view.bounds(size)
    whole = right_bottom - left_top
    unit = min(unit, _ratio(wide, whole[0]), _ratio(high, whole[1]))
    if turning:
        # The ball around the box, as seen; a corner comes near the screen's edge only in passing.
        ball = view.ball(float(np.linalg.norm(size)))
        unit *= min(1.0, across / (unit * ball[0]), down / (unit * ball[1]))
    normal = compose(
        translation(*-(lowest / 2 + highest / 2)),
        scaling(*size / extent),
    )
    # Near by, the middle of the box is not the middle of its picture; turned, it is best there.
    aside = np.zeros(2) if turning else (left_top + right_bottom) / 2 * unit * (1, aspect)
    x, y = (left + (width - 1 - right)) / 2 - aside[0], (top + (height - 1 - bottom)) / 2 - aside[1]
    return normal, view.placed((float(x), float(y)), unit, aspect)


def _ratio(space: float, size: float) -> float:
    """How often the size goes into the space; infinitely often if there is no size."""
    return float(space / size) if size > 1e-12 * space else np.inf
