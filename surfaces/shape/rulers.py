"""How numbers are laid out along an axis and marked: evenly, by powers of ten, by the calendar.

A surface is drawn where a ruler puts it: in *places*, which are the numbers themselves, their
logarithms, or seconds from a certain date. What a user gives becomes places on the way in, and what
a user reads off becomes numbers, or dates, on the way out; in between nobody knows.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from datetime import UTC, date, datetime
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfaces import dates, decades, ticks
from surfaces.arrays import Doubles, masks_exist
from surfaces.shape.sampling import MOST_POINTS, Interval, interval, real
from surfaces.ticks import Labels

Dates = NDArray[np.datetime64]
KINDS = (date, np.datetime64)
"""What a date may be; a datetime is a date, too."""
FARTHEST = 2.0**62
"""Steps of time that numpy can add to a date."""


class Marks(NamedTuple):
    """What is marked along an axis; all of it in places."""

    places: list[float]
    labels: Labels
    """Their numbers."""
    between: list[float]
    """Where there are smaller marks without a number."""


class Ruler(ABC):
    """An axis: how its numbers are laid out, and marked."""

    aside: ClassVar[int] = 3
    """Characters that may stand out of the picture at the right, where its numbers stand there."""

    @abstractmethod
    def place(self, given: Any, name: str) -> Doubles:
        """Where numbers belong, NaN for those that have no place; TypeError for no numbers."""

    @abstractmethod
    def read(self, places: Doubles) -> Any:
        """The numbers at places."""

    @abstractmethod
    def marks(self, low: float, high: float, about: int = 5, least: int = 2) -> Marks:
        """Round numbers from place to place, about as many as asked for."""

    def every(self, given: Any, name: str) -> Doubles:
        """The places of numbers; ValueError unless all of them have one."""
        places = self.place(given, name)
        if np.isnan(places).any():
            raise ValueError(f"{name} must be above 0 on a logarithmic axis, not {given!r:.60}")
        return places

    def ends(self, given: Any, name: str) -> Interval:
        """The places of an interval (a, b), as it was given; ValueError unless it is one."""
        low, high = self.every(interval(name, given), name).tolist()
        return low, high

    def axis(self, given: Any, name: str) -> Any:
        """The nodes or the ends of an axis, as they were given, as numbers."""
        return given

    def along(self, numbers: Doubles, name: str) -> Doubles:
        """The places of such numbers; ValueError unless all of them have one."""
        return numbers


class Even(Ruler):
    """Numbers as they are."""

    def place(self, given: Any, name: str) -> Doubles:
        return real(given, name)

    def read(self, places: Doubles) -> Any:
        return places

    def marks(self, low: float, high: float, about: int = 5, least: int = 2) -> Marks:
        found = ticks.ticks(low, high, about, least)
        return Marks(found, ticks.labels(found), [])


class Logarithmic(Ruler):
    """Logarithms to the base of ten; what is not above 0 has none."""

    def place(self, given: Any, name: str) -> Doubles:
        numbers = real(given, name)
        return np.log10(numbers, out=np.full(numbers.shape, np.nan), where=numbers > 0)

    def read(self, places: Doubles) -> Any:
        with np.errstate(over="ignore"):
            return 10.0**places

    def along(self, numbers: Doubles, name: str) -> Doubles:
        return self.every(numbers, name)

    def marks(self, low: float, high: float, about: int = 5, least: int = 2) -> Marks:
        found = decades.ticks(low, high, about, least)
        more = decades.between(found, low, high)
        return Marks(np.log10(found).tolist(), decades.labels(found), np.log10(more).tolist())


@dataclass(frozen=True)
class Calendar(Ruler):
    """Dates, by the seconds from a certain one."""

    aside: ClassVar[int] = 8
    start: np.datetime64
    """A whole second."""
    unit: str
    """How finely dates are told: "us" or "ns"."""

    @classmethod
    def of(cls, given: Dates, name: str) -> "Calendar":
        """A calendar that begins with the first of some dates, whatever their order."""
        known = given[~np.isnat(given)]
        if not known.size:
            raise ValueError(f"{name} must have a date")
        fine = np.datetime_data(given.dtype)[0] == "ns"
        return cls(known.flat[0].astype("datetime64[s]"), "ns" if fine else "us")

    def place(self, given: Any, name: str) -> Doubles:
        found = dates_of(given, name)
        if found is None:
            raise TypeError(f"{name} must be dates, as its axis has them, not {given!r:.60}")
        seconds: Doubles = (found - self.start) / dates.SECOND
        return seconds

    def read(self, places: Doubles) -> Any:
        steps = np.rint(np.multiply(places, dates.PARTS[self.unit]))
        known = np.abs(steps) < FARTHEST
        whole = np.where(known, steps, 0).astype(f"timedelta64[{self.unit}]")
        found = np.where(known, self.start + whole, np.datetime64("NaT"))
        return found[()]  # of no dimension: the date itself

    def marks(self, low: float, high: float, about: int = 5, least: int = 2) -> Marks:
        found = dates.ticks(self.start, low, high, about, least)
        return Marks(found, dates.labels(self.start, found), [])

    def ends(self, given: Any, name: str) -> Interval:
        places = self.place(given, name)
        if places.shape != (2,) or not places[0] < places[1]:
            raise ValueError(f"{name} must be (a, b) with dates a < b, not {given!r:.60}")
        low, high = places.tolist()
        return low, high

    def axis(self, given: Any, name: str) -> Any:
        return self.place(given, name)


EVEN = Even()
Rulers = tuple[Ruler, Ruler, Ruler]
"""Those of x, y and z."""
PLAIN: Rulers = (EVEN, EVEN, EVEN)


def rulers(log: str, x: Any, y: Any) -> Rulers:
    """The rulers of a surface: by the names of its logarithmic axes, and its x and y.

    Raises:
        ValueError: for dates on a logarithmic axis, or beyond the calendar.
    """
    found: dict[str, Ruler] = {name: Logarithmic() for name in log}
    for name, given in (("x", x), ("y", y)):
        known = dates_of(given, name)
        if known is not None:
            if name in log:
                raise ValueError(f"log must leave out {name}, which has dates, not be {log!r}")
            found[name] = Calendar.of(known, name)
    x_ruler, y_ruler, z_ruler = (found.get(name, EVEN) for name in "xyz")
    return x_ruler, y_ruler, z_ruler


def dates_of(given: Any, name: str) -> Dates | None:
    """Dates of any kind, by numpy's, in universal time if they have a zone; None if they are none.

    Raises:
        ValueError: for years before 1 or after 9999.
    """
    if getattr(given, "size", 0) > MOST_POINTS:
        return None
    if masks_exist() and isinstance(given, np.ma.MaskedArray) and given.dtype.kind == "M":
        given = given.filled(np.datetime64("NaT"))
    try:
        array = np.asarray(given)
    except ValueError:  # rows of different lengths
        return None
    if array.dtype.kind == "O" and any(isinstance(one, KINDS) for one in array.flat):
        if not all(one is None or isinstance(one, KINDS) for one in array.flat):
            return None
        each = [_universal(one) for one in array.flat]
        array = np.array(each, "datetime64[us]").reshape(array.shape)
    if array.dtype.kind != "M":
        return None
    years = array.astype("datetime64[Y]")
    if ((years < np.datetime64("0001")) | (years > np.datetime64("9999"))).any():
        raise ValueError(f"{name} must have dates of the years 1 to 9999")
    return array if np.datetime_data(array.dtype)[0] == "ns" else array.astype("datetime64[us]")


def _universal(one: Any) -> Any:
    """A date without its time zone, at the same moment."""
    aware = isinstance(one, datetime) and one.tzinfo is not None
    return one.astimezone(UTC).replace(tzinfo=None) if aware else one
