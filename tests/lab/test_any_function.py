"""Whatever a function draws or answers, it gets a verdict: no hint's search ends in an error."""

import random
from itertools import pairwise

import pytest

from bgi import putpixel
from bgi.lab import check

DRAWN = {
    "line": "x1, y1, x2, y2, color",
    "circle": "x, y, radius, color",
    "ellipse": "x, y, xradius, yradius, color",
    "polygon": "points, color",
    "boundary": "x, y, color, border",
    "flood": "x, y, color",
}


def drawer(parameters, seed):
    """A function that sets some pixels, near what it is given or anywhere, or none, or fails."""
    chance = random.Random(seed)
    count, near, lazy = chance.choice([1, 2, 5, 30]), chance.random() < 0.7, chance.random()

    def draw(*given):
        if chance.random() < lazy - 0.5:
            return
        if chance.random() < 0.02:
            raise chance.choice([ValueError, IndexError, ZeroDivisionError, TypeError])
        numbers = [value for value in given if isinstance(value, int)]
        for _ in range(count):
            aside, down = (chance.randrange(-3, 4) for _ in range(2))
            x, y = (chance.choice(numbers) if near else chance.randrange(479) for _ in range(2))
            putpixel(x + aside, y + down, chance.choice([numbers[-1], 15, 0]))

    names = {"draw": draw}
    return eval(f"lambda {parameters}: draw({parameters})", names)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("exercise", DRAWN)
def test_any_drawing_gets_a_verdict(exercise, seed):
    verdict = getattr(check, exercise)(drawer(DRAWN[exercise], seed))
    assert not verdict and verdict.reason


ANSWERS = [
    *(None, 0, 1.5, "x", (), [], (1, 2), (1, 2, 3, 4), [(1, 2), (3, 4), (5, 6)], [[1, 0, 0]] * 3),
    *([[1, 0, 0], [0, 1, 0], [0, 0, 1]], float("nan"), [float("inf")] * 2, (200, 140, 300, 140)),
    *({}, [[]], [(1,)], object(), None),
]
ANSWERED = {
    **{"clip_line": 8, "clip_polygon": 5, "translation": 2, "scaling": 2, "rotation": 1},
    **{"about": 3, "window_to_viewport": 2, "bezier": 2, "casteljau": 2, "bspline": 2},
    **{"projection": 4, "paper": 6},
}


@pytest.mark.parametrize("exercise", ANSWERED)
def test_any_answer_gets_a_verdict(exercise):
    parameters = ", ".join("abcdefgh"[: ANSWERED[exercise]])
    for both in [*pairwise(ANSWERS), ([], [(1, 2), (3, 4), (5, 6)])]:
        odd = {"both": both, "odd": lambda *given: len(repr(given)) % 2}
        function = eval(f"lambda {parameters}: both[odd({parameters})]", odd)
        verdict = getattr(check, exercise)(function)
        assert not verdict and verdict.reason
