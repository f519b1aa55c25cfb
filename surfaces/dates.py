"""Round dates for an axis, and how they are written.

Ticks are steps of the calendar: years, months, days, hours, minutes, seconds. Labels tell what
changes from one to the next; what all have in common is written once, in a note, by ISO 8601, where
"2026-11-25/26" is from the 25th to the 26th.
"""

from collections.abc import Sequence
from math import log10

import numpy as np

from surfaces import ticks as even
from surfaces.ticks import Labels

SECONDS = {"Y": 31_556_952, "M": 2_629_746, "D": 86_400, "h": 3600, "m": 60, "s": 1}
"""Of each unit; of a year and a month in the mean."""
COUNTS = {
    "Y": (1000, 500, 200, 100, 50, 20, 10, 5, 2, 1),
    "M": (6, 3, 2, 1),
    "D": (15, 10, 5, 2, 1),
    "h": (12, 6, 3, 2, 1),
    "m": (30, 15, 10, 5, 2, 1),
    "s": (30, 15, 10, 5, 2, 1),
}
STEPS = [(count, unit) for unit, counts in COUNTS.items() for count in counts]
"""From the longest to the shortest; each is counted from the beginning of a longer unit."""
MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
SECOND = np.timedelta64(1, "s")
PARTS = {"us": 10**6, "ns": 10**9}
"""Of a second."""


def ticks(start: np.datetime64, low: float, high: float, about: int, least: int) -> list[float]:
    """Round dates, in seconds from the start: about as many as asked for, and at least so many."""
    if not low < high:
        return [low]
    rough = (high - low) / max(1, about)
    sizes = [abs(log10(count * SECONDS[unit] / rough)) for count, unit in STEPS]
    for count, unit in STEPS[sizes.index(min(sizes)) :] if 2 * rough > 1 else []:
        found = _multiples(count, unit, start, low, high)
        if len(found) >= least:
            return found
    since = _since_minute(start, low)
    return [tick - since for tick in even.ticks(low + since, high + since, about, least)]


def _multiples(count: int, unit: str, start: np.datetime64, low: float, high: float) -> list[float]:
    """The beginnings of every `count`-th unit from low to high."""
    first, last = (_date(start, end).astype(f"datetime64[{unit}]") for end in (low, high))
    dates = np.arange(first, last + 1)
    if unit == "D":  # of a month; its 31st day would be next to another first
        number = (dates - dates.astype("datetime64[M]")).astype(np.int64)
        dates = dates[(number % count == 0) & ((number < 30) | (count == 1))]
    else:
        number = dates.astype(np.int64) + (1970 if unit == "Y" else 0)
        dates = dates[number % count == 0]
    seconds = (dates.astype("datetime64[s]") - start) / SECOND
    found: list[float] = seconds[(seconds >= low) & (seconds <= high)].tolist()
    return found


def labels(start: np.datetime64, found: Sequence[float]) -> Labels:
    """Seconds from the start as text, without what all have in common; and that as a note."""
    if any(tick % 1 for tick in found):
        return _parts_of_seconds(start, found)
    dates = start + np.array(found).astype("timedelta64[s]")
    unit = next(unit for unit in "YMDms" if (dates == dates.astype(f"datetime64[{unit}]")).all())
    stamps = [str(date) for date in dates]  # such as 2026-11-25T10:30:15
    years, days = sorted({stamp[:4] for stamp in stamps}), sorted({stamp[:10] for stamp in stamps})
    if unit == "Y":
        return Labels([stamp[:4] for stamp in stamps], "")
    if unit == "M" and len(years) > 1:
        return Labels([stamp[:7] for stamp in stamps], "")
    if unit == "M":
        return Labels([_day(stamp)[:3] for stamp in stamps], *years)
    if unit == "D":
        return Labels([_day(stamp) for stamp in stamps], _interval(years[0], years[-1]))
    midnight = "00:00:00" if len(days) > 1 else ""
    end = len("2026-11-25T10:30:15" if unit == "s" else "2026-11-25T10:30")
    texts = [_day(one) if one[11:] == midnight else one[11:end] for one in stamps]
    return Labels(texts, _interval(days[0], days[-1]))


def _parts_of_seconds(start: np.datetime64, found: Sequence[float]) -> Labels:
    """Seconds and their parts, counted from a whole minute that the note tells."""
    since = _since_minute(start, found[0])
    texts, note = even.labels([round(tick + since, 9) for tick in found])
    minute = _date(start, found[0]).astype("datetime64[m]")
    return Labels(texts, f"{note} s after {minute}".replace("T", " ").strip())


def _date(start: np.datetime64, seconds: float) -> np.datetime64:
    return start + np.timedelta64(round(seconds * 1e6), "us")


def _since_minute(start: np.datetime64, seconds: float) -> float:
    """The seconds from the whole minute before a date to the start."""
    return float((start - _date(start, seconds).astype("datetime64[m]")) / SECOND)


def _day(stamp: str) -> str:
    return f"{MONTHS[int(stamp[5:7]) - 1]} {int(stamp[8:10])}"


def _interval(first: str, last: str) -> str:
    """From one day, or year, to another, by ISO 8601: what they have in common once."""
    if first == last:
        return first
    common = next(length for length in (8, 5, 0) if first[:length] == last[:length])
    return f"{first}/{last[common:]}"
