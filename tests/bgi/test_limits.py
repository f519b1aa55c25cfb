"""What is too large or too strange is refused at once, by the name of its argument."""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import bgi
from bgi import dos, mouse
from bgi.errors import brief
from bgi.fonts import bitmap, codepage, layout
from bgi.fonts.chr import Operation
from bgi.fonts.layout import Scale
from bgi.fonts.lettering import Lettering, letter
from bgi.fonts.lettering import text as whole_text
from bgi.graphics import Graphics
from bgi.kernel.arguments import MAX_DIMENSIONS, MAX_NUMBERS
from bgi.kernel.modes import window
from bgi.kernel.state import KERNEL
from bgi.memory.card import MAX_SIDE
from bgi.memory.pixmap import Numbers
from bgi.raster import ellipses, slices
from bgi.raster.kept import Kept
from bgi.raster.lines import trace_many
from tests.stroked import font_of

BILLION = 10**9
MANY = [
    np.broadcast_to(np.int16(5), BILLION),  # which takes no memory
    np.broadcast_to(np.float32(5), (BILLION // 8, 1, 2)),
    range(BILLION),
    range(10**30),
    [range(BILLION)],
    [[1], range(BILLION)],
]
TOO_MANY = r"may hold 16,777,216 numbers at most in one call$"


@pytest.fixture(autouse=True)
def _on_vga() -> None:
    bgi.initgraph(bgi.VGA, bgi.VGAHI)


# How many numbers


@pytest.mark.parametrize("many", MANY, ids=brief)
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("x", lambda many: bgi.putpixel(many, 1, 1)),
        ("y", lambda many: bgi.getpixel(1, many)),
        ("color", lambda many: bgi.line(1, 1, 2, 2, many)),
        ("bottom", lambda many: bgi.bar(1, 1, 2, many)),
        ("radius", lambda many: bgi.circle(1, 1, many)),
        ("points", lambda many: bgi.drawpoly(many)),
        ("flat", lambda many: bgi.fillpoly(3, many)),
        ("fill", lambda many: bgi.fillpoly(np.zeros((1, 3, 2)), fill=many)),
        ("red", lambda many: bgi.setrgbpalette(1, many, 1, 1)),
    ],
)
def test_arrays_of_a_billion(name: str, call: Callable[[object], object], many: object) -> None:
    with pytest.raises(ValueError, match=rf"^{name} {TOO_MANY}"):
        call(many)


def test_arrays_that_are_a_billion_together() -> None:
    across, down = np.zeros((1, 40_000)), np.zeros((40_000, 1))
    with pytest.raises(ValueError, match=f"^x, y, color {TOO_MANY}"):
        bgi.putpixel(across, down, 1)


def test_as_many_as_the_largest_window_has_are_taken() -> None:
    assert MAX_NUMBERS == MAX_SIDE**2
    bgi.putpixel(np.broadcast_to(np.int64(5), MAX_NUMBERS), 7, bgi.RED)
    assert bgi.getpixel(5, 7) == bgi.RED


@pytest.mark.parametrize("pattern", [range(BILLION), bytes(9), [1] * 7, np.zeros(BILLION // 100)])
def test_a_pattern_of_another_length(pattern: object) -> None:
    before = bgi.getfillpattern(), bgi.getfillsettings()
    with pytest.raises(ValueError, match=r"^pattern must be 8 bytes, not \d+$"):
        bgi.setfillpattern(pattern, 1)
    assert (bgi.getfillpattern(), bgi.getfillsettings()) == before


@pytest.mark.parametrize("palette", [range(BILLION), [1] * 258, np.zeros(1000)])
def test_a_palette_of_too_many(palette: object) -> None:
    before = bgi.getpalette()
    with pytest.raises(ValueError, match=r"^palette may hold 256 colours at most$"):
        bgi.setallpalette(palette)
    assert bgi.getpalette() == before


# Dimensions and kinds


def test_dimensions() -> None:
    most = np.full((1,) * MAX_DIMENSIONS, 5)
    bgi.putpixel(most, 6, bgi.RED)
    assert bgi.getpixel(5, 6) == bgi.RED
    deeper: object = 5
    for _ in range(MAX_DIMENSIONS + 1):
        deeper = [deeper]
    with pytest.raises(ValueError, match=r"^y m"):  # how many a numpy can make at all differs
        bgi.putpixel(1, deeper, 1)


@pytest.mark.filterwarnings("error")
def test_half_precision() -> None:
    bgi.putpixel(np.array([3, 300], np.float16), np.float16(9.9), bgi.RED)
    assert [bgi.getpixel(x, 9) for x in (3, 300)] == [bgi.RED, bgi.RED]
    for value in ("nan", "inf", "-inf"):
        with pytest.raises(ValueError, match=r"^x must be a finite number"):
            bgi.putpixel(np.array([1, value], np.float16), 1, 1)
        with pytest.raises(ValueError, match=r"^x must be a finite number"):
            bgi.moveto(np.float16(value), 1)


# Wrong kinds of arguments are named


@pytest.mark.parametrize(
    "value", [72, None, "12345678", {}, 2.5, object(), np.array(5), iter("ab")]
)
def test_what_is_no_sequence(value: object) -> None:
    with pytest.raises(TypeError, match=r"^pattern must be a sequence of numbers, not "):
        bgi.setfillpattern(value, 1)
    with pytest.raises(TypeError, match=r"^palette must be a sequence of numbers, not "):
        bgi.setallpalette(value)


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("palette.size", lambda: bgi.setallpalette(bgi.palettetype("1", [1]))),
        ("palette", lambda: bgi.setallpalette(bgi.palettetype(1, None))),
        ("font", lambda: bgi.registerbgifont(3)),
        ("on", lambda: bgi.strict(np.zeros(2))),
        ("status", lambda: bgi.setmousequeuestatus(bgi.WM_MOUSEMOVE, "no")),
        ("handler", lambda: bgi.registermousehandler(bgi.WM_MOUSEMOVE, 5)),
        ("handler", lambda: mouse.on_event(1, "f")),
        ("detect", lambda: bgi.installuserdriver("MINE", 5)),
        ("points", lambda: bgi.drawpoly([1, 2], [1, 2])),
        ("flat", lambda: bgi.drawpoly(1, "1 2")),
    ],
)
def test_an_argument_of_the_wrong_kind(name: str, call: Callable[[], object]) -> None:
    with pytest.raises(TypeError, match=f"^{name} must "):
        call()


@pytest.mark.parametrize("name", ["width", "title", "dbflag", "closeflag"])
def test_a_window_that_is_refused_changes_nothing(name: str) -> None:
    bgi.putpixel(1, 1, bgi.RED)
    before = bgi.getcurrentwindow()
    with pytest.raises(TypeError, match=f"^{name} must be a "):
        bgi.initwindow(**{"width": 99, "height": 99} | {name: np.zeros(2)})
    assert (bgi.getcurrentwindow(), bgi.getmaxx(), bgi.getpixel(1, 1)) == (before, 639, bgi.RED)


def test_numbers_too_long_to_be_written() -> None:
    digits = sys.get_int_max_str_digits()
    for call in (dos.random, dos.bioskey, bgi.conio.ungetch, mouse.presses, bgi.ismouseclick):
        with pytest.raises(ValueError, match=r"must be .* not <a whole number of \d+ bits>$"):
            call(-(10 ** (digits + 1)))
    assert brief([10**5000]) == "[<a whole number of 16610 bits>]"
    assert len(brief("x" * 10**6)) == 60


# Colours of many polygons


@pytest.mark.parametrize("polygons", [1, 2])
def test_one_color_beyond_int64_for_many_polygons(polygons: int) -> None:
    triangle = [(10, 10), (60, 10), (30, 50)]
    bgi.initwindow(99, 99)
    bgi.fillpoly([triangle] * polygons, fill=bgi.COLOR(1, 2, 3), color=bgi.COLOR(4, 5, 6))
    assert bgi.getpixel(30, 20) == bgi.COLOR(1, 2, 3)
    assert bgi.getpixel(30, 10) == bgi.COLOR(4, 5, 6)
    bgi.setcolor(bgi.COLOR(7, 8, 9))
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.COLOR(9, 9, 9))
    bgi.fillpoly([triangle] * polygons)
    assert bgi.getpixel(30, 20) == bgi.COLOR(9, 9, 9)
    bgi.cleardevice()
    bgi.drawpoly([triangle] * polygons)
    assert bgi.getpixel(30, 10) == bgi.COLOR(7, 8, 9)


def test_a_color_of_more_bits_than_the_mode_has(vga: Graphics) -> None:
    vga.drawpoly([[(10, 10), (60, 10)]], color=1 << 70 | bgi.RED)
    assert vga.getpixel(30, 10) == bgi.RED


# Texts


def test_a_stroked_text_has_a_length() -> None:
    bgi.settextstyle(bgi.GOTHIC_FONT, 0, 4)
    text = "i" * (layout.MAX_CHARACTERS + 1)
    for call in (bgi.outtext, bgi.textwidth, lambda text: bgi.outtextxy(1, 1, text)):
        with pytest.raises(ValueError, match=r"^text may have 65,536 characters at most in a str"):
            call(text)
    assert bgi.getx() == 0
    assert bgi.textwidth(text[1:]) == layout.MAX_CHARACTERS * bgi.textwidth("i")


def test_the_built_in_font_has_none() -> None:
    text = "x" * 10**7
    assert bgi.textwidth(text) == 8 * 10**7
    bgi.outtextxy(0, 0, text)
    first, last = bgi.getimage(0, 0, 7, 7), bgi.getimage(632, 0, 639, 7)
    assert first.array.any() and (first.array == last.array).all()


@pytest.mark.parametrize(
    ("cache", "call"),
    [
        (codepage._remembered, lambda: bgi.textwidth("x" * 81)),
        (layout._known_width, lambda: bgi.textwidth("x" * 81)),
        (bitmap._remembered, lambda: bitmap.mask(b"x" * 80, 4, 4)),
    ],
)
def test_what_is_large_is_not_kept(cache: object, call: Callable[[], object]) -> None:
    bgi.settextstyle(bgi.GOTHIC_FONT, 0, 4)
    cache.cache_clear()  # type: ignore[attr-defined]
    call()
    assert cache.cache_info().currsize == 0  # type: ignore[attr-defined]


def fill_twice(radius: int) -> None:
    """What is filled once is not kept."""
    for _ in range(2):
        bgi.fillellipse(1, 1, 9, radius)


@pytest.mark.parametrize(
    ("table", "call"),
    [
        (ellipses.RINGS, lambda radius: bgi.arc(1, 1, 10, 80, radius)),
        (ellipses.CURVES, lambda radius: bgi.circle(1, 1, radius)),
        (slices.DISCS, lambda radius: bgi.fillellipse(1, 1, 9, radius)),
        (slices.PIECES, lambda radius: bgi.sector(1, 1, 30, 60, 9, radius)),
        (slices.REGIONS, fill_twice),
    ],
)
def test_what_is_kept_of_curves_is_bounded_by_its_bytes(
    table: Kept[Any], call: Callable[[int], None]
) -> None:
    for radius in range(6553, 0, -41):
        call(radius)
        assert 0 <= table.bytes <= 1 << 23
    assert table.bytes > 1 << 20
    assert len(table) < 160  # the first ones have gone


def test_letters_with_thousands_of_strokes_are_not_kept() -> None:
    strokes = [Operation(True, number % 64, number // 64) for number in range(layout.KEPT_STROKES)]
    for name, extra in ("KEEP", 0), ("DROP", 1):
        font = font_of([*strokes, *strokes[:extra]], name=name)
        layout._known_strokes.cache_clear()
        lines = layout.strokes(font, 65, layout.SIZES[4], False)
        assert len(lines) == len(strokes) + extra - 1
        assert layout._known_strokes.cache_info().currsize == (extra == 0)


@pytest.mark.parametrize(("length", "kept"), [(2047, True), (2048, False)])
def test_the_pixels_of_large_letters_are_not_kept(length: int, kept: bool) -> None:
    font = font_of([Operation(False, 0, 0), Operation(True, 1, 0)])
    way = Lettering(font, Scale(length, 1, 1, 1), False, False, trace_many, 640)
    assert (letter(way, 65).pixels is not None) == kept


@pytest.mark.parametrize(("letters", "kept"), [(4, True), (5, False), (81, False)])
def test_texts_that_come_again_are_kept_unless_they_are_large(letters: int, kept: bool) -> None:
    font = font_of([Operation(False, 0, 0), Operation(True, 1, 0)])
    way = Lettering(font, Scale(2047, 1, 1, 1), False, False, trace_many, 640)
    assert not whole_text(way, b"A" * letters, 0, 2)  # a new one
    assert bool(whole_text(way, b"A" * letters, 0, 2)) == kept


def test_a_text_of_large_letters_is_drawn() -> None:
    bgi.settextstyle(bgi.SANS_SERIF_FONT, 0, bgi.USER_CHAR_SIZE)
    bgi.setusercharsize(400, 1, 1, 1)
    bgi.outtextxy(-790, 0, "-" * 81)  # whose first stroke begins at 800
    line = [bgi.getpixel(x, bgi.textheight("-") - 9) for x in range(640)]
    assert line == [bgi.BLACK] * 10 + [bgi.WHITE] * 630


@pytest.mark.parametrize("number", range(1, 11))
def test_letters_of_the_fonts_that_come_along_are_kept(number: int) -> None:
    font = KERNEL.fonts.load(number, "")
    assert font is not None and 0 < font.longest <= layout.KEPT_STROKES


# Memory of others


def test_a_buffer_of_objects_is_left_alone() -> None:
    objects = np.array([object()] * 9)
    kept = objects.tolist()
    with pytest.raises(TypeError, match=r"^buffer must be bytes, not ndarray: "):
        bgi.getimage(0, 0, 0, 0, objects)
    assert objects.tolist() == kept


def test_an_image_of_a_billion_bytes_is_read_where_it_lies() -> None:
    block = np.broadcast_to(np.uint8(1), BILLION)  # 258 x 258 pixels, every eighth one WHITE
    bgi.putimage(0, 0, block, bgi.COPY_PUT)
    assert [bgi.getpixel(x, 257) for x in (6, 7, 8, 255)] == [0, bgi.WHITE, 0, bgi.WHITE]
    assert bgi.getpixel(7, 258) == 0


def test_an_image_holds_no_more_than_a_screen() -> None:
    for array in (np.broadcast_to(np.uint8(5), (10**5, 10**4)), [range(BILLION)]):
        with pytest.raises(ValueError, match=r"^array may hold 16,777,216 numbers at most"):
            bgi.Image(array)


def test_strict_mode_has_words_for_numbers_too_long_to_be_written() -> None:
    with bgi.strict(), pytest.raises(bgi.GraphicsError, match="no color <a whole number of 16610"):
        bgi.setcolor(10**5000)


@pytest.mark.parametrize("answer", ["3", None, float("nan")])
def test_the_answer_of_a_detecting_function_is_a_number(answer: object) -> None:
    bgi.installuserdriver("SVGA256", lambda: answer)  # type: ignore[return-value]
    with pytest.raises((TypeError, ValueError), match=r"^detect's answer must be a "):
        bgi.initgraph()
    assert bgi.getmaxx() == 639


def test_the_numbers_kept_for_pixels_are_bounded_in_a_window_of_all_colours() -> None:
    screen = Graphics(window(32, 32))
    for red in range(256):
        for green in range(3):
            screen.setcolor(bgi.COLOR(red, green, 1))
            screen.circle(16, 16, 5)
            assert screen.getpixel(21, 16) == bgi.COLOR(red, green, 1)
    assert 0 < len(screen.page.numbers) <= Numbers.MOST
