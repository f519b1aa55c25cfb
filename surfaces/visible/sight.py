"""Whether single points of surfaces are seen, surface by surface, holes and all.

The horizon knows what hides a point when the surface has no holes and is alone. Otherwise this
asks, for each point, every strip in its column (see `visible.sweep`): one that covers it and is
nearer hides it. That costs one look at every line for every point; for lines on a surface, whose
points are few, it is quick enough.
"""

from collections.abc import Sequence

import numpy as np

from surfaces.arrays import Bools, Doubles
from surfaces.visible.sweep import BLOCK, Sweep


def seen(sweeps: Sequence[Sweep], points: Doubles) -> Bools:
    """Which points (m, 3) of the surfaces no strip hides; a strip of its own cell never does."""
    found = np.ones(len(points), dtype=bool)
    for sweep in sweeps:
        if not sweep.edge_on:
            step = max(1, BLOCK // sweep.shape[0])
            for start in range(0, len(points), step):
                part = slice(start, start + step)
                found[part] &= ~sweep.hides(points[part])
    return found
