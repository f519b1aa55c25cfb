"""printf's format language: as the original printed, as Python does, and with mistakes."""

import math
import struct

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from bgi.clib.printf import LONGEST, format
from tests import captured


@pytest.mark.parametrize("format_string, given, made", captured.printed())
def test_as_the_original_printed(format_string, given, made):
    if "%n" in format_string:
        # The capture shows what it stored, of a format with three characters before it.
        assert format("abc%n", *given) == "abc"
        assert str(given[0][0]) == made
    else:
        assert format(format_string, *given) == made


# Where C and Python agree

flags = st.lists(st.sampled_from("-+ 0#"), max_size=3).map("".join)
real_flags = flags.map(lambda chosen: chosen.replace("0", ""))
width = st.one_of(st.just(""), st.integers(1, 40).map(str))
precision = st.one_of(st.just(""), st.integers(0, 30).map(".{}".format))


@given(flags, width, precision, st.sampled_from("di"), st.integers(-(2**40), 2**40))
def test_whole_numbers_as_python_prints_them(flags, width, precision, letter, number):
    format_string = f"<%{flags}{width}{precision}{letter}>"
    if not (number == 0 and precision == ".0"):  # C prints no digit
        if precision:  # which Python lets the flag 0 overrule
            flags = flags.replace("0", "")
        assert format(format_string, number) == f"<%{flags}{width}{precision}{letter}>" % number


@given(flags, width, st.sampled_from("uoxX"), st.integers(0, 2**40))
def test_numbers_without_a_sign_as_python_prints_them(flags, width, letter, number):
    flags = flags.translate(str.maketrans("", "", "+ #"))
    assert format(f"%{flags}{width}{letter}", number) == f"%{flags}{width}{letter}" % number


@given(real_flags, width, st.integers(0, 14), st.floats(allow_nan=False, allow_infinity=False))
def test_exponents_as_python_prints_them(flags, width, places, number):
    for format_string in (f"%{flags}{width}.{places}e", f"%{flags}{width}.{places}G"):
        assert format(format_string, number) == format_string % number


@given(real_flags, width, st.integers(0, 5), st.floats(-1e9, 1e9))
def test_places_as_python_prints_them(flags, width, places, number):
    format_string = f"%{flags}{width}.{places}f"
    assert format(format_string, number) == format_string % number


@given(flags, width, precision, st.text(st.characters(exclude_characters="\0")))
def test_texts_as_python_prints_them(flags, width, precision, text):
    format_string = f"%{flags}{width}{precision}s"
    assert format(format_string, text) == format_string % text


# Where they differ


@given(st.floats(allow_nan=False, allow_infinity=False), st.integers(0, 400))
@example(9.9999999999999999e22, 3)
@example(0.99999999999999999, 14)
@example(9.999999999999995, 14)
def test_no_number_has_more_than_15_digits(number, places):
    for letter in "fe":
        digits = format(f"%.{places}{letter}", number).partition("e")[0]
        significant = digits.lstrip("-0.").replace(".", "").rstrip("0")
        assert len(significant) <= 15
        assert len(digits.partition(".")[2]) == places


@given(st.integers(-(2**15), -1))
def test_a_negative_number_without_a_sign_has_16_bits(number):
    (bits,) = struct.unpack("H", struct.pack("h", number))
    assert format("%u %x %o", number, number, number) == f"{bits} {bits:x} {bits:o}"
    assert format("%lu", number) == str(number + 2**32)


def test_numbers_stay_what_they_are():
    assert format("%d %u %x", 70000, 70000, 70000) == "70000 70000 11170"
    assert format("%u", -40000) == str(2**32 - 40000)
    assert format("%hd %hu %hx", 70000, 70000, 70000) == "4464 4464 1170"
    assert format("%d", 10**100) == str(10**100)
    assert format("%d %i", 7 / 2, -7 / 2) == "3 -3"


def test_numbers_of_numpy():
    assert format("%d %u %x", np.int8(-5), np.uint8(200), np.int64(255)) == "-5 200 ff"
    assert format("%.2f %g %d", np.float32(0.5), np.int16(3), np.float64(3.9)) == "0.50 3 3"
    assert format("%d", np.array(5)) == "5"


def test_zeros_before_a_real_number_do_not_count_its_sign():
    assert format("%08.2f %08.2f %+08.2f", 1.5, -1.5, 1.5) == "00001.50 -00001.50 +00001.50"
    assert format("%-08.2f|%8.2f", -1.5, -1.5) == "-1.50   |   -1.50"


def test_what_is_no_number_has_a_name_and_a_sign():
    assert format("%f %e %5.1f|", math.inf, -math.inf, math.nan) == "+INF -INF  +NAN|"


def test_zero_has_no_prefix():
    assert format("%#x %#o %#X %#5.3o", 0, 0, 255, 8) == "0 0 0XFF   010"


def test_characters():
    assert format("%c%c%c%c", "é", 196, b"\xc4", 0x141) == "é──A"
    assert format("%c", 0) == "\0"


def test_bytes_are_in_code_page_437():
    assert format(b"\xcd%s\xcd", b"\x82t\x82") == "═été═"


def test_a_string_ends_at_its_zero():
    assert format("%s|%d\0%d", b"abc\0\0\0", 5) == "abc|5"


def test_addresses_are_far_unless_they_are_called_near():
    assert format("%p %Fp %Np", 0x12AB0004, 0x12AB0004, 0x12AB0004) == "12AB:0004 12AB:0004 0004"


def test_sizes_change_nothing_else():
    assert format("%ld %lf %Lf %Fs %Ns", 5, 1.5, 1.5, "a", "b") == "5 1.500000 1.500000 a b"


def test_from_what_is_no_conversion_the_rest_stands_as_it_is():
    assert format("%d%% %k %d", 5, 6) == "5% %k %d"
    assert format("100%") == "100%"


def test_n_counts_what_came_before():
    first: list[int] = []
    second: list[int] = []
    assert format("%5d%n%s%n", 3, first, "ab", second) == "    3ab"
    assert first == [5]
    assert second == [7]


def test_what_is_left_over_is_ignored():
    assert format("%d", 1, 2, 3) == "1"


MISTAKES = [
    (("%d",), TypeError, "the argument of %d (conversion 1) is missing: the call gives 0"),
    (("%d%%%5s", 1), TypeError, "the argument of %5s (conversion 2) is missing: the call gives 1"),
    (("%*d", 5), TypeError, "the argument of %*d (conversion 1) is missing"),
    (("%*d", "x", 5), TypeError, "the width of %*d (conversion 1) must be a number, not str: 'x'"),
    (("%.*f", None, 5), TypeError, "the precision of %.*f (conversion 1) must be a number"),
    (("%d", "12"), TypeError, "the argument of %d (conversion 1) must be a number, not str: '12'"),
    (("%f", "1.5"), TypeError, "the argument of %f (conversion 1) must be a number, not str"),
    (("%d", None), TypeError, "the argument of %d (conversion 1) must be a number, not NoneType"),
    (("%s", 5), TypeError, "(conversion 1) must be a str: use %d or %f to print 5"),
    (("%s", []), TypeError, "the argument of %s (conversion 1) must be a str, not list: []"),
    (("%c", "ab"), ValueError, "the argument of %c (conversion 1) must be one character, not 'ab'"),
    (("%c", b"ab"), TypeError, "the argument of %c (conversion 1) must be a number, not bytes"),
    (("%n", 5), TypeError, "(conversion 1) must be a list, to append a number to, not int"),
    (("%d", math.nan), ValueError, "must be a finite number, not nan"),
    (("%d", 10**5000), ValueError, "is too large: <a whole number of 16610 bits>"),
    (("%f", 10**400), ValueError, "the argument of %f (conversion 1) is too large"),
    (("%32768d", 1), ValueError, "the width of %32768d (conversion 1) must be at most 32,767"),
    (("%.*d", 10**30, 1), ValueError, "the precision of %.*d (conversion 1) must be at most"),
    (("%" + "9" * 10000 + "d", 1), ValueError, "9999 (conversion 1) must be at most 32,767"),
    ((5,), TypeError, "the format must be a str, not int: 5"),
    (
        ("%32767d" * 600, *range(600)),
        ValueError,
        "the format makes more than 16,777,216 characters",
    ),
]


@pytest.mark.parametrize("call, error, words", MISTAKES)
def test_mistakes_are_named(call, error, words):
    with pytest.raises(error) as raised:
        format(*call)
    assert words in str(raised.value)
    assert len(str(raised.value)) < 200


@pytest.mark.parametrize("hostile", ["%" * 10**5, "%" + "0" * 10**6, "%.0" * 10**5, "%-%" * 10**5])
def test_a_hostile_format_takes_no_time(hostile):
    assert len(format(hostile)) <= len(hostile)


anything = st.one_of(
    st.integers(), st.floats(), st.text(), st.binary(), st.none(), st.builds(list), st.booleans()
)
spelling = st.lists(
    st.sampled_from([*"%%%%-+ 0#*.19hlLFNdiuoxXfeEgGcspnz", "32767", "99999"]), max_size=20
)


@given(spelling.map("".join), st.lists(anything, max_size=8))
def test_any_format_prints_or_says_why_not(format_string, arguments):
    try:
        made = format(format_string, *arguments)
    except (TypeError, ValueError) as error:
        assert str(error)
    else:
        assert len(made) <= LONGEST * 20 + 10**4
