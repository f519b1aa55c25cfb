"""BOLD: the outlines that a broad pen leaves when it follows the skeleton of EURO.

The union of the pen's traces comes from `shapely`. The pen is broader than high; it is finer for
signs whose parts lie close together.
"""

import math
from itertools import pairwise
from typing import NamedTuple

from shapely import LinearRing, LineString, Polygon, box, unary_union  # type: ignore[import-untyped]
from shapely.affinity import scale  # type: ignore[import-untyped]
from shapely.geometry.base import BaseGeometry  # type: ignore[import-untyped]

from tools.fonts.euro import rounded_drawing
from tools.fonts.strokes import Glyph, Path, rounded, shifted
from tools.fonts.strokes import box as ink_box

Real = tuple[float, float]
Curve = list[Real]


class Pen(NamedTuple):
    """A pen's width and height."""

    width: int
    height: int


_SPACE = 5  # to the right of a letter's ink
_EURO_LINES = (-10, 0, 30, 42)
_LINES = (-7, 0, 30, 40)  # what these heights are in BOLD, measured at the outer edge
_BROAD = Pen(9, 6)
_FINE = Pen(4, 4)
_NARROWER = 0.6  # the letters' part of their breadth in EURO, on the whole
_NARROW = "0123456789,.;:!`"  # their boxes have room for more than
_WIDEST = 0.75  # of their breadth in EURO
_PENS = {
    **dict.fromkeys("gy", Pen(9, 5)),  # their two lower bars must not touch
    **dict.fromkeys("#%@*\"'`", _FINE),
    **dict.fromkeys("+<=>-_^~/\\&$()[]{}|,;", Pen(6, 5)),
}
_FOR_A_BROAD_PEN = {
    ord("A"): rounded_drawing("0,0 15,42 30,0; 11,14 19,14", 0),
    ord("Q"): rounded_drawing("0,0r 0,42r 30,42r 30,0r z; 16,15 30,0", 6),
}
_MITRE_LIMIT = 4.0


def letters(skeleton: dict[int, Glyph], widths: dict[int, int]) -> dict[int, Glyph]:
    """The outlines of codes 33..126, each as wide as its advance leaves room for."""
    found = {}
    for code, glyph in (skeleton | _FOR_A_BROAD_PEN).items():
        pen = _PENS.get(chr(code), _BROAD)
        inside = max(0, widths[code] - min(_SPACE, pen.width) - pen.width)
        if chr(code) in _NARROW:
            inside = min(inside, round(_breadth(glyph) * _WIDEST))
        letter = outlined(glyph, pen, inside)
        excess = _breadth(letter) - inside - pen.width
        if excess > 0:  # slanting lines, cut off level, reach out
            letter = outlined(glyph, pen, inside - excess)
        spare = widths[code] - _SPACE - inside - pen.width if chr(code).isdigit() else 0
        found[code] = shifted(letter, spare // 2 - ink_box(letter)[0])
    return found


def _breadth(glyph: Glyph) -> int:
    left, _, right, _ = ink_box(glyph)
    return right - left


def broad(glyph: Glyph) -> Glyph:
    """The outlines of one more letter, as much narrower than EURO's as the others are."""
    return outlined(glyph, _BROAD, round(_breadth(glyph) * _NARROWER))


def fine(glyph: Glyph) -> Glyph:
    """The outlines of an accent or a sign as it is."""
    return outlined(glyph, _FINE, _breadth(glyph))


def outlined(glyph: Glyph, pen: Pen, inside: int) -> Glyph:
    """The outlines of a glyph in EURO's units, its pen's centre moving over `inside` units."""
    left = ink_box(glyph)[0]
    across = inside / (_breadth(glyph) or 1)
    traces = []
    for path in glyph:
        curve = [(pen.width / 2 + (x - left) * across, _height(y, pen)) for x, y in path]
        at_line = path[0][1] in _EURO_LINES, path[-1][1] in _EURO_LINES
        traces.append(_trace(curve, at_line, pen))
    return _rings(unary_union(traces))


def _height(y: int, pen: Pen) -> float:
    """Where the pen's centre goes for a height in EURO: its edge must reach BOLD's line."""
    half = pen.height / 2
    centres = [_LINES[0] + half, _LINES[1] + half, _LINES[2] - half, _LINES[3] - half]
    if y <= _EURO_LINES[0]:
        return centres[0] + y - _EURO_LINES[0]
    for (a, b), (c, d) in zip(pairwise(_EURO_LINES), pairwise(centres), strict=True):
        if y <= b:
            return c + (y - a) * (d - c) / (b - a)
    return centres[-1] + y - _EURO_LINES[-1]


def _trace(curve: Curve, at_line: tuple[bool, bool], pen: Pen) -> BaseGeometry:
    """What the pen covers on a path, no higher and lower than half a pen beyond the path."""
    bottom = min(y for _, y in curve) - pen.height / 2
    top = max(y for _, y in curve) + pen.height / 2
    shape = LineString
    if len(curve) > 2 and curve[0] == curve[-1]:
        shape = LinearRing
    else:
        curve[0] = _end(curve[0], curve[1], at_line[0], pen)
        curve[-1] = _end(curve[-1], curve[-2], at_line[1], pen)
    # A pen as high as it is broad, on a stretched path; its end is square.
    stretch = pen.width / pen.height
    line = shape([(x, y * stretch) for x, y in curve])
    area = line.buffer(
        pen.width / 2, cap_style="square", join_style="mitre", mitre_limit=_MITRE_LIMIT
    )
    return scale(area, 1, 1 / stretch, origin=(0, 0)).intersection(box(-64, bottom, 64, top))


def _end(end: Real, other: Real, at_line: bool, pen: Pen) -> Real:
    """Where a slanting line must end: far out, to be cut off level at its height, or short.

    Elsewhere than at a line the pen's square end would stick out of what the line runs into.
    """
    if end[0] == other[0] or end[1] == other[1]:
        return end
    more = pen.width if at_line else -pen.width / 2
    part = more / math.dist(end, other)
    return end[0] + (end[0] - other[0]) * part, end[1] + (end[1] - other[1]) * part


def _rings(area: BaseGeometry) -> Glyph:
    """The outlines of an area, in an order that does not depend on how it was computed."""
    polygons = [part for part in getattr(area, "geoms", [area]) if isinstance(part, Polygon)]
    rings = [ring for part in polygons for ring in (part.exterior, *part.interiors)]
    paths = [_normal([(_whole(x), _whole(y)) for x, y in ring.coords]) for ring in rings]
    return sorted(path for path in paths if len(path) > 3)


def _whole(number: float) -> int:
    """Rounded so that the last bits of the computation do not matter."""
    return rounded(round(number, 6))


def _normal(ring: Path) -> Path:
    """A closed path begun at its first point and turned one way, without needless points."""
    points = [b for a, b in pairwise(ring) if a != b]
    points = [
        b
        for a, b, c in zip(points[-1:] + points[:-1], points, points[1:] + points[:1], strict=True)
        if (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])
    ]
    if not points:
        return []
    start = points.index(min(points))
    points = points[start:] + points[:start]
    if points[1] > points[-1]:
        points[1:] = points[:0:-1]
    return points + points[:1]
