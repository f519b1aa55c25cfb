"""Flood filling: the 4-connected area around a point, as rows.

This is span filling (A. R. Smith, "Tint Fill", SIGGRAPH 1979): whole runs of a row are filled, and
from each of them the rows above and below are searched. The driver goes on wherever it sees a pixel
that is not border and does not look filled already: what looks filled stops it. (It does not look
at the first and the last column of the viewport: `Page.flood` sees to that.) The original keeps its
seeds on a short stack and loses what does not fit; here nothing is lost, whatever the shape, and
every run is visited once.
"""

from bgi.raster.polygons import Rows


def flood(inside: bytearray, unfilled: bytearray, width: int, x: int, y: int) -> Rows:
    """The rows to fill from x, y: runs of `inside`, entered through pixels `unfilled` as well.

    Both hold a byte for each pixel of an area of that width, 1 for yes and 0 for no.
    """
    waiting = [_run(inside, width, y * width + x)]
    found = set(waiting)
    while waiting:
        start, end = waiting.pop()
        for step in (-width, width):
            place, stop = start + step, end + step
            if (place, stop) in found or not 0 <= place < len(inside):
                continue
            while (place := unfilled.find(1, place, stop)) >= 0:
                if not inside[place]:
                    place = inside.find(1, place, stop)
                    if place < 0:
                        break
                    continue
                run = _run(inside, width, place)
                if run not in found:
                    found.add(run)
                    waiting.append(run)
                place = run[1]
    runs = sorted(found)
    rows = [start // width for start, _ in runs]
    return (
        rows,
        [start % width for start, _ in runs],
        [(end - 1) % width for _, end in runs],
    )


def _run(inside: bytearray, width: int, place: int) -> tuple[int, int]:
    """The run of inside pixels around a place: its start, and where it ends (excluded)."""
    row = place // width * width
    start = inside.rfind(0, row, place) + 1 or row
    end = inside.find(0, place, row + width)
    return start, end if end >= 0 else row + width
