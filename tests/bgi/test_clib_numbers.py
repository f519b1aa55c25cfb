"""stdlib.h: as the original computed, and what goes there and back."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi import stdlib
from bgi.clib.bits import signed
from bgi.clib.printf import format
from tests import captured

longs = st.integers(-(2**31), 2**31 - 1)


# As the original computed


def test_captured_texts_of_whole_numbers():
    assert captured.numbers("itoa") == [
        stdlib.itoa(-255, 16),
        stdlib.itoa(-255, 10),
        stdlib.itoa(255, 2),
        stdlib.ltoa(-1, 16),
        stdlib.ultoa(4000000000, 10),
        stdlib.itoa(35, 36),
    ]


def test_captured_texts_of_real_numbers():
    digits, point, negative = stdlib.ecvt(-12.5, 4)
    assert captured.numbers("gcvt") == [
        stdlib.gcvt(3.14159, 4),
        stdlib.gcvt(1e10, 5),
        stdlib.gcvt(1e-5, 5),
        "ecvt",
        f"{digits}/{point}/{negative}",
        "fcvt",
        stdlib.fcvt(12.34, 2)[0],
    ]


def test_captured_numbers_of_texts():
    texts = ["  42abc", "-70000", "x"]
    expected = [*map(stdlib.atoi, texts), "atol", stdlib.atol("99999999"), "atof"]
    expected.append(f"{stdlib.atof('1.5e3'):g}")
    assert captured.numbers("atoi") == [str(value) for value in expected]


def test_captured_quotients():
    quotients = stdlib.div(-7, 2) + stdlib.ldiv(7, -2)
    assert captured.numbers("div")[:4] == [str(number) for number in quotients]


def test_captured_chance():
    assert captured.numbers("rand") == [str(stdlib.rand()) for _ in range(12)]
    stdlib.srand(7)
    assert captured.numbers("srand(7)") == [str(stdlib.rand()) for _ in range(12)]
    for seed, num in ((0, 100), (40000, 640)):
        stdlib.srand(seed)
        drawn = [str(stdlib.random(num)) for _ in range(12)]
        assert captured.numbers(f"srand({seed}) random({num})") == drawn
    assert captured.numbers("CLK_TCK")[-1] == str(stdlib.RAND_MAX)


def test_a_star_leaves_the_programs_random_alone():
    brought: dict[str, object] = {}
    exec("import random\nfrom bgi.stdlib import *", brought)
    assert brought["random"] is random
    assert brought["atoi"] is stdlib.atoi


# Texts of numbers


@given(longs, st.integers(2, 36))
def test_whole_numbers_come_back(number, radix):
    text = stdlib.ltoa(number, radix)
    assert text == text.lower()
    assert signed(int(text, radix), 32) == number
    assert signed(int(stdlib.itoa(number, radix), radix), 16) == signed(number, 16)
    assert stdlib.strtoul(stdlib.ultoa(number, radix), radix) == (number % 2**32, "")


def test_an_int_has_16_bits_and_a_long_32():
    assert stdlib.itoa(40000) == "-25536"
    assert stdlib.ltoa(40000) == "40000"
    assert stdlib.ltoa(2**31) == str(-(2**31))
    assert stdlib.ultoa(-1) == "4294967295"
    assert stdlib.itoa(0, 2) == "0"
    assert stdlib.itoa(7.9) == "7"


@given(st.floats(allow_nan=False, allow_infinity=False), st.integers(1, 20))
def test_digits_are_those_of_printf(value, places):
    assert stdlib.gcvt(value, places).lstrip("-") == format(f"%.{places}g", abs(value))
    digits, point, negative = stdlib.ecvt(value, places)
    assert len(digits) == places
    written = f"{'-' * negative}0.{digits}e{point}"
    assert float(written) == float(format(f"%.{places - 1}e", value))


@given(st.floats(-1e12, 1e12), st.integers(0, 10))
def test_places_are_those_of_printf(value, places):
    digits, point, negative = stdlib.fcvt(value, places)
    whole, behind = digits[: max(point, 0)] or "0", "0" * -point + digits[max(point, 0) :]
    written = f"{'-' * negative}{whole}{'.' * (places > 0)}{behind}"
    assert written.lstrip("-") == format(f"%.{places}f", abs(value))


# Numbers of texts


def test_whole_numbers_with_which_a_text_begins():
    assert [stdlib.atoi(s) for s in (" +7", "-", "", "12.9", "0x1f", b"8 ")] == [7, 0, 0, 12, 0, 8]
    assert stdlib.atoi("70000") == 4464
    assert stdlib.atol("\t\n-70000x") == -70000
    assert stdlib.atol("4294967297") == 1


def test_real_numbers_with_which_a_text_begins():
    found = [stdlib.atof(s) for s in ("1.5e3 m", " -.5", "x", "", "1e", ".")]
    assert found == [1500.0, -0.5, 0.0, 0.0, 1.0, 0.0]
    assert stdlib.strtod(" 2.5kg") == (2.5, "kg")
    assert stdlib.strtod(" kg") == (0.0, " kg")


def test_the_text_behind_a_number():
    assert stdlib.strtol(" 12 apples") == (12, " apples")
    assert stdlib.strtol("apples") == (0, "apples")
    assert stdlib.strtol("0x1fg", 0) == stdlib.strtol("1fg", 16) == (31, "g")
    assert stdlib.strtol("0179", 0) == (15, "9")
    assert stdlib.strtol("Zz,", 36) == (35 * 37, ",")
    assert stdlib.strtol("9999999999") == (2**31 - 1, "")
    assert stdlib.strtol("-9999999999") == (-(2**31), "")
    assert stdlib.strtoul("-1") == (2**32 - 1, "")
    assert stdlib.strtoul("9999999999") == (2**32 - 1, "")


# Arithmetic


@given(longs, longs.filter(bool))
def test_division_is_toward_zero(numer, denom):
    quot, rem = stdlib.div(numer, denom)
    assert quot * denom + rem == numer
    assert abs(rem) < abs(denom)
    assert rem == 0 or (rem < 0) == (numer < 0)


def test_labs():
    assert stdlib.labs(-70000) == stdlib.labs(70000.9) == 70000


# Mistakes


@pytest.mark.parametrize(
    "call, error, words",
    [
        (lambda: stdlib.itoa(5, 1), ValueError, "radix must be 2 to 36, not 1"),
        (lambda: stdlib.itoa("5"), TypeError, "value must be a number, not str: '5'"),
        (lambda: stdlib.atoi(5), TypeError, "s must be a str, not int: 5"),
        (lambda: stdlib.atoi("1" * 9999), ValueError, "has a number of more than 300 digits"),
        (lambda: stdlib.strtol("5", 1), ValueError, "radix must be 0 or 2 to 36, not 1"),
        (lambda: stdlib.gcvt(10**400, 5), ValueError, "value must be a finite number, not <a who"),
        (
            lambda: stdlib.gcvt(float("nan"), 5),
            ValueError,
            "value must be a finite number, not nan",
        ),
        (lambda: stdlib.ecvt(1.5, 10**9), ValueError, "ndig must be 0 to 1000, not 1000000000"),
        (lambda: stdlib.div(1, 0), ZeroDivisionError, ""),
    ],
)
def test_mistakes_are_named(call, error, words):
    with pytest.raises(error) as raised:
        call()
    assert words in str(raised.value)
