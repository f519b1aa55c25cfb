"""The upper half of code page 437, composed from a font's own letters.

Accented letters are a letter and an accent; fractions and superscripts are small digits; the rest
are signs, Greek letters and box drawing. A face holds what is needed for that.
"""

from dataclasses import dataclass, field

from tools.fonts.boxes import Cell, boxes
from tools.fonts.metrics import Metrics
from tools.fonts.strokes import Glyph, box, drawing, heavier, scaled, shifted, tidy, turned
from tools.fonts.symbols import CONTROL_PICTURES, HEIGHT, SIGNS, WIDTH

ACCENTS = {
    "'": drawing("0,0 3,5"),
    "`": drawing("3,0 0,5"),
    "^": drawing("0,0 4,4 8,0"),
    '"': drawing("0,1 0,3; 6,1 6,3"),
    "o": drawing("3,0 1,1 0,3 1,5 3,6 5,5 6,3 5,1 3,0"),
    "~": drawing("0,0 1,2 3,3 7,1 9,2 10,4"),
    ",": drawing("2,0 2,-2 4,-3 4,-5 2,-6 0,-6"),
}
SMALL_ACCENTS = {
    "'": drawing("0,0 1,1"),
    "`": drawing("1,0 0,1"),
    "^": drawing("0,0 1,1 2,0"),
    '"': drawing("0,0 0,0; 2,0 2,0"),
    "o": drawing("1,0 0,1 1,2 2,1 1,0"),
    "~": drawing("0,0 1,1 2,0 3,1"),
    ",": drawing("1,0 1,-1 0,-2"),
}
"""For letters only six points high."""

# A code, its letter and the accent.
_ACCENTED = """
128C, 129u" 130e' 131a^ 132a" 133a` 134ao 135c, 136e^ 137e" 138e` 139i" 140i^ 141i` 142A" 143Ao
144E' 147o^ 148o" 149o` 150u^ 151u` 152y" 153O" 154U" 160a' 161i' 162o' 163u' 164n~ 165N~
"""


@dataclass
class Face:
    """Letters of a font on their way to a file: glyphs and advance widths by code.

    `weight` is how many strokes make a line of its signs; `dotless` replaces i under accents.
    """

    metrics: Metrics
    widths: dict[int, int]
    glyphs: dict[int, Glyph]
    weight: int = 1
    accents: dict[str, Glyph] = field(default_factory=dict)  # its own, if not the common ones
    light: dict[int, Glyph] = field(default_factory=dict)  # thin letters for fractions

    @property
    def across(self) -> float:
        """How much wider than the signs' box its letters are."""
        return (self.widths[ord("0")] * 0.7) / WIDTH

    @property
    def up(self) -> float:
        """How much higher than the signs' box its capitals are."""
        return self.metrics.capital / HEIGHT

    def add(self, code: int, glyph: Glyph, width: int | None = None) -> None:
        """Give a code its glyph; by default as wide as its ink and the space after an H."""
        self.glyphs[code] = tidy(glyph)
        self.widths[code] = box(glyph)[2] + self.gap if width is None else width

    def offer(self, code: int, glyph: Glyph, width: int | None = None) -> None:
        """Give a code its glyph unless it has one already."""
        if code not in self.glyphs:
            self.add(code, glyph, width)

    @property
    def gap(self) -> int:
        """The space after an H."""
        return self.widths[ord("H")] - box(self.glyphs[ord("H")])[2]


def complete(face: Face) -> None:
    """Add codes 127..255, and 1..31 if the font begins there."""
    for word in _ACCENTED.split():
        _accented(face, int(word[:3]), ord(word[3]), word[4])
    _composed(face)
    _small(face)
    for code, sign in SIGNS.items():
        face.offer(code, _fitted(face, sign))
    _boxes(face)
    if face.metrics.first < 32:
        for code, sign in CONTROL_PICTURES.items():
            face.offer(code, _fitted(face, sign))
    for code in range(face.metrics.first, face.metrics.first + face.metrics.characters):
        face.glyphs.setdefault(code, [])
        face.widths.setdefault(code, face.widths[ord(" ")])


def _fitted(face: Face, sign: Glyph) -> Glyph:
    return heavier(scaled(sign, face.across, face.up), face.weight)


def _accented(face: Face, code: int, letter: int, mark: str) -> None:
    glyph = face.glyphs[letter]
    if letter == ord("i"):  # without its dot
        glyph = [path for path in glyph if min(y for _, y in path) <= face.metrics.small]
    common = heavier(scaled(ACCENTS[mark], face.up, face.up), face.weight)
    accent = face.accents.get(mark, common)
    left, bottom, right, top = box(accent)
    _, lowest, _, highest = box(glyph)
    if mark == ",":
        y = lowest - top
    else:
        space = 3 if highest <= face.metrics.small + 1 else 2
        y = highest - bottom + max(2, round(space * face.up))
    x = _middle(glyph, low=mark == ",") - (left + right + 1) // 2
    glyph = glyph + shifted(accent, x, y)
    # An accent broader than its letter needs room of its own.
    start, _, end, _ = box(glyph)
    room = end - min(0, start) + face.gap // 2 + 1
    face.offer(code, shifted(glyph, -min(0, start)), max(face.widths[letter], room))


def _middle(glyph: Glyph, low: bool) -> int:
    """The middle of a letter's lower or upper third: slanting letters lean."""
    _, bottom, _, top = box(glyph)
    third = (top - bottom) / 3
    points = [point for path in glyph for point in path]
    near = [x for x, y in points if (y <= bottom + third if low else y >= top - third)]
    return (min(near) + max(near)) // 2


def _composed(face: Face) -> None:
    glyphs, up = face.glyphs, face.up
    for code, pair, apart in ((145, "ae", 0), (146, "AE", 0), (158, "Pt", face.gap // 2)):
        first, second = (glyphs[ord(letter)] for letter in pair)
        start = box(first)[2] - box(second)[0] + apart
        face.offer(code, first + shifted(second, start))
    left, bottom, right, top = box(glyphs[ord("c")])
    beyond, middle = max(1, round(3 * up)), (left + right) // 2
    bar = [[(middle, bottom - beyond), (middle, top + beyond)]]
    face.offer(155, glyphs[ord("c")] + heavier(bar, face.weight), face.widths[ord("c")])
    left, _, right, top = box(glyphs[ord("Y")])
    rungs = [[(left + right // 6, y), (right - right // 6, y)] for y in (top // 2, top // 3 - 1)]
    face.offer(157, glyphs[ord("Y")] + rungs, face.widths[ord("Y")])
    for code, mark in ((168, "?"), (173, "!")):
        glyph = turned(glyphs[ord(mark)])
        hung = face.metrics.small - box(glyph)[3]
        face.offer(code, shifted(glyph, 0, hung), face.widths[ord(mark)])


def _small(face: Face) -> None:
    """Superscripts and fractions, in thin strokes: heavy ones would run together."""
    letters = face.light or face.glyphs
    capital = face.metrics.capital

    def small(letter: str, size: float) -> Glyph:
        glyph = scaled(letters[ord(letter)], size, size)
        return shifted(glyph, -box(glyph)[0])

    def raised(letter: str, size: float) -> Glyph:
        glyph = small(letter, size)
        return shifted(glyph, 0, capital - box(glyph)[3])

    for code, letter in ((166, "a"), (167, "o")):
        glyph = raised(letter, 0.7)
        _, bottom, right, _ = box(glyph)
        line = bottom - max(2, round(3 * face.up))
        face.offer(code, [*glyph, [(0, line), (right, line)]])
    face.offer(252, raised("n", 0.7))
    face.offer(253, raised("2", 0.5))
    one = raised("1", 0.5)
    foot = box(one)[2] + max(1, round(face.up))
    top = foot + round(9 * face.across)
    for code, digit in ((171, "2"), (172, "4")):
        below = shifted(small(digit, 0.5), top - round(2 * face.across))
        face.offer(code, [*one, [(foot, 0), (top, capital)], *below])


def _boxes(face: Face) -> None:
    metrics = face.metrics
    width = face.widths[ord("0")]
    gap = max(1, round(2 * face.up))
    for code, glyph in boxes(Cell(width, metrics.dec, metrics.cap, gap)).items():
        face.offer(code, glyph, width)
    middle, hook = width // 2, max(1, round(3 * face.up))
    top, bottom = metrics.cap, metrics.dec
    # The integral sign is two characters high: its halves meet where lines of text meet.
    upper = [(middle, bottom), (middle, top - hook), (middle + hook, top), (middle + 2 * hook, top)]
    upper.append((middle + 3 * hook, top - hook))
    lower = [(2 * middle - x, top + bottom - y) for x, y in upper]
    face.offer(244, [upper], width)
    face.offer(245, [lower], width)
