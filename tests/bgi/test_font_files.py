"""Font files: their format, whatever may be wrong with them, and the table that finds them."""

import os
from dataclasses import astuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bgi.constants import grError, grFontNotFound, grInvalidFont, grInvalidFontNum, grIOerror
from bgi.fonts.chr import MAX_BYTES, FontError, Operation, StrokedFont, encode, parse
from bgi.fonts.layout import SIZES
from bgi.fonts.table import STANDARD, FontTable
from tests.cases import FONTS
from tests.stroked import font_of, segments

# The format

numbers = st.integers(-64, 63)
glyphs = st.lists(st.builds(Operation, st.booleans(), numbers, numbers), max_size=20).map(tuple)


@st.composite
def fonts(draw):
    """Any font that a file can hold."""
    first = draw(st.integers(0, 255))
    strokes = draw(st.lists(glyphs, min_size=1, max_size=min(30, 256 - first)))
    widths = draw(st.lists(st.integers(0, 255), min_size=len(strokes), max_size=len(strokes)))
    cap = draw(st.integers(-127, 127))
    dec = draw(st.integers(-128, cap - 1))
    name = draw(st.text("ABCXYZ789", max_size=4))
    return StrokedFont(name, first, cap, dec, tuple(widths), tuple(strokes))


@settings(deadline=None)
@given(font=fonts(), notice=st.text("abc ", max_size=40))
def test_round_trip(font, notice):
    assert astuple(parse(encode(font, notice))) == astuple(font)


def test_the_layout_of_a_file():
    data = encode(font_of([(False, 1, -1), (True, -64, 63)], widths=[9]), "Hello")
    assert data.startswith(b"PK\x08\x08BGI Stroked Font V1.1\r\nHello\r\n\x1a")
    assert data[0x80:] == bytes.fromhex(
        "2b 0100 00 41 1300 00 07 00 fe 0000000000 0000 09 817f c0bf 0000"
    )


@pytest.mark.parametrize(
    "wrong",
    [
        font_of([(True, 64, 0)]),
        font_of([(True, 0, -65)]),
        font_of([], widths=[256]),
        font_of([], widths=[1, 2]),
        font_of([], name="LONGER"),
        font_of([(True, 0, 0)] * MAX_BYTES),
    ],
    ids=["x", "y", "width", "widths", "name", "size"],
)
def test_what_does_not_fit_is_not_written(wrong):
    with pytest.raises(ValueError):
        encode(wrong)


GOOD = encode(font_of([(False, 0, 0), (True, 4, 4)], [(False, 1, 1), (True, 2, 0)]), "A test")
BLOCK = 0x80


def changed(place, *values):
    data = bytearray(GOOD)
    data[place : place + len(values)] = bytes(values)
    return bytes(data)


MALFORMED = {
    "empty": (b"", "does not begin"),
    "another file": (b"GIF89a" + bytes(200), "does not begin"),
    "no header": (b"PK\x08\x08" + b"A" * 300, "no header"),
    "short header": (GOOD[: GOOD.index(b"\x1a") + 9], "ends inside its header"),
    "header in itself": (changed(GOOD.index(b"\x1a") + 1, 4, 0), "before its header"),
    "header beyond": (changed(GOOD.index(b"\x1a") + 1, 0, 255), "ends before"),
    "cut": (GOOD[:-1], "ends before"),
    "bitmaps": (changed(BLOCK, ord("-")), "does not hold strokes"),
    "no characters": (changed(BLOCK + 1, 0, 0), "claims 0"),
    "too many": (changed(BLOCK + 1, 200, 0), "claims 200 characters from code 65"),
    "far too many": (changed(BLOCK + 1, 255, 255), "claims 65535"),
    "no height": (changed(BLOCK + 8, 0xFE), "no height"),
    "strokes in tables": (changed(BLOCK + 5, 16, 0), "strokes outside"),
    "strokes beyond": (changed(BLOCK + 5, 0, 9), "strokes outside"),
    "offset beyond": (changed(BLOCK + 16, 0, 9), "inside a character"),
    "no end": (GOOD[:-2] + b"\x80\x80", "inside a character"),
    "huge": (GOOD + bytes(MAX_BYTES), "longer than"),
}


@pytest.mark.parametrize("data, fault", MALFORMED.values(), ids=MALFORMED)
def test_malformed(data, fault):
    with pytest.raises(FontError, match=fault) as caught:
        parse(data)
    assert caught.value.code == grInvalidFont


def test_the_scan_operation_does_nothing():
    assert parse(changed(len(GOOD) - 6, 0x01, 0x81)).strokes[1] == (Operation(True, 2, 0),)


def test_one_long_tail_shared_by_all_is_refused():
    """255 characters, each beginning two bytes behind the last: millions of strokes."""
    count, length = 255, 30000
    block = bytearray(
        b"+" + count.to_bytes(2, "little") + b"\0\0" + (16 + 3 * count).to_bytes(2, "little")
    )
    block += bytes([0, 7, 0, 0xFE]) + bytes(5)
    block += b"".join((2 * n).to_bytes(2, "little") for n in range(count)) + bytes(count)
    block += b"\x81\x81" * length + b"\0\0"
    header = b"PK\x08\x08\x1a\x80\0TEST" + len(block).to_bytes(2, "little") + bytes(4)
    with pytest.raises(FontError, match="more than"):
        parse(header.ljust(0x80, b"\0") + block)


def only_fonts_or_errors(data):
    try:
        font = parse(data)
    except FontError as error:
        assert str(error).startswith("The font file ") and str(error).endswith(".")
    else:
        segments(font, bytes(range(256)), SIZES[4])


@settings(deadline=None)
@given(data=st.binary(max_size=400))
def test_random_bytes(data):
    only_fonts_or_errors(data)
    only_fonts_or_errors(b"PK\x08\x08" + data)
    only_fonts_or_errors(GOOD[:BLOCK] + data)


@settings(deadline=None)
@given(
    cut=st.integers(0, 1500),
    changes=st.lists(st.tuples(st.integers(0, 700), st.integers(0, 255)), max_size=6),
)
def test_mutations(cut, changes):
    data = bytearray((FONTS / "TRIP.CHR").read_bytes()[:cut])
    for place, value in changes:
        if place < len(data):
            data[place] = value
    only_fonts_or_errors(bytes(data))


# The table


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty current folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def a_font(name="MINE", width=5):
    return encode(font_of([(False, 0, 0), (True, 4, 4)], widths=[width], name=name))


def load_error(table, number, path=""):
    with pytest.raises(FontError) as caught:
        table.load(number, path)
    return caught.value.code, table.file(number)


def test_the_ten_fonts_are_there(here):
    for number, name in enumerate(STANDARD, start=1):
        assert FontTable().load(number).name == name


@pytest.mark.parametrize("number", [0, -1, 11, 10**9])
def test_unknown_numbers(here, number):
    assert load_error(FontTable(), number) == (grInvalidFontNum, "")


def test_install(here):
    table = FontTable()
    assert table.install("MINE") == 11
    assert table.install("mine.chr") == 11
    assert table.install("OTHER.CHR") == 12
    assert table.install("LITT") == table.install("litt.chr") == 2
    assert load_error(table, 11) == (grFontNotFound, "MINE.CHR")
    (here / "Mine.Chr").write_bytes(a_font())
    assert table.load(11).name == "MINE"


@pytest.mark.parametrize("name", ["", "NINELETTER", ".CHR", "folder/"])
def test_names_that_are_none(here, name):
    assert FontTable().install(name) == grError


def test_the_table_holds_twenty(here):
    table = FontTable()
    assert [table.install(f"F{n}") for n in range(10)] == list(range(11, 21))
    assert table.install("F10") == grError
    assert table.install("F3") == 14
    assert table.register(a_font("NEW")) == grError
    assert table.register(a_font("TRIP")) == 1


@pytest.mark.parametrize("separator", ["/", "\\"])
def test_installed_by_path(here, separator):
    (here / "fonts").mkdir()
    (here / "fonts" / "SCRIPTURE.chr").write_bytes(a_font("LONG"))
    table = FontTable()
    number = table.install(f"fonts{separator}Scripture.chr")
    assert table.load(number).name == "LONG"
    assert load_error(table, table.install("fonts/none")) == (grFontNotFound, "NONE.CHR")


def test_register(here):
    table = FontTable()
    assert table.register(a_font("LITT", 99)) == 2
    assert table.load(2).widths == (99,)
    assert FontTable().load(2).widths != (99,)
    assert table.register(bytearray(a_font("MINE"))) == 11
    assert table.register(a_font("mine")) == 11
    assert table.load(11).name == "mine"
    assert table.register(b"not a font") == grInvalidFont
    with pytest.raises(TypeError):
        table.register(5)


@pytest.mark.parametrize("name", ["TRIP.CHR", "trip.chr", "Trip.Chr"])
def test_search(here, name):
    """The folder of initgraph comes first, then the current one, then the package."""
    folder = here / "bgi"
    folder.mkdir()
    table = FontTable()
    assert table.load(1, folder).name == "TRIP"
    (here / name).write_bytes(a_font("HERE"))
    assert table.load(1, folder).name == "HERE"
    (folder / name).write_bytes(a_font("THER"))
    assert table.load(1, folder).name == "THER"
    assert table.load(1, str(folder) + os.sep).name == "THER"
    assert table.load(1).name == "HERE"
    assert table.load(1, "C:\\TC\\BGI").name == "HERE"
    assert table.load(1, ".\\bgi").name == "THER"
    assert table.load(1, "\0").name == "HERE"
    table.register(a_font("TRIP", 77))
    assert table.load(1, folder).widths == (77,)


def test_a_changed_file_is_read_again(here):
    file = here / "TRIP.CHR"
    file.write_bytes(a_font("TRIP", 5))
    table = FontTable()
    assert table.load(1) is table.load(1)
    file.write_bytes(a_font("TRIP", 6))
    os.utime(file, (1, 1))
    assert table.load(1).widths == (6,)


def test_a_file_that_is_no_font(here):
    (here / "TRIP.CHR").write_bytes(b"something else")
    assert load_error(FontTable(), 1) == (grInvalidFont, "TRIP.CHR")
    (here / "TRIP.CHR").write_bytes(GOOD + bytes(10 * MAX_BYTES))
    assert load_error(FontTable(), 1) == (grInvalidFont, "TRIP.CHR")


def test_a_folder_or_pipe_of_that_name_is_passed_over(here):
    (here / "TRIP.CHR").mkdir()
    if hasattr(os, "mkfifo"):
        os.mkfifo(here / "SANS.CHR")
    assert FontTable().load(1).name == "TRIP"
    assert FontTable().load(3).name == "SANS"


def test_a_file_that_cannot_be_read(here, monkeypatch):
    (here / "TRIP.CHR").write_bytes(a_font())

    def refuse(path, *_, stat=os.stat):
        if str(path).endswith(".CHR"):
            raise PermissionError("no")
        return stat(path)

    monkeypatch.setattr("bgi.fonts.table.os.stat", refuse)
    assert load_error(FontTable(), 1) == (grIOerror, "TRIP.CHR")


@pytest.fixture
def looked_into(monkeypatch):
    """The folders that are looked through, one after another."""
    folders = []

    def look(folder, scandir=os.scandir):
        folders.append(folder)
        return scandir(folder)

    monkeypatch.setattr("bgi.fonts.table.os.scandir", look)
    return folders


LONG_AGO = 10**9, 10**9


def test_a_folder_is_looked_through_again_when_it_has_changed(here, looked_into):
    (here / "empty").mkdir()
    os.utime(here / "empty", LONG_AGO)
    os.utime(here, LONG_AGO)
    table = FontTable()
    for number in (1, 3, 1):
        table.load(number, "empty")
    assert looked_into == ["empty", "."]
    (here / "trip.chr").write_bytes(a_font("HERE"))
    assert table.load(1, "empty").name == "HERE"
    assert looked_into == ["empty", ".", "."]


def test_a_folder_that_changes_right_now_may_change_again_at_the_same_time(here, looked_into):
    moment = os.stat(here).st_mtime_ns
    assert FontTable().load(1).name == "TRIP"
    (here / "trip.chr").write_bytes(a_font("HERE"))
    os.utime(here, ns=(moment, moment))  # as where a clock is too coarse to tell
    assert FontTable().load(1).name == "HERE"


def test_each_current_folder_is_looked_through(here, monkeypatch):
    (here / "other").mkdir()
    (here / "other" / "trip.chr").write_bytes(a_font("OTHR"))
    for folder in (here, here / "other"):
        os.utime(folder, LONG_AGO)
    assert FontTable().load(1).name == "TRIP"
    monkeypatch.chdir("other")
    assert FontTable().load(1).name == "OTHR"
    monkeypatch.chdir("..")
    assert FontTable().load(1).name == "TRIP"
