"""What the public functions cost, in multiples of an empty Python call.

One unit is the time of `def empty(a, b, c): pass`, called as a script calls it: in a loop at module
level, `for a, b, c in many: function(a, b, c)`. Everything else runs in the same kind of loop. The
unit is taken anew beside every row, and of several rounds the quickest counts, so that rows compare
on any machine, however busy.
"""

import random
import time
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

import bgi

CALLS = 400
ROUNDS = 25


class Row(NamedTuple):
    """One measured call: what it is, the budget in units (None: no budget), how to prepare it."""

    name: str
    budget: float | None
    function: Callable[..., object]
    arguments: Sequence[tuple[Any, ...]]
    before: Callable[[], object] = lambda: None


def empty(a: object, b: object, c: object) -> None:
    """The unit."""


def seconds_per_call(function: Callable[..., object], many: Sequence[tuple[Any, ...]]) -> float:
    """The quickest of several rounds, per call."""
    names = ", ".join("abcd"[: len(many[0])])
    head = f"for {names}, in many" if names else "for _ in many"
    loop = compile(f"{head}: function({names})", "a script", "exec")
    script = {"function": function, "many": many}
    best = float("inf")
    for _ in range(ROUNDS):
        start = time.perf_counter()
        exec(loop, script)
        best = min(best, time.perf_counter() - start)
    return best / len(many)


def unit() -> float:
    """Seconds that an empty call takes just now."""
    return seconds_per_call(empty, [(1, 2, 3)] * CALLS)


def random_points(count: int, seed: int = 1) -> list[tuple[int, int]]:
    """Points all over a 640x480 screen."""
    dice = random.Random(seed)
    return [(dice.randrange(640), dice.randrange(480)) for _ in range(count)]


def rows() -> list[Row]:
    """The table: every call that has a budget, and a few beside it."""
    points = random_points(CALLS)
    ends = [(*a, *b) for a, b in zip(points, random_points(CALLS, seed=2), strict=True)]
    short = [(x % 600, y % 450, x % 600 + 10, y % 450 + 5) for x, y in points]
    boxes = [(x % 580, y % 420, x % 580 + 49, y % 420 + 49) for x, y in points]
    big_boxes = [(x % 530, y % 370, x % 530 + 99, y % 370 + 99) for x, y in points]
    centres = [(50 + x % 540, 50 + y % 380, 50) for x, y in points]
    triangles = [
        (((x, y), (x + 50, y + 10), (x + 20, y + 50)),) for x, y, *_ in (box[:2] for box in boxes)
    ]
    texts = [(x % 470, y % 470, "Twenty characters...") for x, y in points]
    once = [()] * 20

    def plain() -> None:
        bgi.graphdefaults()

    return [
        Row("putpixel", 4, bgi.putpixel, [(*p, 5) for p in points]),
        Row("getpixel", 4, bgi.getpixel, points),
        Row("line, 10 pixels", 11, bgi.line, short),
        Row("line, random ends", 28, bgi.line, ends),
        Row("line, random, dashed", None, bgi.line, ends, lambda: bgi.setlinestyle(3, 0, 1)),
        Row("line, random, thick", None, bgi.line, ends, lambda: bgi.setlinestyle(0, 0, 3)),
        Row("line, random, XOR", None, bgi.line, ends, lambda: bgi.setwritemode(1)),
        Row("rectangle 100x100", None, bgi.rectangle, big_boxes, plain),
        Row("bar 50x50, solid", 20, bgi.bar, boxes),
        Row("bar 50x50, hatched", None, bgi.bar, boxes, lambda: bgi.setfillstyle(7, 4)),
        Row("circle r=50", 40, bgi.circle, centres, plain),
        Row("fillpoly, triangle of 50 px", None, bgi.fillpoly, triangles, plain),
        Row("outtextxy, 20 characters", 100, bgi.outtextxy, texts),
        Row("cleardevice", 200, bgi.cleardevice, once),
    ]


def report() -> None:
    """Print the table."""
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    print(f"{'call (640x480, 16 colours)':34}{'units':>8}{'budget':>8}{'microseconds':>15}")
    for row in rows():
        bgi.graphdefaults()
        row.before()
        seconds = seconds_per_call(row.function, row.arguments)
        budget = "" if row.budget is None else f"{row.budget:g}"
        print(f"{row.name:34}{seconds / unit():8.1f}{budget:>8}{seconds * 1e6:15.2f}")
    report_arrays()
    bgi.closegraph()


def report_arrays() -> None:
    """Print what one element of an array call costs."""
    count = 100_000
    rng = np.random.default_rng(1)
    x, y = rng.integers(0, 640, count), rng.integers(0, 480, count)
    color = rng.integers(0, 16, count)
    quads = rng.integers(0, 470, (10_000, 1, 2)) + np.array([[0, 0], [4, 1], [5, 5], [1, 4]])
    short = x[:10_000] % 630, y[:10_000] % 470, x[:10_000] % 630 + 8, y[:10_000] % 470 + 5
    calls: list[tuple[str, int, Callable[[], object]]] = [
        ("putpixel, array of 100,000", count, lambda: bgi.putpixel(x, y, color)),
        ("getpixel, array of 100,000", count, lambda: bgi.getpixel(x, y)),
        ("line, array of 10,000 x 8 px", 10_000, lambda: bgi.line(*short)),
        ("fillpoly, 10,000 quads of 5x5", 10_000, lambda: bgi.fillpoly(quads, color=0)),
        ("  the same with outlines", 10_000, lambda: bgi.fillpoly(quads)),
    ]
    print(f"\n{'array call':34}{'nanoseconds an element':>31}")
    for name, elements, call in calls:
        print(f"{name:34}{seconds_per_call(call, [()] * 3) / elements * 1e9:31.1f}")
