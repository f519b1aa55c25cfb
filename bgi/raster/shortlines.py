"""Short lines in a pattern, thick or for XOR: kept as offsets by where they lead."""

import numpy as np

from bgi.raster import lines
from bgi.raster.kept import Kept
from bgi.raster.lines import Trace
from bgi.raster.offsets import Offsets, figure, reach
from bgi.raster.patterns import dashes

LONGEST = 32
"""Steps in x and y that a short line may have."""


def _short_line(
    dx: int, dy: int, bits: int, thick: bool, xor: bool, trace: Trace, width: int
) -> Offsets:
    """A line from 0, 0 in a style, on pages of one width."""
    x1 = y1 = np.zeros(1, np.int64)
    line = x1, y1, x1 + dx, y1 + dy
    x, y, step = lines.trace_strands(trace, line) if thick else trace(line)[:3]
    drawn = dashes(bits).drawn[step]
    return figure(x[drawn], y[drawn], reach(x, y), width, xor)


SHORT_LINES = Kept(_short_line, 1 << 21)
