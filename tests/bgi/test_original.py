"""The original, asked: what Turbo C++ 3.0's library drew and answered, index for index."""

import pytest

from tests.cases import ORIGINAL, compared, load, stands_for_itself
from tests.pictures import assert_same

CASES = {f"{case['group']}/{case['name']}": case for case in load() if stands_for_itself(case)}

DEBT = (ORIGINAL / "debt.txt").read_text().split()
"""Cases in which we still differ, by mistake; the list may only shrink."""

MORE_CORNERS = "the buffer of the original has room for 679 corners: it says -6 and draws nothing"
ON_PURPOSE = {
    "model_arc/arc_thick_grid": MORE_CORNERS,
    "arc/32767_90_w3": MORE_CORNERS,
    "random_pies/pies_048": MORE_CORNERS,
}
"""Cases in which we differ, and what the original does."""

ALIKE = [name for name in CASES if name not in ON_PURPOSE and name not in DEBT]


@pytest.mark.parametrize("name", ALIKE)
def test_drawn_and_answered_alike(name):
    got, expected, answers = compared(CASES[name])
    assert_same(got, expected, name.replace("/", "-"))
    assert answers == CASES[name]["results"]


@pytest.mark.parametrize("name", [*ON_PURPOSE, *DEBT])
def test_different(name):
    """A case that has become alike leaves the lists."""
    try:
        got, expected, answers = compared(CASES[name])
    except Exception:
        return
    assert (got != expected).any() or answers != CASES[name]["results"]
