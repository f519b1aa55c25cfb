"""scanf's format language: as the original read, what printf has written, and with mistakes."""

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi.clib.bits import signed
from bgi.clib.printf import format
from bgi.clib.reading import StringSource
from bgi.clib.scanf import EOF, scan, sscanf
from tests import captured


def in_c(value, format_string):
    """A value as the capture shows it: what was stored in an int of 16 bits, 0 and ? if nothing."""
    if value is None:
        return "0"
    if isinstance(value, str) and format_string.endswith("c"):
        return str(ord(value))
    if isinstance(value, int) and "l" not in format_string:
        value = signed(value, 16)
    return value if isinstance(value, str) else f"{value:g}"


@pytest.mark.parametrize("format_string, text, count, stored", captured.read())
def test_as_the_original_read(format_string, text, count, stored):
    values, returned = scan(StringSource(text), format_string)
    assert returned == count
    assert [in_c(value, format_string) for value in values] == [s for s in stored if s != "?"]


# What is returned


def test_as_many_values_as_the_format_has():
    x, y = sscanf("3 4", "%d%d")
    assert (x, y) == (3, 4)
    assert sscanf("42", "%d") == 42
    assert sscanf("3,x", "%d,%d") == (3, None)
    assert sscanf("", "%d%s") == (None, None)
    assert sscanf("x", "%d") is None
    assert sscanf("5 6", "%*d%d") == 6
    assert sscanf("5", "%*d") == ()
    assert sscanf("abc", "abc") == ()


@pytest.mark.parametrize(
    "text, format_string, stored",
    [
        ("", "%d", EOF),
        ("  \n", "%d", EOF),
        ("  ", "%c%c%c", 2),
        ("x", "%d", 0),
        ("-", "%d", 0),
        ("abc", "abc%d", EOF),
        ("abd", "abc%d", 0),
        ("3", "%d%d", 1),
        ("3 x", "%d%d", 1),
        ("3 4", "%d%n%d", 2),
        ("", "%n", 0),
        ("5", "%*d", 0),
    ],
)
def test_the_number_that_c_returns(text, format_string, stored):
    assert scan(StringSource(text), format_string).stored == stored


# Fields


def test_whole_numbers():
    assert sscanf("08", "%i%d") == (0, 8)
    assert sscanf("0xg", "%i%c") == (0, "g")
    assert sscanf("-0x1F,+17,-8,9", "%x,%o,%i,%i") == (65536 - 31, 15, -8, 9)
    assert sscanf("12345678", "%2d%3o%X") == (12, 0o345, 0x678)
    assert sscanf("- 5", "%d") is None
    assert sscanf("99999999999", "%ld") == 99999999999
    assert sscanf("70000 70000 -1", "%hd%hu%hx") == (4464, 4464, 65535)
    assert sscanf("-1 -1 -40000", "%u%lu%u") == (65535, 2**32 - 1, 2**32 - 40000)
    assert sscanf("-1 -1 017 1", "%D%U%I%O") == (-1, 2**32 - 1, 15, 1)


def test_real_numbers():
    assert sscanf("1.5 -.5 2. 1e3 +2E-1", "%f%e%g%lf%Lf") == (1.5, -0.5, 2.0, 1000.0, 0.2)
    assert sscanf("1e+x", "%f%c") == (1.0, "x")
    assert sscanf("1.5.5", "%f%f") == (1.5, 0.5)
    assert sscanf(". 1", "%f") is None
    assert sscanf("123.456", "%5f%d") == (123.4, 56)
    assert sscanf("1e999", "%f") == float("inf")


def test_words_and_characters():
    assert sscanf("  ab\tcd", "%s%s") == ("ab", "cd")
    assert sscanf("a b", "%c%c%c") == ("a", " ", "b")
    assert sscanf("abcde", "%3c%c") == ("abc", "d")
    assert sscanf("ab", "%3c") is None
    assert sscanf(b"\x82t\x82", "%s") == "été"
    assert sscanf("ab\0cd", "%s") == "ab"


def test_sets():
    assert sscanf("hello, world\nnext", "%[^\n]") == "hello, world"
    assert sscanf("a-c", "%[-ac]") == "a-c"
    assert sscanf("a-c", "%[ac-]") == "a-c"
    assert sscanf("z-a", "%[z-a]") == "z-a"
    assert sscanf("]x", "%[^x]") == "]"
    assert sscanf("x]", "%[^]]") == "x"
    assert sscanf("A1b2-", "%[A-Z0-9a-z]") == "A1b2"
    assert sscanf("abcabc", "%4[abc]%s") == ("abca", "bc")
    assert sscanf(" a", "%[a]") is None
    assert sscanf("^^", "%[x^]") == "^^"


def test_addresses():
    assert sscanf("12AB:0004 12ab", "%p%Np") == (0x12AB0004, 0x12AB)


def test_n_counts_what_has_been_read():
    assert sscanf("  42 abc", "%d%n%s%n") == (42, 4, "abc", 8)


def test_what_must_come():
    assert sscanf("10:30", "%d:%d") == (10, 30)
    assert sscanf("10 :30", "%d:%d") == (10, None)
    assert sscanf("10 :30", "%d :%d") == (10, 30)
    assert sscanf("50%", "%d%%%n") == (50, 3)
    assert sscanf("(1,\n 2)", "(%d,%d)%n") == (1, 2, 7)


def test_what_does_not_belong_there_is_left_in_the_source():
    source = StringSource("12 abc\n7")
    assert scan(source, "%d").values == (12,)
    assert source.getc() == " "
    assert scan(source, "%d").values == (None,)
    assert scan(source, "%s%d").values == ("abc", 7)
    assert source.getc() == ""


# What printf has written


@given(st.lists(st.integers(-(2**31), 2**31 - 1), min_size=2, max_size=5))
def test_whole_numbers_come_back(numbers):
    for letter in "di":
        format_string = f"%{letter} " * len(numbers)
        assert sscanf(format(format_string, *numbers), format_string) == tuple(numbers)


@given(st.integers(0, 2**32 - 1), st.sampled_from(["%lu", "%lo", "%lx", "%#lx", "%lX", "%p"]))
def test_numbers_without_a_sign_come_back(number, format_string):
    assert sscanf(format(format_string, number), format_string.replace("#", "")) == number


@given(st.floats(-1e300, 1e300), st.sampled_from(["%.14e", "%.15g", "%.17G"]))
def test_real_numbers_come_back(number, format_string):
    assert sscanf(format(format_string, number), "%lf") == float(f"{number:.15g}")


@given(st.text(st.characters(codec="cp437", exclude_characters="\0 \t\n\v\f\r"), min_size=1))
def test_words_come_back(word):
    assert sscanf(format("%s %d", word, 7), "%s%d") == (word, 7)


# Mistakes


@pytest.mark.parametrize(
    "call, error, words",
    [
        (("1", "%y"), ValueError, "'%y' begins with no conversion of scanf"),
        (("1", "%d %"), ValueError, "'%' begins with no conversion of scanf"),
        (("1", "%[abc"), ValueError, "'%[abc' begins with no conversion of scanf"),
        (("1", "%.2f"), ValueError, "'%.2f' begins with no conversion of scanf"),
        (("1", "%0d"), ValueError, "the width of %0d must be 1 to 32,767"),
        (("1", "%99999d"), ValueError, "the width of %99999d must be 1 to 32,767"),
        (("1" * 301, "%d"), ValueError, "the input has a number of more than 300 digits"),
        ((5, "%d"), TypeError, "the text must be a str, not int: 5"),
        (("5", 5), TypeError, "the format must be a str, not int: 5"),
    ],
)
def test_mistakes_are_named(call, error, words):
    with pytest.raises(error) as raised:
        sscanf(*call)
    assert words in str(raised.value)


def test_a_field_without_a_width_has_an_end():
    assert [len(word) for word in sscanf("a" * 40000, "%s%s")] == [32767, 7233]
    assert sscanf("0" * 32000 + "7", "%d") == 7


class Endless:
    """The same character over and over."""

    def __init__(self, character):
        self.characters = itertools.cycle(character)

    def getc(self):
        return next(self.characters)

    def ungetc(self, character):
        pass  # the next one is the same


@pytest.mark.parametrize("character, format_string", [("a", "%s"), ("1", "%f"), ("x", "%[x]")])
def test_endless_input_fills_a_field(character, format_string):
    (value,) = scan(Endless(character), format_string).values
    assert len(str(value)) == 32767 or value == float("inf")


def test_endless_white_space_ends(monkeypatch):
    monkeypatch.setattr("bgi.clib.reading.MOST_CHARACTERS", 1000)
    with pytest.raises(ValueError, match="the input has more than 1,000 characters"):
        scan(Endless(" "), "%d")


spelling = st.lists(
    st.sampled_from([*"%%%%*19hlLFNdDiIoOuUxXeEfgGscpn[]^-az ,", "%d"]), max_size=20
)


@given(st.text("0123456789 +-.exaz,:\n"), spelling.map("".join))
def test_any_format_reads_or_says_why_not(text, format_string):
    source = StringSource(text)
    try:
        values, stored = scan(source, format_string)
    except ValueError as error:
        assert str(error)
    else:
        assert EOF <= stored <= len(values)
        assert source.position <= len(text)
