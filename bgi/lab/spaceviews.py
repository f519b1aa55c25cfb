"""From space to the screen: perspective, and the paper's map.

Sandipan Dey, Ajith Abraham, Sugata Sanyal: "A Very Simple Approach for 3-D to 2-D Mapping",
equation 1, gives the second.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import cos, degrees, pi, radians, sin

from bgi.lab.answered import AnswerExercise, Arguments, Slip, point

Point = tuple[float, float]


def projection(x: float, y: float, z: float, distance: float) -> Point:
    """Where the line to the eye meets the screen.

    The screen is the plane z = 0, the eye lies `distance` before it, and z grows away from the eye.
    """
    part = distance / (distance + z)
    return x * part, y * part


def paper(x: float, y: float, z: float, theta: float, x0: float, y0: float) -> Point:
    """The paper's equation 1: y to the right, z up, x to the lower left."""
    return x0 + y - x * sin(theta), y0 - z + x * cos(theta)


def _places() -> Iterator[Arguments]:
    yield 10, 20, 0, 100
    yield 10, 20, 100, 100
    yield from product((-50, 0, 7), (-30, 0, 80), (-40, 0, 25, 300), (50, 200))


def _corners() -> Iterator[Arguments]:
    for x, y, z in ((0, 0, 0), (0, 50, 0), (0, 0, 50), (50, 0, 0)):
        yield x, y, z, pi / 4, 320, 240
    yield from product((-60, 20), (-5, 100), (-30, 40), (pi / 4, pi / 6, 1.2), (320, 100), (240,))


EXERCISES = {
    "projection": AnswerExercise(
        "projection",
        ("x", "y", "z", "distance"),
        _places,
        projection,
        point,
        [
            Slip(lambda x, y, z, d: (x, y), "that is a parallel projection: z is not used"),
            Slip(
                lambda x, y, z, d: (x * d / z, y * d / z),
                "z is counted from the screen, not from the eye: divide by distance + z",
            ),
            Slip(
                lambda x, y, z, d: projection(x, y, abs(z), d),
                "z may be less than 0, and things larger than they are: no abs()",
            ),
            Slip(
                lambda x, y, z, d: (x * d / (d - z), y * d / (d - z)),
                "what is farther away is smaller: z grows away from the eye, distance + z",
            ),
            Slip(
                lambda x, y, z, d: (x * (d + z) / d, y * (d + z) / d),
                "the fraction is upside down: what is farther away is smaller",
            ),
            Slip(
                lambda x, y, z, d: (x / (d + z), y / (d + z)),
                "multiply by the distance: what lies in the screen stays as it is",
            ),
            Slip(lambda x, y, z, d: (x * d / (d + z), y), "y is divided, too"),
            Slip(lambda x, y, z, d: (x, y * d / (d + z)), "x is divided, too"),
            Slip(lambda x, y, z, d: projection(y, x, z, d), "x and y are exchanged"),
            Slip(
                lambda x, y, z, d: (-x * d / (d + z), -y * d / (d + z)),
                "it is upside down: the screen lies between the eye and the thing",
            ),
            Slip(
                lambda x, y, z, d: (x * d / (d + z), -y * d / (d + z)),
                "y has another sign: it grows downwards in space, too",
            ),
            Slip(
                lambda x, y, z, d: (x * z / (d + z), y * z / (d + z)),
                "multiply by the distance of the screen, not by z",
            ),
            Slip(
                lambda x, y, z, d: (x + z, y + z),
                "that moves things: perspective divides, by (distance + z) in brackets",
            ),
            Slip(
                lambda x, y, z, d: (x * d // (d + z), y * d // (d + z)),
                "// cuts the fraction off: divide by /",
            ),
            Slip(
                lambda x, y, z, d: (x / z, y / z),
                "z is counted from the screen, and the distance is missing: x * distance /"
                " (distance + z)",
            ),
            *(
                Slip(
                    lambda x, y, z, d, sign=sign: (
                        320 + x * d / (d + z),
                        240 + sign * y * d / (d + z),
                    ),
                    "0, 0 is in the middle of the answer, too: nothing is added",
                )
                for sign in (1, -1)
            ),
            Slip(
                lambda x, y, z, d: (x * d / (d + z) ** 2, y * d / (d + z) ** 2),
                "divide by distance + z once, not by its square",
            ),
            Slip(
                lambda x, y, z, d: (x * (1 - z / d), y * (1 - z / d)),
                "1 - z / distance is only nearly right, and only near the screen: divide by"
                " distance + z",
            ),
            Slip(
                lambda x, y, z, d: projection(x, y, z, 100),
                "the distance is given: use that, no fixed one",
            ),
            Slip(
                lambda x, y, z, d: (x * d / (z - d), y * d / (z - d)),
                "the eye lies at z = -distance, before the screen: divide by distance + z",
            ),
        ],
        {"ZeroDivisionError": "the eye is `distance` before the screen: divide by distance + z"},
        otherwise="by similar triangles x and y are multiplied by distance / (distance + z)",
    ),
    "paper": AnswerExercise(
        "paper",
        ("x", "y", "z", "theta", "x0", "y0"),
        _corners,
        paper,
        point,
        [
            Slip(
                lambda x, y, z, t, x0, y0: (x0 + y - x * cos(t), y0 - z + x * sin(t)),
                "sin and cos are exchanged: theta is measured from the vertical",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, -z, t, x0, y0),
                "z goes up, and y of the screen goes down: y0 - z",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, -t, x0, y0),
                "x goes to the left: x0 + y - x * sin(theta)",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, pi - t, x0, y0),
                "x goes down: y0 - z + x * cos(theta)",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, t, 0, 0),
                "the origin is missing: add x0 and y0",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(y, x, z, t, x0, y0),
                "x and y are exchanged: y goes to the right, x to the lower left",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, radians(t), x0, y0),
                "theta comes in radians already",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, degrees(t), x0, y0),
                "theta comes in radians, and so sin and cos want it",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: (x0 + y, y0 - z),
                "x is not used: it goes to the lower left",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: (x0 + y - x * sin(t), y0 - z),
                "x goes down, too: + x * cos(theta)",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: (x0 + y, y0 - z + x * cos(t)),
                "x goes to the left, too: - x * sin(theta)",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: (x0 + y - x * sin(t), y0 + x * cos(t)),
                "z is not used: it goes up",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, t, y0, x0),
                "x0 and y0 are exchanged",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, pi / 4, x0, y0),
                "theta is given: 45 degrees are only an example",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, t, 320, 240),
                "x0 and y0 are given: 320 and 240 are only an example",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x / 2, y, z, t, x0, y0),
                "x is not halved: the paper shortens nothing",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(-x, y, z, t, x0, y0),
                "x goes to the lower left: - x * sin(theta), + x * cos(theta)",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, -y, z, t, x0, y0),
                "y goes to the right: x0 + y",
            ),
            Slip(
                lambda x, y, z, t, x0, y0: paper(x, y, z, t, x0, y0)[::-1],
                "the two results are exchanged: first how far right, then how far down",
            ),
        ],
        otherwise="x' = x0 + y - x * sin(theta), and y' = y0 - z + x * cos(theta)",
    ),
}
