"""Ticks of logarithmic axes."""

from math import log10

import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces.decades import between, labels, ticks


def axis(low: float, high: float, about: int = 5, least: int = 2) -> list[str]:
    return labels(ticks(log10(low), log10(high), about, least)).texts


@pytest.mark.parametrize(
    ("low", "high", "texts"),
    [
        (1, 1000, ["1", "10", "100", "1000"]),
        (0.001, 10, ["0.001", "0.01", "0.1", "1", "10"]),
        (1e-5, 0.1, ["1e-5", "1e-4", "1e-3", "1e-2", "1e-1"]),
        (1e-6, 1e6, ["1e-6", "1e-3", "1e0", "1e3", "1e6"]),
        (1e-300, 1e300, ["1e-300", "1e-200", "1e-100", "1e0", "1e100", "1e200", "1e300"]),
        (3, 400, ["10", "100"]),
        (3, 40, ["3", "10", "30"]),
        (2, 7, ["2", "5"]),
        (1.2, 1.45, ["1.20", "1.25", "1.30", "1.35", "1.40", "1.45"]),
    ],
)
def test_labels(low: float, high: float, texts: list[str]) -> None:
    assert axis(low, high) == texts


def test_far_from_one_labels_share_what_they_have_in_common() -> None:
    found = ticks(log10(1_000_000), log10(1_000_006), 5, 2)
    assert found == pytest.approx([1_000_000 + n for n in range(7)])
    assert labels(found) == (["0", "1", "2", "3", "4", "5", "6"], "+1e6")


def test_one_number_alone() -> None:
    assert axis(5, 5) == ["5"]


def test_between_powers_are_the_steps_of_each_and_between_few_powers_the_others() -> None:
    def small(low: float, high: float) -> list[float]:
        return between(ticks(log10(low), log10(high), 5, 2), log10(low), log10(high))

    assert small(7, 130) == [7, 8, 9, 20, 30, 40, 50, 60, 70, 80, 90]
    assert small(1e-4, 1e4) == [1e-3, 1e-1, 10, 1000]
    assert small(1.2, 1.45) == []


@given(st.floats(-250, 250), st.floats(1e-6, 300), st.integers(1, 60), st.integers(1, 2))
def test_always_enough_ascending_and_inside(
    low: float, width: float, about: int, least: int
) -> None:
    high = min(low + width, 300.0)
    found = ticks(low, high, about, least)
    assert len(found) >= least
    assert found == sorted(set(found))
    assert log10(found[0]) >= low - 1e-8
    assert log10(found[-1]) <= high + 1e-8
    assert len(set(labels(found).texts)) == len(found)
