"""check.projection and check.paper: the right formula passes, each usual mistake gets its hint."""

from math import cos, degrees, radians, sin

import pytest

from bgi.lab import check


def projection(x, y, z, d):
    return x * d / (d + z), y * d / (d + z)


def paper(x, y, z, theta, x0, y0):
    return x0 + y - x * sin(theta), y0 - z + x * cos(theta)


def test_the_right_ones_pass():
    assert check.projection(projection)
    assert check.paper(paper)


EYE = {
    "a parallel projection": lambda x, y, z, d: (x, y),
    "not from the eye": lambda x, y, z, d: (x * d / z, y * d / z) if z else (0, 0),
    "z grows away from the eye": lambda x, y, z, d: (
        (x * d / (d - z), y * d / (d - z)) if d != z else (0, 0)
    ),
    "upside down: what is farther": lambda x, y, z, d: (x * (d + z) / d, y * (d + z) / d),
    "multiply by the distance: what": lambda x, y, z, d: (x / (d + z), y / (d + z)),
    "y is divided, too": lambda x, y, z, d: (x * d / (d + z), y),
    "x is divided, too": lambda x, y, z, d: (x, y * d / (d + z)),
    "x and y are exchanged": lambda x, y, z, d: projection(y, x, z, d),
    "it is upside down": lambda x, y, z, d: projection(-x, -y, z, d),
    "y has another sign": lambda x, y, z, d: projection(x, -y, z, d),
    "not by z": lambda x, y, z, d: (x * z / (d + z), y * z / (d + z)),
    "perspective divides": lambda x, y, z, d: (x + z, y + z),
    "// cuts the fraction off": lambda x, y, z, d: (x * d // (d + z), y * d // (d + z)),
    "divide by distance + z": lambda x, y, z, d: (x * d / z, y * d / z),
    "rounded": lambda x, y, z, d: tuple(map(round, projection(x, y, z, d))),
    "two numbers, (x, y)": lambda x, y, z, d: (*projection(x, y, z, d), z),
}

PAPER = {
    "sin and cos are exchanged": lambda x, y, z, t, x0, y0: (
        x0 + y - x * cos(t),
        y0 - z + x * sin(t),
    ),
    "z goes up": lambda x, y, z, t, x0, y0: paper(x, y, -z, t, x0, y0),
    "x goes to the left: x0": lambda x, y, z, t, x0, y0: (
        x0 + y + x * sin(t),
        y0 - z + x * cos(t),
    ),
    "x goes down: y0": lambda x, y, z, t, x0, y0: (x0 + y - x * sin(t), y0 - z - x * cos(t)),
    "the origin is missing": lambda x, y, z, t, x0, y0: paper(x, y, z, t, 0, 0),
    "x and y are exchanged": lambda x, y, z, t, x0, y0: paper(y, x, z, t, x0, y0),
    "in radians already": lambda x, y, z, t, x0, y0: paper(x, y, z, radians(t), x0, y0),
    "sin and cos want it": lambda x, y, z, t, x0, y0: paper(x, y, z, degrees(t), x0, y0),
    "x is not used": lambda x, y, z, t, x0, y0: (x0 + y, y0 - z),
    "x goes down, too": lambda x, y, z, t, x0, y0: (x0 + y - x * sin(t), y0 - z),
    "x goes to the left, too": lambda x, y, z, t, x0, y0: (x0 + y, y0 - z + x * cos(t)),
    "z is not used": lambda x, y, z, t, x0, y0: paper(x, y, 0, t, x0, y0),
    "x0 and y0 are exchanged": lambda x, y, z, t, x0, y0: paper(x, y, z, t, y0, x0),
    "the two results": lambda x, y, z, t, x0, y0: paper(x, y, z, t, x0, y0)[::-1],
    "rounded": lambda x, y, z, t, x0, y0: tuple(map(int, paper(x, y, z, t, x0, y0))),
}

TABLE = [("projection", *row) for row in EYE.items()] + [("paper", *row) for row in PAPER.items()]


@pytest.mark.parametrize(("exercise", "hint", "function"), TABLE, ids=[row[1] for row in TABLE])
def test_each_mistake_gets_its_hint(exercise, hint, function):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
