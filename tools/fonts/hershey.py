"""Seven faces from the Hershey fonts, placed in Borland's boxes.

The letters come from the package `Hershey-Fonts` (PyPI, MIT licence), which holds the fonts of
Dr. A. V. Hershey in the form of the Usenet Font Consortium. There y grows downward and letters
stand on 9.

Borland's widths show how its fonts were made from the same drawings: a letter's ink begins at 0,
and the width is the ink and the face's own space on the right. Letters are placed so; signs and
digits are centred in their boxes, and squeezed if they are too wide.
"""

import importlib
from typing import Any, NamedTuple

from tools.fonts.cp437 import Face
from tools.fonts.metrics import METRICS, WIDTHS
from tools.fonts.strokes import Glyph, box, drawing, heavier, mapped, shifted, tidy

_BASELINE = 9
_DRAWN_FACES: dict[str, dict[str, Glyph]] = {}


class Source(NamedTuple):
    """Which face, which characters from another one, the Greek face, and the weight of signs."""

    face: str
    others: dict[str, str]
    greek: str
    weight: int


SOURCES = {
    "TRIP": Source("rowmant", {}, "greekc", 2),
    "SANS": Source("futuram", {"{}": "rowmans"}, "greekc", 2),
    "GOTH": Source("gothgbt", {}, "greekc", 3),
    "SCRI": Source("scripts", {}, "greeks", 1),
    "SIMP": Source("futural", {".,:;": "rowmans"}, "greeks", 1),
    "TSCR": Source("timesib", {}, "greekc", 2),
    "LCOM": Source("timesr", {".,:;": "greekc"}, "greekc", 1),
}
_LIGHT = "futural"
_GREEK = {
    **{224: "a", 226: "C", 227: "p", 228: "R", 229: "r", 230: "l", 231: "s", 232: "U", 233: "H"},
    **{234: "X", 235: "d", 237: "u", 238: "e"},
}
_SIGNS = {236: "_", 239: "g"}  # infinity and intersection, in the face of mathematics
_MARKS = ".,:;!'\"`?"
# The script f and j reach back under the letter before them; Borland's boxes begin at their tails,
# so what joins them to that letter is missing.
_LEAD_INS = {ord("f"): drawing("0,5 2,4 3,4 5,5"), ord("j"): drawing("0,5 3,4 5,4 8,5")}
_CARET = drawing("0,14 5,21 10,14")
_GRAVE = drawing("0,21 4,16")


def face(name: str) -> Face:
    """The face for one of Borland's fonts, codes 32..126."""
    source, widths = SOURCES[name], WIDTHS[name]
    drawn = dict(_drawn(source.face))
    for characters, other in source.others.items():
        drawn |= {character: _drawn(other)[character] for character in characters}
    drawn["^"] = heavier(_CARET, source.weight)
    drawn["`"] = heavier(_GRAVE, source.weight)
    glyphs = {code: _placed(chr(code), drawn[chr(code)], width) for code, width in widths.items()}
    if name == "SCRI":
        glyphs |= {code: glyphs[code] + lead_in for code, lead_in in _LEAD_INS.items()}
    found = Face(METRICS[name], dict(widths), glyphs, source.weight)
    found.light = {ord(character): glyph for character, glyph in _drawn(_LIGHT).items()}
    for code, letter in _GREEK.items():
        glyph = _drawn(source.greek)[letter]
        found.add(code, shifted(glyph, -box(glyph)[0]))
    for code, letter in _SIGNS.items():
        glyph = _drawn("mathupp")[letter]
        found.add(code, heavier(shifted(glyph, -box(glyph)[0]), source.weight))
    return found


def _placed(character: str, glyph: Glyph, width: int) -> Glyph:
    left, _, right, _ = box(glyph)
    ink = right - left
    if character.isalpha():
        # Only the script p reaches back under the letter before it.
        return shifted(glyph, width - right if character == "p" and ink > width else -left)
    room = max(1, width - 2)
    if ink > room:
        glyph = tidy(mapped(glyph, lambda x, y: ((x - left) * room / ink, y)))
        left, ink = box(glyph)[0], room
    space = (width - ink) // 2
    return shifted(glyph, (min(space, 2) if character in _MARKS else space) - left)


def _drawn(name: str) -> dict[str, Glyph]:
    """A face of the package by character, y upward from the baseline; fetched once."""
    if name not in _DRAWN_FACES:
        package: Any = importlib.import_module("HersheyFonts")
        fonts = package.HersheyFonts()
        fonts.load_default_font(name)
        _DRAWN_FACES[name] = {
            character: tidy([[(x, _BASELINE - y) for x, y in path] for path in glyph.strokes])
            for character, glyph in fonts.all_glyphs.items()
        }
    return _DRAWN_FACES[name]
