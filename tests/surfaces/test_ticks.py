"""The numbers at axes and bars of colours: round, short, each told from the next, each readable."""

import re
from decimal import Decimal
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces import Text, surface
from surfaces.ticks import ROOM, Labels, labels, ticks
from tests.surfaces.test_around import Writer


@pytest.mark.parametrize(
    ("low", "high", "about", "expected"),
    [
        (0, 10, 5, [0, 2, 4, 6, 8, 10]),
        (-1, 1, 5, [-1, -0.5, 0, 0.5, 1]),
        (0.13, 0.97, 4, [0.2, 0.4, 0.6, 0.8]),
        (0, 1e6, 5, [0, 2e5, 4e5, 6e5, 8e5, 1e6]),
        (0, 1, 5, [0, 0.2, 0.4, 0.6, 0.8, 1]),  # 3 times 0.2 was 0.6000000000000001
        (0.13, 0.97, 1, [0.2, 0.4, 0.6, 0.8]),  # 0.5 would stand alone
        (1e16, 1e16 + 4, 5, [1e16, 1e16 + 2, 1e16 + 4]),  # all that there are
        (5, 5, 4, [5]),
    ],
)
def test_ticks(low: float, high: float, about: int, expected: list[float]) -> None:
    assert ticks(low, high, about) == expected


def test_one_tick_may_be_enough() -> None:
    assert ticks(0.13, 0.97, 1, least=1) == [0.5]


def value(text: str, note: str) -> float:
    """What a reader makes of a number and the note to it."""
    found = re.fullmatch(r"(?:\*(1e-?\d+))? ?([+-].*)?", note)
    assert found, note
    return float(Decimal(text) * Decimal(found[1] or 1) + Decimal(found[2] or 0))


lows = st.one_of(st.floats(-1e6, 1e6), st.floats(-1e30, 1e30), st.integers(-(10**9), 10**9))
sizes = st.one_of(st.floats(1e-30, 1e30), st.floats(1e-6, 1e6), st.integers(1, 10**6))


@given(lows, sizes, st.integers(1, 12))
def test_ticks_are_round_and_inside(low: float, size: float, about: int) -> None:
    high = float(low) + float(size)
    found = ticks(low, high, about)
    slack = 1e-6 * size + 4 * abs(low + size) * 2.0**-52
    assert all(low - slack <= tick <= high + slack for tick in found)
    assert len(found) <= 2 * about + 5
    if size > 1e-12 * abs(low):
        assert len(found) >= 2


@given(lows, sizes, st.integers(1, 12))
def test_numbers_differ_and_are_those_of_their_ticks(low: float, size: float, about: int) -> None:
    found = ticks(low, float(low) + float(size), about)
    texts, note = labels(found)
    if len(found) > 1:
        assert len(set(texts)) == len(found)
        assert [value(text, note) for text in texts] == found


@given(lows, sizes, st.integers(1, 12))
def test_numbers_keep_to_their_room(low: float, size: float, about: int) -> None:
    texts, _ = labels(ticks(low, float(low) + float(size), about))
    assert max(map(len, texts)) <= ROOM


@given(st.floats(-1e30, 1e30))
def test_a_number_alone_has_five_digits(number: float) -> None:
    (text,), note = labels([number])
    assert len(text) <= ROOM + 1
    assert value(text, note) == pytest.approx(number, rel=1e-4, abs=1e-300)


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([0.0, 0.5, 1.0], Labels(["0.0", "0.5", "1.0"], "")),
        ([-2.0, 0.0, 2.0], Labels(["-2", "0", "2"], "")),
        ([-0.0, 1.0], Labels(["0", "1"], "")),
        ([5.25], Labels(["5.25"], "")),
        ([0.0, 2e5, 4e5], Labels(["0", "200000", "400000"], "")),
        ([0.0, 2e6, 4e6], Labels(["0", "2", "4"], "*1e6")),
        ([-1e6, -5e5, 0.0], Labels(["-1.0", "-0.5", "0.0"], "*1e6")),
        ([0.0, 2e-6, 4e-6], Labels(["0", "2", "4"], "*1e-6")),
        ([1e5, 100010, 100020], Labels(["100000", "100010", "100020"], "")),
        ([1e6, 1000010, 1000020], Labels(["0", "10", "20"], "+1e6")),
        ([1234560, 1234570, 1234580], Labels(["60", "70", "80"], "+1234500")),
        ([-1000006, -1000004, -1000002], Labels(["4", "6", "8"], "-1000010")),
        ([999999.5, 1e6, 1000000.5], Labels(["-0.5", "0.0", "0.5"], "+1e6")),
        ([2020.5, 2020.55, 2020.6], Labels(["0.50", "0.55", "0.60"], "+2020")),
        ([1.0, 1.0000002, 1.0000004], Labels(["0", "2", "4"], "*1e-7 +1")),
        ([], Labels([], "")),
    ],
)
def test_labels(values: list[float], expected: Labels) -> None:
    assert labels(values) == expected


# On the screen -----------------------------------------------------------------------------------

AXES: list[dict[str, Any]] = [
    {"x": (1e6, 1e6 + 6), "y": (1000.5, 1000.75)},
    {"x": (-3, 3), "y": (-1e-7, 1e-7)},
    {"x": (100_000, 100_030), "y": (1.7e9, 1.7e9 + 3600)},
]


def written(view: str, heights: float, **domain: Any) -> list[tuple[int, int, str]]:
    page = Writer(640, 480)
    low, high = domain["x"]
    surface(
        lambda x, y: heights + (x - low) / (high - low) + 0 * y,
        **domain,
        n=4,
        mode="wire",
        projection=view,
        axes=True,
        colorbar=True,
        on=page,
    )
    return page.texts


@pytest.mark.parametrize("view", ["paper", "isometric", "dimetric", "military", "top"])
@pytest.mark.parametrize("heights", [0, 2020.5, -1e7])
@pytest.mark.parametrize("domain", AXES)
def test_what_is_written_is_whole_and_touches_nothing(
    view: str, heights: float, domain: dict[str, Any]
) -> None:
    found = written(view, heights, **domain)
    assert found
    assert all(0 <= x <= 640 - 8 * len(text) and 0 <= y <= 472 for x, y, text in found)
    for number, (x, y, text) in enumerate(found):
        for x2, y2, other in found[:number]:
            across = x < x2 + 8 * len(other) and x2 < x + 8 * len(text)
            assert not (across and abs(y - y2) < 8), (text, other)


def test_what_belongs_to_all_numbers_is_written_once() -> None:
    found = [text for _, _, text in written("paper", 12340.5, x=(1e6, 1e6 + 6), y=(0, 1))]
    assert found.count("x (+1e6)") == 1
    assert found.count("z (+12340)") == 1
    assert found.count("+12340") == 1  # the bar's
    assert "y" in found


@pytest.mark.parametrize("view", ["paper", "isometric", "dimetric", "military"])
def test_long_names_find_a_place(view: str) -> None:
    names = ("Easting in metres", "Northing in metres", "Height above sea")
    page = Writer(640, 480)
    for domain in ((0, 1), (1e6, 1e6 + 6)):
        page.texts.clear()
        how: dict[str, Any] = {"axes": names, "colorbar": True, "projection": view, "on": page}
        surface(lambda x, y: x * y, domain, domain, n=4, mode="wire", **how)
        ends = [x + 8 * len(text) for x, _, text in page.texts if text.startswith(names)]
        assert len(ends) == 3
        assert max(ends) <= 640 - 9 * 8  # where the bar of colours begins


def test_a_page_of_text_has_notes_too() -> None:
    page = Text(78, 40)
    surface(lambda x, y: x + 0 * y, (1e6, 1e6 + 6), (0, 1), n=4, mode="wire", axes=True, on=page)
    assert "(+1e6)" in str(page)
