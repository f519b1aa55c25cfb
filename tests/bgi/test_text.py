"""Text in the built-in font and in stroked ones, and the fonts that cannot be had."""

import pytest

import bgi
from bgi.fonts import read
from tests.pictures import points


def test_text_is_cut_by_whole_characters(vga):
    vga.setviewport(10, 10, 29, 17, 1)
    vga.outtextxy(-3, 0, "AAA")
    drawn = points(vga)
    assert {x for x, _ in drawn} <= set(range(15, 23))
    assert drawn
    vga.cleardevice()
    vga.outtextxy(0, 1, "A")
    vga.outtextxy(-11, 0, "AAA")  # one that begins left of the screen is left out as a whole
    assert not points(vga)
    vga.settextstyle(0, 1, 1)
    vga.outtextxy(8, -4, "AAA")
    assert not points(vga)
    vga.settextjustify(0, 0)
    vga.outtextxy(8, 12, "AAA")  # of which the second has room
    assert {y for _, y in points(vga)} <= set(range(10, 18))
    vga.setviewport(10, 10, 29, 17, 0)
    vga.outtextxy(8, 12, "AAA")
    assert max(y for _, y in points(vga)) == 21


def test_text_is_code_page_437(new_screen):
    one, other = new_screen(), new_screen()
    one.outtextxy(0, 0, "Ä☺é⌂→€")
    other.outtextxy(0, 0, bytes([142, 1, 130, 127, 26]) + b"?")
    assert (one.page.array == other.page.array).all()


def test_text_measures(vga):
    assert (vga.textwidth("Hello"), vga.textwidth(b""), vga.textheight("Hello")) == (40, 0, 8)
    for wrong in (42, None, ["a"], 1.5):
        for call in (vga.textwidth, vga.textheight, vga.outtext):
            with pytest.raises(TypeError, match="str or bytes"):
                call(wrong)


def test_bitmap_text_sizes_and_justification():
    bgi.initgraph()
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 0)
    assert bgi.textwidth("abc") == 24
    for size, height in {11: 88, 99: 24, 32: 8, -1: 248}.items():
        bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, size)
        assert bgi.textheight("abc") == height
        assert bgi.gettextsettings().charsize == size
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 2)
    bgi.settextjustify(bgi.RIGHT_TEXT, bgi.BOTTOM_TEXT)
    bgi.outtextxy(100, 100, "\xdb")  # a full block: '█' in code page 437 is 219
    bgi.outtextxy(100, 100, b"\xdb")
    assert (bgi.getpixel(84, 84), bgi.getpixel(99, 99), bgi.getpixel(100, 100)) == (15, 15, 0)


def test_stroked_text():
    bgi.initgraph()
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 5)
    assert (bgi.textwidth("Hello, World"), bgi.textheight("x")) == (260, 41)
    bgi.moveto(10, 10)
    bgi.outtext("Hello, World")
    assert (bgi.getx(), bgi.gety()) == (270, 10)
    bgi.setusercharsize(2, 1, 1, 1)
    assert bgi.gettextsettings().charsize == bgi.USER_CHAR_SIZE
    assert (bgi.textwidth("Hello, World"), bgi.textheight("x")) == (390, 31)
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    assert bgi.textwidth("Hello, World") == 195
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, bgi.USER_CHAR_SIZE)
    assert bgi.textwidth("Hello, World") == 390
    for bad in [(1, 0, 1, 1), (1, 1, 1, 0), (40000, 1, 1, 1)]:
        bgi.setusercharsize(*bad)
        assert bgi.graphresult() == bgi.grError
    bgi.settextjustify(3, 0)
    assert bgi.graphresult() == bgi.grError


def test_registering_fonts():
    assert bgi.registerbgifont(bgi.gothic_font) == bgi.GOTHIC_FONT
    assert bgi.registerfarbgifont(bgi.triplex_font) == bgi.TRIPLEX_FONT
    assert bgi.registerbgifont(b"no font") == bgi.graphresult() == bgi.grInvalidFont
    with pytest.raises(TypeError):
        bgi.registerbgifont(7)


def test_fonts_that_cannot_be_had(tmp_path):
    bgi.initgraph(bgi.VGA, bgi.VGAHI, str(tmp_path))
    number = bgi.installuserfont("MINE")
    assert number == 11
    for font, code, text in [
        (number, bgi.grFontNotFound, "Font file not found (MINE.CHR)"),
        (99, bgi.grInvalidFontNum, "Invalid font number"),
    ]:
        bgi.settextstyle(font, bgi.HORIZ_DIR, 2)
        assert bgi.grapherrormsg(bgi.graphresult()) == text, code
        assert bgi.gettextsettings().font == bgi.DEFAULT_FONT
        assert bgi.textwidth("ab") == 32
    (tmp_path / "mine.chr").write_bytes(b"PK\x08\x08 rubbish")
    bgi.settextstyle(number, 0, 4)
    assert bgi.graphresult() == bgi.grInvalidFont
    assert bgi.grapherrormsg(bgi.grInvalidFont) == "Invalid font file (MINE.CHR)"


def test_a_font_in_use_is_not_looked_for_again(tmp_path):
    bgi.initgraph(bgi.VGA, bgi.VGAHI, str(tmp_path))
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    width = bgi.textwidth("Wide")
    small = read("LITT.CHR")
    (tmp_path / "TRIP.CHR").write_bytes(small)
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    assert bgi.textwidth("Wide") == width
    bgi.settextstyle(bgi.DEFAULT_FONT, bgi.HORIZ_DIR, 4)
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    assert bgi.textwidth("Wide") < width


def test_a_font_that_is_registered_takes_the_place_of_the_one_in_use():
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    width = bgi.textwidth("Wide")
    small = read("LITT.CHR")
    assert bgi.registerbgifont(small.replace(b"LITT", b"TRIP", 1)) == bgi.TRIPLEX_FONT
    bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
    assert bgi.textwidth("Wide") < width
