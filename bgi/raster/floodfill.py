"""Flood filling: the 4-connected area around a point, as rows.

From each run of the area the driver looks at the rows above and below, and goes on wherever it sees
a pixel that is not border and does not look filled already: what looks filled stops it. The
original keeps its seeds on a short stack and loses what does not fit; here nothing is lost,
whatever the shape, and every run is visited once.
"""

import numpy as np
from numpy.typing import NDArray

from bgi.raster.polygons import Rows


def flood(inside: NDArray[np.bool_], unfilled: NDArray[np.bool_], x: int, y: int) -> Rows:
    """The rows to fill from x, y: runs of `inside`, reached through pixels `unfilled` as well."""
    width = inside.shape[1]
    area, open_area = inside.tobytes(), (inside & unfilled).tobytes()
    start = area.rfind(b"\0", y * width, y * width + x) + 1 or y * width
    end = area.find(b"\0", y * width + x, (y + 1) * width)
    waiting = [(start, end if end >= 0 else (y + 1) * width)]
    found = set(waiting)
    while waiting:
        start, end = waiting.pop()
        base = start // width * width
        for neighbour in (base - width, base + width):
            if not 0 <= neighbour < len(area):
                continue
            place = start - base + neighbour
            stop = end - base + neighbour
            while (place := open_area.find(b"\1", place, stop)) >= 0:
                first = area.rfind(b"\0", neighbour, place) + 1 or neighbour
                last = area.find(b"\0", place, neighbour + width)
                run = first, last if last >= 0 else neighbour + width
                if run not in found:
                    found.add(run)
                    waiting.append(run)
                place = run[1]
    runs = sorted(found)
    rows = [start // width for start, _ in runs]
    return (
        rows,
        [start - row * width for (start, _), row in zip(runs, rows, strict=True)],
        [end - 1 - row * width for (_, end), row in zip(runs, rows, strict=True)],
    )
