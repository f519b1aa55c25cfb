"""Polygons: their paths, their edges, and the rows that fill them.

This is scan-line filling by the even-odd rule (Foley, van Dam, Feiner and Hughes, "Computer
Graphics: Principles and Practice", 1990, 3.6), with the kernel's choice of pixels.

A path that comes back to its first point ends there, and the next point starts another one: that is
how Borland's kernel puts several outlines into one polygon. An edge crosses the rows from its upper
end to the one above its lower end; x, y being the upper end, the crossing is at
`x + (row - y) * dx / dy`, the quotient truncated toward zero. The crossings of a row are sorted and
filled in pairs, both ends included.
"""

from collections.abc import Sequence
from itertools import pairwise

from bgi.raster.lines import Segment

Point = tuple[int, int]
Path = list[Point]
Rows = tuple[Sequence[int], Sequence[int], Sequence[int]]
"""y and both ends of rows to fill, the ends in any order."""
_Side = tuple[int, int, list[int]]
"""A side's rows, first and last (excluded), and where it crosses them."""


def paths(points: Sequence[Point]) -> list[Path]:
    """Split a polygon where a path returns to its first point; a single last point is dropped."""
    if len(points) > 2 and points[0] not in points[1:-1]:  # as most are
        return [list(points)]
    found: list[Path] = []
    path: Path = []
    for point in points:
        if not path or point != path[0]:
            path.append(point)
        elif len(path) > 1:
            path.append(point)
            found.append(path)
            path = []
    if len(path) > 1:
        found.append(path)
    return found


def edges(outline: Sequence[Path]) -> list[Segment]:
    """The lines of a polygon, path by path: what drawpoly() draws."""
    return [(*start, *end) for path in outline for start, end in pairwise(path)]


def scan(outline: Sequence[Path], top: int, bottom: int) -> Rows:
    """The rows from top to bottom that fill a closed polygon, given by its paths."""
    heights = [y for path in outline for _, y in path]
    top, bottom = max(top, min(heights, default=0)), min(bottom, max(heights, default=0) - 1)
    height = max(0, bottom + 1 - top)
    down, up = [0] * height, [0] * height
    found: list[_Side] = []
    rows_down = rows_up = 0
    for path in outline:
        for (x1, y1), (x2, y2) in pairwise(path):
            falling = y1 < y2
            if not falling:
                x1, y1, x2, y2 = x2, y2, x1, y1
            first = y1 if y1 > top else top
            last = y2 if y2 <= bottom else bottom + 1
            if first >= last:
                continue
            crossings = _walk(x1, x2 - x1, y2 - y1, first - y1, last - first)
            found.append((first, last, crossings))
            if falling:
                down[first - top : last - top] = crossings
                rows_down += last - first
            else:
                up[first - top : last - top] = crossings
                rows_up += last - first
    if len(outline) == 1 and rows_down == rows_up == height:
        return range(top, bottom + 1), down, up  # every row is crossed once down, once up
    return _paired(found)


def _walk(x: int, dx: int, dy: int, below: int, rows: int) -> list[int]:
    """Where a side that begins at x crosses `rows` rows, the first of them `below` rows down."""
    if dx == 0:
        return [x] * rows
    # Truncated toward zero: the floor where a side goes to the right, the ceiling to the left.
    start = x * dy + below * dx + (dy - 1 if dx < 0 else 0)
    return [numerator // dy for numerator in range(start, start + rows * dx, dx)]


def _paired(sides: list[_Side]) -> Rows:
    """Pair the crossings of each row, by the even-odd rule: from one end of a side to the next.

    Between them the same sides cross every row.
    """
    rows: list[int] = []
    left: list[int] = []
    right: list[int] = []
    for start, stop in pairwise(sorted({end for side in sides for end in side[:2]})):
        crossing: list[Sequence[int]] = [
            side[start - first : stop - first]
            for first, last, side in sides
            if first <= start and stop <= last
        ]
        if len(crossing) > 2:  # two make one pair in any order
            crossing = list(zip(*map(sorted, zip(*crossing, strict=True)), strict=True))
        for one, next_one in zip(crossing[::2], crossing[1::2], strict=False):
            rows += range(start, stop)
            left += one
            right += next_one
    return rows, left, right
