"""Ticks of a logarithmic axis: powers of ten, with finer steps where there are few of them.

`low` and `high` are logarithms to the base of ten; ticks are the numbers themselves.
"""

from collections.abc import Sequence
from decimal import Decimal
from math import ceil, floor, log10

from surfaces import ticks as even
from surfaces.ticks import ROOM, Labels

STRIDES = (1, 2, 3, 5, 10, 20, 30, 50, 100, 200)
"""From one power with a number to the next."""
FINER = ((1, 3), (1, 2, 5), tuple(range(1, 10)))
"""The first digits of ticks where powers of ten are too few."""
ROUNDING = 1e-9
"""So that no power is lost at an end."""


def ticks(low: float, high: float, about: int, least: int) -> list[float]:
    """Numbers with a round logarithm, about as many as asked for; not below `least`, if possible.

    Powers of ten as long as they are a third as many; within one power, round numbers.
    """
    if not low < high:
        return [float(10**low)]
    powers = range(ceil(low - ROUNDING), floor(high + ROUNDING) + 1)
    enough = max(least, about / 3)
    every_nth = [[k for k in powers if k % n == 0] for n in STRIDES]
    fitting = [chosen for chosen in every_nth if len(chosen) >= enough]
    if fitting:
        best = min(fitting, key=lambda chosen: abs(len(chosen) - about))
        return [float(f"1e{k}") for k in best]
    for digits in FINER:
        found = _multiples(digits, low, high)
        if len(found) >= enough:
            return found
    return even.ticks(float(10**low), float(10**high), about, least)


def between(found: Sequence[float], low: float, high: float) -> list[float]:
    """Where to mark more, without a number: the powers left out, or else the steps of each."""
    if not all(_leading(tick) for tick in found):
        return []
    powers = _multiples((1,), low, high)
    more = powers if set(powers) - set(found) else _multiples(FINER[-1], low, high)
    return [number for number in more if number not in found]


def labels(found: Sequence[float]) -> Labels:
    """Ticks as text: all plain, or all by their powers of ten."""
    if not all(_leading(tick) for tick in found):
        return even.labels(found)
    exponents = [floor(log10(tick) + ROUNDING) for tick in found]
    plain = [f"{tick:.{max(0, -k)}f}" for tick, k in zip(found, exponents, strict=True)]
    if max(map(len, plain), default=0) <= ROOM:
        return Labels(plain, "")
    return Labels([f"{_leading(tick)}e{k}" for tick, k in zip(found, exponents, strict=True)], "")


def _multiples(digits: Sequence[int], low: float, high: float) -> list[float]:
    """The numbers from low to high that are one digit of these and zeros."""
    numbers = (float(f"{digit}e{k}") for k in range(floor(low), ceil(high) + 1) for digit in digits)
    return [number for number in numbers if low - ROUNDING <= log10(number) <= high + ROUNDING]


def _leading(number: float) -> int:
    """The first digit of a number that has no other; else 0."""
    digits = Decimal(repr(number)).normalize().as_tuple().digits
    return digits[0] if len(digits) == 1 else 0
