"""Text, in the font of 8x8 and in stroked ones."""

import random

from bench import calls
from bench.arguments import CALLS, Make, always, within
from bench.calls import Call
from bench.timing import Arguments, Row

TRIPLEX = (("settextstyle", 1, 0, 4),)
SANS = (("settextstyle", 3, 0, 1),)
DOUBLED = (("settextstyle", 0, 0, 2),)
WORDS = "Twenty characters..."
same = within(200, 40, WORDS)


def changing(count: int = CALLS) -> Make:
    """Twenty letters that are others each time, as of a score or a clock."""

    def make(dice: random.Random) -> Arguments:
        return [
            (dice.randrange(440), dice.randrange(440), f"Score: {dice.random():.12f}"[:20])
            for _ in range(count)
        ]

    return make


TABLE = [
    Call("outtextxy, 20 characters", "outtextxy", same),
    Call("outtextxy, changing", "outtextxy", changing(), cold=True),
    Call("outtextxy, size 2", "outtextxy", same, DOUBLED),
    Call("outtextxy, TRIPLEX", "outtextxy", within(600, 60, WORDS, count=50), TRIPLEX),
    Call("outtextxy, TRIPLEX, changing", "outtextxy", changing(50), TRIPLEX, cold=True),
    Call("outtextxy, SANS SERIF", "outtextxy", within(400, 60, WORDS, count=50), SANS),
    Call("textwidth, TRIPLEX", "textwidth", always(WORDS), TRIPLEX),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("text", TABLE)
