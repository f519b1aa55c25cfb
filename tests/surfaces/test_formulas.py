"""Formulas: what they mean, what is refused and how, and that no text at all does anything else."""

import math
import warnings
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces.formulas import DEEPEST, FUNCTIONS, LONGEST, NAMES, FormulaError, formula

X, Y = 0.7, -1.3


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("x", X),
        ("x+y*2-3/4", X + Y * 2 - 0.75),
        ("-x**2", -X * X),
        ("-x^2", -X * X),
        ("x^2+y^2", X * X + Y * Y),
        ("2^3^2", 512),
        ("2^-1", 0.5),
        ("7 % 4 + 7 // 4", 4),
        ("-7 % 4", 1),
        ("+x - -y", X + Y),
        ("(x+y)*(x-y)", X * X - Y * Y),
        ("sin(x*y)/2", math.sin(X * Y) / 2),
        ("r", math.hypot(X, Y)),
        ("theta", math.atan2(Y, X)),
        ("cos(pi) + log(e)", 0),
        ("ln(e) + log2(8) + log10(100)", 6),
        ("atan2(y, x) - arctan2(y, x)", 0),
        ("hypot(3, 4) + min(1, 2) + max(1, 2)", 8),
        ("abs(-2) + sign(-3) + floor(1.9) + ceil(1.1) + round(2.4)", 6),
        ("mod(7, 4) + sqrt(9) + cbrt(-8)", 4),
        ("sinc(0) + sinc(pi/2)", 1 + 2 / math.pi),
        ("x > 0", 1),
        ("y > 0", 0),
        ("-1 < x < 1", 1),
        ("-1 < y < 1", 0),
        ("(x > 0) + (y < 0) - (x == y) + (x != y) + (x >= y) + (x <= y)", 4),
        ("where(x > y, x, y)", X),
        ("where(x < y, x, y)", Y),
        (" \t x\n+ 1 ", X + 1),
        ("1e3 + .5 + 2. + 1_000", 2002.5),
    ],
)
def test_meaning(text: str, value: float) -> None:
    z = formula(text)(X, Y)
    assert type(z) is np.float64
    assert z == pytest.approx(value, abs=1e-15)


def test_arrays_give_arrays_of_the_common_shape() -> None:
    x, y = np.linspace(-1, 1, 5)[:, None], np.arange(3)
    for text in ("x*y", "1", "x", "y < 1", "where(x > 0, y, 2)"):
        z = formula(text)(x, y)
        assert (z.shape, z.dtype) == ((5, 3), np.float64)
    assert np.array_equal(formula("x*y")(x, y), x * y)


def test_the_result_is_nobody_elses_array() -> None:
    x = np.zeros(3)
    z = formula("x")(x, x)
    z[:] = 1
    assert not x.any()


@pytest.mark.parametrize("text", ["1/0", "x/0", "0/0", "log(-1)", "10^400", "(-8)^(1/3)", "x % 0"])
def test_where_there_is_no_value_there_is_no_warning(text: str) -> None:
    assert not np.isfinite(formula(text)(X, Y))
    assert not np.isfinite(formula(text)(np.array([X]), np.array([Y]))).any()


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_takes_as_many_values_as_it_says(name: str) -> None:
    count, _ = FUNCTIONS[name]
    assert np.isfinite(formula(f"{name}({', '.join(['0.5'] * count)})")(X, Y))
    with pytest.raises(FormulaError, match=rf"{name} takes .* write {name}\(a"):
        formula(f"{name}({', '.join(['0.5'] * (count + 1))})")
    with pytest.raises(FormulaError, match=f"{name} is a function"):
        formula(f"1 + {name}")


@pytest.mark.parametrize(
    ("text", "problem", "piece"),
    [
        ("sin(x*yy)", "unknown name 'yy': there are x, y, r, theta, pi, e", "yy"),
        ("x^2+y^2+q^2", "unknown name 'q'", "q"),
        ("x + foo(y)", "unknown function 'foo': there are sin, cos", "foo"),
        ("2x", "multiplication is written 2*x", "2"),
        ("sin(x y)", "multiplication is written 2*x", "x y"),
        ("x(y+1)", "this is no function", "x"),
        ("2(x)", "this is no function", "2"),
        ("(x", "never closed", "("),
        ("x)", "there is no ( for this )", ")"),
        ("z = x", "without =", "="),
        ("x^^2", "'^' does not fit here", "^"),
        ("x +* y", "'*' does not fit here", "*"),
        ("007", "write 7, not 07", "00"),
        ("(x, y)", "a comma stands only", "(x, y)"),
        ("x and y", "multiply", "x and y"),
        ("x if y else 1", "write where(", "x if y else 1"),
        ("np.sin(x)", "have no dot", "np.sin"),
        ("x.real", "have no dot", "x.real"),
        ("1 << 2", "this operator is none of", "1 << 2"),
        ("x in y", "this operator is none of", "x in y"),
        ("not x", "this operator is none of", "not x"),
        ("2j", "no part of a formula", "2j"),
        ("True", "no part of a formula", "True"),
        ("...", "no part of a formula", "..."),
        ("sin(*x)", "no part of a formula", "*x"),
        ("max(x, **y)", "max takes 2 values", "max(x, **y)"),
        ("1e999", "too large", "1e999"),
        ("9" * 400, "too large", "9" * 400),
        ("x[0]", "'[' means nothing", "["),
        ("'x'", "means nothing", "'"),
        ("x # y", "'#' means nothing", "#"),
        ("lambda: x", "':' means nothing", ":"),
        ("2·x", "'·' means nothing", "·"),
    ],
)
def test_an_error_says_what_and_where(text: str, problem: str, piece: str) -> None:
    with pytest.raises(FormulaError) as caught:
        formula(text)
    error = caught.value
    assert problem in error.problem
    assert error.text[error.column : error.column + error.width] == piece
    assert str(error) == (
        f"{error.problem} (column {error.column + 1})\n{text}\n"
        f"{' ' * error.column}{'^' * len(piece)}"
    )


@pytest.mark.parametrize("text", ["", " \n", "x+", "sin(x) *  "])
def test_an_error_at_the_end_points_behind_it(text: str) -> None:
    with pytest.raises(FormulaError) as caught:
        formula(text)
    assert caught.value.caret == " " * len(text.strip()) + "^"


def test_what_cannot_be_printed_is_shown_as_a_question_mark() -> None:
    with pytest.raises(FormulaError, match=r"'\\x1b' means nothing.*\nx\?\n \^"):
        formula("x\x1b")


def test_length_and_depth_have_bounds() -> None:
    formula(f"x + {'1' * 300}")
    formula("x".rjust(LONGEST, "0").replace("0", " ") + " " * LONGEST)
    formula("+" * (DEEPEST - 1) + "x")
    for text in ("x+" * LONGEST, "+" * DEEPEST + "x", "+" * (LONGEST - 1) + "x", "(" * LONGEST):
        with pytest.raises(FormulaError, match=r"too long|too deeply"):
            formula(text)
    with pytest.raises(FormulaError) as caught:
        formula("x" * 10**6)
    assert len(str(caught.value)) < 2000


OPERATORS = ("+", "-", "*", "/", "//", "%", "^", "<", ">=", "==")
OTHERS = ("0", "1", "2.5", "1e9", "**", "(", ")", ",", ".", "=", "!", "if", "in", "j")
WORDS = (*NAMES, *FUNCTIONS, *OPERATORS, *OTHERS)
TEXTS = st.one_of(
    st.text(max_size=60),
    st.text("xyre0123456789.+-*/%^()<>=!, _", max_size=60),
    st.lists(st.sampled_from(WORDS), max_size=30).map("".join),
    st.lists(st.sampled_from(WORDS), max_size=30).map(" ".join),
)
SOUND = st.recursive(
    st.sampled_from((*NAMES, "0", "2.5", "1e300", "7")),
    lambda part: st.one_of(
        st.tuples(part, st.sampled_from(OPERATORS), part).map(
            lambda pieces: "({} {} {})".format(*pieces)
        ),
        st.tuples(st.sampled_from(tuple(FUNCTIONS)), part).map(
            lambda pieces: f"{pieces[0]}({', '.join([pieces[1]] * FUNCTIONS[pieces[0]][0])})"
        ),
        part.map(lambda text: f"-{text}"),
    ),
    max_leaves=12,
)
NUMBERS: Any = np.array((0.0, -0.0, 1.0, -2.5, 1e308, -1e-308, np.inf, -np.inf, np.nan))


def check(text: str) -> None:
    f = formula(text)
    x, y = np.meshgrid(NUMBERS, NUMBERS, indexing="ij")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        z = f(x, y)
        one = f(2.0, -3.0)
    assert (z.shape, z.dtype) == (x.shape, np.float64)
    assert type(one) is np.float64


@given(TEXTS)
def test_any_text_is_a_function_or_an_error(text: str) -> None:
    try:
        check(text)
    except FormulaError as error:
        assert 0 <= error.column <= len(error.text)
        assert error.problem
        assert "\n" not in error.problem


@given(SOUND)
def test_a_sound_formula_is_a_function(text: str) -> None:
    if len(text) <= LONGEST:
        check(text)
