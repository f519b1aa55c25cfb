"""Glyphs as pen paths, and what can be done to them.

A path is a list of points, a glyph a list of paths; x grows to the right from the glyph's origin,
y upward from the baseline. A path of two equal points is a dot.
"""

from collections.abc import Callable
from itertools import pairwise

from bgi.fonts.chr import Operation

Point = tuple[int, int]
Path = list[Point]
Glyph = list[Path]


def rounded(number: float) -> int:
    """To the nearest integer, halves upward: the same rounding everywhere."""
    return int(number + 1024.5) - 1024


def mapped(glyph: Glyph, change: Callable[[int, int], tuple[float, float]]) -> Glyph:
    """Every point sent somewhere else."""
    moved = [[change(x, y) for x, y in path] for path in glyph]
    return [[(rounded(x), rounded(y)) for x, y in path] for path in moved]


def shifted(glyph: Glyph, dx: int, dy: int = 0) -> Glyph:
    """The glyph elsewhere."""
    return [[(x + dx, y + dy) for x, y in path] for path in glyph]


def scaled(glyph: Glyph, across: float, up: float) -> Glyph:
    """The glyph larger or smaller, points that fall together merged."""
    return tidy(mapped(glyph, lambda x, y: (x * across, y * up)))


def turned(glyph: Glyph) -> Glyph:
    """Upside down: turned by 180 degrees within its own box."""
    left, bottom, right, top = box(glyph)
    return [[(left + right - x, bottom + top - y) for x, y in path] for path in glyph]


def mirrored(glyph: Glyph) -> Glyph:
    """Left and right exchanged within its own box."""
    left, _, right, _ = box(glyph)
    return [[(left + right - x, y) for x, y in path] for path in glyph]


def tidy(glyph: Glyph) -> Glyph:
    """Without points that repeat the one before, and without paths drawn twice."""
    paths: Glyph = []
    for path in glyph:
        kept = path[:1] + [b for a, b in pairwise(path) if a != b]
        kept = kept if len(kept) > 1 else kept * 2
        if kept and kept not in paths and kept[::-1] not in paths:
            paths.append(kept)
    return paths


def box(glyph: Glyph) -> tuple[int, int, int, int]:
    """left, bottom, right, top of the ink; zeros for a blank."""
    points = [point for path in glyph for point in path] or [(0, 0)]
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def heavier(glyph: Glyph, passes: int) -> Glyph:
    """The glyph drawn several times side by side: how stroked fonts make bold lines."""
    return tidy([path for step in range(passes) for path in shifted(glyph, step)])


def drawing(text: str) -> Glyph:
    """Read a glyph written as `x,y x,y ...; x,y ...`: points, paths parted by semicolons."""
    return [
        [(int(x), int(y)) for x, y in (point.split(",") for point in path.split())]
        for path in text.split(";")
        if path.strip()
    ]


def operations(glyph: Glyph) -> tuple[Operation, ...]:
    """The glyph as movements of the pen."""
    return tuple(Operation(place > 0, x, y) for path in glyph for place, (x, y) in enumerate(path))
