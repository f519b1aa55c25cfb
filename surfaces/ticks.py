"""Round numbers for an axis: steps of 1, 2 or 5 times a power of ten.

Compare Heckbert's "Nice numbers for graph labels" in Graphics Gems, 1990.
"""

from math import ceil, floor, log10

STEPS = (1, 2, 5, 10)


def ticks(low: float, high: float, about: int = 5) -> list[float]:
    """Round numbers from low to high, about as many as asked for, or none."""
    if not low < high:
        return [low]
    rough = (high - low) / max(1, about)
    power = 10.0 ** floor(log10(rough))
    step = min((factor * power for factor in STEPS), key=lambda size: abs(log10(size / rough)))
    # A little more than the ends, so that rounding does not lose a tick on them.
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def labels(values: list[float]) -> list[str]:
    """The numbers as short text, all with the same decimals."""
    if len(values) < 2:
        return [f"{value:.4g}" for value in values]
    step, largest = values[1] - values[0], max(map(abs, values))
    decimals = max(0, -floor(log10(step) + 1e-9))
    if largest >= 1e5 or decimals > 4:
        texts = [f"{value:.{max(0, floor(log10(largest / step)))}e}" for value in values]
        return [text.replace("e+0", "e").replace("e-0", "e-") for text in texts]
    return [f"{value + 0.0:.{decimals}f}" for value in values]
