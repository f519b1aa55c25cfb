"""Round dates, and how they are written."""

from datetime import datetime

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfaces.dates import SECOND, labels, ticks


def axis(low: str, high: str, about: int = 5) -> str:
    start = np.datetime64(low[:10], "s")
    dates = np.array((low, high), "datetime64[us]")
    first, last = ((dates - start) / SECOND).tolist()
    texts, note = labels(start, ticks(start, first, last, about, 2))
    return " ".join(texts) + (f" ({note})" if note else "")


AXES = """
1000-01-01 6000-01-01: 1000 2000 3000 4000 5000 6000
1955-01-01 2026-01-01: 1960 1980 2000 2020
1999-05-01 2003-01-02: 2000 2001 2002 2003
2024-01-05 2026-01-06: 2024-07 2025-01 2025-07 2026-01
2026-02-01 2026-12-31: Mar May Jul Sep Nov (2026)
2026-11-20 2027-01-20: Nov 21 Dec 1 Dec 11 Dec 21 Jan 1 Jan 11 (2026/2027)
2028-02-20 2028-03-09: Feb 21 Feb 26 Mar 1 Mar 6 (2028)
2026-11-25 2026-11-29: Nov 25 Nov 26 Nov 27 Nov 28 Nov 29 (2026)
1969-12-30 1970-01-03: Dec 30 Dec 31 Jan 1 Jan 2 Jan 3 (1969/1970)
2026-11-25T08 2026-11-25T19: 08:00 10:00 12:00 14:00 16:00 18:00 (2026-11-25)
2026-11-25T08:10 2026-11-25T09:02: 08:10 08:20 08:30 08:40 08:50 09:00 (2026-11-25)
2026-11-25T21 2026-11-26T02: 21:00 22:00 23:00 Nov 26 01:00 02:00 (2026-11-25/26)
2026-11-30T12 2026-12-01T20: 12:00 18:00 Dec 1 06:00 12:00 18:00 (2026-11-30/12-01)
2026-12-31T18 2027-01-01T18: 18:00 Jan 1 06:00 12:00 18:00 (2026-12-31/2027-01-01)
2026-11-25T08:10:05 2026-11-25T08:10:08: 08:10:05 08:10:06 08:10:07 08:10:08 (2026-11-25)
2026-11-25T08:10:59.7 2026-11-25T08:11:00.5: 59.8 60.0 60.2 60.4 (s after 2026-11-25 08:10)
2026-11-25T08:10:10.000001 2026-11-25T08:10:10.000009: 2 4 6 8 (*1e-6 +10 s after 2026-11-25 08:10)
"""


@pytest.mark.parametrize("line", AXES.strip().splitlines())
def test_labels(line: str) -> None:
    ends, written = line.split(": ", 1)
    assert axis(*ends.split()) == written


def test_one_date_alone() -> None:
    start = np.datetime64("2026-11-25", "s")
    assert ticks(start, 3600.0, 3600.0, 5, 2) == [3600.0]
    assert labels(start, [3600.0]) == (["01:00"], "2026-11-25")


@given(
    st.datetimes(datetime(2, 1, 1)),
    st.floats(-5, 10.5),
    st.integers(1, 12),
)
def test_always_enough_ascending_inside_and_told_apart(
    first: datetime, power: float, about: int
) -> None:
    start = np.datetime64(first.replace(microsecond=0))
    high = min(10**power, float((np.datetime64("9999-12-31") - start) / SECOND))
    if high < 1e-5:
        return
    found = ticks(start, 0.0, high, about, 2)
    assert len(found) >= 2
    assert found == sorted(set(found))
    assert found[0] >= -1e-9
    assert found[-1] <= high + 1e-9
    texts, _ = labels(start, found)
    if all(":" not in text for text in texts):  # times of several days are told by the midnights
        assert len(set(texts)) == len(texts)
    assert max(map(len, texts)) <= 8
