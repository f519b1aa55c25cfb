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
    """One measured call: its budget in units, what the same takes with SDL_bgi from Python when
    nothing is shown (None: not known), and how to prepare it."""

    name: str
    budget: float | None
    sdl_bgi: float | None
    function: Callable[..., object]
    arguments: Sequence[tuple[Any, ...]]
    before: Callable[[], object] = lambda: None


def empty(a: object, b: object, c: object) -> None:
    """The unit."""


def seconds_per_call(function: Callable[..., object], many: Sequence[tuple[Any, ...]]) -> float:
    """The quickest of several rounds, per call."""
    names = ", ".join("abcdefgh"[: len(many[0])])
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
    corners = [(x % 530, y % 370) for x, y in points]
    once: list[tuple[()]] = [()] * 20
    image = bgi.Image(np.ones((100, 100), np.uint8))

    def box_to_fill() -> None:
        bgi.rectangle(99, 99, 300, 300)

    def fill_again() -> None:
        fill_again.color = 3 - fill_again.color  # type: ignore[attr-defined]
        bgi.setfillstyle(1, fill_again.color)  # type: ignore[attr-defined]
        bgi.floodfill(200, 200, 15)

    fill_again.color = 1  # type: ignore[attr-defined]

    def frame() -> None:
        bgi.cleardevice()
        for x1, y1, x2, y2 in ends[:100]:
            bgi.line(x1, y1, x2, y2)
        bgi.swapbuffers()

    return [
        Row("putpixel", 4, 7.8, bgi.putpixel, [(*p, 5) for p in points]),
        Row("getpixel", 4, 6.1, bgi.getpixel, points),
        Row("line, 10 pixels", 11, 11.5, bgi.line, short),
        Row("line, random ends", 28, 30, bgi.line, ends),
        Row("line, random, dashed", None, 25, bgi.line, ends, lambda: bgi.setlinestyle(3, 0, 1)),
        Row("line, random, thick", None, 74, bgi.line, ends, lambda: bgi.setlinestyle(0, 0, 3)),
        Row("line, random, XOR", None, 30, bgi.line, ends, lambda: bgi.setwritemode(1)),
        Row("rectangle 100x100", None, 33, bgi.rectangle, big_boxes),
        Row("circle r=50", 40, 26, bgi.circle, centres),
        Row(
            "ellipse 60x35", None, 47, bgi.ellipse, [(x, y, 0, 360, 60, 35) for x, y, _ in centres]
        ),
        Row(
            "arc r=50, 180 degrees", None, 110, bgi.arc, [(x, y, 0, 180, 50) for x, y, _ in centres]
        ),
        Row("bar 50x50, solid", 20, 155, bgi.bar, boxes),
        Row("bar 50x50, hatched", None, 402, bgi.bar, boxes, lambda: bgi.setfillstyle(7, 4)),
        Row("fillpoly, triangle of 50 px", None, 137, bgi.fillpoly, triangles),
        Row(
            "fillellipse 40x25", None, 665, bgi.fillellipse, [(x, y, 40, 25) for x, y, _ in centres]
        ),
        Row("floodfill 200x200", 5000, 15200, fill_again, once, box_to_fill),
        Row("outtextxy, 20 characters", 100, 114, bgi.outtextxy, texts),
        Row("cleardevice", 200, 6000, bgi.cleardevice, once),
        Row("getimage 100x100", None, 168, bgi.getimage, big_boxes),
        Row("putimage 100x100", 100, 484, bgi.putimage, [(*c, image, 0) for c in corners]),
        Row("putimage 100x100, XOR", None, 528, bgi.putimage, [(*c, image, 1) for c in corners]),
        Row("frame: clear, 100 lines, show", None, 17400, frame, once),
    ]


def report() -> None:
    """Print the table."""
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    print(f"{'call (640x480, 16 colours)':34}{'units':>8}{'budget':>8}{'SDL_bgi':>9}{'us':>10}")
    for row in rows():
        bgi.graphdefaults()
        bgi.cleardevice()
        row.before()
        seconds = seconds_per_call(row.function, row.arguments)
        budget, peer = (
            "" if number is None else f"{number:g}" for number in (row.budget, row.sdl_bgi)
        )
        units = seconds / unit()
        print(f"{row.name:34}{units:8.1f}{budget:>8}{peer:>9}{seconds * 1e6:10.2f}")
    bgi.graphdefaults()
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
