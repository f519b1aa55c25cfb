"""Make the ten stroked fonts that ship with the library, `bgi/fonts/data/*.CHR`.

    pip install Hershey-Fonts==2.1.0 shapely
    python -m tools.fonts.make [folder]

Nothing here comes from a Borland file but the numbers in `metrics.py`: seven fonts are Hershey
faces, EURO, BOLD and LITT were drawn for this project.
"""

import sys
from pathlib import Path as File

from bgi.fonts.chr import Operation, StrokedFont, encode
from bgi.fonts.table import STANDARD
from tools.fonts import bold, euro, hershey, litt
from tools.fonts.cp437 import ACCENTS, SMALL_ACCENTS, Face, complete
from tools.fonts.metrics import METRICS, WIDTHS
from tools.fonts.strokes import operations, scaled
from tools.fonts.symbols import SIGNS

DATA = File(__file__).parents[2] / "bgi" / "fonts" / "data"
_HERSHEY = "From the Hershey Fonts (A. V. Hershey, US NBS; J. Hurt)"
_BOLD_RADIUS = 6  # the broad pen rounds a corner's outside by itself
_OWN = "Drawn for bgi, a graphics.h for Python"


def litt_face() -> Face:
    """The small font."""
    face = Face(METRICS["LITT"], dict(WIDTHS["LITT"]), litt.letters(), accents=SMALL_ACCENTS)
    for code, glyph in litt.symbols().items():
        face.add(code, glyph)
    return face


def euro_face() -> Face:
    """The tall, thin font."""
    face = Face(METRICS["EURO"], dict(WIDTHS["EURO"]), euro.letters())
    for code, glyph in euro.ligatures().items():
        face.add(code, glyph)
    return face


def bold_face() -> Face:
    """The outlined font."""
    widths = WIDTHS["BOLD"]
    thin = euro_face()
    face = Face(METRICS["BOLD"], dict(widths), bold.letters(euro.letters(_BOLD_RADIUS), widths))
    for code, glyph in euro.ligatures(_BOLD_RADIUS).items():
        face.add(code, bold.broad(glyph))
    for code, glyph in SIGNS.items():
        face.add(code, bold.fine(scaled(glyph, thin.across, thin.up)))
    face.accents = {mark: bold.fine(scaled(glyph, 2, 2)) for mark, glyph in ACCENTS.items()}
    face.light = thin.glyphs
    return face


_DRAWN = {"LITT": litt_face, "EURO": euro_face, "BOLD": bold_face}


def build(name: str) -> StrokedFont:
    """One of the ten fonts, complete."""
    face = _DRAWN[name]() if name in _DRAWN else hershey.face(name)
    complete(face)
    metrics = face.metrics
    codes = range(metrics.first, metrics.first + metrics.characters)
    return StrokedFont(
        name=name,
        first=metrics.first,
        cap=metrics.cap,
        dec=metrics.dec,
        widths=tuple(face.widths[code] for code in codes),
        # A character without strokes would not move the pen: a blank is one movement of it.
        strokes=tuple(
            operations(face.glyphs[code]) or (Operation(False, face.widths[code], 0),)
            for code in codes
        ),
    )


def made(name: str) -> bytes:
    """The bytes of a font's file."""
    return encode(build(name), _OWN if name in _DRAWN else _HERSHEY)


def main() -> None:
    """Write the ten files."""
    folder = File(sys.argv[1]) if len(sys.argv) > 1 else DATA
    for name in STANDARD:
        (folder / f"{name}.CHR").write_bytes(made(name))


if __name__ == "__main__":
    main()
