"""The original, asked: what Turbo C++ 3.0's library drew and answered, index for index."""

import pytest

from tests.cases import ORIGINAL, compared, load
from tests.pictures import assert_same

PRINTED = "console"  # printf and its like on the picture: no call of graphics.h
CASES = {
    f"{case['group']}/{case['name']}": case
    for case in load()
    if not case["unsure"] and case["group"] != PRINTED
}

DEBT = (ORIGINAL / "debt.txt").read_text().split()
"""Cases in which we still differ, by mistake; the list may only shrink."""


@pytest.mark.parametrize("name", [name for name in CASES if name not in DEBT])
def test_drawn_and_answered_alike(name):
    got, expected, answers = compared(CASES[name])
    assert_same(got, expected, name.replace("/", "-"))
    assert answers == CASES[name]["results"]


@pytest.mark.parametrize("name", DEBT)
def test_debt(name):
    """A case that has become alike leaves the list."""
    try:
        got, expected, answers = compared(CASES[name])
    except Exception:
        return
    assert (got != expected).any() or answers != CASES[name]["results"]
