"""Points and curves beside a surface, hidden where they lie behind it.

The z-buffer of the surface tells for every pixel how near it is; what is added later is compared
with that. So it makes no difference how the surface was drawn.
"""

import numpy as np

from surfaces.arrays import Doubles
from surfaces.space.transforms import apply
from surfaces.systems.pen import WHITE
from surfaces.systems.trace import rounded
from surfaces.visible.painter import Picture

STEP = 2.0
"""Pixels of a curve that are seen, or hidden, together."""
CORNERS = np.array(((-1, -1), (1, -1), (1, 1), (-1, 1)))


def points(picture: Picture, places: Doubles, color: int | None, size: int) -> None:
    """Mark points (n, 3) with squares that reach `size` pixels from their middles."""
    seen = places[np.isfinite(places).all(axis=1)]
    seen = seen[picture.depths.shows(seen)]
    middles = apply(seen, picture.view.screen)[:, np.newaxis, :2]
    pen = picture.easel.pen
    ink = pen.ink(WHITE) if color is None else color
    pen.polygons(rounded(middles + size * CORNERS), ink, ink)


def curve(picture: Picture, places: Doubles, color: int | None) -> None:
    """Draw lines from point to point, (n, 3), piece by piece."""
    pen, screen = picture.easel.pen, picture.view.screen
    ink = pen.ink(WHITE) if color is None else color
    ends = apply(places, screen)[:, :2]
    lengths = np.hypot(*np.diff(ends, axis=0).T)
    for start, stop, length in zip(places[:-1], places[1:], lengths, strict=True):
        if np.isfinite(length):
            count = int(min(np.ceil(length / STEP), pen.width + pen.height)) or 1
            nodes = start + np.linspace(0, 1, count + 1)[:, None] * (stop - start)
            shown = picture.depths.shows((nodes[:-1] + nodes[1:]) / 2)
            on_screen = apply(nodes, screen)[:, :2]
            pen.lines(on_screen[:-1][shown], on_screen[1:][shown], ink)
