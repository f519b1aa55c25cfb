"""Round numbers for an axis, and how they are written: short, and each told from the next.

Ticks are steps of 1, 2 or 5 times a power of ten, compare Heckbert's "Nice numbers for graph
labels" in Graphics Gems, 1990. What all labels of an axis have in common, a power of ten or a large
number to add, is written once, in a note, where they would be too long otherwise.
"""

from collections.abc import Sequence
from decimal import ROUND_FLOOR, Decimal
from math import ceil, floor, log10
from typing import NamedTuple

STEPS = (1, 2, 5)
FINER = 16
"""How many finer steps to try at most, for ticks enough."""
ROOM = 6
"""Characters of a label."""
DIGITS = 5
"""Of a number that stands alone, and need not be told from another."""


class Labels(NamedTuple):
    """The numbers at an axis as text."""

    texts: list[str]
    note: str
    """What makes the values of them, "*1e5", "+2020", "*1e-3 +2020"; mostly nothing."""


def ticks(low: float, high: float, about: int = 5, least: int = 2) -> list[float]:
    """Round numbers from low to high, about as many as asked for; not below `least`, if possible.

    Each is the double nearest to its decimal number, so that it is written in a few digits.
    """
    if not low < high:
        return [low]
    rough = (high - low) / max(1, about)
    first = len(STEPS) * floor(log10(rough))
    nearest = min(
        range(first, first + len(STEPS) + 1), key=lambda size: abs(log10(_step(size) / rough))
    )
    found: list[float] = []
    for size in range(nearest, nearest - FINER, -1):
        found = _multiples(size, low, high)
        if len(found) >= least:
            break
    return found


def _step(size: int) -> float:
    """The sizes of steps by number: ... 0 is 1, 1 is 2, 2 is 5, 3 is 10 ..."""
    power, place = divmod(size, len(STEPS))
    return float(f"{STEPS[place]}e{power}")


def _multiples(size: int, low: float, high: float) -> list[float]:
    """All multiples of a step from low to high, without those that no double tells apart."""
    step = _step(size)
    # A little more than the ends, so that rounding does not lose a tick on them.
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    power, place = divmod(size, len(STEPS))
    found = (float(f"{number * STEPS[place]}e{power}") for number in range(first, last + 1))
    return list(dict.fromkeys(found))


def labels(values: Sequence[float], room: int = ROOM) -> Labels:
    """Numbers as text of at most so many characters, all with the same decimals.

    Different numbers have different texts, and text and note give the number again to the last
    digit. (Only a number alone is rounded.)
    """
    numbers = [_decimal(value, alone=len(values) == 1) for value in values]
    offset = _common(numbers)
    rest = [number - offset for number in numbers]
    forms = [form for some in (numbers, rest) for form in (_plain(some), _scaled(some))]
    widths = [max(map(len, form.texts), default=0) for form in forms]
    fitting = (place for place, width in enumerate(widths) if width <= room)
    chosen = next(fitting, widths.index(min(widths)))
    texts, note = forms[chosen]
    return Labels(texts, f"{note} {_sign_and_digits(offset)}".strip() if chosen > 1 else note)


def _decimal(value: float, alone: bool) -> Decimal:
    """A float in the fewest digits that tell it from all others; rounded, if it stands alone."""
    value = float(value) + 0.0  # no "-0"
    return Decimal(f"{value:.{DIGITS - 1}e}" if alone else repr(value))


def _plain(numbers: list[Decimal]) -> Labels:
    """The numbers as they are, with as many decimals as one of them needs."""
    exponents = [int(number.normalize().as_tuple().exponent) for number in numbers]
    decimals = -min(exponents, default=0)
    return Labels([f"{number:.{max(0, decimals)}f}" for number in numbers], "")


def _scaled(numbers: list[Decimal]) -> Labels:
    """The numbers divided by a power of ten, so that the largest has one digit before the point."""
    power = max((number.adjusted() for number in numbers if number), default=0)
    texts, _ = _plain([number.scaleb(-power) for number in numbers])
    return Labels(texts, f"*1e{power}")


def _common(numbers: list[Decimal]) -> Decimal:
    """What can be taken from all of them: a multiple of a power of ten above their range.

    That is the next below the lowest, or one ten times as round among them, such as 2000.
    """
    if not numbers:
        return Decimal(0)
    lowest, highest = min(numbers), max(numbers)
    unit = Decimal(1).scaleb(((highest - lowest) or lowest).adjusted() + 1)
    rounder = (highest / unit / 10).to_integral_value(ROUND_FLOOR) * unit * 10
    below = (lowest / unit).to_integral_value(ROUND_FLOOR) * unit
    return rounder if rounder >= lowest else below


def _sign_and_digits(number: Decimal) -> str:
    """A number with its sign, plainly or by a power of ten, whichever is shorter."""
    number = number.normalize()
    return min(f"{number:+f}", f"{number:+e}".replace("e+", "e"), key=len)
