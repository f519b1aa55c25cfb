"""Stroked fonts: how a text becomes lines, and the ten fonts that ship."""

from dataclasses import astuple

import numpy as np
import pytest

from bgi.fonts import read, rom
from bgi.fonts.chr import encode, parse
from bgi.fonts.layout import SIZES, Scale, anchor, strokes, textheight, textwidth
from bgi.fonts.table import STANDARD, FontTable
from tests.stroked import font_of, segments
from tools.fonts.rom import table

HELLO = b"Hello, World"
FONTS = {name: FontTable().load(number) for number, name in enumerate(STANDARD, start=1)}
named = pytest.mark.parametrize("name", STANDARD)


# The layout (pictures of texts are among the cases of test_original)


def test_strokes_by_hand():
    font = font_of([(False, 0, 0), (True, 3, -2)], [(False, 1, 1), (True, 1, 1)], widths=[5, 7])
    assert segments(font, b"AB", SIZES[4]).tolist() == [[0, 0, 3, 2], [6, -1, 6, -1]]
    assert segments(font, b"AB", SIZES[4], True).tolist() == [[0, 0, 2, -3], [-1, -6, -1, -6]]
    assert segments(font, b"AzB", SIZES[10]).tolist() == [[0, 0, 12, 8], [24, -4, 24, -4]]


def test_a_character_without_strokes_does_not_move_the_pen():
    font = font_of([(False, 0, 0), (True, 3, 0)], [], [(False, 5, 0)])
    assert segments(font, b"ABA", SIZES[4]).tolist() == [[0, 0, 3, 0], [5, 0, 8, 0]]
    assert segments(font, b"ACA", SIZES[4]).tolist() == [[0, 0, 3, 0], [10, 0, 13, 0]]
    assert textwidth(font, b"ABA", SIZES[4]) == 15


def test_a_character_begins_with_the_pen_lifted():
    font = font_of([(True, 2, 2), (True, 4, 4)])
    assert segments(font, b"A", SIZES[4]).tolist() == [[2, -2, 4, -4]]


def test_coordinates_are_truncated_toward_zero():
    font = font_of([(False, -1, -1), (True, 3, 4)])
    assert segments(font, b"A", SIZES[1]).tolist() == [[0, 0, 1, -2]]
    assert segments(font, b"A", Scale(-1, 2, 3, -2)).tolist() == [[0, -1, -1, 6]]


def test_strokes_are_kept_and_cannot_be_spoilt():
    font = font_of([(False, 0, 0), (True, 1, 1)])
    kept = strokes(font, 65, SIZES[4], False)
    assert strokes(font, 65, SIZES[4], False) is kept
    with pytest.raises(ValueError, match="read-only"):
        kept[0, 0] = 9


def test_no_text():
    assert segments(FONTS["TRIP"], b"", SIZES[4]).shape == (0, 4)
    assert textwidth(FONTS["TRIP"], b"", SIZES[4]) == 0


# W = 10, H = 9 at size 4
@pytest.mark.parametrize("horiz, across, up", [(0, 0, 9), (1, -4, 6), (2, -10, 0)])
@pytest.mark.parametrize("vert, down, along", [(2, 9, 10), (1, 4, 5), (0, 0, 0)])
def test_anchors(horiz, across, up, vert, down, along):
    font = font_of([], widths=[10])
    assert anchor(font, b"A", SIZES[4], False, horiz, vert) == (across, down)
    assert anchor(font, b"A", SIZES[4], True, horiz, vert) == (up, along)


# The check values of Borland's fonts

WIDTHS = {  # raw, and at sizes 1, 5 and 10
    "TRIP": (195, 117, 260, 780),
    "LITT": (69, 41, 92, 276),
    "SANS": (188, 112, 250, 752),
    "GOTH": (179, 107, 238, 716),
    "SCRI": (183, 109, 244, 732),
    "SIMP": (158, 94, 210, 632),
    "TSCR": (198, 118, 264, 792),
    "LCOM": (224, 134, 298, 896),
    "EURO": (296, 177, 394, 1184),
    "BOLD": (322, 193, 429, 1288),
}
ADVANCES = {"TRIP": 113, "LITT": 36, "SANS": 107, "GOTH": 102, "SCRI": 103}
METRICS = {  # characters, the first; the text's top and bottom; height of E and x, depth of q
    "TRIP": (223, 32, 24, -7, 21, 14, -7),
    "LITT": (223, 32, 7, -2, 6, 4, -2),
    "SANS": (254, 1, 25, -7, 21, 14, -7),
    "GOTH": (223, 32, 25, -7, 21, 14, -7),
    "SCRI": (223, 32, 25, -12, 21, 9, -12),
    "SIMP": (223, 32, 28, -7, 21, 14, -7),
    "TSCR": (223, 32, 24, -7, 21, 14, -7),
    "LCOM": (223, 32, 28, -7, 21, 14, -7),
    "EURO": (223, 32, 45, -10, 42, 30, -10),
    "BOLD": (224, 32, 53, -7, 40, 30, -7),
}
HEIGHTS = {
    "TRIP": [18, 20, 23, 31, 41, 51, 62, 77, 93, 124],
    "LITT": [5, 6, 6, 9, 12, 15, 18, 22, 27, 36],
    "SANS": [19, 21, 24, 32, 42, 53, 64, 80, 96, 128],
    "GOTH": [19, 21, 24, 32, 42, 53, 64, 80, 96, 128],
    "SCRI": [22, 24, 27, 37, 49, 61, 74, 92, 111, 148],
    "SIMP": [21, 23, 26, 35, 46, 58, 70, 87, 105, 140],
    "TSCR": [18, 20, 23, 31, 41, 51, 62, 77, 93, 124],
    "LCOM": [21, 23, 26, 35, 46, 58, 70, 87, 105, 140],
    "EURO": [33, 36, 41, 55, 73, 91, 110, 137, 165, 220],
    "BOLD": [36, 40, 45, 60, 80, 100, 120, 150, 180, 240],
}


@named
def test_textwidth(name):
    found = [textwidth(FONTS[name], HELLO, SIZES[size]) for size in (4, 1, 5, 10)]
    assert tuple(found) == WIDTHS[name]


@pytest.mark.parametrize("name", ADVANCES)
def test_drawn_text_is_narrower_than_its_width(name):
    """The pen advances by truncated widths: found from where the next character begins."""
    begin = segments(FONTS[name], b"|", SIZES[1])
    both = segments(FONTS[name], HELLO + b"|", SIZES[1])
    assert both[-1, 0] - begin[-1, 0] == ADVANCES[name]


@named
def test_textheight(name):
    assert [textheight(FONTS[name], SIZES[size]) for size in range(1, 11)] == HEIGHTS[name]


@named
def test_metrics(name):
    font = FONTS[name]
    rows = [[y for _, _, y in font.operations(ord(letter))] for letter in "Exq"]
    letters = max(rows[0]), max(rows[1]), min(rows[2])
    assert (len(font.widths), font.first, font.cap, font.dec, *letters) == METRICS[name]
    assert min(rows[0]) == min(rows[1]) == 0
    assert font.name == name


@named
def test_every_shipped_character(name):
    font = FONTS[name]
    blank = {0, 32, 255}
    for code in range(font.first, font.first + len(font.widths)):
        assert font.every_width[code] > 0
        assert any(draw for draw, _, _ in font.operations(code)) == (code not in blank), code
        assert font.operations(code)
    assert font.every_width[0] == 0 and font.operations(0) == ()


@named
def test_shipped_boxes_join(name):
    """Lines of box characters reach from edge to edge, whatever the size."""
    font = FONTS[name]
    for size in SIZES.values():
        level = segments(font, b"\xc4\xc4", size)
        reach = sum(textwidth(font, b"\xc4", size) for _ in range(2))
        assert level[:, [0, 2]].min() == 0 and level[:, [0, 2]].max() == reach
        upright = segments(font, b"\xb3", size)
        assert np.ptp(upright[:, [1, 3]]) >= textheight(font, size) - 1


@named
def test_shipped_files_are_what_the_generator_makes(name):
    pytest.importorskip("HersheyFonts", reason="needs Hershey-Fonts")
    pytest.importorskip("shapely", reason="needs shapely")
    from tools.fonts.make import DATA, made

    assert made(name) == (DATA / f"{name}.CHR").read_bytes()


@pytest.mark.parametrize("height", rom.HEIGHTS)
def test_fonts_of_the_rom_are_read_from_tables_in_c(height):
    rows = read(f"rom8x{height}.bin")
    numbers = ", ".join(f"0x{row:02x}" for row in rows)
    text = f"static Bit8u vgafont{height}[256*{height}]=\n{{\n {numbers}\n}};\n"
    assert table(text, height) == rows
    with pytest.raises(ValueError, match=f"no table of 256 glyphs, {height} rows high"):
        table(text.replace("0x", "", 1), height)


@named
def test_round_trip(name):
    assert astuple(parse(encode(FONTS[name]))) == astuple(FONTS[name])
