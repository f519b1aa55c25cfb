"""Around the surface: its box, axes with numbers, a title, a bar of colours.

What lies behind the surface is drawn before it, the far faces of the box; what lies before it, the
three edges at the corner next to the eye, is drawn after. A box seen from any side has an outline
of six edges, two along each axis: the axes are numbered there, where nothing is in the way.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

import numpy as np

from surfaces.arrays import Doubles
from surfaces.shape.rulers import PLAIN, Ruler, Rulers
from surfaces.shape.sampling import Interval
from surfaces.space.fitting import Room
from surfaces.space.transforms import apply
from surfaces.space.view import View
from surfaces.systems.colors import Palette
from surfaces.systems.pen import DARKGRAY, LIGHTGRAY, WHITE, Pen

Area = tuple[Doubles, Doubles]
"""The upper left and the lower right corner of something on the screen, (2,) each."""

EDGE_COLOR, GRID_COLOR, TEXT_COLOR = LIGHTGRAY, DARKGRAY, WHITE
# In characters: the length of a tick, the bar of colours, and the bar with its numbers.
TICK, BAR, BAR_AND_NUMBERS = 0.6, 1.75, 9
APART = 0.25
"""The least distance of small ticks, in characters."""


def room(pen: Pen, axes: bool, title: bool, colorbar: bool, rulers: Rulers) -> Room:
    """Pixels to leave free for writing, at the left, the top, the right and the bottom."""
    aside = max(ruler.aside for ruler in rulers)
    left, top, right, bottom = max(6, aside) * axes, 2 * title, aside * axes, 3 * axes
    right += BAR_AND_NUMBERS * colorbar
    character = pen.character
    return left * character, top * character, right * character, bottom * character


@dataclass(frozen=True)
class Frame:
    """The box around a surface, with its axes."""

    pen: Pen
    view: View
    low: Doubles
    """(3,): the lowest corner, in the surface's own x, y and z..."""
    high: Doubles
    """(3,): ... and the highest."""
    origin: Doubles
    """(3,): the point that the view counts from."""
    rulers: Rulers = PLAIN
    """Those of x, y and z."""

    @property
    def far(self) -> Doubles:
        """The corner farthest from the eye: for each axis the end that the eye is not at."""
        middle = 0 if self.view.parallel else (self.low + self.high) / 2 - self.origin
        return np.where(self.view.eye > middle, self.low, self.high)

    def _away(self, axis: int, end: float) -> bool:
        """Whether we see the face at one end of an axis from inside the box, or on its edge."""
        if self.view.parallel or end == self.far[axis]:
            return bool(end == self.far[axis])
        beyond = self.view.eye[axis] + self.origin[axis] - end
        return bool(beyond * (end - self.far[axis]) <= 0)  # near by, the eye may be between both

    def _edges(self, axis: int) -> list[tuple[Doubles, Doubles, int]]:
        """The four edges along an axis: both ends, (3,), and to how many far faces each belongs."""
        found = []
        others = [other for other in range(3) if other != axis]
        for ends in product((self.low, self.high), repeat=2):
            start = self.low.copy()
            for other, end in zip(others, ends, strict=True):
                start[other] = end[other]
            stop = start.copy()
            stop[axis] = self.high[axis]
            found.append((start, stop, sum(self._away(other, start[other]) for other in others)))
        return found

    def _lines(self, starts: list[Doubles], ends: list[Doubles], color: int) -> None:
        a, b = (self._on_screen(np.reshape(points, (-1, 3))) for points in (starts, ends))
        self.pen.lines(a, b, self.pen.ink(color))

    def back(self) -> None:
        """The nine edges of the far faces, to be drawn before the surface."""
        edges = [edge for axis in range(3) for edge in self._edges(axis) if edge[2]]
        self._lines([a for a, _, _ in edges], [b for _, b, _ in edges], EDGE_COLOR)

    def front(self) -> None:
        """The three edges at the corner next to the eye, to be drawn after it."""
        edges = [edge for axis in range(3) for edge in self._edges(axis) if not edge[2]]
        self._lines([a for a, _, _ in edges], [b for _, b, _ in edges], EDGE_COLOR)

    def walls(self) -> None:
        """A grid on the far faces, at the numbers of the axes."""
        starts, ends = [], []
        for axis in range(3):
            for value in self.rulers[axis].marks(self.low[axis], self.high[axis]).places:
                for other in range(3):
                    if other != axis:
                        start, stop = self.far.copy(), self.far.copy()
                        start[axis] = stop[axis] = value
                        start[other], stop[other] = self.low[other], self.high[other]
                        starts.append(start)
                        ends.append(stop)
        self._lines(starts, ends, GRID_COLOR)

    def axes(self, names: Sequence[str], taken: Sequence[Area] = ()) -> None:
        """Ticks, numbers and the three names, each axis at an edge of the outline.

        Nothing is written where it would touch what is `taken`, or one another.
        """
        taken = list(taken)
        for axis, name in enumerate(names):
            outline = [(start, stop) for start, stop, n in self._edges(axis) if n == 1]
            # Of the two, the lower one on the screen; for z the left one.
            side = 0 if axis == 2 else 1
            sign = 1 if axis == 2 else -1
            if outline:
                start, stop = min(outline, key=lambda edge: sign * self._middle(edge)[side])
                self._axis(axis, name, start, stop, taken)

    def _middle(self, points: tuple[Doubles, Doubles]) -> Doubles:
        return self._on_screen((points[0] + points[1]) / 2)

    def _on_screen(self, points: Sequence[Doubles] | Doubles) -> Doubles:
        """Where points (..., 3) appear, (..., 2)."""
        return apply(np.asarray(points) - self.origin, self.view.screen)[..., :2]

    def _axis(self, axis: int, name: str, start: Doubles, stop: Doubles, taken: list[Area]) -> None:
        """One axis, along an edge from start to stop; `taken` has been written on."""
        ends = self._on_screen((start, stop))
        along = ends[1] - ends[0]
        length, character = float(np.hypot(*along)), self.pen.character
        if length < 4 * character:
            return  # seen from its end: there is no room for numbers
        outward = np.array((-along[1], along[0])) / length
        if outward @ (ends.mean(axis=0) - self._middle((self.low, self.high))) < 0:
            outward = -outward
        texts, places, note = self._numbers(axis, (start, stop), ends, outward)
        written = [
            (area, text)
            for area, text in zip(places, texts, strict=True)
            if area and not any(_touch(area, other) for other in taken)  # where two axes meet
        ]
        taken += [area for area, _ in written]
        spots = list(self._beside(ends, outward, max(map(len, texts), default=0)))
        for text in (f"{name} ({note})".strip(), f"({note})") if note else (name,):
            place = self._free(spots, text, taken)
            if place:
                written.append((place, text))
                taken.append(place)
                break
        if place or not note:  # without their note numbers would be wrong
            for area, text in written:
                self._write(area, text)

    def _numbers(
        self, axis: int, edge: tuple[Doubles, Doubles], ends: Doubles, outward: Doubles
    ) -> tuple[list[str], list[Area | None], str]:
        """Draw the ticks of an axis; their numbers, where each belongs, and the note to them.

        There are so many that no two touch.
        """
        low, high = edge[0][axis], edge[1][axis]
        along, character = ends[1] - ends[0], self.pen.character
        length = float(np.hypot(*along))
        # A number needs six characters' room along a level axis, two along an upright one.
        apart = character * (6 * abs(along[0]) + 2.5 * abs(along[1])) / length
        most = max(1, min(5, int(length / apart)))
        for about, least in [*((about, 2) for about in range(most, 0, -1)), (1, 1)]:
            values, (texts, note), between = self.rulers[axis].marks(low, high, about, least)
            feet = self._along(edge, axis, values)
            tips = feet + TICK * character * outward
            places = [
                self._place(tip, outward, text) for tip, text in zip(tips, texts, strict=True)
            ]
            there = [place for place in places if place]
            if not any(_touch(one, next_) for one, next_ in pairwise(there)):
                break
        self.pen.lines(feet, tips, self.pen.ink(EDGE_COLOR))
        small = self._along(edge, axis, between)
        apart = np.hypot(*np.diff(self._along(edge, axis, sorted([*values, *between])), axis=0).T)
        if len(between) and apart.min() >= APART * character:
            self.pen.lines(small, small + TICK / 2 * character * outward, self.pen.ink(EDGE_COLOR))
        return texts, places, note

    def _along(self, edge: tuple[Doubles, Doubles], axis: int, places: Sequence[float]) -> Doubles:
        """Where places of an axis appear along an edge, (n, 2)."""
        low, high = edge[0][axis], edge[1][axis]
        parts = (np.array(places) - low) / ((high - low) or 1.0)
        return self._on_screen(edge[0] + parts[:, None] * (edge[1] - edge[0]))

    def _beside(
        self, ends: Doubles, outward: Doubles, widest: int
    ) -> Iterator[tuple[Doubles, Doubles]]:
        """Where the name of an axis may stand, the best first, and which way from there."""
        character = self.pen.character
        clear = character * (1.4 + abs(outward[0]) * widest + abs(outward[1]))
        for part in (1 / 2, 1 / 4, 3 / 4, 0, 1):
            yield ends[0] + part * (ends[1] - ends[0]) + clear * outward, outward
        onward = (ends[1] - ends[0]) / np.hypot(*(ends[1] - ends[0]))
        yield ends[1] + 1.4 * character * onward, onward
        yield ends[0] - 1.4 * character * onward, -onward

    def _free(
        self, spots: Iterable[tuple[Doubles, Doubles]], text: str, taken: list[Area]
    ) -> Area | None:
        """The area of a text at the first of some spots where it touches nothing.

        Better is one where the edge of the screen does not push it back over the axis.
        """
        free: list[tuple[bool, Area]] = []
        for at, away in spots:
            area = self._place(at, away, text)
            if area and not any(_touch(area, other) for other in taken):
                pushed = ((area[0] + area[1]) / 2 - at) @ away <= 0
                free.append((bool(pushed), area))
        return min(free, key=lambda one: one[0])[1] if free else None

    def _write(self, area: Area, text: str) -> None:
        (left, top), _ = area
        self.pen.text(left, top, text, self.pen.ink(TEXT_COLOR))

    def _place(self, at: Doubles, outward: Doubles, text: str) -> Area | None:
        """The area of a text a little outward from a point; None if that is off the screen."""
        character = self.pen.character
        screen = np.array((self.pen.width, self.pen.height))
        if ((at < -character) | (at > screen + character)).any():
            return None
        size = np.array((len(text), 1)) * character
        centre = at + outward * (0.4 * character + np.abs(outward) * size / 2)
        low = np.clip(centre - size / 2, 0, np.maximum(screen - size, 0))
        return low, low + size


def _touch(one: Area, other: Area) -> bool:
    """Whether two areas meet, or two texts in them would read as one."""
    gap = np.array((1.0, 0.25)) * (one[1] - one[0])[1]  # of a character
    return bool((one[0] < other[1] + gap).all() and (other[0] < one[1] + gap).all())


def write_title(pen: Pen, title: str) -> None:
    """A line of text in the middle of the top."""
    left = (pen.width - pen.character * len(title)) / 2
    pen.text(max(0.0, left), pen.character, title, pen.ink(TEXT_COLOR))


def area_of_bar(pen: Pen) -> Area:
    """What `draw_bar` takes of the screen, with its numbers and the note above them."""
    character = pen.character
    left = pen.width - character * (BAR_AND_NUMBERS - 1)  # a text stays one character away
    top, bottom = pen.height // 5 - 4 * character, pen.height - pen.height // 5 + character
    return np.array((left, top)), np.array((pen.width, bottom))


def draw_bar(pen: Pen, palette: Palette, limits: Interval, ruler: Ruler) -> None:
    """A bar at the right that shows what the colours stand for, the least value at its foot."""
    character = pen.character
    left = pen.width - character * BAR_AND_NUMBERS
    right = left + round(character * BAR)
    top, bottom = pen.height // 5, pen.height - pen.height // 5
    x, y = (a.ravel() for a in np.meshgrid(np.arange(left, right), np.arange(top, bottom)))
    shades = palette.shade((bottom - 0.5 - y) / (bottom - top), x, y)
    if pen.vector:
        rows = np.arange(top, bottom)
        strips = [((left, row), (right, row), (right, row + 1), (left, row + 1)) for row in rows]
        pen.polygons(np.array(strips, dtype=np.float64), shades[:: right - left], 0)
    else:
        pen.pixels(x, y, shades)
    corners = np.array(((left - 1, top - 1), (right, top - 1), (right, bottom), (left - 1, bottom)))
    around = corners.astype(np.float64)
    pen.lines(around, np.roll(around, -1, axis=0), pen.ink(EDGE_COLOR))
    low, high = limits
    values, (texts, note), _ = ruler.marks(low, high, about=7)
    for line, part_of_note in enumerate(reversed(note.split())):
        # Above the bar and its uppermost number, up to the edge of the screen.
        above = top - (2 + 1.25 * line) * character
        pen.text(
            pen.width - character * len(part_of_note), above, part_of_note, pen.ink(TEXT_COLOR)
        )
    tick = np.array((TICK * character, 0.0))
    for number, text in zip(values, texts, strict=True):
        part = (number - low) / ((high - low) or 1.0)
        at = np.array((right, bottom - 0.5 - part * (bottom - top)))
        pen.lines(at[None], (at + tick)[None], pen.ink(EDGE_COLOR))
        pen.text(right + 1.2 * character, at[1] - (character - 1) / 2, text, pen.ink(TEXT_COLOR))
