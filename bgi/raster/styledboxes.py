"""Outlines of boxes in a pattern or for XOR: kept as offsets by their size, once met again."""

import numpy as np

from bgi.raster.kept import Kept
from bgi.raster.lines import Trace
from bgi.raster.offsets import Offsets, figure, reach
from bgi.raster.patterns import dashes


def _styled_box(dx: int, dy: int, bits: int, xor: bool, trace: Trace, width: int) -> Offsets:
    """A box between 0, 0 and dx, dy, on pages of one width: each side begins the pattern anew."""
    x = np.array([0, dx, dx, 0, 0])
    y = np.array([0, 0, dy, dy, 0])
    x, y, step, _ = trace((x[:-1], y[:-1], x[1:], y[1:]))
    drawn = dashes(bits).drawn[step]
    return figure(x[drawn], y[drawn], reach(x, y), width, xor)


STYLED_BOXES = Kept(_styled_box, 1 << 21)
