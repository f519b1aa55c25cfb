"""The original, asked: what Turbo C++ 3.0's library drew and answered, index for index."""

import re
from collections import Counter
from pathlib import Path

import pytest

from tests.cases import compared, load, stands_for_itself
from tests.pictures import assert_same

CASES = {f"{case['group']}/{case['name']}": case for case in load() if stands_for_itself(case)}

MORE_CORNERS = "its buffer has room for 679 corners: it says -6 and draws nothing"
NO_OPERATOR = "it runs what lies beyond its table of operators, and says 0"
ON_PURPOSE = {
    "model_arc/arc_thick_grid": MORE_CORNERS,
    "arc/32767_90_w3": MORE_CORNERS,
    "random_pies/pies_048": MORE_CORNERS,
    "putimage/300_300_op-1": NO_OPERATOR,
    "putimage/300_300_op5": NO_OPERATOR,
    "putimage/vp_300_300_op-1": NO_OPERATOR,
    "putimage/vp_300_300_op5": NO_OPERATOR,
}
"""Cases in which we differ, and what the original does."""

LEFT_OVER = {"query/errors": [["settextstyle", 1, 0, 1]]}
"""Calls of an earlier case that show in a later one: the file of the last font, in a message."""

ALIKE = [name for name in CASES if name not in ON_PURPOSE]


@pytest.mark.parametrize("name", ALIKE)
def test_drawn_and_answered_alike(name):
    got, expected, answers = compared(CASES[name], LEFT_OVER.get(name, []))
    assert_same(got, expected, name.replace("/", "-"))
    assert answers == CASES[name]["results"]


@pytest.mark.parametrize("name", ON_PURPOSE)
def test_different_on_purpose(name):
    """A case that has become alike leaves the list."""
    got, expected, answers = compared(CASES[name])
    assert (got != expected).any() or answers != CASES[name]["results"]


def test_the_page_about_it_tells_how_many_are_the_same():
    """`docs/fidelity.md`: `group` cases, or `group` same of cases."""
    page = Path(__file__).parents[2] / "docs" / "fidelity.md"
    told = re.findall(r"`(\w+)` (?:(\d+) of )?(\d+)(?=,| \|)", page.read_text("utf-8"))
    cases = Counter(name.split("/")[0] for name in CASES)
    different = Counter(name.split("/")[0] for name in ON_PURPOSE)
    assert {group: int(count) for group, _, count in told} == cases
    assert {g: int(count) - int(same) for g, same, count in told if same} == different
    assert f"Together {len(ALIKE)} of {len(CASES)}." in page.read_text("utf-8")
